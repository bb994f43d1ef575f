// Chapter 1: one row. Declares the functions that distance.cpp has to define: the step here, those
// of one row in rods.h. Read the text first, README.md in this folder. Given: there is nothing to
// edit here.
#pragma once

#include <vector>

#include "chapters/01_distance/rods.h"

/// \addtogroup chapter1
/// @{
namespace joints {

/// A rod or a rope between the centres of two bodies of an array.
struct Link {
  int body1 = 0, body2 = 1;  ///< indices into the array
  real length = 1;           ///< [m]
  bool rope = false;         ///< true for a rope, which only pulls
};

/// The row of a link in one step.
struct LinkRow {
  Row J;          ///< the row
  real K = 0;     ///< J M^-1 J^T [1/kg]
  real bias = 0;  ///< minus the required J V [m/s]
  real sum = 0;   ///< accumulated impulse [N s]
};

/// Settings of step().
struct StepSettings {
  vec3 gravity{0, real(-9.81), 0};  ///< [m/s^2]
  real h = real(1) / 60;            ///< length of a step [s]
  int iterations = 30;              ///< iterations over all links
  real beta = real(0.2);            ///< fraction of the error removed per step [1] (chapter 6)
};

/// Given: sets up the row of a link at the bodies' present positions.
LinkRow set_up(const Link& link, const std::vector<Body>& bodies, const StepSettings& settings);

/// Exercise 1.4: one step of the whole simulation, Algorithm 1 of the thesis: forces, rows,
/// iterations, positions. Orientations do not change, because no impulse here has a lever.
void step(std::vector<Body>& bodies, const std::vector<Link>& links,
          const StepSettings& settings);

}  // namespace joints
/// @}
