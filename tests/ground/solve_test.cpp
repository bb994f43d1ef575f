// What iterations over contacts settle at, against an oracle that tries every combination of
// pressing or not, sticking or sliding this way or that (identity I17 with bounds that follow).
#include "tests/ground/rigs.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;

// The rows of a step as the oracle sees them: w = A lambda - c is the error of each row's rate.
struct Problem {
  Dense A, response;  // response: W J^T, what impulses do to the velocities
  Column c, forced;   // forced: velocities before the iterations
  std::vector<int> free, normal, friction;  // rows: equalities, normals, a friction's normal
  std::vector<double> mu;                   // of each row, 0 where it is no friction

  Problem(const Blocks& blocks, const std::vector<Body>& bodies) {
    const System system = system_of(blocks, int(bodies.size()));
    response = inverse_masses(bodies) * system.J.transpose();
    forced = velocities(bodies);
    A = system.J * response;
    c = -(system.J * forced);
    friction.assign(std::size_t(c.size()), -1);
    mu.assign(std::size_t(c.size()), 0);
    for (const Block& block : blocks.list) {
      const int last = block.first + block.rows - 1;
      const RowSettings& target = block.settings;
      for (int i = block.first; i <= last; ++i) {
        const bool ahead = i == last && target.lower == 0 && target.follows == 0 &&
                           system.C[i] > 0;  // gap that may be used up
        c[i] -= (ahead ? 1 : double(target.beta)) * system.C[i] / double(h);
      }
      c[last] += double(target.rate);
      if (target.follows != 0) {
        friction[std::size_t(last)] = last + target.follows;  // blocks of one row each
        mu[std::size_t(last)] = double(target.upper);
      } else if (target.lower == 0) {
        normal.push_back(last);
      } else {
        for (int i = block.first; i <= last; ++i) free.push_back(i);
      }
    }
  }

  // The impulses of every consistent state. A normal is off or on; each friction of one that is on
  // sticks, or is at its bound on either side: ten states a corner with two frictions.
  std::vector<Column> solutions() const {
    std::vector<Column> out;
    const int corners = int(normal.size());
    int states = 1;
    for (int k = 0; k < corners; ++k) states *= 10;
    for (int number = 0; number < states; ++number) {
      std::vector<int> unknown = free, on(std::size_t(c.size()), 0);
      std::vector<int> side(std::size_t(c.size()), 0);  // of a friction at its bound
      for (int k = 0, rest = number; k < corners; ++k, rest /= 10) {
        if (rest % 10 == 9) continue;
        unknown.push_back(normal[std::size_t(k)]);
        on[std::size_t(normal[std::size_t(k)])] = 1;
        int digit = rest % 10;
        for (std::size_t i = 0; i < friction.size(); ++i) {
          if (friction[i] != normal[std::size_t(k)]) continue;
          side[i] = digit % 3 - 1;
          digit /= 3;
          if (side[i] == 0) unknown.push_back(int(i));
        }
      }
      if (const Column lambda = solve(unknown, side, on); fits(lambda, side, on))
        out.push_back(lambda);
    }
    return out;
  }

 private:
  Column solve(const std::vector<int>& unknown, const std::vector<int>& side,
               const std::vector<int>& on) const {
    Dense all(c.size(), long(unknown.size()));  // lambda = all x
    for (std::size_t k = 0; k < unknown.size(); ++k) {
      all(unknown[k], long(k)) = 1;
      for (std::size_t i = 0; i < friction.size(); ++i)
        if (friction[i] == unknown[k] && side[i] != 0 && on[std::size_t(friction[i])])
          all(long(i), long(k)) = side[i] * mu[i];
    }
    if (unknown.empty()) return Column(c.size());
    return all * solved((A * all).rows_at(unknown), c.rows_at(unknown));
  }
  bool fits(const Column& lambda, const std::vector<int>& side, const std::vector<int>& on) const {
    const Column w = A * lambda - c;
    const double near = 1e-9 * std::max(1.0, c.largest());
    for (const int i : free)
      if (std::abs(w[i]) > near) return false;
    for (const int i : normal)
      if (lambda[i] < -near || w[i] < -near || (on[std::size_t(i)] && w[i] > near)) return false;
    for (std::size_t i = 0; i < friction.size(); ++i) {
      if (friction[i] < 0 || !on[std::size_t(friction[i])]) continue;
      const double bound = mu[i] * lambda[friction[i]], rate = w[long(i)];
      if (side[i] == 0 && (std::abs(rate) > near || std::abs(lambda[long(i)]) > bound + near))
        return false;
      if (side[i] * rate > near) return false;  // it pushes against what slides
    }
    return true;
  }
};

// A box with one or two corners just over the ground, thrown at it, perhaps on a ball joint.
struct Thrown {
  World world;
  GroundContact* contact;
  SequentialImpulses solver;
  StepOptions stepping{};

  Thrown(Random& random, int corners, bool free_ground, bool on_joint) {
    world.gravity = vec3(0);
    const vec3 slab(8, real(0.5), 8);
    const BodyId ground = world.add(free_ground ? box(15, slab, vec3(0, real(-0.25), 0))
                                                : static_body(vec3(0, real(-0.25), 0)));
    const quat about = rotation(vec3(0, random.uniform(-3, 3), 0));
    const vec3 lean(random.uniform(real(0.2), real(0.7)), 0,  // about an edge, or about both
                    corners == 1 ? random.uniform(real(0.2), real(0.7)) : 0);
    Body made = lowered(random.uniform(real(-0.01), real(0.01)), normalize(about * rotation(lean)));
    made.v = random.vector(2) + vec3(0, real(-3), 0);
    made.w = random.vector(1);
    const BodyId body = world.add(made);
    contact = &world.add<GroundContact>(ground, body, box_top(slab), box_outline(brick));
    contact->friction = random.uniform(real(0.1), real(0.8));
    if (!on_joint) return;
    const BodyId other = world.add(box(5, brick, made.x + vec3(0, 1, 0), random.turn()));
    world.bodies[other].v = random.vector(3);
    world.add<BallJoint>(body, other, point_at(world.bodies[body], world.bodies[other],
                                               made.x + random.vector(real(0.6))));
  }
};

}  // namespace

TEST_CASE("directions of friction are at right angles as exactly as numbers can be, at rest too") {
  Random random(92);
  for (int k = 0; k < 3; ++k)
    for (const double off : {0.0, 1e-12, 1e-9, 1e-6, 1e-3, 1.0}) {
      vec3 n = real(off) * random.vector(1);
      n[k] += 1;
      n = normalize(n);
      const auto t = tangents(n, vec3(0));
      CAPTURE(k, off);
      for (const auto& [a, b] : {std::pair{n, t[0]}, {n, t[1]}, {t[0], t[1]}})
        CHECK(std::abs(double(dot(a, b))) < 4 * double(epsilon));
    }
}

TEST_CASE("I17 iterations settle where trying all of pressing and sticking and sliding ends") {
  Random random(84);
  int sliding = 0, sticking = 0, off = 0, several = 0, two = 0;
  for (int draw = 0; draw < 96; ++draw) {
    const int corners = 1 + draw % 2;
    Thrown thrown(random, corners, draw / 2 % 2, draw / 4 % 2);
    SequentialImpulses& solver = thrown.solver;
    begin_step(thrown.world, solver, h, thrown.stepping);
    const Problem problem(thrown.world.blocks, snapshot(thrown.world.bodies));
    for (int k = 0; k < 20000; ++k) solver.iterate(thrown.world.bodies);
    const Column found = velocities(snapshot(thrown.world.bodies));
    CAPTURE(draw, corners, thrown.contact->touching());
    REQUIRE(problem.normal.size() <= 2);
    const std::vector<Column> all = problem.solutions();
    REQUIRE(!all.empty());
    double nearest = std::numeric_limits<double>::infinity(), spread = 0;
    for (const Column& lambda : all) {
      const Column V = problem.forced + problem.response * lambda;
      nearest = std::min(nearest, difference(found, V));
      spread = std::max(spread,
                        difference(problem.forced + problem.response * all.front(), V));
    }
    CHECK(nearest < tolerance(1e-8, 2e-3));
    // of one corner the impulses are unique as well
    if (problem.normal.size() == 1)
      CHECK(difference(impulses(thrown.world.blocks), all.front()) < tolerance(1e-8, 1e-2));
    several += spread > 1e-6;
    two += problem.normal.size() == 2;
    for (const Touch& touch : touches(thrown.world.blocks))
      for (const double t : {touch.t1, touch.t2})
        ++(touch.normal == 0 ? off : std::abs(t) < 0.999 * touch.mu * touch.normal ? sticking
                                                                                    : sliding);
  }
  CHECK(several == 0);  // with these coefficients there is one answer only
  CHECK(std::min({sliding, sticking, off, two}) > 10);
}

TEST_CASE("bounds that do not follow the normal settle elsewhere than those that do") {
  // the bound of the step's begin, mu times nothing: a box that lands would not be rubbed at all
  Random random(85);
  Thrown thrown(random, 1, false, false);
  thrown.contact->friction = real(0.6);
  SequentialImpulses& solver = thrown.solver;
  begin_step(thrown.world, solver, h, thrown.stepping);
  const Problem problem(thrown.world.blocks, snapshot(thrown.world.bodies));
  solver.iterate(thrown.world.bodies);  // friction comes first: the normal has pressed nothing
  for (const Touch& touch : touches(thrown.world.blocks)) {
    CHECK(touch.normal > 1);
    CHECK(touch.friction() == 0);
  }
  for (int k = 1; k < 1000; ++k) solver.iterate(thrown.world.bodies);
  const Column expected = problem.solutions().front();
  CHECK(difference(impulses(thrown.world.blocks), expected) < tolerance(1e-8, 1e-2));
  for (const Touch& touch : touches(thrown.world.blocks)) CHECK(touch.friction() > 0.1);
}
