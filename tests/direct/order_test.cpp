// The order of convergence of the motion: the direct solver's steps, with and without Newton's
// method on the poses, and the Runge-Kutta method that the others are compared with.
#include <array>

#include "bench/runge_kutta.h"
#include "bench/scenes.h"
#include "tests/direct/rigs.h"
#include "tests/oracle/test.h"

namespace {

using Move = std::function<void(World&, real)>;

Move by_steps(int newton, const StepOptions& how) {
  DirectSolver solver = with(newton);
  return [solver, how](World& world, real h) mutable { step(world, solver, h, how); };
}
Move by_runge_kutta() {
  return [kutta = RungeKutta()](World& world, real h) mutable { kutta.step(world, h); };
}

// Three bodies of uneven inertia on hinges whose axes are askew.
World three_on_hinges() {
  World world;
  BodyId before = world.add(static_body(vec3(0)));
  const std::array<vec3, 3> axes{vec3(1, 0, real(0.2)), vec3(real(0.3), 1, 0),
                                 vec3(0, real(0.4), 1)};
  for (int k = 0; k < 3; ++k) {
    const vec3 x(real(0.9) * real(k + 1), real(0.1) * real(k), real(-0.2));
    const BodyId id = world.add(body_with(real(k + 1), vec3(real(0.1), real(0.25), real(0.3)), x,
                                          rotation(vec3(real(0.3) * real(k), real(0.5), 0))));
    world.add<HingeJoint>(before, id, x - vec3(real(0.5), 0, 0), axes[std::size_t(k)])
        .beta = 1;
    before = id;
  }
  return world;
}

// A hinge, a slider and a ball in a row.
World hinge_slider_ball() {
  World world;
  const BodyId wall = world.add(static_body(vec3(0)));
  const auto add = [&](const vec3& x) {
    return world.add(body_with(2, vec3(real(0.2), real(0.3), real(0.4)), x,
                               rotation(real(0.3) * x)));
  };
  const BodyId a = add(vec3(1, 0, 0)), b = add(vec3(real(1.6), real(0.2), 0)),
               c = add(vec3(real(2.4), 0, real(0.3)));
  world.add<HingeJoint>(wall, a, vec3(0), vec3(0, real(0.3), 1));
  world.add<SliderJoint>(a, b, vec3(real(1.3), 0, 0), vec3(1, real(0.5), 0));
  world.add<BallJoint>(b, c, point_at(world.bodies[b], world.bodies[c], vec3(2, 0, 0)));
  feed_back_all(world);
  return world;
}

// Places of all bodies after a while, at `rate` steps a second.
Column places(World world, Move move, double seconds, int rate) {
  const int steps = int(std::lround(seconds * rate));
  for (int n = 0; n < steps; ++n) move(world, real(1) / real(rate));
  Column out(3 * long(world.bodies.slots()));
  for (int slot = 0; slot < world.bodies.slots(); ++slot)
    for (int i = 0; i < 3; ++i) out[3 * slot + i] = double(world.bodies.at(slot).x[i]);
  return out;
}

// By what power of two a step of half the length is better.
double order(World (*make)(), const Move& move, int rate, double seconds = 0.5) {
  const Column coarse = places(make(), move, seconds, rate);
  const Column middle = places(make(), move, seconds, 2 * rate);
  const Column fine = places(make(), move, seconds, 4 * rate);
  const double first = (coarse - middle).norm(), second = (middle - fine).norm();
  CHECK(second > 1e-11);  // more than rounding
  return std::log2(first / second);
}

}  // namespace

TEST_CASE("leapfrog is of second order on uneven bodies, with velocities alone and with SHAKE") {
  for (const auto make : {three_on_hinges, hinge_slider_ball})
    for (const int newton : {0, 8}) {
      CAPTURE(newton, make == three_on_hinges);
      const double found = order(make, by_steps(newton, second_order), newton > 0 ? 240 : 960);
      CHECK(found == Approx(2).margin(0.05));
    }
}

TEST_CASE("without leapfrog the step is of first order") {
  for (const auto make : {three_on_hinges, hinge_slider_ball})
    for (const int newton : {0, 8}) {
      CAPTURE(newton, make == three_on_hinges);
      CHECK(order(make, by_steps(newton, {}), 960) == Approx(1).margin(0.1));
    }
}

TEST_CASE("leapfrog is of first order with neither feedback nor SHAKE") {
  for (const auto make : {three_on_hinges, hinge_slider_ball}) {
    CAPTURE(make == three_on_hinges);
    const Move step_on = by_steps(0, second_order);
    const Move drift = [&](World& world, real h) {
      world.set_beta(0);
      step_on(world, h);
    };
    CHECK(order(make, drift, 960) == Approx(1).margin(0.1));
  }
}

TEST_CASE("the Runge-Kutta method is of fourth order") {
  for (const auto make : {three_on_hinges, hinge_slider_ball}) {
    CAPTURE(make == three_on_hinges);
    CHECK(order(make, by_runge_kutta(), 120) == Approx(4).margin(0.1));
  }
}

TEST_CASE("every method comes to the same motion as its step becomes short") {
  for (const auto make : {three_on_hinges, hinge_slider_ball}) {
    CAPTURE(make == three_on_hinges);
    const Column exact = places(make(), by_runge_kutta(), 0.5, 480);
    CHECK((places(make(), by_steps(8, second_order), 0.5, 1920) - exact).largest() < 1e-5);
    CHECK((places(make(), by_steps(0, second_order), 0.5, 1920) - exact).largest() < 1e-4);
    CHECK((places(make(), by_steps(0, {}), 0.5, 1920) - exact).largest() < 1e-2);
  }
}

TEST_CASE("the benchmark's references are where the Runge-Kutta method ends") {
  const auto check = [](bench::BenchScene scene, int rate, double near) {
    CAPTURE(scene.name);
    RungeKutta kutta;
    for (int n = 0; n < rate; ++n) kutta.step(scene.world, real(1) / real(rate));
    const glm::dvec3 miss = glm::dvec3(scene.world.bodies.at(scene.tip).x) - scene.tip_reference;
    CHECK(glm::length(miss * scene.tip_mask) < near);
    CHECK(glm::length(scene.tip_mask) > 0);
    CHECK(widest_gap(scene) < 1e-12);
  };
  check(bench::cubes_on_hinges(1, 4), 240, 1e-8);
  check(bench::loaded_axes(), 240, 1e-8);
  check(bench::cubes_on_hinges(1, 100), 240, 1e-6);
  for (const double ratio : {1.0, 100.0}) check(bench::heavy_end(ratio), 480, 1e-5);
}
