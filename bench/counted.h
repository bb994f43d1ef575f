// Counting instructions: valgrind's callgrind runs the program and counts the instructions of every
// call of one function, which it identifies by its name. tools/bench/instructions.py reads them.
#pragma once

#include <functional>

/// \addtogroup bench
/// @{
namespace joints::bench {

/// The steps and iterations that are counted.
struct Counted {
  int before = 2;  ///< steps before the counted ones
  int steps = 4;   ///< counted steps
  int few = 10;    ///< iterations per step in the first count
  int many = 30;   ///< iterations per step in the second count
};

/// Two counts, with few iterations and with many: their difference is the cost of the iterations.
/// \param fresh makes everything anew for this number of iterations per step; returns one step
void count(const std::function<std::function<void()>(int iterations)>& fresh,
           const Counted& counted);

}  // namespace joints::bench
/// @}
