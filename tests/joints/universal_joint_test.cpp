// The joint that docs/library.md makes: its rows are held against differences, as those of the
// chapters' parts are.
#include "tests/checker/joint_fixtures.h"
#include "library/examples/universal_joint.h"
#include "tests/oracle/test.h"

namespace {

struct UniversalFixture {
  using Part = Composite<Point, mine::RightAngle>;
  static constexpr Subject J{"", "the four rows J of a universal joint"};
  static constexpr Subject K{"", "K of a universal joint"};
  static constexpr std::array rows{"C.x", "C.y", "C.z", "a1.a2"};
  static constexpr bool exact_when_broken = true;
  static Part make(const Pair& pair) {
    const vec3 axis1 = normalize(vec3(1, 2, real(-0.5)));
    const vec3 axis2 = normalize(cross(axis1, vec3(real(0.3), 1, 1)));
    return mine::cross_at(pair.body1, pair.body2, vec3(real(0.4), real(-0.2), 1), axis1, axis2);
  }
  // Rotations about the two pins of the cross.
  static void move_freely(const Part& part, Pair& pair, Random& random) {
    const vec3 anchor = world_point(pair.body1, part.first.anchor1_local);
    turn_about(pair.body2, anchor,
               rotation(random.uniform(-3, 3) * to_world(pair.body2, part.second.a2_local)));
    turn_about(pair.body2, anchor,
               rotation(random.uniform(-3, 3) * to_world(pair.body1, part.second.a1_local)));
  }
};

}  // namespace

TEST_CASE("the rows of a universal joint are the slope of its error at every pose") {
  check_jacobian<UniversalFixture>();
  check_K<UniversalFixture>();
}

TEST_CASE("a universal joint stays closed while its body is thrown about") {
  World world;
  const BodyId wall = world.add(static_body(vec3(0)));
  const BodyId body = world.add(box(2, vec3(1, real(0.4), real(0.2)), vec3(1, 0, 0)));
  const auto& joint = world.add<mine::UniversalJoint>(
      wall, body,
      mine::cross_at(world.bodies[wall], world.bodies[body], vec3(0), vec3(0, 1, 0),
                     vec3(0, 0, 1)));
  world.bodies[body].w = vec3(3, 1, -2);
  SequentialImpulses solver;
  double gap = 0, angle = 0, rolled = 0;
  for (int n = 0; n < 600; ++n) {
    step(world, solver, real(1) / 240);
    const auto error = joint.part.error(world.bodies[wall], world.bodies[body]);
    gap = std::max(gap, double(length(vec3(error[0], error[1], error[2]))));
    angle = std::max(angle, std::abs(double(error[3])));
    rolled = std::max(rolled, std::abs(double(world.bodies[body].x.y)));
  }
  CHECK(gap < 2e-3);
  CHECK(angle < 2e-3);
  CHECK(rolled > 0.5);  // it did move
}
