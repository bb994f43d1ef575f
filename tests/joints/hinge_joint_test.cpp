// The hinge as the engine runs it: it comes back from any misalignment, its motor has the strength
// that it was given, it counts its turns, and it does not wear out (cases X7, X8, X12 and X17).
#include "engine/instruments/measure.h"
#include "tests/checker/joint_fixtures.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;

// A hinge between a wall, or a body that is free, and a body turned away from its axis.
struct Bent {
  World world;
  BodyId one, two;
  HingeJoint* hinge;
  SequentialImpulses solver;
  StepOptions stepping{};

  Bent(real angle, bool free, bool beside, bool whole) {
    world.gravity = vec3(0);
    const quat q1 = rotation(vec3(real(0.4), -1, real(0.3)));
    const vec3 anchor(real(0.3), real(0.2), real(-0.1));
    Body other = body_with(2, vec3(1, real(0.7), real(0.5)), anchor, rotation(vec3(1, 2, 0)));
    if (beside) other.x += vec3(real(0.3), real(-0.4), real(0.2));
    one = world.add(free ? body_with(3, vec3(1, 2, real(1.5)), vec3(0), q1)
                         : static_body(vec3(0), q1));
    two = world.add(other);
    hinge = &world.add<HingeJoint>(one, two, anchor, vec3(1, 2, -1));
    hinge->whole = whole;
    hinge->set_limits(-1, 1);
    const vec3 across = normalize(cross(axis1(), vec3(0, 0, 1)));
    turn_about(world.bodies[two], anchor, rotation(angle * across));
  }
  vec3 axis1() const { return to_world(world.bodies[one], hinge->second.a1_local); }
  vec3 axis2() const {
    return to_world(world.bodies[two], cross(hinge->second.b_local, hinge->second.c_local));
  }
  double misalignment() const { return angle_between(axis1(), axis2()); }
};

template <class Look>
void for_every_bent_hinge(Look look) {
  for (double angle : {90.0, 179.9, 180.0})
    for (bool free : {false, true})
      for (bool beside : {false, true})
        for (bool whole : {true, false}) {
          CAPTURE(angle, free, beside, whole);
          const auto make = [=] { return Bent(real(angle) * degree, free, beside, whole); };
          look(make, angle);
        }
}

}  // namespace

TEST_CASE("a hinge's axis may have any length") {
  const double most = is_float ? 1e30 : 1e200;
  for (const double size : {1 / most, 1e-9, 1e9, most})
    for (const vec3& axis : {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1), vec3(1, 2, 3)}) {
      World world;
      const BodyId a = world.add(static_body(vec3(0))), b = world.add(ball(1, 1, vec3(0)));
      auto& hinge = world.add<HingeJoint>(a, b, vec3(0), real(size) * axis);
      CHECK(double(length(hinge.second.a1_local - normalize(axis))) < 4 * double(epsilon));
    }
}

TEST_CASE("the row of a hinge's angle stays short where its axes are nearly opposite") {
  for (const double off : {0.3, 0.1, 0.01, 1e-3, 0.0}) {
    const HingeAngle angle{vec3(0, 0, 1), quat(1, 0, 0, 0), 0};
    const Body a = ball(1, 1, vec3(0));
    Body b = a;
    b.q = rotation(real(std::numbers::pi - off) * vec3(real(0.6), real(0.8), 0));
    CHECK(double(length(angle.jacobian(a, b).w2)) < 7);
    b.q = rotation(real(std::numbers::pi - 3 * off - 0.4) * vec3(real(0.6), real(0.8), 0));
    if (!is_float) CHECK(slope_error(angle, a, b) < 1e-6);  // further from there it is the slope
  }
}

TEST_CASE("X7 a hinge bent by 90 or 180 degrees is back within 3 s and never upside down") {
  for_every_bent_hinge([](auto make, double angle) {
    Bent bent = make();
    CHECK(bent.misalignment() / double(degree) == Approx(angle).epsilon(tolerance(1e-9, 1e-4)));
    int back = -1;
    for (int n = 0; n < 180; ++n) {
      step(bent.world, bent.solver, h, bent.stepping);
      REQUIRE(all_finite(bent.world));
      const double off = bent.misalignment();
      CHECK(off < double(angle) * double(degree) + 1e-3);  // on the way, not further
      if (off < 1e-3 && back < 0) back = n;
      if (back >= 0) CHECK(off < 2e-3);  // and stays
    }
    CHECK(back > 0);
    CHECK(dot(bent.axis1(), bent.axis2()) > real(0.99999));
  });
}

TEST_CASE("X7 a bent hinge does the same to the last bit with q and with its negative") {
  for_every_bent_hinge([](auto make, double) {
    Bent plain = make();
    for (int which = 1; which <= 3; ++which) {
      Bent here = make(), other = make();
      for (const auto& [bit, id] : {std::pair{1, other.one}, {2, other.two}})
        if (which & bit) other.world.bodies[id].q = -other.world.bodies[id].q;
      for (int n = 0; n < 60; ++n) {
        step(here.world, here.solver, h, here.stepping);
        step(other.world, other.solver, h, other.stepping);
      }
      for (int slot = 0; slot < 2; ++slot) {
        const Body &a = here.world.bodies.at(slot), &b = other.world.bodies.at(slot);
        CHECK(same_bits(a.x + vec3(0), b.x + vec3(0)));
        CHECK(same_bits(a.v + vec3(0), b.v + vec3(0)));
        CHECK(same_bits(a.w + vec3(0), b.w + vec3(0)));
        CHECK((a.q == b.q || a.q == -b.q));
      }
    }
  });
}

TEST_CASE("X8 a hinge that spins at 1000 rad per s counts its turns") {
  for (real speed : {real(150), real(190), real(-1000), real(1000)})
    for (real lever : {real(0), real(0.001)})
      for (bool with_motor : {false, true}) {
        Rotor rotor(lever, speed);
        if (with_motor) rotor.hinge->set_motor(speed, 1);
        else rotor.hinge->set_limits(-2000, 2000);
        for (int n = 0; n < 60; ++n) {
          step(rotor.world, rotor.solver, h, rotor.stepping);
          REQUIRE(all_finite(rotor.world));
        }
        begin_step(rotor.world, rotor.solver, h, rotor.stepping);  // it counts when a step begins
        CHECK(rotor.angle() == Approx(double(speed)).epsilon(lever > 0 ? 1e-3 : 1e-5));
        CHECK(double(rotor.rotor().w.z) == Approx(double(speed)).epsilon(1e-3));
      }
}

TEST_CASE("X8 the angle read after a step is the one with which the next step begins") {
  for (real speed : {real(150), real(190), real(-1000), real(1000)}) {
    Rotor rotor(0, speed);
    rotor.hinge->set_limits(-2000, 2000);
    rotor.run(60, h);
    const double read = rotor.angle();
    begin_step(rotor.world, rotor.solver, h, rotor.stepping);
    CHECK(read == Approx(rotor.angle()).epsilon(1e-6));
  }
}

TEST_CASE("X8 a lever of 0.5 m on a hinge at 1000 rad per s stays finite and loses energy only") {
  for (bool whole : {true, false})
    for (bool warm : {false, true}) {
      Rotor rotor(real(0.5), 1000);
      rotor.hinge->whole = whole;
      rotor.stepping.warm_start = warm;
      const double before = kinetic_energy(rotor.rotor());
      for (int n = 0; n < 600; ++n) {
        step(rotor.world, rotor.solver, h, rotor.stepping);
        REQUIRE(all_finite(rotor.world));
        REQUIRE(kinetic_energy(rotor.rotor()) < 1.01 * before);
      }
    }
}

TEST_CASE("X12 a motor of 2 N m gives 1 kg m^2 exactly 2 rad per s in a second") {
  for (bool whole : {true, false})
    for (bool warm : {false, true})
      for (int rate : {60, 240, 1000})
        for (int iterations : {1, 10, 100}) {
          CAPTURE(whole, warm, rate, iterations);
          Rotor rotor;
          rotor.hinge->whole = whole;
          rotor.hinge->set_motor(100, 2);
          rotor.stepping.warm_start = warm;
          rotor.solver.iterations = iterations;
          rotor.run(rate, real(1) / real(rate));
          CHECK(double(rotor.rotor().w.z) == Approx(2).epsilon(tolerance(1e-10, 1e-3)));
          CHECK(double(rotor.hinge->motor_force()) == Approx(2).epsilon(tolerance(1e-10, 1e-3)));
        }
}

TEST_CASE("a motor stops pushing where its speed is reached and brakes what is faster") {
  Rotor rotor(0, 5);
  rotor.hinge->set_motor(3, 6);  // 0.1 rad/s a step
  rotor.run(10, h);
  CHECK(double(rotor.rotor().w.z) == Approx(4).epsilon(tolerance(1e-10, 1e-5)));
  CHECK(double(rotor.hinge->motor_force()) == Approx(-6).epsilon(tolerance(1e-10, 1e-5)));
  rotor.run(30, h);
  CHECK(double(rotor.rotor().w.z) == Approx(3).epsilon(tolerance(1e-10, 1e-5)));
  CHECK(std::abs(double(rotor.hinge->motor_force())) < tolerance(1e-9, 1e-3));
  rotor.hinge->set_motor(3, 0);  // off: it turns on by itself
  rotor.hinge->set_limits(-unbounded, unbounded);
  rotor.run(30, h);
  CHECK(double(rotor.rotor().w.z) == Approx(3).epsilon(tolerance(1e-10, 1e-5)));
  CHECK(double(rotor.hinge->motor_force()) == 0);
}

TEST_CASE("a motor changed between steps pushes the new way at once") {
  for (bool warm : {false, true}) {
    Rotor rotor;
    rotor.stepping.warm_start = warm;
    const double steps[][3] = {{3, 6, 0.1}, {-3, 6, 0}, {-3, 12, -0.2}, {0, 600, 0}, {50, 60, 1}};
    for (const auto& [speed, strength, expected] : steps) {
      rotor.hinge->set_motor(real(speed), real(strength));
      rotor.run(1, h);
      CHECK(std::abs(double(rotor.rotor().w.z) - expected) < tolerance(1e-12, 1e-5));
    }
  }
}

TEST_CASE("S4m a motor of 500 N m has the cube at 0.95 of its speed after 1.3775 s") {
  for (bool whole : {true, false})
    for (bool warm : {false, true}) {
      Crane crane(vec3(0, 1, 0));
      crane.hinge->whole = whole;
      crane.hinge->set_motor(3, 500);
      crane.stepping.warm_start = warm;
      double before = 0, crossing = 0;
      for (int n = 0; n < 300; ++n) {
        step(crane.world, crane.solver, h, crane.stepping);
        const double now = double(crane.hinge->speed(crane.world.bodies));
        if (before < 2.85 && now >= 2.85)
          crossing = (n + (2.85 - before) / (now - before)) * double(h);
        before = now;
      }
      CHECK(crossing == Approx(1.3775).epsilon(0.02));
      CHECK(before == Approx(3).epsilon(1e-3));  // the pull towards the hinge has the last word
    }
}

TEST_CASE("X17 a door with limits and a motor is as good after 1e5 steps as in its first minute") {
  for (bool whole : {true, false}) {
    World world;
    const BodyId frame = world.add(static_body(vec3(0)));
    const BodyId leaf =
        world.add(box(20, vec3(1, 2, real(0.05)), vec3(real(0.5), 0, 0)));
    auto& door = world.add<HingeJoint>(frame, leaf, vec3(0), vec3(0, 1, 0));
    door.whole = whole;
    door.set_limits(0, 110 * degree);
    SequentialImpulses solver;
    solver.iterations = 10;
    struct { double gap = 0, axis = 0, energy = 0, low = 0, high = 0; } first, now;
    const int minute = 3600, steps = 100800;
    for (int n = 0; n < steps; ++n) {
      if (n % 300 == 0) door.set_motor(n % 600 ? -2 : 2, 50);
      step(world, solver, h);
      const Body &a = world.bodies[frame], &b = world.bodies[leaf];
      const double angle = double(door.position(world.bodies) / degree);
      now.gap = std::max(now.gap, double(length(door.first.error(a, b))));
      now.axis = std::max(now.axis, double(std::hypot(door.second.error(a, b)[0],
                                                      door.second.error(a, b)[1])));
      now.energy = std::max(now.energy, kinetic_energy(b) + 20 * 9.81 * double(b.x.y));
      now.low = std::min(now.low, angle);
      now.high = std::max(now.high, angle);
      if ((n + 1) % minute != 0) continue;
      if (n + 1 == minute) first = now;
      if (n + 1 < steps) now = {};
    }
    CHECK(first.energy > 10);  // it does swing, from one limit to the other
    CHECK(std::abs(first.high - 110) < (whole ? 0.01 : 0.5));
    CHECK(now.gap < 1.001 * first.gap + tolerance(1e-12, 1e-6));
    CHECK(now.axis < 1.001 * first.axis + tolerance(1e-12, 1e-6));
    CHECK(now.energy == Approx(first.energy).epsilon(tolerance(1e-6, 1e-3)));
    CHECK(now.low > first.low - tolerance(1e-9, 1e-4));
    CHECK(now.high < first.high + tolerance(1e-9, 1e-4));
  }
}

TEST_CASE("a hinge between two static bodies has no row and no force") {
  for (bool warm : {false, true}) {
    World world;
    const BodyId a = world.add(static_body(vec3(0))), b = world.add(static_body(vec3(5, 0, 0)));
    auto& hinge = world.add<HingeJoint>(a, b, vec3(1, 0, 0), vec3(0, 1, 0));
    hinge.set_limits(-1, 1);
    hinge.set_motor(3, 500);
    world.bodies[b].q = rotation(vec3(0, 3, 0));
    const Body before_a = world.bodies[a], before_b = world.bodies[b];
    SequentialImpulses solver;
    StepOptions stepping{.warm_start = warm};
    for (int n = 0; n < 100; ++n) step(world, solver, h, stepping);
    CHECK(world.blocks.list.empty());
    CHECK(same_bits(world.bodies[a], before_a));
    CHECK(same_bits(world.bodies[b], before_b));
    CHECK(double(hinge.motor_force()) == 0);
    CHECK(double(hinge.limit_force()) == 0);
  }
}

TEST_CASE("the former way to add a hinge, with the world's bodies, makes the same rows") {
  World worlds[2];
  for (World& world : worlds) {
    world.add(static_body(vec3(0)));
    world.add(box(1, vec3(1), vec3(1, 0, 0)));
  }
  const auto of = [](World& world, int slot) { return world.bodies.id(slot); };
  const vec3 anchor(real(0.5), 0, 0), axis(0, 0, 1);
  worlds[0].add<HingeJoint>(of(worlds[0], 0), of(worlds[0], 1), anchor, axis);
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
  worlds[1].add<HingeJoint>(worlds[1].bodies, of(worlds[1], 0), of(worlds[1], 1), anchor, axis);
#pragma GCC diagnostic pop
  std::vector<Row> rows[2];
  for (int k = 0; k < 2; ++k) {
    SequentialImpulses solver;
    step(worlds[k], solver, h);
    rows[k] = worlds[k].blocks.J;
  }
  REQUIRE((rows[0].size() == 5 && rows[1].size() == 5));
  for (std::size_t i = 0; i < 5; ++i)
    CHECK((rows[0][i].v1 == rows[1][i].v1 && rows[0][i].w1 == rows[1][i].w1 &&
           rows[0][i].v2 == rows[1][i].v2 && rows[0][i].w2 == rows[1][i].w2));
}
