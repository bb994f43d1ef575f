// A gear with a mistake in its row, and the report of the checker; then the gear without the
// mistake, driven by a motor. Exit status 1 unless the checker rejects the first one and accepts
// the second, and its wheels keep their ratio for many turns.
// Prints:
//   right  poses: C becomes 0 from 40 of 40 poses.
//   WRONG  J
//   Pose: closed (C is 0). Numeric: how fast C really changes.
//
//     entry        yours         numeric       error
//     C, w1.z      0.500000      2.000000     -1.500000
//
//           v1   w1   v2   w2     (x wrong, . right)
//     C     ...  ..x  ...  ...
//
//   Fails at all poses.
//   None of the usual mistakes explains it (closed): compare it with the
//   equation, entry by entry.
//   Seen: in row C, w1 is 0.25 times the slope at every pose.
//   right  rank: The rows remove 1 degree of freedom at all poses.
//   right  momentum: C changes when both bodies move as one, so the joint
//                    exchanges momentum with the world: right only for parts of
//                    a fixed machine.
//   WRONG  power: The forces do work on motions that keep C (0 of 40 poses are
//                 right): they drive or brake what the joint leaves free.
//   note   turns: C jumps by 12.6 while a body is turned once about itself.
//                 Beyond that place the joint pulls the other way. A part that
//                 turns so far has to count its turns (CountingJoint).
//   the wheels have turned by 50.0 and -100.0 rad
#include <cmath>
#include <cstdio>

#include <checker/check_part.h>
#include <joints.h>

namespace mine {
using namespace joints;

/// Two wheels on axles of a fixed housing: wheel 2 turns `ratio` times as fast as wheel 1.
/// C = angle2 - ratio angle1 [rad]; J = (0, -ratio g1^T, 0, g2^T).
struct Gear {
  HingeAngle angle1, angle2;  ///< of each wheel against the housing
  real ratio = 1;             ///< negative for two wheels that mesh
  bool mistake = true;        ///< divide by the ratio in J

  static constexpr int rows = 1;
  static constexpr bool one_sided = false;
  static constexpr Form form = Form::any;
  static inline const Body housing = static_body(vec3(0));
  real error(const Body& wheel1, const Body& wheel2) const {
    return angle2.error(housing, wheel2) - ratio * angle1.error(housing, wheel1);
  }
  Row jacobian(const Body& wheel1, const Body& wheel2) const {
    const vec3 g1 = angle1.jacobian(housing, wheel1).w2, g2 = angle2.jacobian(housing, wheel2).w2;
    return {vec3(0), -(mistake ? 1 / ratio : ratio) * g1, vec3(0), g2};
  }
  /// Keeps the turns: an angle is within half a turn of the value that is expected here, which is
  /// that at the end of the step.
  void count(const Body& wheel1, const Body& wheel2, real h) {
    count(angle1, wheel1, h), count(angle2, wheel2, h);
  }
  static void count(HingeAngle& angle, const Body& wheel, real h) {
    const vec3 g = angle.jacobian(housing, wheel).w2;
    angle.expected = angle.error(housing, wheel) + h * dot(g, wheel.w);
  }
};
void check(const Gear& gear) { check(gear.angle1), check(gear.angle2); }

}  // namespace mine

int main() {
  using namespace joints;
  const vec3 axle1(0, 0, 1), axle2(0, real(0.6), real(0.8));
  const mine::Gear wrong{{axle1}, {axle2}, -2}, right{{axle1}, {axle2}, -2, false};

  // Poses at which the axles hold: each wheel is rotated about its own.
  const auto on_their_axles = [&](PoseRandom& random) {
    PosePair pair = any_pose(random);
    pair.body1.q = rotation(random.uniform(-1, 1) * axle1);
    pair.body2.q = rotation(random.uniform(-1, 1) * axle2);
    return pair;
  };
  const PartReport report = check_part(wrong, on_their_axles);
  std::printf("%s", report.text().c_str());
  if (report["J"].holds || !check_part(right, on_their_axles).good()) return 1;

  World world;
  const BodyId housing = world.add(static_body(vec3(0)));
  const BodyId wheel1 = world.add(box(2, vec3(real(0.4)), vec3(-1, 0, 0)));
  const BodyId wheel2 = world.add(box(1, vec3(real(0.2)), vec3(1, 0, 0)));
  auto& hinge1 = world.add<HingeJoint>(housing, wheel1, vec3(-1, 0, 0), axle1);
  auto& hinge2 = world.add<HingeJoint>(housing, wheel2, vec3(1, 0, 0), axle2);
  world.add<CountingJoint<mine::Gear>>(wheel1, wheel2, right);
  hinge1.set_motor(5, 50);         // rad/s, N m
  hinge2.set_friction(real(0.1));  // N m
  PackedImpulses solver;
  for (int n = 0; n < 600; ++n) step(world, solver, real(1) / 60, {.warm_start = true});
  const real turned1 = hinge1.position(world.bodies), turned2 = hinge2.position(world.bodies);
  std::printf("the wheels have turned by %.1f and %.1f rad\n", double(turned1), double(turned2));
  return std::abs(turned2 + 2 * turned1) < real(0.01) ? 0 : 1;
}
