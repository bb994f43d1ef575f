// The ragdoll of chapter 8 with cones in its shoulders and hips.
#include "bench/chapters/08_ground/ragdoll.h"
#include "joints/driven_joints.h"
#include "tests/oracle/test.h"

using namespace joints::chapter8;

namespace {

constexpr real arm_swing = real(1.4), leg_swing = real(0.9);  // [rad]
constexpr real arm_twist = 1, leg_twist = real(0.5);          // in either direction [rad]

Joint& in_cone(World& world, BodyId torso, BodyId limb, const vec3& anchor, const vec3& along,
               const vec3& across, bool arm) {
  auto& joint = world.add<ConeTwistJoint>(torso, limb, anchor, along, across,
                                          arm ? arm_swing : leg_swing);
  const real twist = arm ? arm_twist : leg_twist;
  joint.twist().set_limits(-twist, twist);
  return joint;
}

// How far the worst limb is beyond its cone and its twist [rad].
struct Beyond {
  double swing = -10, twist = -10;
};
Beyond beyond(const World& world) {
  Beyond out;
  for (const auto& joint : world.joints())
    if (const auto* limb = dynamic_cast<const ConeTwistJoint*>(joint.get())) {
      const SwingAngle& axes = limb->coordinate<1>().coordinate();
      const vec3 a1 = to_world(world.bodies[limb->body1], axes.a1_local);
      const vec3 a2 = to_world(world.bodies[limb->body2], axes.a2_local);
      const double swing = std::atan2(double(length(cross(a1, a2))), double(dot(a1, a2)));
      const auto& twist = limb->coordinate<0>();
      const bool arm = twist.limits().upper == arm_twist;
      out.swing = std::max(out.swing, swing - double(arm ? arm_swing : leg_swing));
      out.twist = std::max(out.twist, std::abs(double(twist.position(world.bodies))) -
                                          double(twist.limits().upper));
    }
  return out;
}

}  // namespace

TEST_CASE("a ragdoll with cones in shoulders and hips falls within them and lies still") {
  Random random(29);
  int still = 0;
  double swing = -10, twist = -10, gap = 0;
  for (int n = 0; n < 12; ++n) {
    Choice choice;
    choice.iterations = 30;
    Ragdoll doll(choice, 2, random.turn(), in_cone);
    REQUIRE(doll.scene.world.joints().size() == 5 + 6);
    for (int k = 0; k < 900; ++k) {
      step(doll.scene.world, doll.scene.solver, h, doll.scene.stepping);
      const Beyond now = beyond(doll.scene.world);
      swing = std::max(swing, now.swing), twist = std::max(twist, now.twist);
      if (k > 600) gap = std::max(gap, widest(doll.scene));
    }
    still += doll.fastest() < 1e-2 && doll.fastest_turn() < 1e-2;
  }
  CAPTURE(still, swing, twist, gap);
  CHECK(still >= 11);
  CHECK(swing > -0.1);  // the cones were reached
  CHECK(swing < 0.05);
  CHECK(twist < 0.05);
  CHECK(gap < 2e-3);
}
