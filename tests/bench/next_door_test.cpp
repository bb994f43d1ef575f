// The three solvers next door, on families that a seed draws.
#include "bench/next_door/conjugate_gradients.h"
#include "bench/next_door/nonsmooth.h"
#include "bench/next_door/xpbd.h"
#include "tests/checker/catch.h"
#include "tests/direct/rigs.h"

using namespace joints;
using namespace joints::testing;

namespace {

// Bodies of uneven inertia and of masses from 1 to 10 kg, a tree of joints of any kind that hangs
// on the first one, a little out of place and in motion.
World tree(Random& random, int count) {
  World world;
  std::vector<BodyId> ids{world.add(static_body(vec3(0)))};
  for (int k = 1; k < count; ++k) {
    const real mass = std::exp(random.uniform(0, real(2.3)));
    const vec3 moments(random.uniform(real(0.2), real(0.3)), random.uniform(real(0.3), real(0.4)),
                       random.uniform(real(0.4), real(0.5)));
    ids.push_back(world.add(body_with(mass, mass * moments, random.vector(2), random.turn())));
    join_at_random(world, ids[std::size_t(random.uniform(0, real(k) - real(0.01)))], ids.back(),
                   random);
  }
  displace_at_random(world.bodies, random, real(0.03));
  push_at_random(world.bodies, random);
  feed_back_all(world);
  return world;
}

// Rods, ropes and motors between bodies that only move along straight lines: C of every row is
// linear in the places.
class Straight : public Joint {
 public:
  Row J;
  vec3 begin1, begin2;
  real C = 0;
  RowSettings target;
  mutable real impulse = 0;

  using Joint::Joint;
  void append(const Bodies& bodies, Blocks& blocks) const override {
    const real moved = dot(J.v1, bodies[body1].x - begin1) + dot(J.v2, bodies[body2].x - begin2);
    const real now = target.holds_position ? C + moved : real(0);
    blocks.append(bodies, body1, body2, Jacobian<1>{{J}}, {now}, target, &impulse);
  }
};

World straight_rows(Random& random, int count) {
  World world;
  world.gravity = random.vector(10);
  std::vector<BodyId> ids;
  for (int k = 0; k < count; ++k)
    ids.push_back(world.add(ball(random.uniform(1, 5), 1, random.vector(2))));
  push_at_random(world.bodies, random);
  for (int slot = 0; slot < count; ++slot) world.bodies.at(slot).w = vec3(0);
  for (int k = 1; k < count; ++k) {
    auto& joint = world.add<Straight>(ids[std::size_t(k - 1)], ids[std::size_t(k)]);
    joint.J.v1 = random.vector(1);
    joint.J.v2 = random.vector(1);
    joint.begin1 = world.bodies[joint.body1].x;
    joint.begin2 = world.bodies[joint.body2].x;
    joint.C = random.uniform(real(-0.1), real(0.1));
    joint.target.beta = 1;
    switch (k % 4) {
      case 0: joint.target.lower = 0; break;  // C >= 0
      case 1:
        joint.target.frequency = random.uniform(real(0.1), 50);
        joint.target.damping = random.uniform(0, 2);
        break;
      case 2:  // a motor with a bound
        joint.target.holds_position = false;
        joint.target.rate = random.uniform(-3, 3);
        joint.target.upper = random.uniform(1, 100);
        joint.target.lower = -joint.target.upper;
        joint.C = 0;
    }
  }
  return world;
}

Column velocities_of(const World& world) { return velocities(snapshot(world.bodies)); }

// The rates that rows without bounds still lack after this many iterations of a step, over what
// they lacked before it.
template <class Kind>
double lacking(Kind solver, World world, int iterations) {
  solver.iterations = iterations;
  const real h = sixtieth;
  begin_step(world, solver, h);
  const System system = system_of(world.blocks, world.bodies.slots());
  const auto rates = [&] {
    return (system.J * velocities_of(world) + 1 / double(h) * system.C).norm();
  };
  const double before = rates();
  solver.solve(world.bodies);
  return rates() / before;
}

// A step's velocities by a solver with so many iterations.
template <class Kind>
Column after_step(Kind solver, World world, int iterations, const StepOptions& how = {}) {
  solver.iterations = iterations;
  begin_step(world, solver, sixtieth, how);
  solver.solve(world.bodies);
  return velocities_of(world);
}

}  // namespace

TEST_CASE("conjugate gradients end after as many iterations as rows, or half as many more") {
  int held = 0, held_later = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const auto make = [seed] {
      Random random(seed);
      return tree(random, int(random.uniform(2, 13)));
    };
    World world = make();
    const int rows = int(rows_of(world).J.rows());
    const auto holds = [&](int iterations) {
      return lacking(bench::ConjugateGradients(), make(), iterations) < tolerance(1e-9, 1e-3);
    };
    held += holds(rows);
    held_later += holds(rows + (rows + 1) / 2);
  }
  INFO(held << " and " << held_later << " of 60");
  CHECK(held >= 45);
  CHECK(held_later == 60);
}

TEST_CASE("conjugate gradients on soft rows find what Gauss-Seidel ends with, warm or cold") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const StepOptions how{.warm_start = seed % 2 == 0, .frequency = real(seed) / 2};
    const auto make = [&] {
      Random random(seed);
      World world = tree(random, 6);
      SequentialImpulses few;
      if (how.warm_start) step(world, few, sixtieth, how);
      return world;
    };
    CHECK(difference(after_step(bench::ConjugateGradients(), make(), 60, how),
                     after_step(SequentialImpulses(), make(), 20000, how)) < tolerance(1e-8, 1e-3));
  }
}

TEST_CASE("conjugate gradients refuse a row with a bound") {
  Random random(1);
  World world = straight_rows(random, 5);
  bench::ConjugateGradients solver;
  CHECK_THROWS_AS(step(world, solver, sixtieth), std::invalid_argument);
}

// A chain of bodies with random rows, a third of them one-sided and a third with two bounds.
World bounded_rows(unsigned seed) {
  Random random(seed);
  World world;
  std::vector<BodyId> ids;
  for (int k = 0; k < 12; ++k) {
    const vec3 moments(random.uniform(1, 2), random.uniform(1, 2), random.uniform(1, 2));
    ids.push_back(world.add(body_with(random.uniform(1, 5), moments, vec3(0))));
  }
  push_at_random(world.bodies, random);
  for (int k = 1; k < 12; ++k) {
    auto& joint = world.add<AnyJoint<3>>(ids[std::size_t(k - 1)], ids[std::size_t(k)]);
    for (int i = 0; i < 3; ++i) joint.J[i] = random_row(random);
    if (k % 3 == 0) joint.target.lower = 0;
    if (k % 3 == 1) joint.target.upper = -(joint.target.lower = -real(20));
  }
  return world;
}

TEST_CASE("NNCG ends with the impulses of Gauss-Seidel, bounds included, and sooner") {
  int sooner = 0, clamped = 0;
  const int draws = 40;
  for (unsigned seed = 1; seed <= unsigned(draws); ++seed) {
    const auto after = [seed](auto solver, int iterations) {
      return after_step(solver, bounded_rows(seed), iterations);
    };
    const Column end = after(SequentialImpulses(), 50000);
    CHECK(difference(after(bench::NonsmoothGradients(), 2000), end) < tolerance(1e-9, 1e-3));
    const auto off = [&](const Column& velocities) { return (velocities - end).norm(); };
    sooner += off(after(bench::NonsmoothGradients(), 40)) < off(after(SequentialImpulses(), 40));

    World world = bounded_rows(seed);
    bench::NonsmoothGradients few;
    few.iterations = 7;
    begin_step(world, few, sixtieth);
    few.solve(world.bodies);
    for (const Block& block : world.blocks.list) {
      const real lambda = block.impulse[block.rows - 1];
      CHECK(lambda >= block.settings.lower * sixtieth);
      CHECK(lambda <= block.settings.upper * sixtieth);
      clamped += lambda == block.settings.lower * sixtieth ||
                 lambda == block.settings.upper * sixtieth;
    }
  }
  INFO(sooner << " of " << draws << " sooner");
  CHECK(sooner >= draws * 7 / 10);
  CHECK(clamped > draws);
}

TEST_CASE("an iteration of XPBD is one of Gauss-Seidel where C is linear, springs and bounds") {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Random random(seed), again(seed);
    World one = straight_rows(random, 9), other = straight_rows(again, 9);
    bench::Xpbd xpbd;
    SequentialImpulses impulses;
    impulses.iterations = 1;
    const StepOptions how{.substeps = int(random.uniform(1, 4))};
    for (int n = 0; n < 3; ++n) {
      step(one, xpbd, sixtieth, how);
      step(other, impulses, sixtieth, how);
    }
    CHECK(difference(velocities_of(one), velocities_of(other)) < tolerance(1e-9, 1e-3));
  }
}

TEST_CASE("XPBD without compliance closes the gaps of any tree") {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    World world = tree(random, int(random.uniform(2, 7)));
    world.gravity = vec3(0);
    for (int slot = 0; slot < world.bodies.slots(); ++slot)
      world.bodies.at(slot).v = world.bodies.at(slot).w = vec3(0);
    const double before = rows_of(world).C.largest();
    bench::Xpbd solver;
    solver.iterations = 3000;
    step(world, solver, sixtieth);
    INFO("seed " << seed << ", before " << before);
    CHECK(rows_of(world).C.largest() < tolerance(1e-7, 1e-4));
  }
}

TEST_CASE("a load on a spring k sags by m g/k with XPBD, whatever mass, substeps and damping") {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    World world;
    const real m = std::exp(random.uniform(-3, 5)), frequency = random.uniform(1, 8);
    const BodyId wall = world.add(static_body(vec3(0)));
    const BodyId load = world.add(ball(m, real(0.1), vec3(0, -1, 0)));
    auto& spring = world.add<CentreDistanceJoint>(wall, load, CentreDistance{1});
    spring.frequency = frequency;
    spring.damping = random.uniform(real(0.3), 1);
    bench::Xpbd solver;
    solver.iterations = int(random.uniform(1, 4));
    const StepOptions how{.substeps = int(random.uniform(1, 20))};
    for (int n = 0; n < 1200; ++n) step(world, solver, sixtieth, how);
    const double omega = 2 * 3.14159265358979 * double(frequency), k = double(m) * omega * omega;
    CHECK(-double(world.bodies[load].x.y) - 1 ==
          Approx(double(m) * 9.81 / k).epsilon(tolerance(1e-7, 2e-2)));
  }
}

TEST_CASE("elimination adds to a parent what the articulated-body algorithm adds to it") {
  // J^T (J M^-1 J^T)^-1 J = M - M S (S^T M S)^-1 S^T M where the columns of S span J S = 0
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const auto matrix = [&](long rows, long columns) {
      Dense out(rows, columns);
      for (long i = 0; i < rows; ++i)
        for (long k = 0; k < columns; ++k) out(i, k) = double(random.uniform(-1, 1));
      return out;
    };
    const long rows = 1 + long(seed % 5);
    const Dense J = matrix(rows, 6), root = matrix(6, 6);
    const Dense M = root * root.transpose() + 0.1 * Dense::identity(6);
    const Dense S = symmetric_eigenvectors(J.transpose() * J).columns_from(0, 6 - rows);
    REQUIRE((J * S).largest() < 1e-12);
    const Dense eliminated = J.transpose() * inverse_of(J * inverse_of(M) * J.transpose()) * J;
    const Dense articulated = M - M * S * inverse_of(S.transpose() * M * S) * S.transpose() * M;
    CHECK((eliminated - articulated).largest() < 1e-8 * M.largest());
  }
}
