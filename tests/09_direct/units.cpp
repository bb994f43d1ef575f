// The units of chapter 9's exercises. The matrix of the joints is in plain numbers: its rows have
// units of their own.
#include "chapters/09_direct/direct.h"
#include "tests/checker/units.h"

using namespace joints;
using namespace joints::testing;

namespace {

/// Nothing is held: only forces, turns and poses.
class NoSolver : public Solver {
 public:
  void check() const override {}
  void prepare(const Bodies&, const Blocks&, int, real) override {}
  void warm_start(Bodies&, real) override {}
  void solve(Bodies&) override {}
};

}  // namespace

TEST_CASE("9.5 forces act for a time and velocities move for a time", "[9.5]") {
  World world;
  world.gravity = vec3(0, real(-10), 0) * (m / (s * s));
  world.add(body1);
  NoSolver solver;
  world.last_h = real(0.2) * s;
  in("the step", [&] { second_order_step(world, solver, h); });
  const Body& body = world.bodies.at(0);
  expect_unit("the velocity v", body.v, m / s);
  expect_unit("the angular velocity w", body.w, 1 / s);
  expect_unit("the place x", body.x, m);
  expect_unit("world.last_h", world.last_h, s);
}

TEST_CASE("9.8 kappa h^2 |F||r| is an inertia", "[9.8]") {
  const Slowed out = in("slowed", [] {
    return slowed(body1, vec3(300) * (newton * m), vec3(real(0.3)) * (kg * m * m), 8 * pure, h);
  });
  expect_unit("the inverse inertia", out.inverse_inertia_local, 1 / (kg * m * m));
  expect_unit("the angular velocity w", out.w, 1 / s);
}
