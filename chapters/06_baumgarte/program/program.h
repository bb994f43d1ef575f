// What the parts of chapter 6's program share. There is nothing to edit here.
#pragma once

#include <string>
#include <vector>

#include "engine/instruments/scene.h"

/// \addtogroup chapter6
/// @{

/// Chapter 6's program.
namespace joints::chapter6 {

constexpr real h = real(1) / 60;  ///< the step of its scenes [s]

/// What the command line says.
struct Choice {
  int iterations = 30;     ///< iterations a step
  real beta = real(0.15);  ///< share of the error fed back in a step [1]
  double seconds = 10;     ///< how long the scenes run [s]
  std::string out;         ///< folder of tables and recordings
};

/// One joint and an error: drift, decay, energy, the angular velocity left, a rope. (one_joint.cpp)
void one_joint(const Choice& choice, std::vector<Summary>& lines);
/// Beta and the warm start in a chain. (in_a_chain.cpp)
void in_a_chain(const Choice& choice);
/// Many joints: rods that contradict each other, the methods side by side. (many_joints.cpp)
void many_joints(const Choice& choice, std::vector<Summary>& lines);
/// What the answers to the questions say. (questions.cpp)
void questions(const Choice& choice);
/// Every method with the same number of iterations, in one step or in many. (budget.cpp)
void budget(const Choice& choice);
/// The thesis' chain of four links whose ends cannot move, kicked. (between_walls.cpp)
void between_walls(const Choice& choice, std::vector<Summary>& lines);

}  // namespace joints::chapter6
/// @}
