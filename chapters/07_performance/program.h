// What the parts of chapter 7's program share. There is nothing to edit here.
#pragma once

#include <string>
#include <vector>

#include "chapters/07_performance/hinge_loop.h"
#include "engine/summary.h"

/// \addtogroup chapter7
/// @{

/// Chapter 7's program.
namespace joints::chapter7 {

constexpr real h = real(1) / 60;  ///< the step of its scenes [s]

/// What the command line says.
struct Choice {
  int iterations = 30;    ///< sweeps a step
  real beta = real(0.2);  ///< share of the error fed back in a step [1]
  double seconds = 2;     ///< how long the scenes run [s]
  int chains = 10;        ///< of the performance scene
  std::string out;        ///< folder of tables and recordings
};

/// The loop in its steps, from prepared in every visit to lanes. (steps.cpp)
void steps(const Choice& choice, std::vector<Summary>& lines);
/// Over-relaxation: what it gains and when it explodes. (relaxation.cpp)
void relaxation(const Choice& choice);

}  // namespace joints::chapter7
/// @}
