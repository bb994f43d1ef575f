// The loop of chapter 7: the engine's own solver in fewer instructions, in any order of
// the hinges and any number of lanes, and with over-relaxation.
#include <numeric>

#include "bench/scenes.h"
#include "chapters/07_performance/hinge_loop.h"
#include "tests/oracle/beside.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;
constexpr int chains = 3, hinges = 11;  // of each

// The bodies and hinges of a world, as the loop wants them.
template <class Number>
HingeLoop<Number> loop_of(const World& world, const Groups& groups) {
  HingeLoop<Number> loop;
  loop.bodies = snapshot(world.bodies);
  for (const auto& joint : world.joints()) {
    const auto& hinge = static_cast<const HingeJoint&>(*joint);
    loop.links.push_back({world.bodies.index(hinge.body1), world.bodies.index(hinge.body2)});
    loop.hinges.push_back({hinge.first, hinge.second, hinge.beta});
  }
  loop.arrange(groups);
  loop.gravity = world.gravity;
  return loop;
}

// Chains of turned boxes, no two edges alike, on hinges about axes that are not alike either; the
// first of each is static if they are held.
World uneven_chains(int count, int links, bool held = true) {
  World world;
  Random random(71);
  for (int chain = 0; chain < count; ++chain) {
    const vec3 first(real(3 * chain), 0, 0);
    BodyId before = world.add(held ? static_body(first) : box(2, vec3(1, 2, 3), first));
    for (int k = 1; k <= links; ++k) {
      const vec3 x = first + vec3(0, 0, real(k));
      Body body = box(real(1 + k % 3), vec3(real(0.6), real(0.4), real(0.3)), x, random.turn());
      body.w = random.vector(1);
      const BodyId id = world.add(body);
      world.add<HingeJoint>(before, id, x - vec3(0, 0, real(0.5)),
                            vec3(1, real(k % 2), real(0.3)));
      before = id;
    }
  }
  return world;
}
World cubes() { return bench::cubes_on_hinges(chains, hinges + 1).world; }

template <class Loop>
Loop after(Loop loop, int steps) {
  for (int n = 0; n < steps; ++n) loop.step(h);
  return loop;
}

// A chain that hangs straight down: nothing turns, J never changes.
World hanging(int links) {
  World world;
  BodyId before = world.add(static_body(vec3(0)));
  for (int k = 1; k <= links; ++k) {
    const vec3 x(0, real(-1.5) * real(k), 0);
    const BodyId id = world.add(box(100, vec3(1), x));
    world.add<HingeJoint>(before, id, x + vec3(0, real(1.5), 0), vec3(1, 0, 0));
    before = id;
  }
  return world;
}

// A step's linear system: e = bias + J V before the first iteration, and the error that an
// iteration leaves of it.
struct Step {
  System system;
  Dense A;
  Column bias, e;
  explicit Step(World& world, double beta = 0.2) {
    const Bodies as_it_was = world.bodies;
    SequentialImpulses solver;
    begin_step(world, solver, h);
    system = system_of(world.blocks, world.bodies.slots());
    A = testing::whole_K(system, world);
    bias = beta / double(h) * system.C;
    e = left(snapshot(world.bodies));
    world.bodies = as_it_was;
  }
  Column left(const std::vector<Body>& bodies) const {
    return bias + system.J * velocities(bodies);
  }
  // e becomes H e: every block in turn takes omega times its exact impulse.
  Dense H(double omega) const {
    Dense lower = A;
    for (long i = 0; i < A.rows(); ++i)
      for (long j = 0; j < A.columns(); ++j) {
        const int row = system.block[std::size_t(i)], column = system.block[std::size_t(j)];
        if (column > row) lower(i, j) = 0;
        if (column == row) lower(i, j) /= omega;
      }
    return Dense::identity(A.rows()) - A * inverse_of(lower);
  }
};
Dense power(const Dense& H, int exponent) {
  Dense out = Dense::identity(H.rows());
  for (int k = 0; k < exponent; ++k) out = out * H;
  return out;
}

}  // namespace

TEST_CASE("the hinges' loop in chain order moves the cubes as the engine's solver does") {
  for (const vec3& gravity : {vec3(0, real(-9.81), 0), vec3(3, real(-9.81), 0)}) {
    World world = cubes();
    world.gravity = gravity;
    auto loop = loop_of<real>(world, one_by_one(int(world.joints().size())));
    SequentialImpulses solver;
    for (int n = 0; n < 60; ++n) {
      step(world, solver, h);
      loop.step(h);
    }
    CHECK(apart(loop.bodies, world) < tolerance(1e-11, 1e-3));
    CHECK(double(loop.bodies.back().x.y) < -4);  // it did fall
  }
}

TEST_CASE("turned boxes on skew hinges move in the hinges' loop as with the engine's solver") {
  World world = uneven_chains(chains, hinges);
  auto loop = loop_of<real>(world, one_by_one(int(world.joints().size())));
  SequentialImpulses solver;
  for (int n = 0; n < 10; ++n) {
    step(world, solver, h);
    loop.step(h);
  }
  CHECK(apart(loop.bodies, world) < tolerance(1e-11, 1e-3));
  CHECK(speeds_apart(loop.bodies, world) < tolerance(1e-10, 1e-2));
}

TEST_CASE("one chain per lane is one hinge at a time to the last bit") {
  const World worlds[] = {cubes(), uneven_chains(chains, hinges),
                          uneven_chains(chains, hinges, false)};
  for (const World& world : worlds) {
    const auto one = after(
        loop_of<real>(world, one_by_one(int(world.joints().size()))), 60);
    const auto interleaved = after(loop_of<real>(world, by_islands), 60);
    const auto lanes = after(loop_of<Lanes>(world, by_islands), 60);
    // Chains share no body that moves, and a lane adds and multiplies as one number.
    CHECK(same_bodies(interleaved.bodies, one.bodies));
    CHECK(same_bodies(lanes.bodies, one.bodies));
    CHECK(lanes.order().groups() == hinges);  // 3 of 4 or 8 lanes
    CHECK(lanes.order().columns);
    CHECK(apart(one.bodies, world) > 1);
  }
}

TEST_CASE("colours on lanes are one hinge at a time in that order to the last bit") {
  const World world = uneven_chains(chains, hinges);
  auto lanes = loop_of<Lanes>(world, {});
  lanes.arrange(by_colour(colours_of(lanes.links, moving(lanes.bodies)), lane_count));
  std::vector<int> order;
  for (const int hinge : lanes.order().blocks)
    if (hinge >= 0) order.push_back(hinge);
  REQUIRE(order.size() == world.joints().size());
  CHECK(lanes.order().groups() < int(order.size()) / 2);

  const auto one = after(loop_of<real>(world, order), 60);
  const auto in_chain_order =
      after(loop_of<real>(world, one_by_one(int(order.size()))), 60);
  lanes = after(lanes, 60);
  CHECK(same_bodies(lanes.bodies, one.bodies));
  CHECK_FALSE(same_bodies(lanes.bodies, in_chain_order.bodies));  // another order, another motion
}

TEST_CASE("preparing in every solve changes no bit because no pose changes within a step") {
  const World world = uneven_chains(chains, hinges);
  auto once = loop_of<Lanes>(world, by_islands), always = once;
  always.once_a_step = false;
  once = after(once, 30);
  always = after(always, 30);
  CHECK(same_bodies(once.bodies, always.bodies));

  // What was prepared belongs to the poses of this step: one step later a lever has turned on.
  const auto next = after(once, 1);
  for (std::size_t k = 0; k < once.links.size(); ++k) {
    const int slot = once.links[k].body2;
    HingeNumbers<real> now{}, later{};
    hoist(once.hinges[k], once.bodies[once.links[k].body1], once.bodies[slot], h, now);
    hoist(next.hinges[k], next.bodies[next.links[k].body1], next.bodies[slot], h, later);
    const vec3 r(now.r2.x, now.r2.y, now.r2.z), moved(later.r2.x, later.r2.y, later.r2.z);
    const vec3 turn = h * next.bodies[slot].w;
    const double angle = double(length(turn));
    CHECK(double(length(moved - r - cross(turn, r))) <=
          0.6 * angle * angle * double(length(r)) + tolerance(1e-14, 1e-6));
    CHECK(double(length(moved - r)) > 0);
  }
}

TEST_CASE("a relaxed iteration takes omega times the exact impulse of every hinge in turn") {
  World world = uneven_chains(1, 6);
  for (Body& body : world.bodies)  // then the move does not change w
    body.inverse_inertia_local = vec3(body.inverse_inertia_local.x);
  const Step step(world);
  for (const double omega : {0.5, 1.0, 1.9, 2.1}) {
    auto loop = loop_of<real>(world, one_by_one(6));
    loop.relaxation = real(omega);
    loop.iterations = 12;
    loop.step(h);
    const Column expected = power(step.H(omega), 12) * step.e;
    CHECK(difference(step.left(loop.bodies), expected) < tolerance(1e-10, 1e-3));
  }
}

TEST_CASE("iterations of a chain shrink for omega below 2 and grow above it") {
  World world = uneven_chains(1, 6);
  const Step step(world);
  const auto largest = [&](double omega) { return spectral_radius(step.H(omega)); };
  const auto least = [&](double omega) { return 1 / spectral_radius(inverse_of(step.H(omega))); };
  const double rho = largest(1);
  CHECK(rho < 1);
  for (const double omega : {0.3, 1.0, 1.5, 1.9}) CHECK(largest(omega) < 1);
  // Kahan: the eigenvalues' product is (1 - omega)^rows, so that one is at least |1 - omega|
  for (const double omega : {0.3, 1.5, 1.9, 2.1, 3.0}) {
    const Dense H = step.H(omega);
    CHECK(std::log(std::abs(determinant_of(H))) / double(H.rows()) ==
          Approx(std::log(std::abs(1 - omega))).margin(1e-9));
    CHECK(largest(omega) > std::abs(1 - omega) * (1 - 1e-9));
  }
  // Young: above the best omega all of a chain's are omega - 1 in size; best is Eq. 7-8
  const double best = 2 / (1 + std::sqrt(1 - rho));
  REQUIRE(best < 1.9);
  for (const double omega : {1.9, best + 0.02}) {
    CHECK(largest(omega) == Approx(omega - 1).margin(1e-5));
    CHECK(least(omega) == Approx(omega - 1).margin(1e-5));
  }
  CHECK(largest(best - 0.05) > largest(best + 0.02));
}

TEST_CASE("in a chain that hangs at rest omega 1.9 leaves a smaller gap than 1") {
  // At rest a step's iterations turn e = beta C/h + h J g into beta C/h, what is left of it.
  const int iterations = 30;
  World world = hanging(10);
  const Step step(world);
  Column g = Column(6 * world.bodies.slots());
  for (int slot = 1; slot < world.bodies.slots(); ++slot) g[6 * slot + 1] = -9.81;
  std::vector<double> rms;
  for (const double omega : {1.0, 1.9}) {
    auto loop = loop_of<real>(world, one_by_one(10));
    loop.relaxation = real(omega);
    loop.iterations = iterations;
    loop = after(loop, 300);
    const Dense H = power(step.H(omega), iterations);
    const Column C = double(h * h) / 0.2 *
                     solved(Dense::identity(H.rows()) - H, H * (step.system.J * g));
    double sum = 0;
    for (std::size_t k = 0; k < 10; ++k) {
      CHECK(double(loop.gap(k)) ==
            Approx(C.rows_from(5 * long(k), 3).norm()).margin(tolerance(1e-10, 2e-5)));
      sum += double(loop.gap(k) * loop.gap(k));
    }
    rms.push_back(std::sqrt(sum / 10));
  }
  CHECK(rms[1] < rms[0]);
}

TEST_CASE("with omega 2.1 a hanging chain diverges") {
  // Two numbers say what a step makes of a mode of the error, and their product is the factor that
  // the iterations leave of it: 1.1^30 in size. So one of them is at least 1.1^15 = 4.2, and 20
  // steps make 10^12 times what rounding left in such a mode: 10^-16 m or, in float, 10^-7 m.
  auto loop = loop_of<real>(hanging(10), one_by_one(10));
  loop.relaxation = real(2.1);
  double most = 0;
  for (int n = 0; n < 40; ++n) {
    loop.step(h);
    for (std::size_t k = 0; k < 10; ++k) most = std::max(most, double(loop.gap(k)));
  }
  CHECK(most > 1e3);
  loop = after(loop, 100);
  for (const Body& body : loop.bodies) CHECK(finite(body.v));  // the engine caps speeds
}
