// The usual mistakes that a J and a K have in common: levers, and vectors that are rotated with the
// wrong body.
#pragma once

#include "checker/samples.h"

namespace joints::testing {

using Rows = std::vector<Row>;
/// The rows of a J with 12 numbers each.
Rows rows_of(const Numbers& J);
/// Do they push a body, or only turn it?
bool pushes(const Rows& J);

/// The fixture's own mistakes in J.
Wrong own_Js(const Seen& part, const Pair& pair);
/// Mistakes with levers. Rows that only turn have none.
Wrong wrong_levers(const Rows& J, const Pair& pair);

/// Vectors that are rotated wrongly, found from the poses at which an answer is right nevertheless.
/// \param lever "the lever of body 1 is", or other words for it
/// \param lever_left (1, 2 or 0 for both) whether all that is wrong is the lever of that body
std::vector<std::string> wrong_turns(const Pair& pair,
                                     const std::function<bool(const Pair&)>& holds,
                                     const std::string& lever,
                                     const std::function<bool(int)>& lever_left);

/// Adds the mistakes that explain all numbers of a sample. A mistake that has no effect at its pose
/// explains nothing.
void add_named(Sample& sample, const Wrong& wrong, double tolerance);
void add_slips(Sample& sample, const Wrong& wrong, double tolerance);

}  // namespace joints::testing
