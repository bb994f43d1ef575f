// What accumulated and clamped impulses settle at, against an oracle that tries every combination
// of bounds.
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;
const double inf = std::numeric_limits<double>::infinity();

// The one lambda between the bounds with w = A lambda - c zero where lambda is inside its bounds,
// not negative at a lower and not positive at an upper one: by trying all combinations.
Column enumerate(const Dense& A, const Column& c, const Column& lower, const Column& upper) {
  const long n = c.size();
  std::vector<int> state(std::size_t(n), 0);  // 0 inside, 1 at the lower, 2 at the upper bound
  for (;;) {
    std::vector<int> free;
    Column lambda = Column(n);
    bool possible = true;
    for (long i = 0; i < n; ++i) {
      const int s = state[std::size_t(i)];
      if (s == 0) free.push_back(int(i));
      else possible = possible && std::isfinite(lambda[i] = s == 1 ? lower[i] : upper[i]);
    }
    if (possible) {
      if (!free.empty()) {
        const Dense inner = A.rows_at(free).transpose().rows_at(free);  // A is symmetric
        const Column inside = solved(inner, (c - A * lambda).rows_at(free));
        for (std::size_t k = 0; k < free.size(); ++k) lambda[free[k]] = inside[long(k)];
      }
      const Column w = A * lambda - c;
      for (long i = 0; i < n; ++i) {
        const int s = state[std::size_t(i)];
        if (s == 0) possible = possible && lambda[i] >= lower[i] && lambda[i] <= upper[i];
        else possible = possible && (s == 1 ? w[i] >= 0 : w[i] <= 0);
      }
      if (possible) return lambda;
    }
    long i = 0;
    while (i < n && ++state[std::size_t(i)] == 3) state[std::size_t(i++)] = 0;
    REQUIRE(i < n);  // some combination must do
  }
}

Column all_of(long n, double number) { return {n, 1, std::vector(std::size_t(n), number)}; }

// The system of the blocks of a step and the bounds of its rows.
struct Bounded {
  Dense A;
  Column c, lower, upper;
  Column solution() const { return enumerate(A, c, lower, upper); }
};
Bounded bounded(const Blocks& blocks, const std::vector<Body>& forced, real step) {
  const System system = system_of(blocks, int(forced.size()));
  const Dense W = inverse_masses(forced);
  const long n = system.C.size();
  Bounded out{system.J * W * system.J.transpose(), -(system.J * velocities(forced)),
              all_of(n, -inf), all_of(n, inf)};
  for (const Block& block : blocks.list) {
    const long first = block.first, last = first + block.rows - 1;
    const RowSettings& target = block.settings;
    for (long i = first; i <= last; ++i) {
      const bool ahead = i == last && target.lower == 0 && target.upper == unbounded &&
                         system.C[i] > 0;  // gap that may be used up
      out.c[i] -= (ahead ? 1 : double(target.beta)) * system.C[i] / double(step);
    }
    out.c[last] += double(target.rate);
    out.lower[last] = double(step) * double(target.lower);
    out.upper[last] = double(step) * double(target.upper);
  }
  return out;
}

// Body in the middle, four walls around it, a rope to each, some slack, some stretched.
World body_on_ropes(Random& random) {
  World world = weightless();
  const BodyId body = world.add(box(2, vec3(1, real(0.6), real(0.3)), vec3(0), random.turn()));
  for (int k = 0; k < 4; ++k) {
    const BodyId wall = world.add(static_body(random.vector(1) + vec3(0, 2, 0)));
    Rope<Distance> rope{{vec3(0), random.vector(real(0.5)), 1}};
    const real length = real(1) - rope.error(world.bodies[wall], world.bodies[body]);
    rope.rod.length = length + random.uniform(real(-0.01), real(0.01));
    world.add<RopeJoint>(wall, body, rope);
  }
  return world;
}

}  // namespace

TEST_CASE("I17 accumulated clamped iterations settle at the pull that trying everything finds") {
  Random random(41);
  int pulling = 0, idle = 0;
  for (int draw = 0; draw < 40; ++draw) {
    World world = body_on_ropes(random);
    SequentialImpulses solver;
    begin_step(world, solver, h);
    push_at_random(world.bodies, random);
    const Column expected =
        bounded(world.blocks, snapshot(world.bodies), h).solution();
    for (int k = 0; k < 20000; ++k) solver.iterate(world.bodies);
    const Column found = impulses(world.blocks);
    CHECK(difference(found, expected) < tolerance(1e-9, 1e-2));
    for (double lambda : expected) ++(lambda > 0 ? pulling : idle);
  }
  CHECK(pulling > 20);  // both kinds were there
  CHECK(idle > 20);
}

TEST_CASE("I17 clamping each change instead of the accumulated impulse leaves a rope pulling") {
  // rope 1 would pull along x, rope 2 along (0.8, 0.6); only rope 2 is needed in the end
  World world = weightless();
  const BodyId body = world.add(ball(1, real(0.1), vec3(0)));
  for (const vec3& end : {vec3(2, 0, 0), vec3(real(1.6), real(1.2), 0)})
    world.add<CentreRopeJoint>(world.add(static_body(end)), body, Rope<CentreDistance>{{2}});
  SequentialImpulses solver;
  begin_step(world, solver, h);
  world.bodies[body].v = vec3(-1, -3, 0);
  const System system = system_of(world.blocks, 3);
  const Dense W = inverse_masses(snapshot(world.bodies));
  Column V = velocities(snapshot(world.bodies)), wrong = Column(2);
  for (int k = 0; k < 200; ++k)
    for (long i = 0; i < 2; ++i) {
      const double dlambda = std::max(0.0, -(system.J.rows_from(i, 1) * V)[0]);  // each one clamped
      wrong[i] += dlambda;
      V += dlambda * (W * system.J.rows_from(i, 1).transpose());
    }
  for (int k = 0; k < 200; ++k) solver.iterate(world.bodies);
  const Column right = impulses(world.blocks);
  const double near = tolerance(1e-12, 1e-5);
  CHECK(std::abs(wrong[0] - 1) < near);
  CHECK(std::abs(wrong[1] - 1.8) < near);
  CHECK(std::hypot(V[0] - 1.44, V[1] + 1.92) < near);
  CHECK(std::abs(right[0]) < near);
  CHECK(std::abs(right[1] - 2.6) < near);
  CHECK(length(world.bodies[body].v - vec3(real(1.08), real(-1.44), 0)) < near);
}

TEST_CASE("the last row of a block stays within its bounds while the others hold exactly") {
  Random random(42);
  int inside = 0, below = 0, above = 0;
  for (int draw = 0; draw < 200; ++draw) {
    World world = weightless();
    const Pair pair = uneven_pair();
    const BodyId a = world.add(pair.body1), b = world.add(pair.body2);
    auto& joint = world.add<AnyJoint<4>>(a, b);
    for (Row& row : joint.J.row) row = random_row(random);
    for (real& C : joint.C) C = random.uniform(real(-0.02), real(0.02));
    const real step = draw % 2 ? h : h / 4;  // bounds are forces: their impulses go with the step
    joint.target = {.beta = real(0.2), .rate = random.uniform(-3, 3),
                    .lower = random.uniform(-60, 0), .upper = random.uniform(0, 60)};
    SequentialImpulses solver;
    begin_step(world, solver, step);
    push_at_random(world.bodies, random);
    const Bounded system = bounded(world.blocks, snapshot(world.bodies), step);
    const Column expected = system.solution();
    solver.iterate(world.bodies);
    CHECK(difference(impulses(world.blocks), expected) < tolerance(1e-11, 1e-3));
    solver.iterate(world.bodies);  // and stays there
    CHECK(difference(impulses(world.blocks), expected) < tolerance(1e-11, 1e-3));
    ++(expected[3] == system.lower[3] ? below : expected[3] == system.upper[3] ? above : inside);
  }
  CHECK(std::min({inside, below, above}) > 20);
}

TEST_CASE("blocks with a bounded last row settle together at the one solution") {
  Random random(43);
  for (int draw = 0; draw < 20; ++draw) {
    World world = weightless();
    std::vector<BodyId> ids;
    for (int k = 0; k < 3; ++k)
      ids.push_back(world.add(box(random.uniform(1, 3), vec3(1, real(0.7), real(0.4)), vec3(0),
                                  random.turn())));
    for (const auto& [one, other] : {std::pair{0u, 1u}, {1u, 2u}, {2u, 0u}}) {
      auto& joint = world.add<AnyJoint<2>>(ids[one], ids[other]);
      for (Row& row : joint.J.row) row = random_row(random);
      joint.C[1] = random.uniform(real(-0.02), real(0.05));
      joint.target.beta = real(0.2);
      joint.target.lower = draw % 2 ? 0 : real(-10);
      joint.target.upper = draw % 2 ? unbounded : 25;
    }
    SequentialImpulses solver;
    begin_step(world, solver, h);
    push_at_random(world.bodies, random);
    const Column expected = bounded(world.blocks, snapshot(world.bodies), h).solution();
    for (int k = 0; k < 20000; ++k) solver.iterate(world.bodies);
    CHECK(difference(impulses(world.blocks), expected) < tolerance(1e-9, 3e-3));
  }
}
