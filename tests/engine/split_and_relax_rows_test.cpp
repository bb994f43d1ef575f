// Relax iterations and split impulses with limits, motors, contacts, springs and soft rows.
#include "contacts/ground_contact.h"
#include "tests/oracle/test.h"
#include "tests/oracle/track.h"

namespace {

const real h = real(1) / 60;

}  // namespace

// ---- rows with bounds ---------------------------------------------------------------------------

TEST_CASE("a rope pulled in by relaxing or splitting leaves its ball at rest") {
  // fed back the ball keeps 0.9 m/s: a rope cannot brake. Relaxed, its own pull is taken back.
  for (const auto& [solver, left] : {std::pair{feeding_back(), 0.9}, {relaxing(), 0.0},
                                     {splitting(), 0.0}}) {
    Track track({0, real(-1.1)}, {1});  // body 2 is 1.1 m before body 1, at most 1 m is allowed
    Along& rope = track.join(0, 1, -1, true);
    rope.beta = real(0.15);
    TwoPassImpulses own = solver;
    step(track.world, own, h);
    CHECK(track.x(1) == Approx(-1.085).epsilon(tolerance(1e-12, 1e-6)));
    CHECK(double(track.v(1)) == Approx(left).margin(tolerance(1e-13, 1e-5)));
    CHECK(double(rope.impulse) == Approx(left).margin(tolerance(1e-13, 1e-5)));
    CHECK(double(rope.impulse) >= 0);
  }
}

TEST_CASE("what leaves a violated limit by itself is not pushed, and goes on as it came") {
  for (TwoPassImpulses solver : {relaxing(), splitting()}) {
    Track track({0, real(0.99)}, {1});
    Along& limit = track.join(0, 1, 1, true);
    track.v(1) = real(0.3);  // beta asks for 0.12 m/s
    step(track.world, solver, h);
    CHECK(track.x(1) == Approx(0.995).epsilon(tolerance(1e-12, 1e-6)));
    CHECK(double(track.v(1)) == Approx(0.3));
    CHECK(limit.impulse == 0);
  }
}

TEST_CASE("what runs into a limit lands on it and is stopped there") {
  for (TwoPassImpulses solver : {relaxing(), splitting()}) {
    Track track({0, real(1.01)}, {2});
    track.join(0, 1, 1, true);
    track.v(1) = -3;  // 5 cm a step, and 1 cm to go
    step(track.world, solver, h);
    CHECK(track.x(1) == Approx(1).epsilon(tolerance(1e-12, 1e-6)));
    for (int n = 0; n < 10; ++n) step(track.world, solver, h);
    CHECK(track.x(1) == Approx(1).epsilon(tolerance(1e-12, 1e-6)));
    CHECK(std::abs(double(track.v(1))) < tolerance(1e-12, 1e-5));
  }
}

TEST_CASE("a split correction stops at a limit that lies ahead, together with the velocities") {
  for (const real speed : {real(0), real(-0.03)}) {  // of the 1 mm that is left, 0.5 mm a step
    Track track({0, real(1.001), real(1.8)}, {1, 1});
    track.join(1, 2, real(0.9)).beta = 1;  // moves the two apart, by 0.1 m
    Along& limit = track.join(0, 1, 1, true);
    track.v(1) = track.v(2) = speed;
    TwoPassImpulses solver = splitting(300, 300);
    step(track.world, solver, h);
    CHECK(track.x(1) == Approx(1).epsilon(tolerance(1e-9, 1e-6)));
    CHECK(track.x(2) == Approx(1.9).epsilon(tolerance(1e-9, 1e-6)));
    CHECK(double(track.v(1)) == Approx(double(speed)));
    CHECK(double(track.v(2)) == Approx(double(speed)));
    CHECK(limit.impulse == 0);
  }
}

TEST_CASE("a target rate beside a position is a velocity, and the correction is none") {
  for (const bool split : {true, false}) {
    Track track({0, real(1.1)}, {2});
    Along& joint = track.join(0, 1, 1);
    joint.rate = real(0.3);
    joint.beta = real(0.5);
    TwoPassImpulses solver = split ? splitting() : relaxing();
    step(track.world, solver, h);
    CHECK(double(track.v(1)) == Approx(0.3).epsilon(tolerance(1e-12, 1e-5)));
    CHECK(track.x(1) == Approx(1.05 + 0.3 / 60).epsilon(tolerance(1e-12, 1e-6)));
  }
}

TEST_CASE("row by row, a block's target rate is that of its last row alone") {
  World world = weightless();
  const BodyId wall = world.add(static_body(vec3(0)));
  const BodyId id = world.add(ball(1, 1, vec3(0)));
  auto& joint = world.add<AnyJoint<2>>(wall, id);
  joint.J[0] = {vec3(-1, 0, 0), vec3(0), vec3(1, 0, 0), vec3(0)};
  joint.J[1] = {vec3(0, -1, 0), vec3(0), vec3(0, 1, 0), vec3(0)};
  joint.C = {real(0.1), real(0.2)};
  joint.target = {.beta = real(0.5), .rate = real(0.3)};
  for (TwoPassImpulses solver : {relaxing(), splitting()}) {
    world.bodies[id].x = world.bodies[id].v = vec3(0);
    step(world, solver, h, {.row_by_row = true});
    CHECK(double(length(world.bodies[id].v - vec3(0, real(0.3), 0))) < tolerance(1e-13, 1e-6));
    CHECK(double(length(world.bodies[id].x - vec3(real(-0.05), real(-0.095), 0))) <
          tolerance(1e-13, 1e-6));
  }
}

TEST_CASE("a motor gives no more than its strength over both solves of a step") {
  for (TwoPassImpulses solver : {relaxing(5), splitting(5)}) {
    Rotor rotor;
    rotor.solver = solver;
    rotor.hinge->set_motor(100, 2);
    rotor.run(30, h);
    CHECK(double(rotor.hinge->motor_force()) == Approx(2));
    CHECK(double(rotor.rotor().w.z) == Approx(2 * 0.5).epsilon(tolerance(1e-12, 1e-5)));
    rotor.hinge->set_motor(1, 2);  // it is at its speed: the motor holds it and turns on
    const double angle = rotor.angle();
    rotor.run(60, h);
    CHECK(rotor.angle() - angle == Approx(1).epsilon(tolerance(1e-9, 1e-4)));
  }
}

TEST_CASE("a split correction does not fight a brake") {
  Track track({0, real(1.1)}, {1});
  track.join(0, 1, 1);
  World& world = track.world;
  auto& slider = world.add<SliderJoint>(track.ids[0], track.ids[1],
                                        vec3(real(1.1), 0, 0), vec3(1, 0, 0));
  slider.set_motor(0, 1000);  // it is solved after the joint
  TwoPassImpulses solver = splitting();
  step(world, solver, h);
  CHECK(track.x(1) == Approx(1.08).epsilon(tolerance(1e-12, 1e-6)));
  CHECK(slider.motor_force() == 0);
  CHECK(solver.prepared_count() == int(world.blocks.list.size()));
}

TEST_CASE("a motor that presses against a violated limit feels its own torque and no more") {
  for (TwoPassImpulses solver : {relaxing(200, 200), splitting(200, 200)}) {
    for (const bool whole : {true, false}) {
      Rotor rotor(1);
      rotor.solver = solver;
      rotor.hinge->whole = whole;
      rotor.hinge->set_limits(-1, 0);
      rotor.run(1, h);
      rotor.hinge->set_limits(-1, real(-0.02));
      rotor.hinge->set_motor(3, 4);
      for (int n = 1; n <= 10; ++n) {
        rotor.run(1, h);
        CHECK(rotor.angle() == Approx(-0.02 * (1 - std::pow(0.8, n))).epsilon(1e-3));
        CHECK(std::abs(double(rotor.rotor().w.z)) < tolerance(1e-6, 1e-4));
        CHECK(double(rotor.hinge->motor_force()) == Approx(4).epsilon(tolerance(1e-12, 1e-5)));
        CHECK(double(rotor.hinge->limit_force()) == Approx(-4).epsilon(tolerance(1e-5, 1e-3)));
      }
    }
  }
}

TEST_CASE("a limit that is found late is kept by both") {
  for (TwoPassImpulses solver : {relaxing(50, 50), splitting(50, 50)}) {
    Track track({0, real(1.5)}, {1});
    World& world = track.world;
    const BodyId hammer = world.add(ball(1, real(0.1), vec3(2, 1, 0)));
    auto& slider = world.add<SliderJoint>(track.ids[0], track.ids[1],
                                          vec3(real(1.5), 0, 0), vec3(1, 0, 0));
    slider.set_limits(real(-0.01), 1);  // 1 cm away, and the slider stands still
    world.add<Along>(track.ids[1], hammer, real(0.5));
    world.bodies[hammer].v.x = -4;  // it drives the slider at 2 m/s
    step(world, solver, h);
    CHECK(double(slider.position(world.bodies)) == Approx(-0.01).epsilon(tolerance(1e-5, 1e-3)));
    CHECK(slider.limit_force() > 0);
  }
}

TEST_CASE("a box that lies too deep comes up by beta a step and does not hop") {
  for (TwoPassImpulses solver : {relaxing(30, 30), splitting(30, 30)}) {
    World world;
    const BodyId ground = world.add(static_body(vec3(0)));
    const BodyId id = world.add(box(2, vec3(1), vec3(0, real(0.49), 0)));
    auto& contact = world.add<GroundContact>(ground, id, Top{}, box_outline(vec3(1)));
    contact.beta = real(0.2);
    const Body& body = world.bodies[id];
    double highest = 0, fastest = 0;
    for (int n = 1; n <= 60; ++n) {
      step(world, solver, h);
      if (n == 5) CHECK(double(body.x.y) == Approx(0.5 - 0.01 * std::pow(0.8, 5)).margin(1e-5));
      highest = std::max(highest, double(body.x.y));
      fastest = std::max(fastest, double(length(body.v)));
    }
    CHECK(highest < 0.5 + 1e-5);
    CHECK(fastest < tolerance(1e-4, 1e-3));
  }
}

// ---- softness -----------------------------------------------------------------------------------

TEST_CASE("a softened joint keeps the same fraction of its error every step, and no velocity") {
  // from rest an implicit spring loses the part (h omega)^2 / (1 + 2 zeta h omega + (h omega)^2)
  for (const auto& [frequency, damping] : {std::pair{10.0, 1.0}, {10.0, 10.0}, {60.0, 5.0}})
    for (TwoPassImpulses solver : {relaxing(), splitting(3)}) {
      Track track({0, real(1.2)}, {4});
      track.join(0, 1, 1);
      const double a = 2 * std::numbers::pi * frequency / 60;
      const double share = a * a / (1 + 2 * damping * a + a * a);
      double C = track.x(1) - 1;
      for (int n = 0; n < 20; ++n) {
        step(track.world, solver, h, {.frequency = real(frequency), .damping = real(damping)});
        C *= 1 - share;
        CHECK(track.x(1) - 1 == Approx(C).margin(tolerance(1e-13, 1e-6)));
        CHECK(std::abs(double(track.v(1))) < tolerance(1e-13, 1e-5));
      }
    }
}

TEST_CASE("a heavily damped joint halves its error in 2 zeta ln 2 / omega, whatever the step") {
  const double frequency = 30, damping = 20, omega = 2 * std::numbers::pi * frequency;
  for (const real substeps : {real(1), real(4)}) {
    Track track({0, real(1.1)}, {4});
    track.join(0, 1, 1);
    TwoPassImpulses solver = relaxing();
    const real half_time = real(2 * damping * std::log(2) / omega);  // 0.147 s
    for (int n = 0; n < int(9 * substeps); ++n)
      step(track.world, solver, half_time / (9 * substeps),
           {.frequency = real(frequency), .damping = real(damping)});
    CHECK(track.x(1) - 1 == Approx(0.05).epsilon(0.05));
  }
}

TEST_CASE("relaxed, a softened joint sags as far as its spring and pulls with the whole weight") {
  for (const bool warm : {false, true}) {
    World world;
    const BodyId hook = world.add(static_body(vec3(0)));
    const BodyId id = world.add(ball(3, real(0.1), vec3(0)));
    auto& joint = world.add<BallJoint>(hook, id, Point{vec3(0), vec3(0)});
    TwoPassImpulses solver = relaxing(2);
    for (int n = 0; n < 200; ++n)
      step(world, solver, h, {.warm_start = warm, .frequency = 10, .damping = 2});
    const double omega = 20 * std::numbers::pi;
    CHECK(double(world.bodies[id].x.y) == Approx(-9.81 / (omega * omega)).epsilon(1e-4));
    CHECK(double(joint.impulse()[1]) == Approx(3 * 9.81 / 60).epsilon(1e-4));
  }
}

TEST_CASE("a limit that is found late is as soft as one whose row is there from the beginning") {
  // a hammer drives a slider that rests 1 cm before its limit
  const auto place = [](bool late, real frequency) {
    Track track({0, real(1.5)}, {1});
    World& world = track.world;
    const BodyId hammer = world.add(ball(1, real(0.1), vec3(2, 1, 0)));
    auto& slider = world.add<SliderJoint>(track.ids[0], track.ids[1],
                                          vec3(real(1.5), 0, 0), vec3(1, 0, 0));
    if (late) slider.set_limits(real(-0.01), 1);
    else track.join(0, 1, real(1.49), true);
    world.add<Along>(track.ids[1], hammer, real(0.5));
    world.bodies[hammer].v.x = -4;
    TwoPassImpulses solver = feeding_back(500);
    step(world, solver, h, {.frequency = frequency});
    return track.x(1);
  };
  for (const real frequency : {real(5), real(20)}) {
    CHECK(place(true, frequency) == Approx(place(false, frequency)).epsilon(tolerance(1e-9, 1e-5)));
    CHECK(place(true, frequency) < 1.489);  // it gives way
  }
  CHECK(place(true, 0) == Approx(1.49).epsilon(tolerance(1e-9, 1e-5)));
}

TEST_CASE("a spring of the joint's own swings on as a spring with both") {
  const auto swing = [](TwoPassImpulses solver) {
    Track track({0, real(1.3), real(2.4)}, {2, 3});
    Along& spring = track.join(0, 1, 1);
    spring.frequency = 2;
    spring.damping = real(0.05);
    track.join(1, 2, 1);
    for (int n = 0; n < 45; ++n)
      step(track.world, solver, h, {.frequency = real(n < 20 ? 40 : 0)});
    return std::pair{track.x(1), double(track.v(1))};
  };
  const auto [x, v] = swing(feeding_back(100));
  CHECK(std::abs(v) > 0.1);
  for (const TwoPassImpulses& solver : {relaxing(100, 100), splitting(100, 100)}) {
    const auto [x_now, v_now] = swing(solver);
    CHECK(std::abs(x_now - x) < 0.02);  // the joint behind it comes back in another way
    CHECK(std::abs(v_now - v) < 0.1);
  }
  Track alone({0, real(1.3)}, {2}), split({0, real(1.3)}, {2}), relaxed({0, real(1.3)}, {2});
  TwoPassImpulses plain = feeding_back(), splits = splitting(), relaxes = relaxing();
  for (Track* track : {&alone, &split, &relaxed}) track->join(0, 1, 1).frequency = 2;
  for (int n = 0; n < 30; ++n) {
    step(alone.world, plain, h);
    step(split.world, splits, h);
    step(relaxed.world, relaxes, h);
    CHECK(split.x(1) == alone.x(1));
    CHECK(relaxed.x(1) == Approx(alone.x(1)).epsilon(tolerance(1e-12, 1e-5)));
  }
}
