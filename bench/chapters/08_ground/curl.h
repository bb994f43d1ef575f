// A chain on the ground that its motors bend into a ring, after the thesis' fig. 5.4.
#pragma once

#include <numbers>

#include "chapters/08_ground/program/program.h"
#include "joints/hinge_joint.h"

namespace joints::chapter8 {

/// Eight cubes of 100 kg in a row on the ground; only the ground is static. A hinge half way
/// between each two has the limits 0 and 45 degrees: with all at 45 degrees they form a regular
/// octagon. To lift one half of the straight chain its middle hinge would need 11.8 kN m. The
/// motors have 8: the outer hinges, which have less to lift, bend first, and shorten the parts to
/// be lifted by the others. Joints and contacts start warm with a beta of 0.02, as in bridge.h:
/// with 0.2 the ring never comes to rest, and with 10 iterations it bursts.
struct Curl {
  static constexpr int cubes = 8;  ///< how many
  static constexpr double cube_mass = 100;  ///< [kg]
  Scene scene{.name = "curl"};  ///< world, solver, measurements, appearance
  real distance = real(1.5);            ///< between two centres in the straight chain [m]
  real bend = std::numbers::pi_v<real> / 4;  ///< upper limit of each hinge [rad]
  BodyId ground{};                       ///< under all cubes
  std::vector<BodyId> cube;              ///< from end to end
  std::vector<HingeJoint*> hinges;       ///< from end to end
  std::vector<GroundContact*> contacts;  ///< one per cube

  /// Makes it. \param iterations per step \param strength of a motor [N m] \param beta of all
  /// joints [1]
  explicit Curl(int iterations, real strength = 8000, real beta = real(0.02)) {
    scene.solver.iterations = iterations;
    scene.stepping.warm_start = true;
    scene.energy_scale = cubes * cube_mass * 9.81 * 1.8;  // all lifted to the middle of the ring
    ground = add_ground(scene, 16);
    for (int k = 0; k < cubes; ++k) {
      const vec3 place(distance * (real(k) - real(cubes - 1) / 2), real(0.5), 0);
      cube.push_back(scene.box(real(cube_mass), vec3(1), place));
      if (k == 0) continue;
      const vec3 anchor = place - vec3(distance / 2, 0, 0);
      hinges.push_back(&scene.world.add<HingeJoint>(cube[std::size_t(k - 1)], cube.back(),
                                                    anchor, vec3(0, 0, 1)));
      hinges.back()->beta = beta;
      hinges.back()->set_limits(0, bend);
      hinges.back()->set_motor(real(0.4), strength);
      scene.mark(cube[std::size_t(k - 1)], cube.back(), anchor, vec3(0, 0, 1));
    }
    for (const BodyId id : cube) {  // contacts after all joints: they are solved last
      contacts.push_back(&stand(scene, ground, id, vec3(1), real(0.5)));
      contacts.back()->beta = beta;
    }
  }
  /// The point of the last cube at which a next hinge would be [m].
  vec3 tip() const {
    return world_point(scene.world.bodies[cube.back()], vec3(distance / 2, 0, 0));
  }
  /// The same at the other end.
  vec3 tail() const {
    return world_point(scene.world.bodies[cube.front()], vec3(-distance / 2, 0, 0));
  }
  /// Corners that have rows in this step.
  int touching() const {
    int sum = 0;
    for (const GroundContact* contact : contacts) sum += contact->touching();
    return sum;
  }
};

}  // namespace joints::chapter8
