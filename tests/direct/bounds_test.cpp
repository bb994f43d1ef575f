// Bounded rows of the direct solver, motors, limits and ropes: the active set against trying every
// combination of sides.
#include "tests/direct/rigs.h"
#include "tests/oracle/test.h"

namespace {

const real h = sixtieth;

// A tree of two to five bodies whose hinges and sliders have motors and limits, five at most.
World driven(Random& random) {
  World world;
  const int count = 2 + int(random.uniform(0, real(3.99)));
  std::vector<BodyId> ids{world.add(static_body(vec3(0)))};
  int bounded = 0;
  const auto drive = [&](auto& joint) {
    const int what = int(random.uniform(0, real(3.99)));  // 1: motor, 2: limits, 3: both
    if (what % 2 == 1 && bounded < 5) {
      joint.set_motor(random.uniform(-2, 2), random.uniform(1, 60));
      ++bounded;
    }
    if (what >= 2 && bounded < 5) {
      const real room = random.uniform(0, real(0.02));
      joint.set_limits(-room, random.uniform(0, real(0.02)));
      ++bounded;
    }
  };
  for (int k = 1; k < count; ++k) {
    const quat q = random.turn();
    const vec3 x = random.vector(2);
    ids.push_back(world.add(body_with(random.uniform(1, 3),
                                      vec3(real(0.2), real(0.3), real(0.4)), x, q)));
    const BodyId before = ids[std::size_t(random.uniform(0, real(k) - real(0.01)))];
    const vec3 anchor = (x + world.bodies[before].x) / real(2);
    const vec3 axis = random.vector(1) + vec3(0, 0, real(1.1));
    if (random.uniform(0, 1) < real(0.6))
      drive(world.add<HingeJoint>(before, ids.back(), anchor, axis));
    else
      drive(world.add<SliderJoint>(before, ids.back(), anchor, axis));
  }
  feed_back_all(world);
  push_at_random(world.bodies, random);
  return world;
}

// The hard problem: of all combinations of sides the one that breaks the bounds least.
struct Enumerated {
  Column V;          // velocities
  double broken = 0;  // by how much an impulse or a rate is on the wrong side there
  int bounded = 0;

  explicit Enumerated(const World& world) {
    const std::vector<Body> bodies = snapshot(world.bodies);
    const System system = system_of(world.blocks, int(bodies.size()));
    const Dense W = inverse_masses(bodies);
    const Column before = velocities(bodies);
    A = system.J * W * system.J.transpose();
    const long rows = A.rows();
    Column wanted(rows);
    for (const Block& block : world.blocks.list)
      for (int i = 0; i < block.rows; ++i) {
        const double C = double(world.blocks.C[std::size_t(block.first + i)]);
        const bool last = i + 1 == block.rows;
        wanted[block.first + i] = (block.settings.holds_position ? -C / double(h) : 0) +
                                  (last ? double(block.settings.rate) : 0);
      }
    right = wanted - system.J * before;
    for (const Block& block : world.blocks.list)
      if (block.settings.lower > -unbounded || block.settings.upper < unbounded)
        bounds.push_back({block.first + block.rows - 1, double(h * block.settings.lower),
                          double(h * block.settings.upper)});
    bounded = int(bounds.size());
    broken = INFINITY;
    int combinations = 1;
    for (int k = 0; k < bounded; ++k) combinations *= 3;
    Column best(rows);
    for (int n = 0; n < combinations; ++n) attempt(n, best);
    V = before + W * system.J.transpose() * best;
  }

 private:
  struct Bound {
    long row;
    double lower, upper;
  };
  Dense A;
  Column right;
  std::vector<Bound> bounds;

  // 0: free, 1: at the lower bound, 2: at the upper one
  void attempt(int combination, Column& best) {
    std::vector<int> free;
    Column lambda(A.rows());
    std::vector<int> sides;
    for (const Bound& bound : bounds) {
      const int side = combination % 3;
      combination /= 3;
      if (side > 0) lambda[bound.row] = side == 1 ? bound.lower : bound.upper;
      if (std::isinf(lambda[bound.row])) return;
      sides.push_back(side);
    }
    for (int row = 0; row < int(A.rows()); ++row) {
      bool is_free = true;
      for (std::size_t k = 0; k < bounds.size(); ++k)
        is_free = is_free && (bounds[k].row != row || sides[k] == 0);
      if (is_free) free.push_back(row);
    }
    const Column rest = right - A * lambda;
    Dense square(long(free.size()), long(free.size()));
    Column side(long(free.size()));
    for (std::size_t i = 0; i < free.size(); ++i) {
      side[long(i)] = rest[free[i]];
      for (std::size_t j = 0; j < free.size(); ++j) square(long(i), long(j)) = A(free[i], free[j]);
    }
    const Column found = solved(square, side);
    double wrong = (square * found - side).largest();
    for (std::size_t i = 0; i < free.size(); ++i) lambda[free[i]] = found[long(i)];
    const Column rate = A * lambda - right;
    for (std::size_t k = 0; k < bounds.size(); ++k) {
      const auto& [row, lower, upper] = bounds[k];
      wrong = std::max({wrong, lower - lambda[row], lambda[row] - upper});
      if (sides[k] == 1) wrong = std::max(wrong, -rate[row]);
      if (sides[k] == 2) wrong = std::max(wrong, rate[row]);
    }
    if (!(wrong < broken)) return;
    broken = wrong;
    best = lambda;
  }
};

}  // namespace

TEST_CASE("motors and limits end on the sides that are left when all others are tried") {
  Random random(921);
  int cases = 0, exceptions = 0, most = 0, both = 0;
  double passes = 0, worst = 0;
  while (cases < (is_float ? 200 : 1000)) {
    World world = driven(random);
    DirectSolver solver = DirectSolver::velocities_only();
    begin_step(world, solver, h);
    const Enumerated hard(world);
    if (hard.bounded == 0) continue;
    ++cases;
    REQUIRE(hard.broken < tolerance(1e-7, 1e-4));
    solver.solve(world.bodies);
    both += hard.bounded > 1;
    most = std::max(most, solver.report().passes);
    passes += solver.report().passes;
    const double off = difference(velocities(snapshot(world.bodies)), hard.V);
    if (off > tolerance(1e-5, 1e-3)) {
      ++exceptions;
      WARN("case " << cases << ": " << hard.bounded << " bounded rows, " << off << " off, "
                   << solver.report().passes << " passes, " << solver.report().wrong << " wrong");
    } else {
      worst = std::max(worst, off);
    }
  }
  INFO(passes / cases << " passes on average, " << most << " at most; " << exceptions
                      << " exceptions, else " << worst << " off");
  CHECK(exceptions <= 2);
  CHECK(most <= 10);
  CHECK(both > cases / 4);
  CHECK(passes / cases > 1);
}
