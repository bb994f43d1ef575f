// One line of a program's summary: the scene, what a step costs and how well it holds.
#pragma once

#include "engine/instruments/run.h"

/// \addtogroup measuring
/// @{
namespace joints {

/// What `./wb tour` shows of a scene: the measures of a run, and what ran and how.
struct Summary : Measures {
  std::string scene{}, setting{};  ///< what ran, and how
};

/// Prints the lines as a table and writes them to `folder`/summary.csv.
void report(const std::vector<Summary>& lines, const std::string& folder);

}  // namespace joints
/// @}
