// One line of a program's summary: the scene, the cost of a step and the errors.
#pragma once

#include "engine/instruments/run.h"

/// \addtogroup measuring
/// @{
namespace joints {

/// The entry of a scene in `./wb tour`: the measures of a run, its scene and its setting.
struct Summary : Measures {
  std::string scene{}, setting{};  ///< names of the scene and of the setting
};

/// Prints the lines as a table and writes them to `folder`/summary.csv.
void report(const std::vector<Summary>& lines, const std::string& folder);

}  // namespace joints
/// @}
