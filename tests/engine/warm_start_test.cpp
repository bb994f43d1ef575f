// Warm starting: what the joints remember of the last step, and its worth in the next.
#include "engine/simd/packed.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;

// Masses that hang plumb from a ceiling, one below the other, on ball joints midway.
struct Hanging {
  World world;
  std::vector<BodyId> ids;
  std::vector<BallJoint*> joints;

  explicit Hanging(const std::vector<real>& masses) {
    ids.push_back(world.add(static_body(vec3(0))));
    for (real mass : masses) {
      const real y = -real(ids.size());
      ids.push_back(world.add(box(mass, vec3(real(0.4)), vec3(0, y, 0))));
      const BodyId above = ids[ids.size() - 2];
      joints.push_back(&world.add<BallJoint>(
          above, ids.back(),
          point_at(world.bodies[above], world.bodies[ids.back()], vec3(0, y + real(0.5), 0))));
    }
  }
  void set_beta(real beta) {
    for (BallJoint* joint : joints) joint->beta = beta;
  }
  double rate() { return iteration_rate(world, rows_of(world)); }
  // How far the lowest body has sunk [m].
  double sag() const { return -double(ids.size() - 1) - double(world.bodies[ids.back()].x.y); }
};

// The largest sag in each of the last two seconds of a run [m].
struct Sags {
  double first = 0, second = 0;
  Sags(Hanging hanging, int iterations, const StepOptions& stepping, int steps) {
    SequentialImpulses solver;
    solver.iterations = iterations;
    for (int n = 0; n < steps; ++n) {
      step(hanging.world, solver, h, stepping);
      const double sag = std::abs(hanging.sag());
      if (n >= steps - 60) second = std::max(second, sag);
      else if (n >= steps - 120) first = std::max(first, sag);
    }
  }
};

std::vector<real> ten_links(real tip = 1) {
  std::vector<real> masses(10, real(1));
  masses.back() = tip;
  return masses;
}

// Modulus of the slowest root for a mode that k iterations multiply by eta, warm, fed back:
// z^3 - (1 + 2 eta - (1 - eta) beta) z^2 + 3 eta z - eta = 0.
double growth_of_a_mode(double eta, double beta) {
  return spectral_radius({3, 3, {1 + 2 * eta - (1 - eta) * beta, -3 * eta, eta,
                                 1, 0, 0,
                                 0, 1, 0}});
}

}  // namespace

TEST_CASE("I23 a joint that carries 3 kg pulls with 29.43 N after ten warm steps") {
  Hanging hanging({3});
  SequentialImpulses solver;
  StepOptions stepping{.warm_start = true};
  for (int n = 0; n < 10; ++n) step(hanging.world, solver, h, stepping);
  CHECK(double(hanging.joints[0]->impulse()[1] / h) ==
        Approx(29.43).epsilon(tolerance(1e-9, 1e-5)));
  CHECK(std::abs(hanging.sag()) < tolerance(1e-12, 1e-6));
}

TEST_CASE("I23 warm joints of a chain come to pull as much as hangs from them") {
  Hanging hanging({3, 2, 1});
  SequentialImpulses solver;
  StepOptions stepping{.warm_start = true};
  solver.iterations = 2;
  for (int n = 0; n < 2000; ++n) step(hanging.world, solver, h, stepping);
  const double weight[] = {6 * 9.81, 3 * 9.81, 9.81};
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(double(hanging.joints[k]->impulse()[1] / h) ==
          Approx(weight[k]).epsilon(tolerance(1e-9, 1e-4)));
    CHECK(std::abs(double(hanging.joints[k]->impulse()[0])) < tolerance(1e-9, 1e-4));
  }
  CHECK(std::abs(hanging.sag()) < tolerance(1e-9, 2e-5));
}

TEST_CASE("when the step changes the warm start scales its impulses with it") {
  // at rest every force stays the same, so an impulse is force times step; taken over unchanged it
  // would kick the chain with g (h_old - h_new)
  Hanging hanging({3, 2, 1});
  SequentialImpulses solver;
  StepOptions stepping{.warm_start = true};
  solver.iterations = 2;
  for (int n = 0; n < 2000; ++n) step(hanging.world, solver, h, stepping);
  solver.iterations = 1;  // no iterations to mend it with
  for (real length : {h / 2, h * 2, h / 5, h}) {
    step(hanging.world, solver, length, stepping);
    const double kick = 9.81 * std::abs(double(h - length)) + 0.01;
    for (std::size_t k = 1; k <= 3; ++k)
      CHECK(std::abs(double(hanging.world.bodies[hanging.ids[k]].v.y)) <
            tolerance(1e-8, 1e-3) * kick);
    CHECK(double(hanging.joints[0]->impulse()[1]) ==
          Approx(6 * 9.81 * double(length)).epsilon(tolerance(1e-8, 1e-3)));
  }
}

TEST_CASE("a rod whose ends have come together forgets the impulse of the last step") {
  SequentialImpulses one;
  PackedImpulses packed;
  for (Solver* solver : {static_cast<Solver*>(&one), static_cast<Solver*>(&packed)}) {
    World world;
    const BodyId hook = world.add(static_body(vec3(0)));
    const BodyId weight = world.add(ball(3, real(0.1), vec3(0, -1, 0)));
    const auto& rod = world.add<CentreDistanceJoint>(hook, weight, CentreDistance{1});
    step(world, *solver, h, {.warm_start = true});
    CHECK(double(rod.forces()[0]) == Approx(-3 * 9.81));
    world.bodies[weight].x = vec3(0);
    step(world, *solver, h, {.warm_start = true});
    CHECK(rod.forces()[0] == 0);
  }
}

TEST_CASE("E47 the criterion is where the slowest mode of a warm step passes 1", "[E47]") {
  for (const double beta : {0.05, 0.15, 0.5, 1.0})
    for (const double kept : {0.9, 0.99, 1.01, 1.1}) {
      const double eta = kept / (1 + beta);
      if (eta >= 1) continue;
      CHECK((growth_of_a_mode(eta, beta) < 1) == (kept < 1));
    }
  for (const double eta : {0.5, 0.9, 0.99})  // without feedback it never does
    CHECK(growth_of_a_mode(eta, 0) < 1 + 1e-9);
}

TEST_CASE("E47 an unstable warm chain grows by as much a step as its slowest mode", "[E47]") {
  Hanging hanging(ten_links());
  CHECK(hanging.rate() ==
        Approx(std::pow(std::cos(std::numbers::pi / 20), 2)).epsilon(tolerance(1e-9, 1e-5)));
  const double growth = growth_of_a_mode(std::pow(hanging.rate(), 4), 0.15);
  CHECK(growth == Approx(1.0175).margin(1e-4));
  hanging.set_beta(real(0.15));
  const Sags sags(std::move(hanging), 4, {.warm_start = true}, 300);
  CHECK(std::pow(sags.second / sags.first, 1.0 / 60) == Approx(growth).epsilon(3e-3));
}

TEST_CASE("I15 and E47 the criterion tells which warm chains hang still", "[E47]") {
  for (const auto& [tip, iterations] : {std::pair{1, 4}, {1, 10}, {1, 30}, {100, 30}, {100, 200}}) {
    CAPTURE(tip, iterations);
    Hanging hanging(ten_links(real(tip)));
    const double kept = std::pow(hanging.rate(), iterations) * 1.15;
    CHECK(std::abs(kept - 1) > 0.03);  // clear of the edge
    hanging.set_beta(real(0.15));
    const Sags sags(std::move(hanging), iterations, {.warm_start = true},
                    tip == 1 ? 600 : 1200);
    if (kept < 1) CHECK(sags.second < (tip == 1 ? tolerance(1e-8, 1e-4) : 1e-3));
    else CHECK(sags.second > 1);
  }
}

TEST_CASE("E47 warm without feedback a projected chain is stable on either side", "[E47]") {
  for (const int tip : {1, 100})
    for (const int iterations : {4, 10, 30})
      for (const int projections : {1, 4}) {
        CAPTURE(tip, iterations, projections);
        Hanging hanging(ten_links(real(tip)));
        hanging.set_beta(0);
        const Sags sags(std::move(hanging), iterations,
                        {.warm_start = true, .projections = projections}, 1800);
        CHECK(sags.second < (tip == 1 ? tolerance(1e-6, 1e-4) : 0.2));
        CHECK(sags.second < 1.01 * sags.first + tolerance(1e-9, 1e-4));
      }
}

TEST_CASE("I26 a cold chain sags joint by joint by what the formula says and a warm one does not") {
  // C = h^2/beta (I - H)^-1 H J g, H = A G^k A^-1, G what an iteration leaves of an error in lambda
  struct {
    std::vector<real> masses;
    int iterations, steps;
    bool settles_warm;
  } const chains[] = {{{1, 9}, 10, 3600, true},       {ten_links(), 4, 600, false},
                      {ten_links(), 10, 600, false},  {ten_links(), 30, 600, false},
                      {ten_links(100), 72, 2400, false}};
  for (const auto& chain : chains) {
    CAPTURE(chain.masses.size(), chain.iterations);
    const double near = chain.settles_warm ? tolerance(1e-9, 1e-3) : tolerance(1e-4, 1e-2);
    const double beta = 0.15;
    Hanging hanging(chain.masses);
    hanging.set_beta(real(beta));
    const System system = rows_of(hanging.world);
    const Dense A = whole_K(system, hanging.world), G = iteration_matrix(A, system.block);
    const Dense E = Dense::identity(A.rows());
    Dense H = A;
    for (int k = 0; k < chain.iterations; ++k) H = H * G;
    H = H * inverse_of(A);
    Column g = Column(system.J.columns());
    for (std::size_t k = 1; k < hanging.ids.size(); ++k) g[6 * long(k) + 1] = -9.81;
    const Column C = double(h * h) / beta * (inverse_of(E - H) * (H * (system.J * g)));
    SequentialImpulses solver;
    solver.iterations = chain.iterations;
    for (const bool warm : {false, true, false}) {
      if (warm && !chain.settles_warm) break;
      for (int n = 0; n < chain.steps; ++n) step(hanging.world, solver, h, {.warm_start = warm});
      if (warm) CHECK(std::abs(hanging.sag()) < tolerance(1e-9, 2e-5));
      double largest = 0;
      for (std::size_t k = 0; !warm && k < hanging.joints.size(); ++k) {
        const BallJoint& joint = *hanging.joints[k];
        const double gap = double(joint.part.error(hanging.world.bodies[joint.body1],
                                                   hanging.world.bodies[joint.body2]).y);
        largest = std::max(largest, std::abs(gap));
        CHECK(gap == Approx(C[3 * long(k) + 1]).epsilon(near).margin(tolerance(1e-12, 2e-5)));
      }
      if (!warm) CHECK(largest > 1e-3);
    }
  }
}

TEST_CASE("E47 a hinge at its limit in blocks apart does as the criterion says", "[E47]") {
  const auto beyond = [](bool whole, int iterations, real beta) {
    Crane crane(vec3(0, 1, 0));
    crane.hinge->set_limits(0, 60 * degree);  // at the lower one already: its row is there
    crane.hinge->whole = whole;
    const double kept = std::pow(iteration_rate(crane.world, rows_of(crane.world)), iterations) *
                        (1 + double(beta));
    crane.hinge->set_limits(-60 * degree, 60 * degree);
    crane.hinge->set_motor(3, 500);
    crane.hinge->beta = beta;
    crane.solver.iterations = iterations;
    crane.stepping.warm_start = true;
    double late = 0;
    for (int n = 0; n < 1200; ++n) {
      step(crane.world, crane.solver, h, crane.stepping);
      if (!all_finite(crane.world)) return std::pair{kept, 1e30};
      const double past = std::abs(crane.in_degrees()) - 60;
      if (n >= 1100) late = std::max(late, past);
      if (length(crane.world.bodies[crane.cube].v) > 1e4) return std::pair{kept, 1e30};
    }
    return std::pair{kept, late};
  };
  const auto [kept, late] = beyond(false, 1, real(0.2));
  CHECK(kept == Approx(1.2 * 27 / 29).epsilon(1e-4));
  CHECK(late > 1e29);  // it has been thrown out at more than 1e4 m/s
  for (const auto& [iterations, beta] : {std::pair{10, 0.2}, {30, 0.2}, {1, 0.0}}) {
    const auto [apart, rests] = beyond(false, iterations, real(beta));
    CHECK(apart < 0.95);
    CHECK(std::abs(rests) < (beta > 0 ? 0.01 : 0.5));
  }
  const auto [one, there] = beyond(true, 1, real(0.2));
  CHECK(one < 1e-5);  // one block: an iteration leaves nothing
  CHECK(std::abs(there) < 0.01);
}
