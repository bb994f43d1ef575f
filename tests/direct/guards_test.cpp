// What the direct solver refuses within a step, and hubs that it leaves to iterations.
#include "tests/direct/rigs.h"
#include "tests/oracle/test.h"

using namespace joints::chapter9;

namespace {

const real h = sixtieth;

// The message of a solver in a step that goes wrong.
template <class F>
std::string complaint(const F& f) {
  try {
    f();
  } catch (const std::logic_error& error) {  // std::invalid_argument is one
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("whatever changes between the ends of a step is refused in words") {
  for (unsigned seed = 1; seed <= 6; ++seed)
    for (const int newton : {0, 8})
      for (const bool added : {false, true}) {
        CAPTURE(seed, newton, added);
        const auto said = [&](auto change) {
          Random random(seed);
          World world = mechanism(random, 9, int(seed % 3)), other = mechanism(random, 5, 0);
          DirectSolver solver = with(newton, added ? real(8) : real(0));
          step(world, solver, h, second_order);
          begin_step(world, solver, h, second_order);
          const std::string words =
              complaint([&] { change(world, other, solver), solver.solve(world.bodies); });
          const std::string later = complaint([&] { end_step(world, solver, h, second_order); });
          CHECK((later == "accepted") == (words == "accepted"));
          return words;
        };
        CHECK(said([](World&, World&, DirectSolver&) {}) == "accepted");
        const std::string gone = "solver: blocks have come or gone since they were prepared";
        CHECK(said([](World& world, World&, DirectSolver&) {
                world.remove(*world.joints().front());
              }) == gone);
        CHECK(said([](World& world, World&, DirectSolver&) {
                world.remove(world.joints().back()->body2);
              }) == gone);
        CHECK(said([](World& world, World&, DirectSolver&) {
                for (int k = 0; k < 100; ++k) world.add(ball(1, 1, vec3(0)));
              }).find("bodies have come") != std::string::npos);
        std::string words;
        said([&](World&, World& other, DirectSolver& solver) {
          words = complaint([&] { solver.solve(other.bodies); });
          words += complaint([&] { solver.warm_start(other.bodies, 1); });
        });
        CHECK(words.find("another world") != words.rfind("another world"));
        said([&](World& world, World&, DirectSolver& solver) {
          solver.factor_now();
          const std::vector<real> rates(world.blocks.C.size() - 1, 0);
          words = complaint([&] { solver.reach(world.bodies, world.blocks, rates, 0); });
        });
        CHECK(words.find("one for each row") != std::string::npos);
      }
  DirectSolver fresh;
  CHECK(complaint([&] { fresh.factor_now(); }).find("no matrix") != std::string::npos);
}

TEST_CASE("a hub that is left to iterations has no factor, and says so") {
  Scene scene = star(60);
  DirectSolver solver;
  begin_step(scene.world, solver, h);
  REQUIRE(solver.report().iterated);
  CHECK(complaint([&] { solver.factor_now(); }).find("no matrix") != std::string::npos);
}

TEST_CASE("hubs that are left to iterations gain no energy with the beta that is advised") {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    Random random(seed);
    World world = weightless();
    const BodyId hub = world.add(ball(std::exp(random.uniform(0, 5)), 1, vec3(0)));
    const int arms = int(random.uniform(60, 400));
    for (int k = 0; k < arms; ++k) {
      const vec3 way = normalize(random.vector(1));
      const real size = random.uniform(real(0.3), real(1.3));
      Body arm = box(1, vec3(real(0.1), size, real(0.1)), (1 + size / 2) * way);
      arm.v = random.vector(real(0.5));
      arm.w = random.vector(1);
      const BodyId id = world.add(arm);
      world.add<BallJoint>(hub, id, point_at(world.bodies[hub], world.bodies[id], way));
    }
    feed_back_all(world);
    const auto now = [&] { return energy(all_of(world.bodies), world.gravity); };
    const double before = now();
    for (const bool warm : {false, true}) {
      DirectSolver solver = shake();
      double most = 0;
      for (int n = 0; n < 60; ++n) {
        step(world, solver, h, {.warm_start = warm, .leapfrog = true});
        most = std::max(most, now());
      }
      CAPTURE(seed, arms, warm);
      REQUIRE(solver.report().iterated);
      CHECK(most <= before * 1.001);
      double gap = 0;
      for (const auto& joint : world.joints()) {
        Blocks blocks;
        joint->append(world.bodies, blocks);
        for (const real C : blocks.C) gap = std::max(gap, std::abs(double(C)));
      }
      CHECK(gap < 0.1);
    }
  }
}
