// What the scenes of chapter 6 have in common. There is nothing to edit here.
#pragma once

#include <string>

#include "engine/real.h"

/// Chapter 6's program.
namespace joints::chapter6 {

constexpr real h = real(1) / 60;  ///< the step of its scenes [s]

/// The options of the command line.
struct Choice {
  int iterations = 30;     ///< iterations per step
  real beta = real(0.15);  ///< fraction of the error fed back per step [1]
  double seconds = 10;     ///< duration of the scenes [s]
  std::string out;         ///< folder of tables and recordings
};

}  // namespace joints::chapter6
