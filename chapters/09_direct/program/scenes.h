// The scenes of chapter 9's program: chains pulled sideways, a beam. Read it; there is nothing to
// edit here.
#pragma once

#include "engine/instruments/scene.h"
#include "joints/fixed_joint.h"
#include "joints/hinge_joint.h"

namespace joints::chapter9 {

/// A hinge. \param axis world, of any length
inline HingeJoint& on_hinge(Scene& scene, BodyId id1, BodyId id2, const vec3& anchor,
                            const vec3& axis) {
  HingeJoint& hinge = scene.world.add<HingeJoint>(id1, id2, anchor, axis);
  hinge.beta = 1;
  scene.mark(id1, id2, anchor, axis);
  return hinge;
}
/// A weld.
inline void welded(Scene& scene, BodyId id1, BodyId id2, const vec3& anchor) {
  scene.world.add<FixedJoint>(id1, id2, anchor).beta = 1;
  scene.mark(id1, id2, anchor);
}

/// The performance scene of the thesis, pulled sideways: chains of cubes of 1 m and 100 kg, 1.5 m
/// apart along z. Each hangs on a hinge about x at the centre of the previous cube; the first cube
/// of a chain is static. Gravity also has 3 m/s^2 along x, a direction that no hinge allows.
inline Scene sideways_chains(int chains, int cubes) {
  Scene scene{.name = "sideways"};
  scene.world.gravity = vec3(3, real(-9.81), 0);
  for (int c = 0; c < chains; ++c) {
    BodyId before{};
    for (int k = 0; k < cubes; ++k) {
      const vec3 x(real(3 * c), 0, real(1.5) * real(k));
      const BodyId id = scene.box(k == 0 ? real(0) : real(100), vec3(1), x);
      if (k > 0) on_hinge(scene, before, id, scene.world.bodies[before].x, vec3(1, 0, 0));
      scene.energy_scale += k == 0 ? 0 : 100 * 9.81 * 1.5 * k;
      before = id;
    }
  }
  return scene;
}

/// A beam: cubes of 1 m and 100 kg that are welded face to face. The first one is static.
inline Scene beam(int cubes) {
  Scene scene{.name = "beam"};
  BodyId before = scene.box(0, vec3(1), vec3(0));
  for (int k = 1; k < cubes; ++k) {
    const BodyId id = scene.box(100, vec3(1), vec3(real(k), 0, 0));
    welded(scene, before, id, vec3(real(k) - real(0.5), 0, 0));
    scene.energy_scale += 100 * 9.81 * k;
    before = id;
  }
  return scene;
}

}  // namespace joints::chapter9
