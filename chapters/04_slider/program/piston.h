// The piston of chapter 4's program. Read it; there is nothing to edit here.
#pragma once

#include <algorithm>

#include "engine/instruments/scene.h"
#include "joints/slider_joint.h"

/// \addtogroup chapter4
/// @{
namespace joints::chapter4 {

/// A slider, with the settings of the command line.
inline SliderJoint& slider(Scene& scene, BodyId id1, BodyId id2, const vec3& anchor,
                    const vec3& direction, const Settings& settings, bool whole) {
  auto& joint = scene.world.add<SliderJoint>(id1, id2, anchor, direction);
  joint.beta = settings.beta;
  joint.whole = whole;
  return joint;
}

/// How far the anchor of body 2 is off the line, or beyond a limit [m].
inline double gap(const SliderJoint& joint, const Bodies& bodies) {
  const Vector<2> C = joint.first.error(bodies[joint.body1], bodies[joint.body2]);
  const double x = double(joint.position(bodies));
  const double beyond = std::max({double(joint.limits().lower) - x,
                                  x - double(joint.limits().upper), 0.0});
  return std::hypot(double(C[0]), double(C[1]), beyond);
}

/// A piston of 5 kg that a motor of 80 N drives up and down between 0 and 0.4 m, 1 m/s at most; it
/// is held 0.3 m beside its centre.
struct Piston {
  Scene scene{.name = "piston"};  ///< world, solver, marks and shapes
  SliderJoint* joint;             ///< with its limits and its motor
  real speed = 1;                 ///< of the motor [m/s]
  real strength = 80;             ///< of the motor [N]

  /// Makes the scene. \param whole one block, or a block for each part
  Piston(const Settings& settings, bool whole) {
    scene.solver.iterations = settings.iterations;
    scene.energy_scale = 5 * 9.81 * 0.4;
    const BodyId cylinder = scene.box(0, vec3(real(0.1), real(1.2), real(0.1)), vec3(0));
    const BodyId body =
        scene.box(5, vec3(real(0.4), real(0.2), real(0.4)), vec3(real(0.3), 0, 0));
    joint = &slider(scene, cylinder, body, vec3(0), vec3(0, 1, 0), settings, whole);
    joint->set_limits(0, real(0.4));
    turn_round(0);
    scene.gaps = [this](GapMeter& meter) { meter.add(gap(*joint, scene.world.bodies)); };
  }
  Piston(const Piston&) = delete;  // its gaps are those of this one
  /// The motor's direction at a time [s]: it turns round every 1.5 s.
  void turn_round(double time) {
    joint->set_motor(int(time / 1.5) % 2 == 0 ? speed : -speed, strength);
  }
};

}  // namespace joints::chapter4
/// @}
