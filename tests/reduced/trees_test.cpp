// Trees in reduced coordinates against their rows: accelerations, trajectories, what is conserved.
#include <optional>

#include "bench/runge_kutta.h"
#include "engine/instruments/measure.h"
#include "tests/oracle/beside.h"
#include "tests/oracle/test.h"
#include "tests/reduced/drawn_trees.h"

namespace {

double energy_of(const World& world) { return energy(all_of(world.bodies), world.gravity); }

// Runs the same drawn world in several ways, each for a second at 1 kHz.
struct Runs {
  TreeFamily family;
  Random random;
  World start() const {
    Random again = random;
    World world = drawn_tree(again, family);
    world.gravity *= family.size / 3;  // so that small ones do not swing faster
    Reduced(world).satisfy(world);
    return world;
  }
  World after(const std::function<void(World&, real)>& step, int steps = 1000) const {
    World world = start();
    for (int n = 0; n < steps; ++n) step(world, real(1) / real(steps));
    return world;
  }
  World reduced(Reduced::Method method, int steps = 1000, int iterations = 2) const {
    std::optional<Reduced> tree;
    return after([&](World& world, real h) {
      if (!tree) tree.emplace(world);
      tree->method = method, tree->iterations = iterations;
      tree->step(world, h);
    }, steps);
  }
};

Runs draw_run(Random& random, int most_joints, Root root) {
  Runs runs{any_family(random, most_joints), random};
  runs.family.root = root;
  runs.family.speed = real(1.5);
  drawn_tree(random, runs.family);
  return runs;
}

constexpr auto leapfrog = Reduced::Method::leapfrog, kutta = Reduced::Method::runge_kutta;

// The energy that a motion of this world can be expected to exchange [J].
double scale_of_energy(const World& world, const TreeFamily& family) {
  double out = 0;
  for (const Body& body : world.bodies)
    if (!body.is_static())
      out += kinetic_energy(body) + double(length(world.gravity) * family.size) /
                                        double(body.inverse_mass);
  return out;
}

}  // namespace

TEST_CASE("accelerations in coordinates are those of the rows, in drawn trees of any size",
          "[slow]") {
  Random random(51001);
  int held = 0;
  double worst = 0;
  const int trees = is_float ? 10 : 40;
  for (int n = 0; n < trees; ++n) {
    TreeFamily family = any_family(random, n == 0 && !is_float ? 200 : 40);
    if (n == 0) family.joints = is_float ? 20 : 200;
    World world = drawn_tree(random, family);
    if (n % 3 == 1)
      for (Body& body : world.bodies)
        if (!body.is_static())
          body.force = random.vector(family.mass * 20), body.torque = random.vector(family.mass);
    Reduced tree(world);
    tree.satisfy(world);
    const auto yours = tree.accelerations(world);
    const Column expected = accelerations_of_rows(world, family.speed);
    double apart = 0, size = 0;
    for (std::size_t k = 0; k < yours.size(); ++k) {
      const dvec3 v = three(expected, 6 * long(k)), w = three(expected, 6 * long(k) + 3);
      if (world.bodies.at(int(k)).is_static()) continue;
      const double lever = double(family.size);
      apart = std::max(apart, glm::length(dvec3(yours[k].v) - v) +
                                  lever * glm::length(dvec3(yours[k].w) - w));
      size = std::max(size, glm::length(v) + lever * glm::length(w));
    }
    worst = std::max(worst, apart / size);
    if (apart < tolerance(1e-9, 1e-2) * size) ++held;
  }
  INFO(held << " of " << trees << " held, worst " << worst);
  CHECK(held == trees);
}

TEST_CASE("in drawn trees Runge-Kutta steps of the coordinates go where those of the rows go") {
  if (is_float) return;  // a comparison to many digits
  Random random(51002);
  double worst = 0, worst_energy = 0;
  for (int n = 0; n < 12; ++n) {
    Runs runs = draw_run(random, 15, Root(n % 3));
    runs.family.six = false;  // the method on rows rejects limits, and a locked coordinate is one
    RungeKutta rows;
    const World expected = runs.after([&](World& world, real h) { rows.step(world, h); });
    const World world = runs.reduced(kutta);
    worst = std::max(worst, apart(world, expected) / double(runs.family.size));
    if (runs.family.root == Root::is_kinematic) continue;  // its root works on it
    const World before = runs.start();
    worst_energy = std::max(worst_energy, std::abs(energy_of(world) - energy_of(before)) /
                                              scale_of_energy(before, runs.family));
  }
  INFO("worst " << worst << " of a size, energy " << worst_energy);
  CHECK(worst < 1e-6);
  CHECK(worst_energy < 1e-6);
}

TEST_CASE("leapfrog in the coordinates is four times as exact at half the step") {
  if (is_float) return;
  Random random(51003);
  double worst = 0, least = 100, most = 0;
  int compared = 0;
  for (int n = 0; n < 12; ++n) {
    const Runs runs = draw_run(random, 15, Root(n % 3));
    const World exact = runs.reduced(kutta), coarse = runs.reduced(leapfrog, 500),
                fine = runs.reduced(leapfrog);
    worst = std::max(worst, apart(fine, exact) / double(runs.family.size));
    if (apart(fine, exact) < 1e-9 * double(runs.family.size)) continue;  // hardly bent: exact
    const double ratio = apart(coarse, exact) / apart(fine, exact);
    ++compared;
    least = std::min(least, ratio), most = std::max(most, ratio);
  }
  INFO("worst " << worst << " of a size, ratios " << least << " to " << most);
  CHECK(worst < 1e-3);
  CHECK(compared >= 8);
  CHECK(least > 3.5);
  CHECK(most < 4.5);
}

TEST_CASE("a tree that floats freely keeps its momentum, by either method") {
  Random random(51004);
  double worst = 0;
  for (int n = 0; n < 10; ++n) {
    Runs runs = draw_run(random, 20, Root::is_free);
    for (const auto method : {leapfrog, kutta}) {
      World world = runs.start();
      world.gravity = vec3(0);
      const auto before = momentum(all_of(world.bodies));
      Reduced tree(world);
      tree.method = method;
      double scale = 0;
      for (const Body& body : world.bodies)
        scale += double(length(body.v) + length(body.w) * runs.family.size) /
                 double(body.inverse_mass);
      for (int k = 0; k < 200; ++k) tree.step(world, real(0.005));
      const auto after = momentum(all_of(world.bodies));
      worst = std::max({worst, glm::length(after.linear - before.linear) / scale,
                        glm::length(after.angular - before.angular) /
                            (scale * double(runs.family.size))});
    }
  }
  INFO("worst " << worst);
  CHECK(worst < tolerance(1e-12, 1e-3));
}

TEST_CASE("steps by leapfrog can be undone: exactly on a fixed root, nearly in a free tree") {
  if (is_float) return;
  Random random(51005);
  double worst = 0, worst_free = 0;
  for (int n = 0; n < 10; ++n) {
    const Runs runs = draw_run(random, 10, n % 2 == 0 ? Root::is_static : Root::is_free);
    World world = runs.start();
    const std::vector<Body> start = snapshot(world.bodies);
    Reduced tree(world);
    tree.iterations = 20;
    for (int twice = 0; twice < 2; ++twice) {
      for (int k = 0; k < 100; ++k) tree.step(world, real(0.005));
      for (Body& body : world.bodies) body.v = -body.v, body.w = -body.w;
    }
    double& most = n % 2 == 0 ? worst : worst_free;
    most = std::max(most, apart(world, start) / double(runs.family.size));
  }
  INFO("worst " << worst << " of a size, free " << worst_free);
  CHECK(worst < 1e-11);
  CHECK(worst_free < 1e-6);
}

TEST_CASE("wheels and tops keep momentum and energy up to 5 rad a step") {
  if (is_float) return;
  for (const real spin : {real(30), real(60), real(93), real(150), real(300)}) {
    World car = weightless();
    const BodyId body = car.add(box(1000, vec3(4, real(1.2), real(1.8)), vec3(0)));
    const vec3 hub(real(1.5), 0, 1);
    const BodyId wheel =
        car.add(body_with(20, vec3(real(0.5), real(0.5), real(0.9)), hub));
    car.add<HingeJoint>(body, wheel, hub, vec3(0, 0, 1));
    car.bodies[wheel].w = vec3(0, 0, spin);
    car.bodies[body].w = vec3(real(0.3), real(0.5), real(0.2));
    Reduced tree(car);
    tree.satisfy(car);
    const auto start = momentum(all_of(car.bodies));
    const double before = energy_of(car);
    for (int k = 0; k < 600; ++k) tree.step(car, real(1) / 60);
    CHECK(energy_of(car) == Approx(before).epsilon(1e-6));
    CHECK(glm::length(momentum(all_of(car.bodies)).angular - start.angular) <
          1e-12 * glm::length(start.angular));

    World top;  // level, on a ball joint: it precesses
    const BodyId post = top.add(static_body(vec3(0)));
    const quat level = rotation(vec3(0, 90 * degree, 0));
    const BodyId disc = top.add(body_with(1, vec3(real(0.01), real(0.01), real(0.02)),
                                          vec3(real(0.2), 0, 0), level));
    top.add<BallJoint>(post, disc, vec3(0));
    top.bodies[disc].w = vec3(spin, 0, 0);
    Reduced spinning(top);
    const double at_rest = energy_of(top);
    for (int k = 0; k < 300; ++k) spinning.step(top, real(1) / 60);
    CHECK(energy_of(top) == Approx(at_rest).epsilon(3e-3));
  }
}
