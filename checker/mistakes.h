// What the usual mistakes in a J and in a K have in common: levers, and what is turned with which
// body.
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

/// What is turned wrongly, found from the poses at which an answer holds all the same.
/// \param lever "the lever of body 1 is", or what else can be said of it
std::vector<std::string> wrong_turns(const Pair& pair,
                                     const std::function<bool(const Pair&)>& holds,
                                     const std::string& lever);

/// Adds what explains all numbers of a sample. What is right here, as some mistakes are at some
/// poses, explains nothing.
void add_named(Sample& sample, const Wrong& wrong, double tolerance);

}  // namespace joints::testing
