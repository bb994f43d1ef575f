// Limits of a hinge: hit at any speed, yanked at by a neighbour, pushed into by a motor, narrow,
// equal, beyond a full turn, and changed while it moves (cases X11 and X13).
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;

// A rotor at rest, 5 degrees from its limits, with a weight on a ball joint at its end that is
// thrown away at `speed`.
struct Yanked : Rotor {
  Yanked(real weight, real speed) : Rotor(real(0.5)) {
    hinge->set_limits(-5 * degree, 5 * degree);
    const BodyId thrown =
        world.add(body_with(weight, vec3(weight / 6), vec3(real(1.5), 0, 0)));
    world.add<BallJoint>(body, thrown,
                         point_at(world.bodies[body], world.bodies[thrown], vec3(1, 0, 0)));
    world.bodies[thrown].v = vec3(0, speed, 0);
  }
  // How far beyond its limits it was in the first 5 s [degrees].
  double beyond() {
    double largest = -5;
    for (int n = 0; n < 300; ++n) {
      step(world, solver, h, stepping);
      REQUIRE(all_finite(world));
      largest = std::max(largest, std::abs(in_degrees()) - 5);
    }
    return largest;
  }
};

// Where a crane is in a run of 60 s: how far it got, and between what it was after 10 s.
struct Run {
  double highest = 0, low = 1e9, high = -1e9, speed = 0;
  explicit Run(Crane& crane) {
    for (int n = 0; n < 3600; ++n) {
      step(crane.world, crane.solver, h, crane.stepping);
      const double angle = crane.in_degrees();
      highest = std::max(highest, std::abs(angle));
      if (n < 600) continue;
      low = std::min(low, angle);
      high = std::max(high, angle);
      speed = std::max(speed, std::abs(double(crane.hinge->speed(crane.world.bodies))));
    }
  }
};

}  // namespace

TEST_CASE("X11 a rotor stops at its limit however fast it comes and however far that is") {
  for (double limit : {45.0, 170.0, 179.0, 350.0, 720.0})
    for (double speed : {5.0, 30.0, 100.0})
      for (real lever : {real(0), real(0.5)})
        for (bool whole : {true, false})
          for (bool warm : {false, true})
            for (double way : {1.0, -1.0}) {
              CAPTURE(limit, speed, lever, whole, warm, way);
              Rotor rotor(lever, real(way * speed));
              rotor.hinge->whole = whole;
              rotor.hinge->set_limits(-real(limit) * degree, real(limit) * degree);
              rotor.stepping.warm_start = warm;
              double furthest = 0;
              const int steps = int(60 * (limit * double(degree) / speed + 0.5));
              for (int n = 0; n < steps; ++n) {
                step(rotor.world, rotor.solver, h, rotor.stepping);
                furthest = std::max(furthest, way * rotor.in_degrees());
              }
              const double near = whole ? 0.01 : 0.5;
              CHECK(std::abs(furthest - limit) < near);
              CHECK(std::abs(way * rotor.in_degrees() - limit) < near);
              CHECK(std::abs(double(rotor.rotor().w.z)) < 1e-3);
            }
}

TEST_CASE("X11 a joint at rest beside its limit is held when a neighbour of its weight yanks it") {
  for (bool warm : {false, true})
    for (real way : {real(1), real(-1)}) {
      for (real speed : {real(10), real(100)}) {
        Yanked joint(1, way * speed);
        joint.stepping.warm_start = warm;
        CHECK(joint.beyond() < 0.01);
      }
      for (real speed : {real(10), real(100)}) {
        Yanked apart(1, way * speed);
        apart.hinge->whole = false;
        apart.stepping.warm_start = warm;
        CHECK(apart.beyond() < 0.5);
      }
    }
}

TEST_CASE(
    "X11 yanked by ten times its weight a joint passes its limit until the iterations suffice") {
  // two joints in turn, as any chain: 30 iterations leave degrees, 300 leave nothing
  for (bool whole : {true, false}) {
    const auto beyond = [&](int iterations, real speed) {
      Yanked joint(10, speed);
      joint.hinge->whole = whole;
      joint.solver.iterations = iterations;
      return joint.beyond();
    };
    CHECK(beyond(30, 10) < (whole ? 0.5 : 1.0));
    CHECK(beyond(30, 100) < (whole ? 5.0 : 15.0));
    CHECK(beyond(30, 100) > 1);  // so much is true: it is not held at 30
    CHECK(beyond(300, 10) < 0.01);
    CHECK(beyond(300, 100) < 0.01);
  }
}

TEST_CASE("S4l a cube that falls onto its limit stays there") {
  for (bool warm : {false, true})
    for (int iterations : {1, 30}) {
      Crane crane(vec3(1, 0, 0));
      crane.hinge->set_limits(-60 * degree, 60 * degree);
      crane.stepping.warm_start = warm;
      crane.solver.iterations = iterations;
      const Run run(crane);
      CHECK(std::abs(run.highest - 60) < 0.01);
      CHECK(std::abs(run.low - 60) < 0.01);
      CHECK(std::abs(run.high - 60) < 0.01);
    }
}

TEST_CASE(
    "S4l with blocks apart the cube overshoots and rests within half a degree at 30 iterations") {
  Crane crane(vec3(1, 0, 0));
  crane.hinge->set_limits(-60 * degree, 60 * degree);
  crane.hinge->whole = false;
  const Run run(crane);
  CHECK(run.highest - 60 < 0.5);
  CHECK(run.highest - 60 > 0.1);  // so it is: this is the purpose of the whole joint
  CHECK(std::abs(run.low - 60) < 0.5);
  CHECK(run.high - run.low < tolerance(1e-6, 1e-4));
  Crane once(vec3(1, 0, 0));
  once.hinge->set_limits(-60 * degree, 60 * degree);
  once.hinge->whole = false;
  once.solver.iterations = 1;
  CHECK(Run(once).highest - 60 > 10);  // one iteration is not enough for blocks apart
}

TEST_CASE("X13 and S4ml a motor that pushes into a limit neither drifts nor chatters in a minute") {
  for (bool warm : {false, true})
    for (int iterations : {1, 30}) {
      Crane crane(vec3(0, 1, 0));
      crane.hinge->set_motor(3, 500);
      crane.hinge->set_limits(-60 * degree, 60 * degree);
      crane.stepping.warm_start = warm;
      crane.solver.iterations = iterations;
      const Run run(crane);
      CHECK(std::abs(run.highest - 60) < 0.01);
      CHECK(std::abs(run.low - 60) < 0.01);
      CHECK(std::abs(run.high - 60) < 0.01);
      CHECK(run.high - run.low < tolerance(1e-9, 1e-4));
      CHECK(run.speed < tolerance(1e-9, 1e-4));
      CHECK(double(crane.hinge->motor_force()) == Approx(500).epsilon(tolerance(1e-9, 1e-4)));
      CHECK(double(crane.hinge->limit_force()) == Approx(-500).epsilon(tolerance(1e-9, 1e-4)));
    }
}

TEST_CASE("X13 and S4ml with blocks apart the motor is held at the limit at 30 iterations") {
  for (bool warm : {false, true}) {
    Crane crane(vec3(0, 1, 0));
    crane.hinge->set_motor(3, 500);
    crane.hinge->set_limits(-60 * degree, 60 * degree);
    crane.hinge->whole = false;
    crane.stepping.warm_start = warm;
    const Run run(crane);
    CHECK(run.highest - 60 < 0.5);
    CHECK(std::abs(run.low - 60) < 0.01);
    CHECK(std::abs(run.high - 60) < 0.01);
    CHECK(run.speed < tolerance(1e-9, 1e-4));
  }
}

TEST_CASE("equal limits hold the angle against a motor and against a blow either way") {
  for (bool whole : {true, false})
    for (bool warm : {false, true})
      for (real blow : {real(30), real(-30)}) {
        Rotor rotor(real(0.5));
        rotor.hinge->whole = whole;
        rotor.hinge->set_limits(20 * degree, 20 * degree);
        rotor.hinge->set_motor(blow, 5);
        rotor.stepping.warm_start = warm;
        rotor.run(120, h);  // comes up from 0 to 20 degrees by the error fed back
        CHECK(rotor.in_degrees() == Approx(20).epsilon(tolerance(1e-6, 1e-5)));
        rotor.rotor().w = vec3(0, 0, blow);
        rotor.run(1, h);
        CHECK(std::abs(rotor.in_degrees() - 20) < (whole ? 0.01 : 0.5));
        rotor.run(120, h);
        CHECK(rotor.in_degrees() == Approx(20).epsilon(tolerance(1e-6, 1e-5)));
        CHECK(double(rotor.hinge->limit_force()) ==
              Approx(blow > 0 ? -5 : 5).epsilon(tolerance(1e-4, 1e-3)));
      }
}

TEST_CASE("narrow limits stop a rotor between them at one and then at the other") {
  for (bool whole : {true, false})
    for (double width : {1.0, 0.1}) {
      Rotor rotor(0, 100);  // 95 degrees a step
      rotor.hinge->whole = whole;
      rotor.hinge->set_limits(0, real(width) * degree);
      rotor.run(1, h);
      CHECK(rotor.in_degrees() == Approx(width).epsilon(tolerance(1e-9, 1e-4)));
      rotor.rotor().w = vec3(0, 0, -100);
      rotor.run(1, h);
      CHECK(std::abs(rotor.in_degrees()) < tolerance(1e-9, 1e-4));
    }
}

TEST_CASE("limits of three turns and a bit are kept on both sides") {
  for (real way : {real(1), real(-1)}) {
    Rotor rotor(real(0.2));
    rotor.hinge->set_limits(-1100 * degree, 1100 * degree);
    rotor.hinge->set_motor(way * 20, 50);
    rotor.run(180, h);
    CHECK(rotor.in_degrees() == Approx(1100 * double(way)).epsilon(tolerance(1e-9, 1e-6)));
    rotor.hinge->set_motor(-way * 20, 50);
    rotor.run(240, h);
    CHECK(rotor.in_degrees() == Approx(-1100 * double(way)).epsilon(tolerance(1e-9, 1e-6)));
  }
}

TEST_CASE("limits that close in on a rotor push it and limits that open let it go") {
  for (bool whole : {true, false})
    for (bool warm : {false, true}) {
      Rotor rotor(0);
      rotor.hinge->whole = whole;
      rotor.stepping.warm_start = warm;
      rotor.hinge->set_limits(10 * degree, 30 * degree);  // 10 degrees beyond the lower one
      rotor.run(1, h);
      CHECK(rotor.in_degrees() == Approx(2).epsilon(tolerance(1e-9, 1e-4)));  // beta 0.2
      rotor.hinge->clear_limits();
      rotor.rotor().w = vec3(0);
      rotor.run(10, h);
      CHECK(rotor.in_degrees() == Approx(2).epsilon(tolerance(1e-9, 1e-4)));
      CHECK(double(rotor.hinge->limit_force()) == 0);
      rotor.hinge->set_limits(-30 * degree, 0);  // now beyond the upper one
      rotor.run(1, h);
      CHECK(rotor.in_degrees() == Approx(1.6).epsilon(tolerance(1e-9, 1e-4)));
      CHECK(double(rotor.hinge->limit_force()) < 0);
      rotor.rotor().w = vec3(0, 0, -3);  // comes back by itself: not braked
      rotor.run(1, h);
      CHECK(double(rotor.rotor().w.z) == Approx(-3).epsilon(tolerance(1e-9, 1e-5)));
      CHECK(double(rotor.hinge->limit_force()) == Approx(0).margin(tolerance(1e-9, 1e-4)));
    }
}
