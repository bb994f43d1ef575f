// Settings by name, and cells of tables, for the programs that compare methods.
#pragma once

#include <cstdio>

#include "bench/settings.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// A method by its name in the tables. Iterative methods have 30 iterations, or 32 that are divided
/// among the substeps; `shake/8` is `shake` in 8 substeps, each with all of its iterations, and
/// `beta1:10` is `beta1` with 10 iterations.
/// \throws std::invalid_argument for an unknown name
Setting setting_named(const std::string& method);

/// The methods in reduced coordinates that accept a scene, each after a blank.
std::string tree_methods(const MakeScene& make_scene);

/// The words of a text, separated by blanks.
std::vector<std::string> words(const std::string& text);

/// Opens a program's table, to append to or anew. An empty one begins with its header.
/// \throws std::invalid_argument if it cannot be written
FILE* open_table(const std::string& path, bool append, const std::string& columns);

/// Reduces a list of scenes to the one named by `--scene`; keeps all if it is empty.
/// \throws std::invalid_argument for an unknown name
template <class Entry>
void keep_named(std::vector<Entry>& list, const std::string& name, std::string Entry::*called) {
  if (!name.empty()) std::erase_if(list, [&](const Entry& one) { return one.*called != name; });
  if (list.empty()) refuse("--scene " + name + ": there is none of this name");
}

/// A comma and a number of the table, or only the comma if the number has no meaning.
std::string cell(double number, bool means_something = true);

/// Gaps, axes, tip, displacement in a forbidden direction and the scene's finding, each after a
/// comma.
std::string measure_cells(const BenchScene& scene, const Result& result);
/// Their columns, in this order, and the last one of them for the energy.
inline const std::string measure_columns =
    "gap_rms_m,gap_max_m,axis_error_rad,tip_error_m,sideways_m,finding,expected,found,energy_drift";

}  // namespace joints::bench
/// @}
