// The limits of the machine for the loop of chapter 7: the roofs of a roofline.
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

/// The rate of independent multiplications and additions, with one number and on lanes; and the
/// rate of repeated reads of as many bytes as the hinges of ten chains have on lanes. Each is the
/// best of many short runs.
std::vector<Roof> roofs();

}  // namespace joints::bench
/// @}
