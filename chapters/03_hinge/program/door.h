// A door on its post, for chapter 3's program. Read it; there is nothing to edit here.
#pragma once

#include <numbers>
#include <string>

#include "engine/instruments/scene.h"
#include "joints/hinge_joint.h"

/// \addtogroup chapter3
/// @{
namespace joints::chapter3 {

const real degree = std::numbers::pi_v<real> / 180;  ///< [rad]

/// A hinge that is measured. \param anchor [m, world] \param axis world
inline HingeJoint& hinge(Scene& scene, BodyId id1, BodyId id2, const vec3& anchor, const vec3& axis,
                  const Settings& settings, bool whole) {
  auto& joint = scene.world.add<HingeJoint>(id1, id2, anchor, axis);
  joint.beta = settings.beta;
  joint.whole = whole;
  scene.mark(id1, id2, anchor, axis);
  return joint;
}

/// A door of 20 kg on a static post that can open to 110 degrees. \param post its place [m]
/// \param speed with which it is pushed open [rad/s]
inline HingeJoint& add_door(Scene& scene, const vec3& post, real speed, const Settings& settings,
                            bool whole) {
  const BodyId frame = scene.box(0, vec3(real(0.1), 2, real(0.1)), post);
  const BodyId door = scene.box(20, vec3(1, 2, real(0.05)), post + vec3(real(0.5), 0, 0));
  scene.shapes.back().label = std::to_string(int(speed)) + " rad/s";
  HingeJoint& joint = hinge(scene, frame, door, post, vec3(0, 1, 0), settings, whole);
  joint.set_limits(0, 110 * degree);
  Body& body = scene.world.bodies[door];
  body.w = vec3(0, speed, 0);
  body.v = cross(body.w, body.x - post);
  scene.energy_scale += kinetic_energy(body);
  return joint;
}

}  // namespace joints::chapter3
/// @}
