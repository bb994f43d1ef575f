// Settings by a word, and cells of tables: what the programs share that compare methods.
#pragma once

#include <cstdio>

#include "bench/settings.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// A method by its word in the tables. Those that iterate have 30 iterations, or 32 that the
/// substeps share; `shake/8` is `shake` in 8 substeps, each with all of its iterations.
/// \throws std::invalid_argument for a word that is none
Setting setting_named(const std::string& method);

/// The words of a text, which blanks part.
std::vector<std::string> words(const std::string& text);

/// Opens a program's table: begun with its columns, or continued. \throws std::invalid_argument
/// where it cannot be written
FILE* open_table(const std::string& path, bool append, const std::string& columns);

/// Leaves of a list of scenes the one that `--scene` names, or all if it names none.
/// \throws std::invalid_argument for a name that is none
template <class Entry>
void keep_named(std::vector<Entry>& list, const std::string& name, std::string Entry::*called) {
  if (!name.empty()) std::erase_if(list, [&](const Entry& one) { return one.*called != name; });
  if (list.empty()) refuse("--scene " + name + ": there is none of this name");
}

/// A comma and a number of the table, or nothing behind the comma where it has no meaning.
std::string cell(double number, bool means_something = true);

/// Gaps, axes, tip, the way in a forbidden direction and the scene's finding, each behind a comma.
std::string measure_cells(const BenchScene& scene, const Result& result);
/// Their columns, in this order, and the last one of them for the energy.
inline const std::string measure_columns =
    "gap_rms_m,gap_max_m,axis_error_rad,tip_error_m,sideways_m,finding,expected,found,energy_drift";

}  // namespace joints::bench
/// @}
