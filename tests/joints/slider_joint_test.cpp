// The slider as the engine runs it: its limits hold, its motor pushes with newtons, and whatever
// happens between two free bodies keeps their momentum.
#include "engine/instruments/measure.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;
const vec3 along = normalize(vec3(2, -1, real(0.5)));

// A body of 2 kg on a slider, the anchor beside both centres, both bodies turned; body 1 is a wall
// or a free body of 3 kg. No gravity.
struct Piston {
  World world;
  BodyId one, two;
  SliderJoint* slider;
  SequentialImpulses solver;
  StepOptions stepping{};

  explicit Piston(bool free = false, bool isotropic = false) {
    world.gravity = vec3(0);
    const vec3 moments = isotropic ? vec3(1) : vec3(1, real(0.7), real(0.5));
    const quat q1 = rotation(vec3(real(0.4), -1, real(0.3))), q2 = rotation(vec3(1, 2, 0));
    const vec3 x1(real(0.2), real(-0.3), real(0.1));
    one = world.add(free ? body_with(3, real(2) * moments, x1, q1) : static_body(x1, q1));
    two = world.add(body_with(2, moments, vec3(real(0.9), real(0.4), real(-0.7)), q2));
    slider = &world.add<SliderJoint>(one, two,
                                     vec3(real(0.5), real(0.3), real(0.6)), along);
  }
  Body& body() { return world.bodies[two]; }
  double displacement() const { return double(slider->position(world.bodies)); }
  double speed() const { return double(slider->speed(world.bodies)); }
  void run(int steps, real step_length = h) {
    for (int k = 0; k < steps; ++k) step(world, solver, step_length, stepping);
  }
};

struct Momenta {
  dvec3 linear{0}, angular{0};  // about the origin
};
Momenta momenta(const World& world) {
  Momenta sum;
  for (const Body& body : snapshot(world.bodies)) {
    if (body.is_static()) continue;
    const dvec3 p = dvec3(body.v) / double(body.inverse_mass);
    sum.linear += p;
    sum.angular += cross(dvec3(body.x), p) +
                   inertia_of(body) * dvec3(body.w);
  }
  return sum;
}

}  // namespace

TEST_CASE("a slider stops at its limits however fast it comes") {
  for (double speed : {1.0, 30.0, 300.0})
    for (double way : {1.0, -1.0})
      for (bool whole : {true, false})
        for (bool warm : {false, true})
          for (int iterations : {1, 30}) {
            CAPTURE(speed, way, whole, warm, iterations);
            if (!whole && iterations == 1) continue;
            Piston piston;
            piston.slider->whole = whole;
            piston.slider->set_limits(-1, 2);
            piston.stepping.warm_start = warm;
            piston.solver.iterations = iterations;
            piston.body().v = real(way * speed) * along;
            const double limit = way > 0 ? 2 : 1;
            double furthest = 0;
            for (int step = 0; step < int(60 * (limit / speed + 1)); ++step) {
              piston.run(1);
              furthest = std::max(furthest, way * piston.displacement());
            }
            const double size = std::max(1.0, speed);
            CHECK(std::abs(furthest - limit) < size * (whole ? tolerance(1e-11, 3e-6) : 1e-4));
            if (!whole) continue;  // apart, the rows that had not settled throw it back a little
            CHECK(std::abs(way * piston.displacement() - limit) < size * tolerance(1e-11, 3e-6));
            CHECK(std::abs(piston.speed()) < size * tolerance(1e-11, 1e-5));
          }
}

TEST_CASE("a slider's motor of F newtons has m kilograms at F t over m after t") {
  for (bool whole : {true, false})
    for (bool warm : {false, true})
      for (int rate : {60, 240, 1000})
        for (int iterations : {1, 10, 100}) {
          CAPTURE(whole, warm, rate, iterations);
          Piston piston;
          piston.slider->whole = whole;
          piston.slider->set_motor(100, 5);
          piston.stepping.warm_start = warm;
          piston.solver.iterations = iterations;
          piston.run(rate, real(1) / real(rate));
          CHECK(double(dot(piston.body().v, along)) ==
                Approx(2.5).epsilon(tolerance(whole ? 1e-9 : 1e-6, 5e-3)));
          CHECK(double(piston.slider->motor_force()) ==
                Approx(5).epsilon(tolerance(1e-9, 5e-3)));
        }
}

TEST_CASE("a slider's motor moves two free bodies by its force over their reduced mass") {
  for (int iterations : {30, 100}) {
    Piston piston(true);
    piston.slider->set_motor(100, 6);  // 1/3 + 1/2 kg^-1 if nothing turned
    piston.solver.iterations = iterations;
    const Body one = piston.world.bodies[piston.one], two = piston.body();
    begin_step(piston.world, piston.solver, h, piston.stepping);
    for (int k = 0; k < iterations; ++k) piston.solver.iterate(piston.world.bodies);
    // the six rows solved by the oracle: what a force along the line does when all else holds
    System system = system_of(piston.world.blocks, 2);
    const Dense W = inverse_masses({one, two}), A = system.J * W * system.J.transpose();
    const Dense rigid = A.block(1, 1, 5, 5), cross = A.block(0, 1, 1, 5);
    const double K = A(0, 0) - (cross * inverse_of(rigid) * cross.transpose())(0, 0);
    CHECK(piston.speed() == Approx(6 * double(h) * K).epsilon(tolerance(1e-9, 1e-4)));
  }
}

TEST_CASE("a stalled motor of a slider pushes as hard as the limit pushes back") {
  for (bool whole : {true, false})
    for (bool warm : {false, true})
      for (real way : {real(1), real(-1)}) {
        Piston piston;
        piston.slider->whole = whole;
        piston.slider->set_limits(real(-0.1), real(0.1));
        piston.slider->set_motor(way * 3, 40);
        piston.stepping.warm_start = warm;
        piston.run(300);
        CHECK(double(piston.slider->motor_force()) ==
              Approx(40 * double(way)).epsilon(tolerance(1e-9, 1e-4)));
        CHECK(double(piston.slider->limit_force()) ==
              Approx(-40 * double(way)).epsilon(tolerance(1e-6, 1e-3)));
        CHECK(piston.displacement() == Approx(0.1 * double(way)).epsilon(whole ? 1e-4 : 1e-2));
        CHECK(double(length(piston.body().w)) < tolerance(1e-6, 1e-3));
      }
}

TEST_CASE("a driven slider between two free bodies keeps their momentum about every point") {
  for (bool whole : {true, false})
    for (bool warm : {false, true})
      for (int iterations : {1, 30}) {
        Piston piston(true, true);  // bodies alike about every axis: no gyroscopic rounding
        piston.slider->whole = whole;
        piston.slider->set_limits(real(-0.5), real(0.7));
        piston.stepping.warm_start = warm;
        piston.solver.iterations = iterations;
        piston.world.bodies[piston.one].w = vec3(real(0.5), -1, real(0.3));
        piston.body().v = vec3(1, real(0.2), real(-0.4));
        const Momenta before = momenta(piston.world);
        double low = 0, high = 0;
        for (int step = 0; step < 300; ++step) {
          if (step % 60 == 0) piston.slider->set_motor(step % 120 ? -2 : 2, 20);
          piston.run(1);
          low = std::min(low, piston.displacement());
          high = std::max(high, piston.displacement());
        }
        CHECK(high > 0.6);  // it went to both limits
        CHECK(low < -0.4);
        const Momenta after = momenta(piston.world);
        CHECK(length(after.linear - before.linear) < tolerance(1e-11, 1e-3));
        CHECK(length(after.angular - before.angular) < tolerance(1e-11, 1e-3));
      }
}

TEST_CASE("a box on an inclined slider slides down with g times the sine of the slope") {
  for (double slope : {10.0, 30.0, 75.0})
    for (bool whole : {true, false}) {
      World world;
      const BodyId wall = world.add(static_body(vec3(0)));
      const BodyId body = world.add(box(5, vec3(1, 2, 3), vec3(real(0.3), real(0.4), 0)));
      const real phi = real(slope) * degree;
      auto& slider = world.add<SliderJoint>(wall, body, vec3(0),
                                            vec3(std::cos(phi), -std::sin(phi), 0));
      slider.whole = whole;
      SequentialImpulses solver;
      for (int n = 0; n < 60; ++n) step(world, solver, h);
      CHECK(double(slider.speed(world.bodies)) ==
            Approx(9.81 * std::sin(slope * double(degree))).epsilon(tolerance(1e-6, 1e-4)));
      CHECK(double(length(world.bodies[body].w)) < tolerance(1e-6, 1e-4));
    }
}

TEST_CASE("equal limits of a slider hold it against its motor and against a blow") {
  for (bool whole : {true, false})
    for (bool warm : {false, true}) {
      Piston piston;
      piston.slider->whole = whole;
      piston.slider->set_limits(real(0.2), real(0.2));
      piston.slider->set_motor(-1, 50);
      piston.stepping.warm_start = warm;
      piston.run(200);
      CHECK(piston.displacement() == Approx(0.2).epsilon(whole ? 1e-4 : 1e-2));
      CHECK(double(piston.slider->limit_force()) == Approx(50).epsilon(tolerance(1e-6, 1e-2)));
      piston.body().v = real(20) * along;
      piston.run(1);
      CHECK(std::abs(piston.displacement() - 0.2) < (whole ? 1e-4 : 1e-2));
    }
}

TEST_CASE("a slider's limits and motor may change between steps") {
  for (bool warm : {false, true}) {
    const double near = warm ? 0.02 : 1e-3;  // warm: the blow that turned it round echoes a little
    Piston piston;
    piston.stepping.warm_start = warm;
    piston.slider->set_motor(2, 1000);
    piston.run(30);
    CHECK(std::abs(piston.displacement() - 1) < near);
    piston.slider->set_limits(-5, real(1.1));  // closes in ahead of it
    piston.run(30);
    CHECK(piston.displacement() == Approx(1.1).epsilon(tolerance(1e-6, 1e-4)));
    piston.slider->set_motor(-2, 1000);
    piston.run(30);
    const double start = piston.displacement();
    CHECK(std::abs(start - 0.1) < near);
    CHECK(double(piston.slider->limit_force()) == 0);
    piston.slider->set_limits(1, 5);  // it is 0.9 beyond: comes back by 0.2 of it a step
    piston.slider->set_motor(0, 0);
    piston.run(1);
    CHECK(piston.displacement() - start ==
          Approx(0.2 * (1 - start)).epsilon(tolerance(1e-6, 1e-4)));
    piston.slider->clear_limits();
    piston.run(1);  // a limit brakes nothing: it flies on
    CHECK(piston.displacement() - start == Approx(0.4 * (1 - start)).epsilon(1e-3));
  }
}

TEST_CASE("I25 a driven slider leaves a static body untouched to the last bit") {
  for (bool warm : {false, true})
    for (bool both : {false, true}) {
      Piston piston;
      piston.stepping.warm_start = warm;
      if (both) piston.body() = static_body(vec3(1, 2, 3), rotation(vec3(1)));
      const Body wall = piston.world.bodies[piston.one], other = piston.body();
      piston.slider->set_limits(real(-0.5), real(0.5));
      for (int step = 0; step < 1000; ++step) {
        if (step % 60 == 0) piston.slider->set_motor(step % 120 ? -2 : 2, 20);
        piston.run(1);
      }
      CHECK(same_bits(piston.world.bodies[piston.one], wall));
      CHECK(finite(piston.body().x));
      if (!both) continue;
      CHECK(same_bits(piston.body(), other));
      CHECK(piston.world.blocks.list.empty());
      CHECK(double(piston.slider->motor_force()) == 0);
      CHECK(double(piston.slider->limit_force()) == 0);
    }
}

TEST_CASE("X17 a piston between limits is as good after 20000 steps as in its first minute") {
  for (bool whole : {true, false}) {
    Piston piston;
    piston.slider->whole = whole;
    piston.slider->set_limits(-1, 1);
    piston.solver.iterations = 10;
    struct { double gap = 0, turn = 0, speed = 0; } first, now;
    for (int step = 0; step < 21600; ++step) {
      if (step % 90 == 0) piston.slider->set_motor(step % 180 ? -3 : 3, 40);
      piston.run(1);
      const Body &a = piston.world.bodies[piston.one], &b = piston.body();
      const Vector<2> gap = piston.slider->first.error(a, b);
      now.gap = std::max(now.gap, std::hypot(double(gap[0]), double(gap[1])));
      now.turn = std::max(now.turn, double(length(piston.slider->second.error(a, b))));
      now.speed = std::max(now.speed, std::abs(piston.speed()));
      if (step == 3599) first = now;
      if (step == 17999) now = {};
    }
    CHECK(first.speed == Approx(3).epsilon(1e-2));
    CHECK(now.gap < 1.01 * first.gap + tolerance(1e-12, 1e-5));
    CHECK(now.turn < 1.01 * first.turn + tolerance(1e-12, 1e-5));
    CHECK(now.speed < 1.001 * first.speed);
  }
}
