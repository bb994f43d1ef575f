// What the scenes of chapter 8 have in common. Read it; there is nothing to edit here.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "contacts/ground_contact.h"
#include "engine/instruments/scene.h"

namespace joints::chapter8 {

/// The options of the command line.
struct Choice {
  int iterations = 30;      ///< iterations per step
  real beta = real(0.2);    ///< fraction of the error fed back per step [1]
  double seconds = 6;       ///< duration of the runs [s]
  std::string out;          ///< folder of tables and recordings
};

const real h = real(1) / 60;  ///< the step [s]

/// A static slab whose top is the plane y = 0. \param width of the drawn part [m]
inline BodyId add_ground(Scene& scene, real width) {
  return scene.box(0, vec3(width, real(0.2), width), vec3(0, real(-0.1), 0));
}
/// Adds the contact of a box of this size with that ground.
inline GroundContact& stand(Scene& scene, BodyId ground, BodyId body, const vec3& size,
                            real friction) {
  auto& contact = scene.world.add<GroundContact>(ground, body, Top{.height = real(0.1)},
                                                 box_outline(size));
  contact.friction = friction;
  return contact;
}
/// Penetration depth of the deepest corner of all contacts [m], 0 if there is none.
inline double penetration(const World& world) {
  double deepest = 0;
  for (const auto& joint : world.joints())
    if (const auto* contact = dynamic_cast<const GroundContact*>(joint.get()))
      deepest = std::max(deepest, -double(contact->gap(world.bodies)));
  return deepest;
}

/// The largest present gap of the scene's joints [m].
inline double widest(const Scene& scene) {
  GapMeter meter;
  meter.look(scene.marks, poses(scene.world.bodies));
  return meter.maximum();
}

}  // namespace joints::chapter8
