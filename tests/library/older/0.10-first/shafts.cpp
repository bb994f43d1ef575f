// Two shafts with a universal joint of the user's own, as the library's page wrote it before the
// library had one: the names of the user are in the namespace joints. Exit status 1 if the ratio of
// the speeds does not range from cos 30 degrees to its inverse.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <joints.h>

namespace joints {

struct RightAngle {
  vec3 a1_local{1, 0, 0}, a2_local{0, 1, 0};

  static constexpr int rows = 1;
  static constexpr bool one_sided = false;
  static constexpr Form form = Form::angular;
  real error(const Body& body1, const Body& body2) const {
    return dot(to_world(body1, a1_local), to_world(body2, a2_local));
  }
  Row jacobian(const Body& body1, const Body& body2) const {
    const vec3 n = cross(to_world(body1, a1_local), to_world(body2, a2_local));
    return {vec3(0), n, vec3(0), -n};
  }
};
inline void check(const RightAngle& part) {
  require_unit("a1_local", part.a1_local);
  require_unit("a2_local", part.a2_local);
}
using UniversalJoint = PartJoint<Composite<Point, RightAngle>>;

}  // namespace joints

using namespace joints;

int main() {
  const real angle = std::numbers::pi_v<real> / 6;
  const vec3 along1(1, 0, 0), along2(std::cos(angle), 0, std::sin(angle)), pin1(0, 1, 0);
  World world;
  const BodyId wall = world.add(static_body(vec3(0)));
  const BodyId first = world.add(box(4, vec3(1, real(0.2), real(0.2)), -along1));
  const BodyId second =
      world.add(box(4, vec3(1, real(0.2), real(0.2)), along2, rotation(vec3(0, -angle, 0))));
  auto& drive = world.add<HingeJoint>(world.bodies, wall, first, -along1, along1);
  auto& driven = world.add<HingeJoint>(world.bodies, wall, second, along2, along2);
  const Body &a = world.bodies[first], &b = world.bodies[second];
  world.add<UniversalJoint>(
      first, second,
      Composite<Point, RightAngle>{point_at(a, b, vec3(0)),
                                   {to_local(a, pin1), to_local(b, cross(along2, pin1))}});
  drive.set_motor(5, 1000);
  DirectSolver solver;
  real least = 10, greatest = 0;
  for (int n = 0; n < 240; ++n) {
    step(world, solver, real(1) / 240);
    if (n < 60) continue;
    const real ratio = driven.speed(world.bodies) / drive.speed(world.bodies);
    least = std::min(least, ratio), greatest = std::max(greatest, ratio);
  }
  const real cosine = std::cos(angle);
  return std::abs(least - cosine) < real(0.01) && std::abs(greatest - 1 / cosine) < real(0.01) ? 0
                                                                                               : 1;
}
