// Sequential Impulses is block Gauss-Seidel: the same numbers iteration by iteration, the same rate
// of convergence, and the same answer in whatever order the blocks are taken.
#include "bench/orders.h"
#include "tests/oracle/test.h"

using joints::bench::Order;
using joints::bench::OrderedImpulses;

namespace {

const real h = real(1) / 60;

// A bent chain of five uneven boxes below a static body, and a side branch; gaps of some cm.
World bent_chain() {
  World world;
  Random random(31);
  const auto add_box = [&](const vec3& x) {
    return world.add(box(random.uniform(real(0.5), 4), vec3(real(0.9), real(0.3), real(0.5)), x,
                         random.turn()));
  };
  std::vector<BodyId> ids{world.add(static_body(vec3(0), random.turn()))};
  vec3 x(0);
  for (int k = 0; k < 4; ++k)
    ids.push_back(add_box(x += vec3(real(0.7), 0, 0) + random.vector(real(0.4))));
  ids.push_back(add_box(world.bodies[ids[2]].x + vec3(0, -1, 0)));
  for (const auto& [a, b] : {std::pair{0u, 1u}, {1u, 2u}, {2u, 3u}, {3u, 4u}, {2u, 5u}}) {
    const Body &body1 = world.bodies[ids[a]], &body2 = world.bodies[ids[b]];
    Point part = point_at(body1, body2, (body1.x + body2.x) / real(2));
    part.anchor2_local += random.vector(real(0.05));
    world.add<BallJoint>(ids[a], ids[b], part);
  }
  push_at_random(world.bodies, random);
  return world;
}

// One system A lambda = c, c = -(J V1 + b), and block Gauss-Seidel written out for it.
struct GaussSeidel {
  Dense J, W, A;
  Column c, V1, lambda;
  std::vector<int> block;  // of each row

  GaussSeidel(const World& world, const Blocks& blocks, const std::vector<Body>& forced)
      : W(inverse_masses(forced)), V1(velocities(forced)) {
    const System system = system_of(blocks, world.bodies.slots());
    J = system.J;
    A = J * W * J.transpose();
    Column bias(system.C.size());
    for (long i = 0; i < bias.size(); ++i)
      bias[i] = double(blocks.list[std::size_t(system.block[std::size_t(i)])].settings.beta) /
                double(h) * system.C[i];
    c = -(J * V1 + bias);
    lambda = Column(c.size());
    block = system.block;
  }
  void one_block_a_row() {
    for (std::size_t i = 0; i < block.size(); ++i) block[i] = int(i);
  }
  void iterate(bool back) {
    for (int n = block.back() + 1, k = 0; k < n; ++k) {
      const int now = back ? n - 1 - k : k;
      const long first = std::find(block.begin(), block.end(), now) - block.begin();
      const long rows = std::count(block.begin(), block.end(), now);
      const Column left = c.rows_from(first, rows) - A.rows_from(first, rows) * lambda;
      lambda.add(first, 0, solved(A.block(first, first, rows, rows), left));
    }
  }
  Column V() const { return V1 + W * J.transpose() * lambda; }
};

// The bodies after the forces of a step, before any joint has acted.
std::vector<Body> after_forces(const World& world) {
  std::vector<Body> bodies = snapshot(world.bodies);
  for (Body& body : bodies) integrate_forces(body, world.gravity, h);
  return bodies;
}

void compare_iteration_by_iteration(OrderedImpulses& solver, World& world, Order order,
                                    const StepOptions& stepping = {}) {
  solver.order = order;
  const std::vector<Body> forced = after_forces(world);
  begin_step(world, solver, h, stepping);
  GaussSeidel reference(world, world.blocks, forced);
  if (stepping.row_by_row) reference.one_block_a_row();
  reference.lambda = impulses(world.blocks);
  for (int k = 0; k < 12; ++k) {
    solver.iterate_in_order(world.bodies, k);
    reference.iterate(order == Order::backward || (order == Order::alternating && k % 2 == 1));
    CHECK(difference(impulses(world.blocks), reference.lambda) < tolerance(1e-11, 1e-5));
    CHECK(difference(velocities(snapshot(world.bodies)), reference.V()) < tolerance(1e-11, 1e-5));
  }
}

// Hanging plumb from rods: masses from the top, and how fast an iteration brings them to rest.
double late_ratio(const std::vector<real>& masses, int iterations) {
  World world;
  std::vector<BodyId> ids{world.add(static_body(vec3(0)))};
  for (real mass : masses) {
    ids.push_back(world.add(ball(mass, real(0.1), vec3(0, -real(ids.size()), 0))));
    world.add<CentreDistanceJoint>(ids[ids.size() - 2], ids.back(), CentreDistance{1});
  }
  OrderedImpulses solver;
  begin_step(world, solver, h);
  const auto error = [&] {
    const Column V = velocities(snapshot(world.bodies));
    return (system_of(world.blocks, world.bodies.slots()).J * V).norm();
  };
  for (int k = 0; k < iterations; ++k) solver.iterate(world.bodies);
  const double before = error();
  solver.iterate(world.bodies);
  return error() / before;
}

}  // namespace

TEST_CASE("I16 Sequential Impulses is block Gauss-Seidel iteration by iteration") {
  for (bool row_by_row : {false, true})
    for (Order order : {Order::forward, Order::backward, Order::alternating}) {
      World world = bent_chain();
      OrderedImpulses solver;
      compare_iteration_by_iteration(solver, world, order, {.row_by_row = row_by_row});
    }
}

TEST_CASE("I16 a warm start is Gauss-Seidel that begins with the last impulses") {
  for (bool row_by_row : {false, true}) {
    World world = bent_chain();
    OrderedImpulses solver;
    StepOptions stepping;
    stepping.row_by_row = row_by_row;
    stepping.warm_start = true;
    step(world, solver, h, stepping);
    const Column last = impulses(world.blocks);
    CHECK(last.norm() > 1);
    compare_iteration_by_iteration(solver, world, Order::forward, stepping);
    const Column ended = impulses(world.blocks);
    OrderedImpulses probe = solver;
    begin_step(world, probe, h, stepping);  // it begins with the result of the iterations
    CHECK(impulses(world.blocks) == ended);
  }
}

TEST_CASE("I14 two masses below a ceiling converge by m2 over m1 + m2 an iteration") {
  for (real ratio : {real(0.5), real(1), real(10), real(100)})
    CHECK(late_ratio({2, 2 * ratio}, 12) ==
          Approx(double(ratio / (1 + ratio))).epsilon(tolerance(1e-6, 1e-4)));
}

TEST_CASE("I14 n equal masses below a ceiling converge by cos^2 of pi over 2n an iteration") {
  for (const auto& [n, iterations] : {std::pair{2, 10}, {3, 40}, {5, 90}, {10, 350}, {20, 1400}}) {
    const double rate = std::pow(std::cos(std::numbers::pi / (2 * n)), 2);
    CHECK(late_ratio(std::vector<real>(std::size_t(n), real(1.7)), iterations) ==
          Approx(rate).epsilon(1e-4));
  }
}

TEST_CASE("I16 every order of the blocks leads to the one solution") {
  for (Order order : {Order::forward, Order::backward, Order::alternating, Order::shuffled}) {
    World world = bent_chain();
    const std::vector<Body> forced = after_forces(world);
    OrderedImpulses solver;
    solver.order = order;
    begin_step(world, solver, h);
    for (int k = 0; k < 2000; ++k) solver.iterate_in_order(world.bodies, k);
    const GaussSeidel reference(world, world.blocks, forced);
    const Column solution = solved(reference.A, reference.c);
    CHECK(difference(impulses(world.blocks), solution) < tolerance(1e-10, 1e-4));
  }
}

TEST_CASE("a shuffled order is drawn from its seed and from nothing else") {
  const auto run = [](unsigned seed, Order order) {
    World world = bent_chain();
    OrderedImpulses solver;
    solver.order = order;
    solver.seed = seed;
    solver.iterations = 3;
    for (int n = 0; n < 5; ++n) step(world, solver, h);
    return velocities(snapshot(world.bodies));
  };
  const Column seven = run(7, Order::shuffled);
  CHECK((seven == run(7, Order::shuffled)));
  CHECK((seven != run(8, Order::shuffled)));
  CHECK((seven != run(7, Order::forward)));
  CHECK((run(7, Order::forward) == run(8, Order::forward)));
  // the seed that is set is the seed that counts, whatever was drawn before
  World world = bent_chain();
  OrderedImpulses solver;
  solver.order = Order::shuffled;
  solver.iterations = 3;
  begin_step(world, solver, h);
  solver.iterate_in_order(world.bodies, 0);
  for (unsigned seed : {7u, 0u}) {
    World again = bent_chain();
    solver.seed = seed;
    for (int n = 0; n < 5; ++n) step(again, solver, h);
    CHECK((velocities(snapshot(again.bodies)) == run(seed, Order::shuffled)));
  }
}
