// What the parts of chapter 6's program share. There is nothing to edit here.
#pragma once

#include <string>
#include <vector>

#include "engine/stage.h"

namespace joints::chapter6 {

constexpr real h = real(1) / 60;  // [s]

// What the command line says.
struct Options6 {
  int iterations = 30;      // sweeps a step
  real beta = real(0.15);   // share of the error fed back in a step [1]
  double seconds = 10;      // how long the pendulums swing [s]
  std::string out;          // folder of tables and recordings
};

// One joint: drift, decay, energy, leftover spin, rope. (one_joint.cpp)
void one_joint(const Options6& options, std::vector<Summary>& lines);
// Many joints: warm start, beta in a chain, rods that contradict, a chain between two walls, the
// methods side by side. (many_joints.cpp)
void many_joints(const Options6& options, std::vector<Summary>& lines);

}  // namespace joints::chapter6
