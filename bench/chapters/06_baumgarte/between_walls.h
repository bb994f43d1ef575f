// The chain of T 5.1 between two walls.
#pragma once

#include <cmath>

#include "chapters/06_baumgarte/baumgarte.h"
#include "engine/instruments/scene.h"
#include "joints/ball_joint.h"

namespace joints::chapter6 {

/// Each joint is at the centre of the previous link. The first free link reaches 1 m from the
/// centre of the left wall, the second from there to a fixed point of the right wall. With the bend
/// 0 the two are stretched straight, and their position is unique. Bent by an angle they have some
/// slack.
inline Chain bent_chain(real bend) {
  const real along = std::cos(bend), down = std::sin(bend);
  const quat first = rotation(vec3(0, 0, -bend)), second = rotation(vec3(0, 0, bend));
  Chain chain;
  chain.bodies = {static_body(vec3(0)),
                  box(100, vec3(real(0.4)), vec3(along, -down, 0), first),
                  box(100, vec3(real(0.4)), vec3(2 * along, 0, 0), second),
                  static_body(vec3(2 * along + 1, 0, 0))};
  for (std::size_t k = 0; k < 3; ++k)
    chain.joints.push_back(point_at(chain.bodies[k], chain.bodies[k + 1], chain.bodies[k].x));
  return chain;
}

/// This chain in a world, and three impacts on its second link, as from cubes that are shot at it.
struct BetweenWalls {
  Scene scene{.name = "between"};  ///< world, solver, measurements, appearance
  std::vector<BodyId> ids;         ///< from wall to wall

  /// Makes the scene. \param bend [rad] \param beta of all joints [1]
  BetweenWalls(real bend, real beta) {
    const Chain chain = bent_chain(bend);
    scene.energy_scale = 200 * 9.81;
    for (const Body& body : chain.bodies)
      ids.push_back(scene.box(body.is_static() ? 0 : 100, vec3(real(0.4)), body.x, body.q));
    for (std::size_t k = 0; k < 3; ++k) {
      scene.world.add<BallJoint>(ids[k], ids[k + 1], chain.joints[k]).beta = beta;
      scene.mark(ids[k], ids[k + 1], chain.bodies[k].x);
    }
  }
  /// The impact at this time, if there is one: after half a second, and twice more a second apart.
  void kick(double time) {
    const vec3 blows[] = {vec3(3, 5, -8), vec3(-6, 4, 5), vec3(2, -9, 3)};  // [m/s]
    const int n = int(std::lround(time * 60));
    if (n % 60 == 30 && n / 60 < 3) scene.world.bodies[ids[1]].v += blows[n / 60];
  }
};

}  // namespace joints::chapter6
