// Which turn a hinge is in, where its bodies alone cannot say: the limits say it, or the program
// does.
#include "engine/kept/state.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;

// A rotor that is put at an angle by hand, at rest.
struct Put : Rotor {
  explicit Put(double angle) { rotor().q = rotation(vec3(0, 0, real(angle) * degree)); }
};

}  // namespace

TEST_CASE("a body that is put beyond half a turn within its limits is left alone") {
  for (const double angle : {175.0, 190.0, 205.0, -190.0, -175.0})
    for (const bool motor : {false, true})
      for (const bool whole : {false, true}) {
        CAPTURE(angle, motor, whole);
        Put rotor(angle);
        rotor.hinge->whole = whole;
        if (motor) rotor.hinge->set_friction(1);  // the order of the settings does not matter
        rotor.hinge->set_limits(real(angle > 0 ? 170 : -210) * degree,
                                real(angle > 0 ? 210 : -170) * degree);
        CHECK(rotor.in_degrees() == Approx(angle).epsilon(tolerance(1e-9, 1e-5)));
        rotor.run(60, h);
        CHECK(rotor.in_degrees() == Approx(angle).epsilon(tolerance(1e-9, 1e-5)));
        CHECK(double(length(rotor.rotor().w)) < tolerance(1e-9, 1e-4));
      }
}

TEST_CASE("a body outside of its limits goes to the nearer one by the shorter way round") {
  for (const auto& [angle, limit] : {std::pair{165.0, 170.0}, {220.0, 210.0}, {95.0, 170.0},
                                     {275.0, 210.0}}) {
    CAPTURE(angle, limit);
    Put rotor(angle);
    rotor.hinge->set_limits(170 * degree, 210 * degree);
    rotor.hinge->beta = real(0.1);
    double low = angle, high = angle;
    for (int n = 0; n < 200; ++n) {
      step_once(rotor.world, h);
      rotor.rotor().w = vec3(0);  // or it would go on beyond
      low = std::min(low, rotor.in_degrees());
      high = std::max(high, rotor.in_degrees());
    }
    CHECK(low == Approx(std::min(angle, limit)).epsilon(1e-4));
    CHECK(high == Approx(std::max(angle, limit)).epsilon(1e-4));
  }
}

TEST_CASE("limits a turn apart or more leave the turn alone and the program says it") {
  for (const double turns : {0.0, 1.0, -2.0}) {
    Put rotor(-20);
    rotor.hinge->set_limits(-1000 * degree, 1000 * degree);
    if (turns != 0) rotor.hinge->expect(real(turns * 360) * degree);
    rotor.run(5, h);
    CHECK(rotor.in_degrees() == Approx(360 * turns - 20).epsilon(tolerance(1e-9, 1e-5)));
  }
  Put edge(-0.5);  // a little below the lower limit, not almost two turns above it
  edge.hinge->set_limits(0, 720 * degree);
  edge.run(1, h);
  CHECK(edge.in_degrees() > -0.5);
  CHECK(edge.in_degrees() < 0);
}

TEST_CASE("what the program says of the turn goes before what limits would say") {
  for (const bool limits_first : {false, true}) {
    Put rotor(10);
    if (limits_first) rotor.hinge->set_limits(-30 * degree, 30 * degree);
    rotor.hinge->expect(360 * degree);
    if (!limits_first) rotor.hinge->set_limits(-30 * degree, 30 * degree);
    rotor.run(1, h);
    CHECK(rotor.in_degrees() < 369);  // from 370 on its way down to 30
    CHECK(rotor.in_degrees() > 180);
  }
}

TEST_CASE("a count goes on when limits change and begins anew when there were none for a step") {
  Rotor rotor(0, 20);
  rotor.stepping.projections = 1;
  rotor.hinge->set_motor(20, 100);
  rotor.run(60, h);  // 20 rad: three turns and 66 degrees
  CHECK(rotor.angle() == Approx(20).epsilon(1e-3));
  rotor.hinge->set_limits(0, 30 * degree);  // three turns below
  CHECK(rotor.angle() == Approx(20).epsilon(1e-3));
  rotor.hinge->clear_limits();
  rotor.hinge->set_motor(0, 0);
  rotor.rotor().w = vec3(0);
  rotor.run(1, h);
  rotor.hinge->set_limits(0, 90 * degree);
  CHECK(rotor.angle() == Approx(20 - 6 * std::numbers::pi).epsilon(1e-2));
  rotor.run(60, h);
  CHECK(rotor.angle() == Approx(20 - 6 * std::numbers::pi).epsilon(1e-2));
}

TEST_CASE("a wheel that is built anew at its old pose goes on with its turns if it is told them") {
  Rotor old(0, 0);
  old.hinge->set_motor(real(5.97), 1000);
  old.run(60, h);
  REQUIRE(old.angle() == Approx(5.97).epsilon(1e-6));
  Rotor made;
  made.rotor() = old.rotor();
  made.hinge->set_motor(real(5.97), 1000);
  made.hinge->expect(old.hinge->position(old.world.bodies));
  CHECK(made.angle() == Approx(5.97).epsilon(1e-6));
  made.run(60, h);
  CHECK(made.angle() == Approx(11.94).epsilon(1e-6));
  Rotor told, restored;  // neither has a limit or a motor
  told.hinge->expect(13);
  restore(restored.world, save(told.world));
  CHECK(restored.angle() == told.angle());
}

TEST_CASE("a motor alone keeps the count of turns at any speed between bodies that tumble") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    World world;
    std::vector<BodyId> ids{world.add(static_body(vec3(0)))};
    std::vector<HingeJoint*> hinges;
    for (int k = 1; k <= 2; ++k) {
      ids.push_back(world.add(box(random.uniform(1, 5), vec3(1, real(0.4), real(0.3)),
                                  vec3(real(k), 0, 0), random.turn())));
      hinges.push_back(&world.add<HingeJoint>(ids[std::size_t(k - 1)], ids.back(),
                                              vec3(real(k) - real(0.5), 0, 0), random.vector(1)));
    }
    SequentialImpulses solver;
    std::vector<real> angles(hinges.size(), real(0));  // followed from step to step
    for (int n = 0; n < 600; ++n)
      for (std::size_t k = 0; k < hinges.size(); ++k) {
        if (n % 100 == 0) hinges[k]->set_motor(random.uniform(-40, 40), 1000);
        if (k == 0) step(world, solver, h, {.warm_start = true});
        HingeAngle now = hinges[k]->coordinate();
        now.expected = angles[k];
        angles[k] = now.error(world.bodies[ids[k]], world.bodies[ids[k + 1]]);
        REQUIRE(hinges[k]->position(world.bodies) == Approx(angles[k]).margin(1e-4));
      }
  }
}

TEST_CASE("a wheel faster than bodies may be turns as far as they may, and its turns are counted") {
  for (const double speed : {1e9, 1e20, 1e37}) {
    Rotor rotor(0, real(speed));
    rotor.hinge->set_limits(-max_limit, max_limit);
    rotor.run(2, h);
    CHECK(rotor.angle() == Approx(2 * double(max_speed) / 60).epsilon(1e-5));
  }
}

TEST_CASE("a motor switched off has no force, and a limit on the other side begins at zero") {
  Rotor rotor;
  rotor.hinge->set_motor(-3, 2);
  rotor.hinge->set_limits(0, real(0.5));
  const StepOptions warm{.warm_start = true};
  step(rotor.world, rotor.solver, h, warm);
  CHECK(rotor.hinge->motor_force() == -2);
  CHECK(double(rotor.hinge->limit_force()) == Approx(2));
  rotor.hinge->set_motor(-3, 0);
  rotor.rotor().q = rotation(vec3(0, 0, real(0.5)));
  begin_step(rotor.world, rotor.solver, h, warm);
  CHECK(rotor.hinge->stats().live_limits == 1);
  CHECK(rotor.hinge->motor_force() == 0);
  CHECK(rotor.hinge->limit_force() == 0);
}

TEST_CASE("between bodies that no longer move a hinge has no forces") {
  Rotor rotor(1);
  rotor.world.gravity = vec3(0, -9, 0);
  rotor.hinge->set_motor(-3, 2);
  rotor.hinge->set_limits(0, 1);
  rotor.run(1, h);
  CHECK(rotor.hinge->motor_force() != 0);
  CHECK(rotor.hinge->limit_force() != 0);
  rotor.rotor() = static_body(rotor.rotor().x);
  rotor.run(1, h);
  CHECK(rotor.hinge->motor_force() == 0);
  CHECK(rotor.hinge->limit_force() == 0);
  CHECK(rotor.hinge->forces() == Vector<5>{});
}

TEST_CASE("projection counts the turn of an angle that it brings to its limits") {
  for (const real lower : {real(4), real(-9)}) {
    Rotor rotor;
    rotor.hinge->expect(0);
    rotor.hinge->set_limits(lower, lower + real(0.5));
    rotor.hinge->beta = 0;
    rotor.stepping.projections = 60;
    rotor.run(1, h);
    CHECK(rotor.angle() == Approx(double(lower > 0 ? lower : lower + real(0.5))).epsilon(1e-4));
  }
}

TEST_CASE("a coordinate that is held has one row, however far the iterations have come") {
  Rotor rotor(1);
  rotor.world.gravity = vec3(0, -9, 0);
  rotor.solver.iterations = 1;
  rotor.hinge->whole = false;
  rotor.hinge->set_limits(real(0.3), real(0.3));
  for (int n = 0; n < 60; ++n) {
    rotor.run(1, h);
    REQUIRE(rotor.world.blocks.J.size() == 6);
  }
}

TEST_CASE("an angle that is not finite is not expected, and a length has no turns") {
  Rotor rotor;
  rotor.hinge->expect(7);
  for (const real bad : {unbounded, -unbounded, std::numeric_limits<real>::quiet_NaN()})
    CHECK(refusal([&] { rotor.hinge->expect(bad); }) == "x: must be finite [rad or m]");
  CHECK(rotor.angle() == Approx(2 * std::numbers::pi));
  World world;
  const BodyId wall = world.add(static_body(vec3(0)));
  const BodyId sledge = world.add(box(1, vec3(1), vec3(0)));
  auto& slider = world.add<SliderJoint>(wall, sledge, vec3(0), vec3(1, 0, 0));
  slider.expect(50);
  slider.set_limits(4, 5);
  CHECK(slider.position(world.bodies) == 0);
}
