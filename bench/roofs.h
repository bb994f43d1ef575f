// What the machine can do at most: the roofs over the loop of chapter 7.
#pragma once

#include <string>
#include <vector>

/// \addtogroup bench
/// @{
namespace joints::bench {

/// A limit of the machine.
struct Roof {
  std::string name;  ///< "arithmetic" or "cache"
  int lanes = 1;     ///< numbers per instruction
  double per_ns;     ///< multiplications and additions [1/ns], or bytes read [B/ns]
};

/// Multiplications and additions that do not wait for each other, with one number and on lanes; and
/// what can be read over and over again of as many bytes as the hinges of ten chains have on lanes.
/// Each is the best of many short tries.
std::vector<Roof> roofs();

}  // namespace joints::bench
/// @}
