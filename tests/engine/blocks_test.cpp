// Blocks of one to six rows: solved as an independent dense solver does it, whatever they touch,
// and unharmed by rows that occur twice.
#include "bench/orders.h"
#include "tests/checker/fixtures.h"
#include "tests/oracle/test.h"

using joints::bench::Order;
using joints::bench::OrderedImpulses;

namespace {

const real h = real(1) / 60;

// Two parts on top of each other in one block.
template <class A, class B>
struct Pile {
  A a;
  B b;
  static constexpr int rows = A::rows + B::rows;
  static constexpr bool one_sided = false;
  static constexpr Form form = Form::any;
  Vector<rows> error(const Body& body1, const Body& body2) const {
    Vector<rows> C;
    const Vector<A::rows> upper = to_vector(a.error(body1, body2));
    const Vector<B::rows> lower = to_vector(b.error(body1, body2));
    std::copy(upper.begin(), upper.end(), C.begin());
    std::copy(lower.begin(), lower.end(), C.begin() + A::rows);
    return C;
  }
  Jacobian<rows> jacobian(const Body& body1, const Body& body2) const {
    Jacobian<rows> J;
    const Jacobian<A::rows> upper = to_jacobian(a.jacobian(body1, body2));
    const Jacobian<B::rows> lower = to_jacobian(b.jacobian(body1, body2));
    std::copy(upper.row.begin(), upper.row.end(), J.row.begin());
    std::copy(lower.row.begin(), lower.row.end(), J.row.begin() + A::rows);
    return J;
  }
  Matrix<rows> K(const Body& body1, const Body& body2) const {
    return dense_K(jacobian(body1, body2), body1, body2);
  }
};
template <class A, class B>
void check(const Pile<A, B>&) {}

// One iteration of one block of N random rows against the dense solution.
template <int N>
void compare_with_dense(bool linear, bool angular, unsigned seed) {
  Random random(seed);
  World world = weightless();
  const Pair pair = uneven_pair();
  const BodyId a = world.add(pair.body1), b = world.add(pair.body2);
  auto& joint = world.add<AnyJoint<N>>(a, b);
  for (Row& row : joint.J.row) row = random_row(random, linear, angular);
  for (real& C : joint.C) C = random.uniform(real(-0.1), real(0.1));
  joint.target.beta = real(0.2);
  OrderedImpulses solver;
  begin_step(world, solver, h);
  push_at_random(world.bodies, random);
  const std::vector<Body> start = snapshot(world.bodies);
  const System system = system_of(world.blocks, 2);
  const Dense W = inverse_masses(start);
  const Dense A = system.J * W * system.J.transpose();
  const Column V1 = velocities(start);
  const Column lambda = solved(A, -(system.J * V1 + 0.2 / double(h) * system.C));
  solver.iterate(world.bodies);
  INFO("rows: " << N);
  CHECK(difference(impulses(world.blocks), lambda) < tolerance(1e-10, 2e-3));
  CHECK(difference(velocities(snapshot(world.bodies)), V1 + W * system.J.transpose() * lambda) <
        tolerance(1e-10, 2e-3));
}

// A pendulum box on `count` joints made by add(world, ceiling, box, part).
template <class Add>
std::vector<vec3> swing(const Add& add, OrderedImpulses solver, const StepOptions& stepping,
                        int steps) {
  World world;
  const BodyId ceiling = world.add(static_body(vec3(0)));
  const BodyId body = world.add(box(2, vec3(1, real(0.4), real(0.2)), vec3(1, real(-0.2), 0)));
  add(world, ceiling, body, point_at(world.bodies[ceiling], world.bodies[body], vec3(0)));
  std::vector<vec3> path;
  for (int n = 0; n < steps; ++n) {
    step(world, solver, h, stepping);
    path.push_back(world.bodies[body].x);
    for (double lambda : impulses(world.blocks)) CHECK(std::abs(lambda) < 10);  // [N s]
  }
  return path;
}

double apart(const std::vector<vec3>& one, const std::vector<vec3>& other) {
  double largest = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    if (!finite(one[i]) || !finite(other[i])) return unbounded;
    largest = std::max(largest, double(length(one[i] - other[i])));
  }
  return largest;
}

}  // namespace

TEST_CASE("a block of one to six rows is solved like a dense system of as many") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    compare_with_dense<1>(true, true, seed);
    compare_with_dense<2>(true, true, seed);
    compare_with_dense<3>(true, true, seed);
    compare_with_dense<4>(true, true, seed);
    compare_with_dense<5>(true, true, seed);
    compare_with_dense<6>(true, true, seed);
  }
}

TEST_CASE("a block of linear or of angular rows alone is solved like any other") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    compare_with_dense<1>(true, false, seed);
    compare_with_dense<2>(true, false, seed);
    compare_with_dense<3>(true, false, seed);
    compare_with_dense<1>(false, true, seed);
    compare_with_dense<2>(false, true, seed);
    compare_with_dense<3>(false, true, seed);
  }
}

TEST_CASE("the inverse of a block is that of its regular part where rows depend on others") {
  // row 3 is the sum of rows 1 and 2: it gets no impulse and the others get theirs
  Random random(61);
  for (int draw = 0; draw < 50; ++draw) {
    const Pair pair = uneven_pair();
    Jacobian<3> J;
    J[0] = random_row(random);
    J[1] = random_row(random);
    J[2] = {J[0].v1 + J[1].v1, J[0].w1 + J[1].w1, J[0].v2 + J[1].v2, J[0].w2 + J[1].w2};
    Matrix<3> K = dense_K(J, pair.body1, pair.body2);
    for (int i = 0; i < 3; ++i) {  // dependent to the last bit
      K[2][i] = K[i][2] = K[0][i] + K[1][i];
      if (i == 2) K[2][2] = K[0][2] + K[1][2];
    }
    Matrix<3> inverse = K;
    invert_symmetric(inverse.m[0].data(), 3);
    Vector<3> e{real(0.3), real(-0.7), real(-0.4)}, left = e, lambda{};  // e3 = e1 + e2
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) lambda[i] -= inverse[i][j] * e[j];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) left[i] += K[i][j] * lambda[j];
    for (int i = 0; i < 3; ++i) CHECK(std::abs(double(left[i])) < tolerance(1e-10, 2e-2));
  }
}

TEST_CASE("a row is dependent where no more than 4 epsilon of it are left") {
  for (const int left : {1, 2, 3, 5, 6, 20}) {
    const real cosine = 1 - real(left) * epsilon / 2;  // of the angle between two rows
    real K[] = {1, cosine, cosine, 1};
    const real pivot = 1 - cosine * cosine;
    invert_symmetric(K, 2);
    CAPTURE(left, double(pivot / epsilon));
    CHECK((K[3] != 0) == (left > 4));
  }
}

TEST_CASE("X14 two identical ball joints hold a pendulum as one does") {
  const auto one = [](World& world, BodyId a, BodyId b, const Point& part) {
    world.add<BallJoint>(a, b, part);
  };
  const auto two = [](World& world, BodyId a, BodyId b, const Point& part) {
    world.add<BallJoint>(a, b, part);
    world.add<BallJoint>(a, b, part);
  };
  const auto both_in_one_block = [](World& world, BodyId a, BodyId b, const Point& part) {
    world.add<PartJoint<Pile<Point, Point>>>(a, b, Pile<Point, Point>{part, part});
  };
  for (bool warm : {false, true})
    for (Order order : {Order::forward, Order::alternating}) {
      OrderedImpulses solver;
      StepOptions stepping{.warm_start = warm};
      solver.order = order;
      const std::vector<vec3> path = swing(one, solver, stepping, 300);
      CHECK(length(path.back()) > real(0.9));
      CHECK(apart(path, swing(two, solver, stepping, 300)) < tolerance(1e-10, 1e-2));
      CHECK(apart(path, swing(both_in_one_block, solver, stepping, 300)) < tolerance(1e-10, 1e-2));
    }
}

TEST_CASE("a rod that a ball joint already holds adds nothing and takes nothing away") {
  const auto ball_alone = [](World& world, BodyId a, BodyId b, const Point& part) {
    world.add<BallJoint>(a, b, part);
  };
  const auto ball_and_rod = [](World& world, BodyId a, BodyId b, const Point& part) {
    // from the ceiling's other corner to the anchor of the body: always 2 m
    const Distance rod{part.anchor1_local + vec3(0, 2, 0), part.anchor2_local, 2};
    world.add<PartJoint<Pile<Point, Distance>>>(a, b, Pile<Point, Distance>{part, rod});
  };
  OrderedImpulses solver;
  const std::vector<vec3> path = swing(ball_alone, solver, {}, 120);
  CHECK(apart(path, swing(ball_and_rod, solver, {}, 120)) < tolerance(1e-4, 1e-2));
}
