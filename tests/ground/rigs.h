// A body on the ground, and the quantities that the tests of the ground read off it.
#pragma once

#include <algorithm>
#include <numbers>

#include "bench/orders.h"
#include "contacts/ground_contact.h"
#include "tests/oracle/oracle.h"

namespace joints::testing {

inline const vec3 brick(1, real(0.6), real(0.8));  ///< edges of the box of chapter 8 [m]
inline constexpr double g = 9.81;                  ///< [m/s^2]

/// One body over a static ground whose top goes through the origin. The ground is turned by `slope`
/// about z [rad], the body with it: in the ground's own axes -x leads downhill.
struct Grounded {
  World world;
  BodyId ground, body;
  GroundContact* contact;
  bench::OrderedImpulses solver;
  StepOptions stepping{};

  Grounded(Body made, const Outline& outline, real slope = 0, const Top& top = {}) {
    const quat turn = rotation(vec3(0, 0, slope));
    made.x = turn * made.x;
    made.q = turn * made.q;
    made.v = turn * made.v;
    ground = world.add(static_body(vec3(0), turn));
    body = world.add(made);
    contact = &world.add<GroundContact>(ground, body, top, outline);
  }
  Body& it() { return world.bodies[body]; }
  /// Place and velocity in the axes of the ground.
  vec3 place() { return to_local(world.bodies[ground], it().x); }
  vec3 velocity() { return to_local(world.bodies[ground], it().v); }
  void run(double seconds, real h) {
    for (int n = int(std::lround(seconds / double(h))); n > 0; --n)
      step(world, solver, h, stepping);
  }
};

/// The box of 10 kg that stands on the ground. \param turned about the vertical [rad]
inline Grounded standing(real turned = 0, real slope = 0) {
  return {box(10, brick, vec3(0, brick.y / 2, 0), rotation(vec3(0, turned, 0))),
          box_outline(brick), slope};
}
/// The same box in any orientation, its lowest corner at this gap [m] over a level top through the
/// origin.
inline Body lowered(real gap, const quat& q) {
  Body made = box(10, brick, vec3(0), q);
  real lowest = unbounded;
  for (const vec3& corner : box_outline(brick).corners)
    lowest = std::min(lowest, to_world(made, corner).y);
  made.x.y = gap - lowest;
  return made;
}

/// What a corner gave in a step [N s].
struct Touch {
  double t1, t2, normal, mu;
  double friction() const { return std::max(std::abs(t1), std::abs(t2)); }
};
/// Of all corners that have rows with friction.
inline std::vector<Touch> touches(const Blocks& blocks) {
  std::vector<Touch> out;
  for (const Block& block : blocks.list)
    if (block.settings.follows == 2)
      out.push_back({double(block.impulse[0]), double(block.impulse[1]), double(block.impulse[2]),
                     double(block.settings.upper)});
  return out;
}

}  // namespace joints::testing
