// Settings by a word, and cells of tables: what the programs share that compare methods.
#pragma once

#include "bench/settings.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// A method by its word in the tables. Those that iterate have 30 iterations, or 32 that the
/// substeps share. \throws std::invalid_argument for a word that is none
Setting setting_of(const std::string& method);

/// A comma and a number of the table, or nothing behind the comma where it has no meaning.
std::string cell(double number, bool means_something = true);

}  // namespace joints::bench
/// @}
