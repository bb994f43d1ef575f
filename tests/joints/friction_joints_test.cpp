// Dry friction of a joint: what it takes from a motion is its force times the way, and where it can
// hold it holds.
#include "direct/direct_solver.h"
#include "engine/instruments/measure.h"
#include "engine/simd/packed.h"
#include "tests/oracle/test.h"

using Catch::Matchers::StartsWith;

namespace {

const real h = real(1) / 500;

// A bar of 1 m and 2 kg that swings about a wall's z axis by its end, let go level.
struct Pendulum {
  World world;
  BodyId wall, bar;
  HingeJoint* hinge;
  SequentialImpulses solver;
  explicit Pendulum(real friction) {
    wall = world.add(static_body(vec3(0)));
    bar = world.add(box(2, vec3(1, real(0.1), real(0.1)), vec3(real(0.5), 0, 0)));
    hinge = &world.add<HingeJoint>(wall, bar, vec3(0), vec3(0, 0, 1));
    hinge->beta = 1;
    hinge->set_friction(friction);
  }
  double angle() const { return double(hinge->position(world.bodies)); }
  double energy() const { return joints::energy(all_of(world.bodies), world.gravity); }
};

}  // namespace

TEST_CASE("the energy of a pendulum with dry friction falls by the torque times the angle") {
  const double torque = 0.7;
  Pendulum rubbed{real(torque)}, free(0);
  for (Pendulum* pendulum : {&rubbed, &free}) {
    double way = 0, before = pendulum->angle();
    const double start = pendulum->energy();
    for (int n = 0; n < 1500; ++n) {
      step(pendulum->world, pendulum->solver, h);
      way += std::abs(pendulum->angle() - before);
      before = pendulum->angle();
      if (n % 250 != 249) continue;
      CAPTURE(n, way);
      const double lost = start - pendulum->energy();
      if (pendulum == &rubbed) CHECK(lost == Approx(torque * way).margin(0.1));
      else CHECK(std::abs(lost) < 0.1);
    }
    CHECK(way > 4);
  }
}

TEST_CASE("a pendulum with dry friction comes to rest where friction can hold it, and stays") {
  const double torque = 0.7, weight = 2 * 9.81 * 0.5;  // [N m] of the weight if level
  Pendulum pendulum{real(torque)};
  for (int n = 0; n < 5000; ++n) step(pendulum.world, pendulum.solver, h);
  const double at_rest = pendulum.angle();
  CHECK(double(length(pendulum.world.bodies[pendulum.bar].w)) < 1e-3);
  CHECK(weight * std::abs(std::cos(at_rest)) < torque);
  CHECK(double(pendulum.hinge->friction_force()) ==
        Approx(weight * std::cos(at_rest)).margin(tolerance(1e-6, 1e-2)));
  for (int n = 0; n < 2500; ++n) step(pendulum.world, pendulum.solver, h);
  CHECK(pendulum.angle() == Approx(at_rest).margin(tolerance(1e-9, 1e-3)));
  Pendulum held(real(1.01 * weight)), let_go(real(0.99 * weight));
  for (Pendulum* one : {&held, &let_go})
    for (int n = 0; n < 500; ++n) step(one->world, one->solver, h);
  CHECK(std::abs(held.angle()) < 1e-3);
  CHECK(let_go.angle() < -0.05);
}

TEST_CASE("a slider with friction stops after v^2 m / 2 F, and a motor leaves the friction alone") {
  World world = weightless();
  const BodyId wall = world.add(static_body(vec3(0)));
  const BodyId sledge = world.add(box(3, vec3(1), vec3(0)));
  auto& slider = world.add<SliderJoint>(wall, sledge, vec3(0), vec3(1, 0, 0));
  slider.set_friction(6);
  world.bodies[sledge].v = vec3(4, 0, 0);
  SequentialImpulses solver;
  for (int n = 0; n < 1500; ++n) step(world, solver, h);
  CHECK(double(slider.position(world.bodies)) == Approx(4).epsilon(2e-3));
  CHECK(double(slider.speed(world.bodies)) == Approx(0).margin(1e-6));
  slider.set_motor(1, 100);
  CHECK(slider.motor().speed == 1);
  CHECK(slider.motor().strength == 100);
  CHECK(slider.friction() == 6);
  CHECK_THAT(refusal([&] { slider.set_friction(-1); }), StartsWith("strength is -1; "));
  CHECK(slider.friction() == 6);
}

TEST_CASE("an arm that friction holds sinks with a cold start, and hardly with a warm one") {
  const auto sinks = [](Solver& solver, bool warm) {
    World world;
    const BodyId wall = world.add(static_body(vec3(0)));
    const vec3 size(1, real(0.1), real(0.1));
    const BodyId upper = world.add(box(1, size, vec3(real(0.5), 0, 0)));
    const BodyId lower = world.add(box(1, size, vec3(real(1.5), 0, 0)));
    const real enough = real(1.05 * 9.81);  // a twentieth more than the load
    world.add<HingeJoint>(wall, upper, vec3(0), vec3(0, 0, 1)).set_friction(2 * enough);
    world.add<HingeJoint>(upper, lower, vec3(1, 0, 0), vec3(0, 0, 1)).set_friction(enough / 2);
    world.set_beta(1);
    for (int n = 0; n < 600; ++n)
      step(world, solver, real(1) / 60, {.warm_start = warm, .substeps = 4});
    return -double(world_point(world.bodies[lower], vec3(real(0.5), 0, 0)).y);
  };
  PackedImpulses iterations;
  iterations.iterations = 8;
  DirectSolver direct;
  CHECK(sinks(iterations, false) > 1);
  CHECK(sinks(iterations, true) < 0.01);
  CHECK(std::abs(sinks(direct, false)) < tolerance(1e-6, 1e-3));
}
