// The scene that docs/which_method.md shows: a crane's chain with its load.
#pragma once

#include "engine/world.h"
#include "joints/hinge_joint.h"

namespace joints {

World make_world() {
  World world;
  BodyId before = world.add(static_body(vec3(0)));
  for (int k = 1; k <= 10; ++k) {
    const real mass = k == 10 ? 100 : 1;
    const BodyId link = world.add(box(mass, vec3(1, 0.2, 0.2), vec3(k - 0.5, 0, 0)));
    world.add<HingeJoint>(before, link, vec3(k - 1, 0, 0), vec3(0, 0, 1));
    before = link;
  }
  return world;
}

}  // namespace joints
