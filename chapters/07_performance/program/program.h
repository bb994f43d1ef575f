// What the parts of chapter 7's program share. There is nothing to edit here.
#pragma once

#include <string>
#include <vector>

#include "engine/real.h"
#include "engine/instruments/record.h"
#include "engine/instruments/summary.h"

/// \addtogroup chapter7
/// @{

/// Chapter 7's program.
namespace joints::chapter7 {

constexpr real h = real(1) / 60;  ///< the step of its scenes [s]

/// What the command line says.
struct Choice {
  int iterations = 30;    ///< iterations per step
  real beta = real(0.2);  ///< share of the error fed back per step [1]
  double seconds = 5;     ///< how long the scenes run [s]
  int chains = 10;        ///< of the performance scene
  std::string out;        ///< folder of tables and recordings
};

/// The loop in its steps, from prepared in every solve to lanes: steps.csv. (steps.cpp)
void steps(const Choice& choice, std::vector<Summary>& lines);
/// What an iteration leaves: the order of the joints, over-relaxation and when it explodes, the
/// rows inside one step: order.csv, relaxation.csv, inside_a_step.csv. (relaxation.cpp)
void relaxation(const Choice& choice);
/// A chain, a bridge and a net in colours: colours.csv; how full they make eight lanes, these and a
/// wheel: groups.csv. (colours.cpp)
void colours(const Choice& choice);
/// What the questions and folds of the text ask: iterations to an error, what an iteration leaves,
/// half a kick: needed.csv, rate.csv, kick.csv. (needed.cpp)
void needed(const Choice& choice);
/// Joints that all answer what they saw at one moment: at_once.csv, left.csv. (at_once.cpp)
void at_once(const Choice& choice);
/// Three chains that whip down, recorded: whips.motion.json. (whips.cpp)
void whips(const Choice& choice, std::vector<Summary>& lines);

}  // namespace joints::chapter7
/// @}
