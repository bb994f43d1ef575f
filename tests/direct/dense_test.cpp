// The direct solver against dense matrices and against many iterations: the same velocities.
#include "tests/direct/rigs.h"
#include "tests/oracle/test.h"

namespace {

const real h = sixtieth;

// A prepared step, and the velocities that a dense solve of all its rows gives.
struct Solved {
  Column before, expected;
  double smallest = 0;  // eigenvalue of A over its largest

  Solved(const World& world, double beta) {
    const std::vector<Body> bodies = snapshot(world.bodies);
    const System system = system_of(world.blocks, int(bodies.size()));
    const Dense W = inverse_masses(bodies);
    before = velocities(bodies);
    const Dense A = system.J * W * system.J.transpose();
    const Column lambda = solved(A, -(system.J * before + beta / double(h) * system.C));
    expected = before + W * system.J.transpose() * lambda;
    const Column values = symmetric_eigenvalues(A);
    smallest = values[0] / values[values.rows() - 1];
  }
};

}  // namespace

TEST_CASE("velocities of any mechanism with loops are those of a dense solve") {
  Random random(901);
  int tried = 0, loops = 0;
  for (int n = 0; n < 120; ++n) {
    CAPTURE(n);
    const int count = 4 + n % 5, more = n % 3;
    World world = mechanism(random, count, more);
    feed_back_all(world);
    displace_at_random(world.bodies, random, real(0.02));
    push_at_random(world.bodies, random);
    DirectSolver solver = DirectSolver::velocities_only();
    begin_step(world, solver, h);
    const Solved dense(world, 1);
    if (dense.smallest < 1e-6) continue;  // nearly dependent: no solver is exact there
    ++tried;
    loops += more > 0;
    solver.solve(world.bodies);
    const Column found = velocities(snapshot(world.bodies));
    const double size = std::max(1.0, dense.expected.largest());
    // rows in loops are softened: what that leaves grows as the least eigenvalue shrinks
    const double most = more > 0 ? tolerance(1e-6, 0.1) : tolerance(1e-9, 1e-3);
    CHECK((found - dense.expected).largest() < most * size);
    CHECK((found - dense.before).largest() > 0.1);  // there was something to do
  }
  CHECK(tried > 30);
  CHECK(loops > 15);
}

TEST_CASE("rows of any numbers between any bodies are solved as a dense system") {
  Random random(902);
  for (int n = 0; n < 40; ++n) {
    World world;
    std::vector<BodyId> ids;
    for (int k = 0; k < 6; ++k)
      ids.push_back(world.add(k == 0 ? static_body(vec3(0))
                                     : body_with(random.uniform(1, 2), vec3(1, 2, real(2.5)),
                                                 random.vector(1), random.turn())));
    const auto add = [&]<int N>(std::integral_constant<int, N>, int a, int b) {
      auto& joint = world.add<AnyJoint<N>>(ids[std::size_t(a)], ids[std::size_t(b)]);
      for (int i = 0; i < N; ++i) joint.J[i] = random_row(random), joint.C[i] = real(0.01);
      joint.target.beta = 1;
    };
    add(std::integral_constant<int, 4>{}, 0, 1);
    add(std::integral_constant<int, 1>{}, 1, 2);
    add(std::integral_constant<int, 6>{}, 2, 3);
    add(std::integral_constant<int, 2>{}, 3, 4);
    add(std::integral_constant<int, 5>{}, 4, 5);
    add(std::integral_constant<int, 3>{}, 5, 1);
    add(std::integral_constant<int, 1>{}, 0, 4);
    push_at_random(world.bodies, random);
    DirectSolver solver = DirectSolver::velocities_only();
    begin_step(world, solver, h);
    const Solved dense(world, 1);
    if (dense.smallest < 1e-4) continue;
    solver.solve(world.bodies);
    CHECK(difference(velocities(snapshot(world.bodies)), dense.expected) < tolerance(1e-9, 1e-4));
  }
}

TEST_CASE("the direct solver finds what 30,000 iterations find, impulses and velocities") {
  World direct, iterated;
  for (World* world : {&direct, &iterated}) {
    Random random(903);
    std::vector<BodyId> ids{world->add(static_body(vec3(0)))};
    for (int k = 1; k <= 6; ++k) {
      const BodyId before = ids[std::size_t(k < 4 ? k - 1 : k - 3)];
      const vec3 x = world->bodies[before].x + vec3(real(0.8), 0, k < 4 ? real(0) : real(0.6));
      const vec3 size(real(0.7), real(0.3), real(0.4));
      ids.push_back(world->add(box(random.uniform(1, 3), size, x)));
      const vec3 anchor = (x + world->bodies[before].x) / real(2);
      auto& hinge = world->add<HingeJoint>(before, ids.back(), anchor,
                                           vec3(0, 1, 1));
      if (k == 3) hinge.set_motor(2, 5);
      if (k == 5) hinge.set_limits(0, 1);
    }
    push_at_random(world->bodies, random, 1);
  }
  DirectSolver solver = DirectSolver::velocities_only();
  SequentialImpulses many;
  many.iterations = 30000;  // a chain of hinges: many are needed
  step(direct, solver, h);
  step(iterated, many, h);
  const Column found = impulses(direct.blocks), expected = impulses(iterated.blocks);
  REQUIRE(found.size() == expected.size());
  CHECK(found.norm() > 1);
  CHECK((found - expected).largest() < tolerance(1e-7, 1e-2) * expected.largest());
  CHECK(difference(velocities(snapshot(direct.bodies)), velocities(snapshot(iterated.bodies))) <
        tolerance(1e-7, 1e-4));
}

TEST_CASE("joints twice over are held once: the second one's rows depend on the first one's") {
  World once, twice;
  for (World* world : {&once, &twice}) {
    Random random(905);
    *world = mechanism(random, 5, 1);
    feed_back_all(*world);
    const BodyId a = world->add(static_body(vec3(3, 0, 0)));
    const BodyId b = world->add(body_with(2, vec3(1, 2, real(2.5)), vec3(4, 0, 0)));
    for (int n = world == &once ? 1 : 2; n > 0; --n)
      world->add<HingeJoint>(a, b, vec3(real(3.5), 0, 0), vec3(0, 1, 1));
    push_at_random(world->bodies, random);
  }
  DirectSolver one = DirectSolver::velocities_only(), other = one;
  step(once, one, h);
  step(twice, other, h);
  CHECK(one.dependent() == 0);
  CHECK(other.dependent() == 5);
  CHECK(difference(velocities(snapshot(twice.bodies)), velocities(snapshot(once.bodies))) <
        tolerance(1e-9, 1e-4));
}
