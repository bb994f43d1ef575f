// Linkages that close in loops: Bricard's, whose rows depend on each other, and parallel four-bars.
#include "bench/families.h"
#include "engine/rotation/free_rotation.h"
#include "tests/direct/rigs.h"
#include "tests/oracle/test.h"

using namespace joints::chapter9;

namespace {

// Places of the uprights of a parallel linkage among the bodies: ground, upright, coupler, upright,
// coupler, upright, ...
std::vector<int> uprights(int loops) {
  std::vector<int> out{1};
  for (int k = 1; k <= loops; ++k) out.push_back(2 * k + 1);
  return out;
}

// The greatest angle between two uprights [rad].
double out_of_parallel(const Scene& scene, int loops) {
  const auto along = [&](int slot) { return to_world(scene.world.bodies.at(slot), vec3(1, 0, 0)); };
  double most = 0;
  for (const int slot : uprights(loops))
    most = std::max(most, angle_between(along(1), along(slot)));
  return most;
}

// z of the last rod of Bricard's linkage after a second.
double bricard_after(double rate) {
  Scene scene = bricard();
  DirectSolver solver = shake();
  watch(scene, solver, 1, 1 / rate);
  return double(scene.world.bodies.at(5).x.z);
}

// A pivot's inverse without the rule for rows that depend on others.
double plain_inverse(double pivot, double) { return 1 / pivot; }

// A of the blocks of a world's last step, which are one island.
struct Assembled {
  JointSystem system;

  explicit Assembled(const World& world) {
    JointIslands islands;
    const auto moves = [&](int slot) { return !world.bodies.at(slot).is_static(); };
    for (const Block& block : world.blocks.list)
      islands.given.push_back({{block.body1, block.body2},
                               {moves(block.body1), moves(block.body2)},
                               block.rows, false});
    islands.group(true, world.bodies.slots(), 1e9);
    system = islands.list.at(0).system;
    system.prepare(world.blocks, nullptr, sixtieth);
    for (int column = 0; column < int(system.bodies.size()); ++column)
      system.set_mass(column, world.bodies.at(system.bodies[std::size_t(column)]));
    system.assemble();
    for (const SystemBlock& block : system.blocks)
      for (int i = 0; i < block.rows; ++i)
        system.A.original[std::size_t(system.row_of(block) + i)] = system.diagonal(block, i);
  }
  // The largest multiplier that a right-hand side of any numbers up to 1 gives.
  double largest_multiplier(PivotInverse inverse) const {
    JointMatrix A = system.A;
    factor(A, inverse);
    std::vector<double> x(A.original.size());
    Random random(911);
    for (double& entry : x) entry = double(random.uniform(-1, 1));
    solve(A, x.data());
    double out = 0;
    for (const double a : x) out = std::isfinite(a) ? std::max(out, std::abs(a)) : INFINITY;
    return out;
  }
};

}  // namespace

TEST_CASE("Bricard's linkage moves with one row dropped, and stays closed for ten seconds") {
  for (const double rate : {960.0, 240.0}) {
    CAPTURE(rate);
    Scene scene = bricard();
    DirectSolver solver = shake();
    int fewest = 100, most = 0;
    const Watched seen = watch(scene, solver, 10, 1 / rate, [&] {
      fewest = std::min(fewest, solver.dependent());
      most = std::max(most, solver.dependent());
    });
    CHECK(seen.finite);
    CHECK(fewest == 1);
    CHECK(most <= (is_float ? 2 : 1));  // float cannot tell a row that nearly depends
    CHECK(seen.gap < tolerance(1e-8, 1e-3));
    CHECK(seen.change < tolerance(0.01, 0.02));
    CHECK(glm::length(scene.world.bodies.at(3).x - bricard().world.bodies.at(3).x) > 0.1);
  }
}

TEST_CASE("Bricard's linkage converges at second order") {
  const double coarse = bricard_after(240), middle = bricard_after(480), fine = bricard_after(960);
  const double first = coarse - middle, second = middle - fine;
  CHECK(std::abs(first) > 1e-7);
  if (!is_float) CHECK(std::log2(first / second) == Approx(2).margin(0.1));
}

TEST_CASE("Bricard's linkage: a pivot that is rounding error makes impulses of any size") {
  Scene scene = bricard();
  DirectSolver solver = shake();
  for (int n = 0; n < 100; ++n) step(scene.world, solver, real(1) / 960, second_order);
  const Assembled matrix(scene.world);
  CHECK(matrix.largest_multiplier(inverse_pivot) < 1e3);
  CHECK(matrix.largest_multiplier(plain_inverse) > tolerance(1e6, 1e4));
}

TEST_CASE("parallel four-bars stay parallel, and closed, where they all lie level", "[slow]") {
  // in float the linkage leaves the parallel motion there, as any linkage of such bars may
  for (const int loops : is_float ? std::vector<int>{2} : std::vector<int>{2, 10, 40}) {
    CAPTURE(loops);
    Scene scene = four_bars(loops);
    DirectSolver solver = shake();
    double apart = 0, lowest = 1;
    const Watched seen = watch(scene, solver, loops < 40 ? 10 : 3, 1.0 / 960, [&] {
      apart = std::max(apart, out_of_parallel(scene, loops));
      lowest = std::min(lowest, double(scene.world.bodies.at(1).x.y));
    });
    CHECK(seen.finite);
    CHECK(seen.gap < tolerance(1e-8, 1e-3));
    if (!is_float) CHECK(apart < 3e-6);
    CHECK(lowest < -0.4);  // it went through the level pose and hung
    CHECK(solver.dependent() > 0);
  }
}

TEST_CASE("the tolerance of the positions is reached at once at steps down to a millionth") {
  for (const double step_size : {1e-3, 1e-4, 1e-5, 1e-6})
    for (const bool far : {false, true}) {
      CAPTURE(step_size, far);
      Scene scene = far ? heavy_chain(5, 10) : bricard();
      const double x = far ? 1000 : 0;
      for (int slot = 0; slot < scene.world.bodies.slots(); ++slot)
        scene.world.bodies.at(slot).x.x += real(x);
      DirectSolver solver = shake();
      int most = 0;
      for (int n = 0; n < 200; ++n) {
        step(scene.world, solver, real(step_size), second_order);
        CHECK(solver.report().moved_exactly);
        CHECK(solver.report().halved == 0);
        most = std::max(most, solver.report().corrections);
      }
      CHECK(most <= 3);
    }
}

TEST_CASE("beads that whip faster than the step can follow are slowed down, and gain no energy") {
  int halved = 0;
  for (const bench::Family& family : bench::joint_families())
    for (unsigned seed = 1; family.name == "beads" && seed <= 12; ++seed) {
      CAPTURE(seed);
      bench::Drawn scene = family.draw(seed);
      DirectSolver solver = with(8);
      const Watched seen = watch(scene, solver, 3, double(sixtieth), [&] {
        halved += solver.report().halved;
      });
      CHECK(seen.finite);
      CHECK(seen.highest < 0.1);
    }
  CHECK(halved > 0);
}

// ---- energy -------------------------------------------------------------------------------------

TEST_CASE("where new factors correct the poses of drawn linkages, the energy hardly grows",
          "[slow]") {
  const auto kinetic = [](const World& world) {
    Bodies bodies = world.bodies;
    for (Body& body : bodies) use_own_rate(body);
    return double(energy(all_of(bodies), vec3(0)));
  };
  int projected = 0;
  double most = 0;
  for (const bench::Family& family : bench::joint_families()) {
    if (family.name != "unequal four-bars" && family.name != "slider-cranks" &&
        family.name != "loose rings")
      continue;
    for (unsigned seed = 71001; seed < 71021; ++seed) {
      World world = family.draw(seed).world;
      feed_back_all(world);
      DirectSolver solver = shake();
      for (int n = 0; n < 600; ++n) {
        begin_step(world, solver, sixtieth, second_order);
        solver.solve(world.bodies);
        const double before = kinetic(world);
        end_step(world, solver, sixtieth, second_order);
        if (solver.report().projected == 0) continue;
        ++projected;
        most = std::max(most, kinetic(world) / before - 1);
      }
    }
  }
  CAPTURE(projected, most);
  CHECK(projected > 100);
  CHECK(most < tolerance(0.0101, 0.05));
}

TEST_CASE("a mechanism that passes a pose too fast for its energy says so, and no other",
          "[slow]") {
  int told = 0, quiet = 0;
  for (const bench::Family& family : bench::joint_families())
    for (unsigned seed = 301; seed <= 340; ++seed) {
      if (family.name != "unequal four-bars" && family.name != "slider-cranks") continue;
      DirectSolver solver = shake();
      bool said = false;
      const auto one_step = [&](World& world, real h) {
        step(world, solver, h, second_order);
        said = said || !solver.report().sentences().empty();
      };
      const bench::Outcome out = run_drawn(family.draw(seed), one_step, true);
      const bool kept = std::max(out.gain, std::abs(out.loss)) < (is_float ? 0.2 : 0.1);
      CAPTURE(family.name, seed, out.gain, out.loss);
      CHECK((kept || said));
      (said ? told : quiet) += 1;
    }
  INFO(told << " told, " << quiet << " quiet");
  CHECK(told > 5);
  CHECK(quiet > 20);
}
