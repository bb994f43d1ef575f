// Soft rows: a frequency and a damping ratio in place of beta are a spring and a damper, stepped by
// implicit Euler (math: Catto 2011).
#include "tests/oracle/test.h"

namespace {

// The coefficients of one soft row that feels the inverse mass K, from spring and damper.
struct Spring {
  double omega, k, c, gamma, beta;
  Spring(double K, double frequency, double damping, double h) {
    const double m = 1 / K;
    omega = 2 * std::numbers::pi * frequency;
    k = m * omega * omega;
    c = 2 * m * damping * omega;
    gamma = 1 / (h * (c + h * k));
    beta = h * k / (c + h * k);
  }
};

// Two bodies that fly apart, a joint of N random rows between them, and one iteration.
template <int N>
struct SoftPair {
  World world;
  AnyJoint<N>* joint = nullptr;
  SequentialImpulses solver;
  StepOptions stepping{};
  Column V1, C;
  Dense K, J;

  SoftPair(Random& random, const RowSettings& target, real h) {
    world.gravity = vec3(0);
    const Pair pair = uneven_pair();
    const BodyId a = world.add(pair.body1), b = world.add(pair.body2);
    joint = &world.add<AnyJoint<N>>(a, b);
    for (Row& row : joint->J.row) row = random_row(random);
    for (real& error : joint->C) error = random.uniform(real(-0.3), real(0.3));
    joint->target = target;
    begin_step(world, solver, h);
    push_at_random(world.bodies, random);
    V1 = velocities(snapshot(world.bodies));
    const System system = system_of(world.blocks, 2);
    J = system.J;
    C = system.C;
    K = J * inverse_masses(snapshot(world.bodies)) * J.transpose();
    solver.iterate(world.bodies);
  }
  Column rate() const { return J * velocities(snapshot(world.bodies)); }
  Column lambda() const { return impulses(world.blocks); }
};

}  // namespace

TEST_CASE("I19 a soft row is a spring and a damper stepped by implicit Euler") {
  Random random(51);
  for (int draw = 0; draw < 200; ++draw) {
    const real f = random.uniform(real(0.2), 30), zeta = random.uniform(0, 2);
    const real h = random.uniform(real(0.002), real(0.05));
    SoftPair<1> pair(random, {.frequency = f, .damping = zeta}, h);
    const double m = 1 / pair.K(0, 0), t = double(h), before = (pair.J * pair.V1)[0];
    const Spring s(pair.K(0, 0), double(f), double(zeta), t);
    const double expected =
        (before - t * s.k * pair.C[0] / m) / (1 + t * s.c / m + t * t * s.k / m);
    CHECK(std::abs(pair.rate()[0] - expected) < tolerance(1e-12, 1e-4));
    // the other form of the same coefficients: what is left is gamma lambda
    const double lambda = -(before + s.beta * pair.C[0] / t) / (pair.K(0, 0) + s.gamma);
    CHECK(std::abs(pair.lambda()[0] - lambda) < tolerance(1e-12, 1e-4));
    CHECK(std::abs(pair.rate()[0] + s.beta * pair.C[0] / t + s.gamma * pair.lambda()[0]) <
          tolerance(1e-11, 2e-3));
  }
}

TEST_CASE("I19 a mass on a soft row swings as implicit Euler swings it") {
  const double f = 2, zeta = 0.1, t = 1.0 / 60, m = 3;
  World world = weightless();
  const BodyId wall = world.add(static_body(vec3(0)));
  const BodyId body = world.add(ball(real(m), 1, vec3(real(0.5), 0, 0)));
  auto& joint = world.add<AnyJoint<1>>(wall, body);
  joint.J[0] = {vec3(-1, 0, 0), vec3(0), vec3(1, 0, 0), vec3(0)};
  joint.target = {.frequency = real(f), .damping = real(zeta)};
  const Spring s(1 / m, f, zeta, t);
  double x = 0.5, v = 0;
  SequentialImpulses solver;
  solver.iterations = 4;  // one block: more iterations must change nothing
  for (int n = 0; n < 120; ++n) {
    joint.C[0] = world.bodies[body].x.x;
    step(world, solver, real(t));
    v = (v - t * s.k * x / m) / (1 + t * s.c / m + t * t * s.k / m);
    x += t * v;
    CHECK(std::abs(double(world.bodies[body].x.x) - x) < tolerance(1e-12, 1e-4));
  }
}

TEST_CASE("a soft block has the same frequency in every direction") {
  Random random(52);
  const double t = 1.0 / 60, f = 5, zeta = 0.7;
  const double omega = 2 * std::numbers::pi * f, a1 = 2 * zeta + t * omega, a2 = t * omega * a1;
  for (int draw = 0; draw < 50; ++draw) {
    SoftPair<3> pair(random, {.frequency = real(f), .damping = real(zeta)}, real(t));
    const auto left = [&]() -> double {  // J V + b + gamma lambda, gamma = K/a2
      const Column e = pair.rate() + omega / a1 * pair.C + pair.K * pair.lambda() / a2;
      return e.largest();
    };
    CHECK(left() < tolerance(1e-11, 1e-3));
    const Column one =
        (pair.J * pair.V1 - t * omega * omega * pair.C) / (1 + 2 * zeta * omega * t +
                                                           omega * omega * t * t);
    CHECK((pair.rate() - one).largest() < tolerance(1e-11, 1e-3));
    pair.solver.iterate(pair.world.bodies);  // a second iteration keeps what the first one found
    CHECK(left() < tolerance(1e-11, 1e-3));
  }
}

TEST_CASE("a soft block with a bound keeps the bound and the spring of the other rows") {
  Random random(53);
  const double t = 1.0 / 60, f = 5, zeta = 0.7;
  const double omega = 2 * std::numbers::pi * f, a1 = 2 * zeta + t * omega, a2 = t * omega * a1;
  int bounded = 0;
  for (int draw = 0; draw < 50; ++draw) {
    SoftPair<3> pair(
        random, {.frequency = real(f), .damping = real(zeta), .lower = -6, .upper = 6}, real(t));
    const Column e = pair.rate() + omega / a1 * pair.C + pair.K * pair.lambda() / a2;
    CHECK(std::abs(pair.lambda()[2]) <= 6 * t * (1 + tolerance(1e-12, 1e-5)));
    CHECK(e.rows_from(0, 2).largest() < tolerance(1e-11, 1e-3));
    if (std::abs(e[2]) > 0.01) {
      ++bounded;
      CHECK(pair.lambda()[2] * e[2] < 0);  // pushes as hard as it may and still lacks that much
      CHECK(std::abs(pair.lambda()[2]) == Approx(6 * t).epsilon(tolerance(1e-12, 1e-5)));
    }
  }
  CHECK(bounded > 10);
}

TEST_CASE("the stiffest soft row removes its whole error in one step") {
  Random random(54);
  const real h = real(1) / 60;
  SoftPair<2> pair(random, {.frequency = real(1e6)}, h);
  CHECK((pair.rate() + pair.C / double(h)).largest() < tolerance(1e-3, 1e-2));
  SoftPair<2> hard(random, {.beta = 1}, h);
  CHECK((hard.rate() + hard.C / double(h)).largest() < tolerance(1e-11, 1e-3));
}

TEST_CASE("soft rows that share bodies settle at the solution of A + gamma") {
  Random random(55);
  const double t = 1.0 / 60;
  const double frequencies[] = {4, 9};
  World world = weightless();
  const Pair pair = uneven_pair();
  const BodyId a = world.add(pair.body1), b = world.add(pair.body2);
  for (double f : frequencies) {
    auto& joint = world.add<AnyJoint<1>>(a, b);
    joint.J[0] = random_row(random);
    joint.C[0] = random.uniform(real(-0.3), real(0.3));
    joint.target = {.frequency = real(f), .damping = real(0.5)};
  }
  SequentialImpulses solver;
  begin_step(world, solver, real(t));
  push_at_random(world.bodies, random);
  const std::vector<Body> start = snapshot(world.bodies);
  const System system = system_of(world.blocks, 2);
  Dense A = system.J * inverse_masses(start) * system.J.transpose();
  Column c = -(system.J * velocities(start));
  for (long i = 0; i < 2; ++i) {
    const Spring s(A(i, i), frequencies[i], 0.5, t);
    A(i, i) += s.gamma;
    c[i] -= s.beta * system.C[i] / t;
  }
  for (int k = 0; k < 500; ++k) solver.iterate(world.bodies);
  CHECK(difference(impulses(world.blocks), solved(A, c)) < tolerance(1e-12, 1e-4));
}
