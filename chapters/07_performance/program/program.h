// Declarations common to the parts of chapter 7's program. There is nothing to edit here.
#pragma once

#include <string>
#include <vector>

#include "engine/real.h"
#include "engine/instruments/record.h"
#include "engine/instruments/run.h"

/// \addtogroup chapter7
/// @{

/// Chapter 7's program.
namespace joints::chapter7 {

constexpr real h = real(1) / 60;  ///< the step of its scenes [s]

/// The options of the command line.
struct Choice {
  int iterations = 30;    ///< iterations per step
  real beta = real(0.2);  ///< fraction of the error fed back per step [1]
  double seconds = 5;     ///< duration of the scenes [s]
  int chains = 10;        ///< of the performance scene
  std::string out;        ///< folder of tables and recordings
};

/// The variants of the loop, from prepared in every solve to lanes: steps.csv. (steps.cpp)
void steps(const Choice& choice, std::vector<Summary>& lines);
/// Convergence: the order of the joints, over-relaxation and its divergence, the rows inside one
/// step: order.csv, relaxation.csv, inside_a_step.csv. (relaxation.cpp)
void relaxation(const Choice& choice);
/// The colours of a chain, a bridge and a net: colours.csv; the fraction of eight lanes in use, for
/// these and a wheel: groups.csv. (colours.cpp)
void colours(const Choice& choice);
/// The numbers of the questions and folds: iterations to an error, factors per iteration, half a
/// kick: needed.csv, rate.csv, kick.csv. (needed.cpp)
void needed(const Choice& choice);
/// Joints that are all solved from the same velocities: at_once.csv, left.csv. (at_once.cpp)
void at_once(const Choice& choice);
/// Three chains that whip down, recorded: whips.motion.json. (whips.cpp)
void whips(const Choice& choice, std::vector<Summary>& lines);

}  // namespace joints::chapter7
/// @}
