// What relax iterations and split impulses do not change, and which settings they reject.
#include "tests/oracle/allocations.h"
#include "tests/oracle/test.h"
#include "tests/oracle/track.h"

namespace {

const real h = real(1) / 60;

}  // namespace

TEST_CASE("a static body that carries others along keeps its velocity and its place") {
  for (TwoPassImpulses solver : {relaxing(), splitting()}) {
    Track track({0, real(1.1)}, {1});
    track.join(0, 1, 1);
    track.v(0) = real(0.6);  // a conveyor belt
    step(track.world, solver, h);
    CHECK(track.v(0) == real(0.6));
    CHECK(track.x(0) == 0);
    CHECK(double(track.v(1)) == Approx(0.6));
    CHECK(track.x(1) == Approx(1.08 + 0.6 / 60).epsilon(tolerance(1e-12, 1e-6)));
  }
}

TEST_CASE("a body that no joint holds moves by its own velocities, up to the speed clamp") {
  for (TwoPassImpulses solver : {feeding_back(), relaxing(), splitting()}) {
    Track track({0, 1, 2}, {1, 1});
    track.v(1) = real(0.6);
    track.v(2) = track.world.bodies[track.ids[2]].w.z = real(2e9);
    track.world.bodies[track.ids[1]].w = vec3(0, 1, 0);
    step(track.world, solver, h);
    CHECK(track.x(1) == Approx(1.01));
    CHECK(track.v(1) == real(0.6));
    CHECK(track.world.bodies[track.ids[1]].w == vec3(0, 1, 0));
    CHECK(2 * double(track.world.bodies[track.ids[1]].q.y) == Approx(1.0 / 60).epsilon(1e-4));
    CHECK(track.v(2) == max_speed);
    CHECK(track.world.bodies[track.ids[2]].w.z == max_speed);
  }
}

TEST_CASE("a step with relax iterations or split impulses does not allocate after the first") {
  for (TwoPassImpulses solver : {relaxing(), splitting()}) {
    Track track({0, real(1.1), real(2.4)}, {2, 5});
    track.join(1, 2, 1);
    step(track.world, solver, h);
    CHECK(allocations_of([&] { step(track.world, solver, h); }) == 0);
  }
}

TEST_CASE("the end of a step may be taken twice, and asks for the same correction again") {
  for (const real frequency : {real(0), real(10)}) {
    Track track({0, real(1.1)}, {1});
    track.join(0, 1, 1);
    TwoPassImpulses solver = splitting();
    begin_step(track.world, solver, h, {.frequency = frequency});
    end_step(track.world, solver, h);
    const double moved = 1.1 - track.x(1);
    CHECK(moved > 0.01);
    end_step(track.world, solver, h);
    CHECK(track.x(1) == Approx(1.1 - 2 * moved));
  }
}

TEST_CASE("a negative count is refused, and so are relax iterations beside split impulses") {
  World world;
  const auto refused = [&](int relax, int split) {
    TwoPassImpulses solver;
    solver.relax_iterations = relax;
    solver.split_iterations = split;
    return refusal([&] { step(world, solver, h); }).substr(0, 17);
  };
  CHECK(refused(0, 0) == "accepted");
  CHECK(refused(3, 0) == "accepted");
  CHECK(refused(0, 3) == "accepted");
  CHECK(refused(-1, 0) == "relax_iterations:");
  CHECK(refused(0, -1) == "split_iterations:");
  CHECK(refused(2, 3) == "relax_iterations:");
}
