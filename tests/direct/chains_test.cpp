// Chains by the direct solver: how far they hold together, and how much energy they keep.
#include "bench/scenes.h"
#include "tests/direct/rigs.h"
#include "tests/oracle/test.h"

namespace {

const double h = 1.0 / 60;

Scene hinged_cubes(int count) {
  Scene scene = bench::cubes_on_hinges(1, count);
  feed_back_all(scene.world);
  return scene;
}

// A chain with a heavy end that swings for some seconds.
struct Heavy {
  Scene scene;
  DirectSolver solver;
  Watched seen;
  int halved = 0;

  Heavy(double ratio, real added_inertia, double seconds = 10)
      : scene(chapter9::heavy_chain(20, real(ratio))) {
    solver.newton = 8;
    solver.added_inertia = added_inertia;
    seen = watch(scene, solver, seconds, h, [&] { halved += solver.report().halved > 0; });
  }
};

// Cubes on balls on a straight line between two static ones, pushed sideways.
Scene taut(int links = 6) {
  Scene scene{.name = "taut", .energy_scale = 9.81};
  BodyId before = scene.box(0, vec3(real(0.4)), vec3(0));
  for (int k = 1; k <= links; ++k) {
    const vec3 x(real(0.5) * real(k), 0, 0);
    const BodyId id = scene.box(k == links ? real(0) : real(1), vec3(real(0.4)), x);
    chapter9::on_ball(scene, before, id, x - vec3(real(0.25), 0, 0));
    before = id;
  }
  return scene;
}

}  // namespace

TEST_CASE("S1 a hundred cubes hang together to nanometres for five seconds, with their energy") {
  Scene scene = hinged_cubes(100);
  DirectSolver solver = shake();
  int missed = 0;
  const Watched seen =
      watch(scene, solver, 5, h, [&] { missed += !solver.report().moved_exactly; });
  CHECK(seen.finite);
  CHECK(seen.gap < tolerance(1e-6, 1e-3));
  CHECK(seen.change < tolerance(1e-4, 1e-3));
  CHECK(missed == 0);
  CHECK(scene.world.bodies.at(99).x.y < -1);  // it did fall
}

TEST_CASE("S1 velocities alone leave a hundred cubes gaps of millimetres") {
  Scene scene = hinged_cubes(100);
  DirectSolver solver = DirectSolver::velocities_only();
  const Watched seen = watch(scene, solver, 5, h);
  CHECK(seen.gap < 1e-2);
  CHECK(seen.gap > 1e-5);  // what the positions' own iterations are for
  CHECK(seen.change < 0.01);
}

TEST_CASE("S7 gravity along the axes of a hundred hinges moves no body that way") {
  for (const int newton : {0, 8}) {
    CAPTURE(newton);
    Scene scene = chapter9::sideways_chains(1, 100);
    DirectSolver solver = with(newton);
    double furthest = 0;
    const Watched seen = watch(scene, solver, 5, h, [&] {
      for (const Body& body : snapshot(scene.world.bodies))
        furthest = std::max(furthest, std::abs(double(body.x.x)));
    });
    CHECK(seen.finite);
    CHECK(furthest < tolerance(1e-6, 1e-4));
    if (newton > 0) CHECK(seen.gap < tolerance(1e-6, 1e-3));
  }
}

TEST_CASE("S2 with more inertia a chain holds a million times its link's weight at its end") {
  for (const double ratio : {1e5, 1e6}) {
    CAPTURE(ratio);
    const Heavy heavy(ratio, 16);
    CHECK(heavy.seen.finite);
    CHECK(heavy.seen.gap < tolerance(1e-6, 1e-2));
    CHECK(heavy.seen.highest < tolerance(1e-6, 1e-3));
  }
}

TEST_CASE("S2 without more inertia that chain is slowed down in nearly every step, or is lost") {
  const Heavy heavy(1e6, 0);
  CHECK((heavy.halved > 50 || heavy.seen.gap > 1e-2));
}

TEST_CASE("S2 what more inertia changes of a chain's motion vanishes with the step") {
  const auto apart = [](double h) {
    Scene plain = chapter9::heavy_chain(20, 1), stiff = chapter9::heavy_chain(20, 1);
    DirectSolver one = shake(), other = shake();
    other.added_inertia = 16;
    watch(plain, one, 1, h);
    watch(stiff, other, 1, h);
    double most = 0;
    for (int slot = 0; slot < plain.world.bodies.slots(); ++slot)
      most = std::max(most, double(length(plain.world.bodies.at(slot).x -
                                          stiff.world.bodies.at(slot).x)));
    return most;
  };
  const double coarse = apart(h), fine = apart(h / 16);
  INFO(coarse << " and " << fine << " m");
  CHECK(coarse > 0.1);
  CHECK(fine < coarse / 4);
}

TEST_CASE("a chain taut between two walls keeps its velocities, and gains no energy") {
  // no pose near by has all joints closed once it sags: nothing is left but the velocities
  for (const bool pushed : {false, true}) {
    CAPTURE(pushed);
    Scene scene = taut();
    if (pushed)
      for (int k = 1; k < 6; ++k) scene.world.bodies.at(k).v.z = real(k == 3 ? 2 : -1);
    DirectSolver solver = shake();
    int kept = 0;
    const Watched seen =
        watch(scene, solver, 5, h, [&] { kept += !solver.report().moved_exactly; });
    INFO(kept << " steps kept the best that they found");
    CHECK(seen.finite);
    CHECK(seen.highest < 0.3);
    CHECK(seen.gap < 5e-3);
    if (!is_float) CHECK(kept > 0);  // float asks for less
  }
}

TEST_CASE("the factor of the new poses closes a taut chain that the one of the step does not") {
  Scene scene = taut(4);
  DirectSolver solver = shake();
  int moved = 0, more = 0;
  const Watched seen = watch(scene, solver, 10, h, [&] {
    moved += solver.report().moved_exactly;
    more += solver.report().corrections > 8;
  });
  CHECK(moved == 600);
  if (!is_float) CHECK(more > 0);
  CHECK(seen.gap < tolerance(1e-6, 1e-3));
}
