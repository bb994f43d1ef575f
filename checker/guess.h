// Guessing from the entries of a J or K what went wrong.
#pragma once

#include "checker/samples.h"

namespace joints::testing {

inline constexpr std::array block_names{"v1", "w1", "v2", "w2"};

/// What guess_J() and guess_K() say of a sample without any entry.
extern const char* const told_all_zero;

/// Adds to a sample's mistakes what its numbers alone tell. \param rows their names
void guess_J(Sample& s, double tolerance, const std::vector<std::string>& rows);
void guess_K(Sample& s, double tolerance, const std::vector<std::string>& rows);

}  // namespace joints::testing
