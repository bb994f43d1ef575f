// Declarations common to the parts of chapter 6's program. There is nothing to edit here.
#pragma once

#include <string>
#include <vector>

#include "engine/instruments/scene.h"

/// \addtogroup chapter6
/// @{

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

/// One joint and an error: drift, decay, energy, remaining angular velocity, a rope.
/// (one_joint.cpp)
void one_joint(const Choice& choice, std::vector<Summary>& lines);
/// Beta and the warm start in a chain. (in_a_chain.cpp)
void in_a_chain(const Choice& choice);
/// Many joints: rods that contradict each other, the methods side by side. (many_joints.cpp)
void many_joints(const Choice& choice, std::vector<Summary>& lines);
/// The numbers of the answers to the questions. (questions.cpp)
void questions(const Choice& choice);
/// Every method with the same number of iterations, in one step or in many. (budget.cpp)
void budget(const Choice& choice);
/// The thesis' chain of four links between static ends, with impacts. (between_walls.cpp)
void between_walls(const Choice& choice, std::vector<Summary>& lines);

}  // namespace joints::chapter6
/// @}
