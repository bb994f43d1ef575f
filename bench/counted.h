// Counting instructions: the program is run by valgrind's callgrind, which knows one function by
// its name and keeps a count of every call of it. tools/bench/instructions.py reads the counts.
#pragma once

#include <functional>

/// \addtogroup bench
/// @{
namespace joints::bench {

/// How much is counted.
struct Counted {
  int before = 2;  ///< steps that come first and are not counted
  int steps = 4;   ///< steps that are
  int few = 10;    ///< iterations a step of the first count
  int many = 30;   ///< and of the second
};

/// Two counts, with few iterations and with many: their difference is what iterations cost.
/// \param fresh everything made anew with so many iterations a step; what it returns is one step
void count(const std::function<std::function<void()>(int iterations)>& fresh,
           const Counted& counted);

}  // namespace joints::bench
/// @}
