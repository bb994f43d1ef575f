// Bad input to hinge, slider and weld is refused with the argument named, and the world stays as it
// was (case X16).
#include "bench/runge_kutta.h"
#include "direct/direct_solver.h"
#include "engine/instruments/rate.h"
#include "joints/driven_joints.h"
#include "joints/rack_joint.h"
#include "tests/oracle/test.h"

using Catch::Matchers::StartsWith;

namespace {

const real h = real(1) / 60;
const real no_number = std::numeric_limits<real>::quiet_NaN();
const vec3 anchor(0, real(-0.5), 0), axis(0, 0, 1);

// A wall and a weight that moves, held by one hinge.
struct Small {
  World world;
  BodyId wall, weight;
  HingeJoint* hinge;
  Small() {
    wall = world.add(static_body(vec3(0)));
    weight = world.add(box(2, vec3(1), vec3(0, -1, 0)));
    world.bodies[weight].v = vec3(1, 2, 3);
    hinge = &world.add<HingeJoint>(wall, weight, anchor, axis);
  }
  bool unchanged() const {
    const Body& body = world.bodies[weight];
    return world.bodies.size() == 2 && world.joints().size() == 1 &&
           world.joints().size() == 1 && body.x == vec3(0, -1, 0) &&
           body.v == vec3(1, 2, 3) && body.w == vec3(0) && body.q == quat(1, 0, 0, 0);
  }
  // What the world says to a joint of kind J.
  template <class J, class... Rest>
  std::string add(BodyId a, BodyId b, const Rest&... rest) {
    return refusal([&] { world.add<J>(a, b, rest...); });
  }
};

const vec3 endless[] = {vec3(no_number, 0, 0), vec3(0, unbounded, 0), vec3(0, 0, -unbounded)};

}  // namespace

TEST_CASE("X16 a hinge or slider without a proper axis is refused") {
  Small small;
  std::vector<vec3> bad(std::begin(endless), std::end(endless));
  bad.push_back(vec3(0));
  for (const vec3& none : bad) {
    CHECK_THAT(small.add<HingeJoint>(small.wall, small.weight, anchor, none), StartsWith("axis:"));
    CHECK_THAT(small.add<SliderJoint>(small.wall, small.weight, anchor, none), StartsWith("axis:"));
    CHECK(small.unchanged());
  }
  for (real size : {real(1e-6), real(1e6)}) {  // any other length will do
    CHECK(small.add<HingeJoint>(small.wall, small.weight, anchor, size * axis) == "accepted");
    CHECK(small.add<SliderJoint>(small.wall, small.weight, anchor, size * axis) == "accepted");
  }
}

TEST_CASE("X16 an anchor that is not finite is refused by hinge and slider and weld") {
  Small small;
  for (const vec3& bad : endless) {
    const std::string hinge = small.add<HingeJoint>(small.wall, small.weight, bad, axis);
    const std::string slider = small.add<SliderJoint>(small.wall, small.weight, bad, axis);
    const std::string weld = small.add<FixedJoint>(small.wall, small.weight, bad);
    for (const std::string& said : {hinge, slider, weld}) {
      CHECK_THAT(said, StartsWith("anchor"));
      CHECK_THAT(said, Catch::Matchers::EndsWith("must be finite [m]"));
    }
    CHECK(small.unchanged());
  }
}

TEST_CASE("X16 a hinge or slider or weld of a body with itself or with none is refused") {
  Small small;
  for (BodyId id : {small.wall, small.weight}) {
    CHECK_THAT(small.add<HingeJoint>(id, id, anchor, axis), StartsWith("body2:"));
    CHECK_THAT(small.add<SliderJoint>(id, id, anchor, axis), StartsWith("body2:"));
    CHECK_THAT(small.add<FixedJoint>(id, id, anchor), StartsWith("body2:"));
    CHECK(small.unchanged());
  }
  for (const BodyId& bad : {BodyId{}, BodyId{1, 3}, BodyId{7, 1}, BodyId{~0u, 1}}) {
    CHECK_THAT(small.add<HingeJoint>(small.wall, bad, anchor, axis), StartsWith("body:"));
    CHECK_THAT(small.add<SliderJoint>(bad, small.weight, anchor, axis), StartsWith("body:"));
    CHECK_THAT(small.add<FixedJoint>(bad, small.weight, anchor), StartsWith("body:"));
    CHECK(small.unchanged());
  }
}

TEST_CASE("X16 a lower limit above the upper one or a limit without a number changes nothing") {
  Small small;
  HingeJoint& hinge = *small.hinge;
  hinge.set_limits(-1, 2);
  const auto set = [&](const auto& limits) {
    return refusal([&] { hinge.set_limits(limits.first, limits.second); });
  };
  for (const auto& limits :
       {std::pair{real(1), real(0)}, {no_number, real(1)}, {real(0), no_number},
        {no_number, no_number}, {unbounded, -unbounded}}) {
    CHECK_THAT(set(limits), StartsWith("lower:"));
    CHECK(double(hinge.limits().lower) == -1);
    CHECK(double(hinge.limits().upper) == 2);
  }
  for (const auto& limits : {std::pair{real(1), real(1)}, {-unbounded, real(0)},
                             {real(0), unbounded}, {-unbounded, unbounded}})
    CHECK(set(limits) == "accepted");
  CHECK(small.unchanged());
}

TEST_CASE("X16 a motor without a finite speed or with a negative strength changes nothing") {
  Small small;
  HingeJoint& hinge = *small.hinge;
  hinge.set_motor(3, 4);
  for (real bad : {no_number, unbounded, -unbounded})
    CHECK_THAT(refusal([&] { hinge.set_motor(bad, 1); }), StartsWith("speed is"));
  for (real bad : {no_number, real(-1), -unbounded})
    CHECK_THAT(refusal([&] { hinge.set_motor(1, bad); }), StartsWith("strength is"));
  CHECK(double(hinge.motor().speed) == 3);
  CHECK(double(hinge.motor().strength) == 4);
  CHECK(refusal([&] { hinge.set_motor(-1, 0); }) == "accepted");
  CHECK(small.unchanged());
}

TEST_CASE("X16 a motor faster than any body and a limit farther than any turn are refused") {
  Small small;
  HingeJoint& hinge = *small.hinge;
  const real huge = real(is_float ? 1e30 : 1e300);
  for (const real bad : {huge, -huge, 2 * max_speed})
    CHECK_THAT(refusal([&] { hinge.set_motor(bad, 1); }), StartsWith("speed is"));
  CHECK(refusal([&] { hinge.set_motor(max_speed, 0); }) == "accepted");
  CHECK_THAT(refusal([&] { hinge.set_limits(huge, huge); }), StartsWith("lower is"));
  CHECK_THAT(refusal([&] { hinge.set_limits(0, huge); }), StartsWith("upper is"));
  CHECK_THAT(refusal([&] { hinge.set_limits(-huge, 0); }), StartsWith("lower is"));
  CHECK(refusal([&] { hinge.set_limits(-max_limit, max_limit); }) == "accepted");
  CHECK(small.unchanged());
}

TEST_CASE("a motor of unbounded strength reaches its speed in one step and stays finite") {
  Small small;
  small.world.gravity = vec3(0);
  small.world.bodies[small.weight].v = vec3(0);
  small.hinge->set_motor(3, unbounded);
  for (int n = 0; n < 60; ++n) step_once(small.world, h);
  CHECK(double(small.hinge->speed(small.world.bodies)) == Approx(3).epsilon(1e-3));
}

TEST_CASE("X16 equal infinite limits are refused or at least leave the joint finite") {
  for (real nowhere : {unbounded, -unbounded}) {
    Small small;
    const std::string said = refusal([&] { small.hinge->set_limits(nowhere, nowhere); });
    for (int n = 0; n < 3; ++n) step_once(small.world, h);
    INFO(said);
    CHECK(finite(small.world.bodies[small.weight].v));
  }
}

TEST_CASE("X16 an axis too long or too short to be squared is refused or taken as any other") {
  const real largest = std::numeric_limits<real>::max(), least = std::numeric_limits<real>::min();
  for (real size : {std::sqrt(largest) * 8, largest / 2, std::sqrt(least), least * 8}) {
    Small small;
    small.world.gravity = vec3(0);
    const std::string said =
        small.add<HingeJoint>(small.wall, small.weight, anchor, size * axis);
    step_once(small.world, h);
    CAPTURE(size, said);
    CHECK(finite(small.world.bodies[small.weight].v));
    if (said != "accepted") continue;
    const auto& hinge = static_cast<const HingeJoint&>(*small.world.joints().back());
    CHECK(double(length(hinge.second.a1_local)) == Approx(1).epsilon(tolerance(1e-12, 1e-6)));
  }
}

TEST_CASE("a cross of parallel pins, a length below zero and a pinion of no radius are refused") {
  Small small;
  const vec3 nearly = axis + vec3(real(1e-9), 0, 0);
  CHECK_THAT(small.add<UniversalJoint>(small.wall, small.weight, anchor, axis, nearly),
             StartsWith("pin2: must not be parallel"));
  CHECK_THAT(small.add<UniversalJoint>(small.wall, small.weight, anchor, axis, real(-3) * axis),
             StartsWith("pin2: must not be parallel"));
  CHECK_THAT(small.add<RackJoint>(small.weight, small.wall, axis, vec3(1, 0, 0), real(0)),
             StartsWith("radius is 0"));
  CHECK(small.unchanged());
  auto& strut = small.world.add<StrutJoint>(small.wall, small.weight, vec3(0), vec3(0, -1, 0));
  strut.length().set_limits(-3, -1);
  SequentialImpulses solver;
  CHECK_THAT(refusal([&] { step(small.world, solver, h); }),
             StartsWith("joint 1: length: upper limit is -1"));
}

TEST_CASE("settings with which no step can be computed are refused in words") {
  Small small;
  DirectSolver direct;
  direct.inverse = nullptr;
  CHECK_THAT(refusal([&] { step(small.world, direct, h); }), StartsWith("inverse: must be"));
  RungeKutta method;
  method.most_work = double(no_number);
  CHECK_THAT(refusal([&] { method.step(small.world, h); }), StartsWith("most_work is nan"));
  for (const int most : {-1, 0, 1})
    CHECK_THAT(refusal([&] { contraction_rate(small.world, most); }),
               StartsWith("most: a rate needs"));
  CHECK(small.unchanged());
}
