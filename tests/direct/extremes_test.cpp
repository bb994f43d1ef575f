// The direct solver where numbers are extreme (cases X5, X6, X8, X9, X10), soft blocks, rods and
// ropes.
#include "bench/scenes.h"
#include "tests/direct/rigs.h"
#include "tests/oracle/test.h"

using namespace joints::chapter9;

namespace {

const real h = sixtieth;

// A body on a rod or a rope of 1 m that hangs from the origin.
template <class Rod>
struct Hanging {
  World world;
  BodyId wall, body;

  Hanging(const Rod& rod, const vec3& x, const vec3& v) {
    wall = world.add(static_body(vec3(0)));
    body = world.add(ball(1, real(0.1), x));
    world.bodies[body].v = v;
    world.add<PartJoint<Rod>>(wall, body, rod).beta = 1;
  }
  double far() { return double(length(world.bodies[body].x)); }
};

}  // namespace

// ---- soft blocks --------------------------------------------------------------------------------

TEST_CASE("soft joints move by the direct solver as by many iterations") {
  for (const bool by_step : {true, false}) {
    Scene direct = heavy_chain(5, 3), iterated = heavy_chain(5, 3), hard = heavy_chain(5, 3);
    const auto soft = [&](Solver& solver, Scene& scene) {
      const StepOptions how{.warm_start = true, .leapfrog = true};
      if (by_step) {
        StepOptions all = how;
        all.frequency = 3, all.damping = real(0.5);
        return step(scene.world, solver, h, all);
      }
      begin_step(scene.world, solver, h, how);
      for (Block& block : scene.world.blocks.list)  // two of the joints alone
        if (block.first < 6) block.settings.frequency = 3, block.settings.damping = real(0.5);
      solver.prepare(scene.world.bodies, scene.world.blocks, 0, h);
      solver.solve(scene.world.bodies);
      end_step(scene.world, solver, h, how);
    };
    DirectSolver solver = DirectSolver::velocities_only(), other = solver;
    SequentialImpulses many;
    many.iterations = 5000;
    for (int n = 0; n < 30; ++n) {
      soft(solver, direct);
      soft(many, iterated);
      step(hard.world, other, h, second_order);
    }
    double apart = 0, from_hard = 0;
    for (int slot = 0; slot < direct.world.bodies.slots(); ++slot) {
      const vec3 x = direct.world.bodies.at(slot).x;
      apart = std::max(apart, double(length(x - iterated.world.bodies.at(slot).x)));
      from_hard = std::max(from_hard, double(length(x - hard.world.bodies.at(slot).x)));
    }
    CHECK(apart < tolerance(1e-8, 1e-3));
    CHECK(from_hard > 0.01);
  }
}

TEST_CASE("a weight on a soft joint swings at its frequency, and Newton's method leaves it alone") {
  for (const real frequency : {real(2), real(30)}) {
    CAPTURE(frequency);
    double lowest[] = {0, 0};
    for (const int newton : {0, 8}) {
      Scene scene{.name = "soft"};
      const BodyId wall = scene.box(0, vec3(1), vec3(0));
      const BodyId body = scene.box(1, vec3(1), vec3(1, 0, 0));
      on_hinge(scene, wall, body, vec3(1, 0, 0), vec3(1, 0, 0));
      DirectSolver solver = with(newton);
      for (int n = 0; n < 240; ++n) {
        step(scene.world, solver, real(1) / 240, {.frequency = frequency, .damping = 0});
        double& y = lowest[newton / 8];
        y = std::min(y, double(scene.world.bodies[body].x.y));
      }
    }
    CHECK(lowest[0] == lowest[1]);
    const double omega = 2 * std::numbers::pi * 2;
    if (frequency == 2) CHECK(lowest[0] == Approx(-2 * 9.81 / (omega * omega)).epsilon(0.1));
  }
}

// ---- rods and ropes -----------------------------------------------------------------------------

TEST_CASE("a rope is free while it is slack, and a rod never is") {
  for (const int newton : {0, 8}) {
    CAPTURE(newton);
    Hanging<Rope<CentreDistance>> rope({CentreDistance{1}}, vec3(0), vec3(1, 0, 0));
    Hanging<CentreDistance> rod(CentreDistance{1}, vec3(1, 0, 0), vec3(0, 0, 1));
    DirectSolver one = with(newton), other = with(newton);
    double longest = 0, shortest = 2, at_most = 0;
    for (int n = 0; n < 300; ++n) {
      step(rope.world, one, h, second_order);
      step(rod.world, other, h, second_order);
      if (n == 10) {  // slack
        CHECK(double(rope.world.bodies[rope.body].v.x) == Approx(1));
        CHECK(one.report().moved_exactly == (newton > 0));
      }
      longest = std::max(longest, rope.far());
      shortest = std::min(shortest, rod.far());
      at_most = std::max(at_most, rod.far());
    }
    CHECK(longest > 0.99);
    CHECK(longest < (newton == 0 ? 1.05 : 1.0 + tolerance(1e-6, 1e-4)));
    CHECK(at_most - shortest < (newton == 0 ? 0.05 : tolerance(1e-6, 1e-3)));
  }
}

TEST_CASE("X5 points that coincide, and a rope of length 0, push nothing in no direction") {
  for (const int newton : {0, 8}) {
    Hanging<CentreDistance> rod(CentreDistance{1}, vec3(0), vec3(0));
    Hanging<Rope<CentreDistance>> rope({CentreDistance{0}}, vec3(0), vec3(0));
    DirectSolver one = with(newton), other = with(newton);
    step(rod.world, one, h, second_order);
    step(rope.world, other, h, second_order);
    CHECK(double(rod.world.bodies[rod.body].v.y) == Approx(-9.81 / 120));
    CHECK(largest_impulse(rod.world) == 0);
    for (int n = 0; n < 300; ++n) {
      step(rod.world, one, h, second_order);
      step(rope.world, other, h, second_order);
    }
    CHECK(all_finite(rod.world));
    CHECK(all_finite(rope.world));
    CHECK(rod.far() == Approx(1).epsilon(0.01));
    CHECK(rope.far() < 0.01);
  }
}

// ---- extremes -----------------------------------------------------------------------------------

TEST_CASE("X6 static bodies keep their bits for a thousand steps of their neighbours") {
  for (const int newton : {0, 8}) {
    Scene scene = four_bars(2);
    const Body before = scene.world.bodies.at(0);
    DirectSolver solver = with(newton);
    for (int n = 0; n < 1000; ++n) step(scene.world, solver, h, second_order);
    const Body& after = scene.world.bodies.at(0);
    CHECK(same_bits(before.x, after.x));
    CHECK(same_bits(before.q, after.q));
    CHECK(after.v == vec3(0));
    CHECK(after.w == vec3(0));
  }
}

TEST_CASE("X8 a hinge that turns at a thousand radians a second stays whole") {
  for (const int newton : {0, 8}) {
    Rotor rotor(0, 1000);
    feed_back_all(rotor.world);
    DirectSolver solver = with(newton);
    for (int n = 0; n < 600; ++n) step(rotor.world, solver, h, second_order);
    CHECK(double(rotor.rotor().w.z) == Approx(1000).epsilon(tolerance(1e-9, 1e-3)));
    CHECK(double(length(rotor.rotor().x)) < tolerance(1e-9, 1e-4));
  }
}

TEST_CASE("X9 a chain swings alike at the origin and a thousand kilometres off") {
  const auto tip = [](const vec3& origin, int newton) {
    Scene scene = heavy_chain(5, 10);
    for (int slot = 0; slot < scene.world.bodies.slots(); ++slot)
      scene.world.bodies.at(slot).x += origin;
    DirectSolver solver = with(newton);
    double gap = 0;
    for (int n = 0; n < 60; ++n) {
      step(scene.world, solver, h, second_order);
      gap = std::max(gap, widest_gap(scene));
    }
    CHECK(all_finite(scene.world));
    if (newton > 0) CHECK(gap < tolerance(1e-6, 0.5));  // rounding of a float there: 0.06 m
    return scene.world.bodies.at(6).x - origin;
  };
  for (const int newton : {0, 8}) {
    const vec3 near = tip(vec3(0), newton), far = tip(vec3(real(1e6), 0, 0), newton);
    if (!is_float) CHECK(double(length(near - far)) < 1e-6);
    CHECK(double(length(near - vec3(3, 0, 0))) > 1);
  }
}

TEST_CASE("X10 a chain of masses from a milligram to a million tons hangs by all its joints") {
  std::vector<double> rising;
  for (int power = -6; power <= 9; ++power) rising.push_back(std::pow(10.0, power));
  const std::vector<double> falling(rising.rbegin(), rising.rend());
  for (const std::vector<double>& masses : {rising, falling})
    for (const int newton : {0, 8}) {
      CAPTURE(masses.front(), newton);
      bench::BenchScene scene = bench::chain_of_masses(masses, vec3(0, -1, 0));
      feed_back_all(scene.world);
      DirectSolver solver = with(newton);
      const Watched seen = watch(scene, solver, 2, double(h));
      CHECK(seen.finite);
      CHECK(seen.gap < (newton == 0 ? 1e-2 : tolerance(1e-6, 1e-2)));
      CHECK(solver.dependent() == 0);
      double below = 0;
      for (std::size_t k = masses.size(); k-- > 0;) {
        below += masses[k];
        const auto& joint = dynamic_cast<const BallJoint&>(*scene.world.joints()[k]);
        CHECK(double(joint.forces()[1]) == Approx(9.81 * below).epsilon(tolerance(1e-6, 1e-3)));
      }
    }
}

TEST_CASE("X10 a mountain may hang on a grain, until a double cannot tell the two apart") {
  const auto hang = [](double grain, double mountain, DirectSolver& solver) {
    bench::BenchScene scene = bench::chain_of_masses({grain, mountain}, vec3(0, -1, 0));
    feed_back_all(scene.world);
    return watch(scene, solver, 1, double(h)).gap;
  };
  DirectSolver solver;
  CHECK(hang(1e-3, tolerance(1e6, 1e2), solver) < tolerance(1e-6, 1e-3));
  CHECK(solver.dependent() == 0);
  hang(1e-6, 1e9, solver);
  CHECK(solver.dependent() > 0);  // it says so
}

TEST_CASE("what a mass ratio leaves of a pivot is taken for a dependence from some ratio on") {
  if (is_float) return;  // its limit is another
  for (const auto& [mass, falls] : {std::pair{1e11, false}, {1e13, false}, {1e15, true}}) {
    World world;
    BodyId before = world.add(static_body(vec3(0)));
    for (int k = 1; k <= 3; ++k) {
      const vec3 x(0, real(-k), 0);
      const BodyId next = world.add(k == 3 ? ball(real(mass), real(0.5), x)
                                           : box(1, vec3(real(0.5)), x));
      world.add<BallJoint>(before, next, point_at(world.bodies[before], world.bodies[next],
                                                  x + vec3(0, real(0.5), 0)));
      before = next;
    }
    feed_back_all(world);
    DirectSolver solver = shake();
    for (int n = 0; n < 60; ++n) step(world, solver, sixtieth, second_order);
    CAPTURE(mass);
    CHECK((std::abs(double(world.bodies[before].x.y) + 3) > 1e-3) == falls);
    CHECK((solver.dependent() > 0) == falls);
  }
}
