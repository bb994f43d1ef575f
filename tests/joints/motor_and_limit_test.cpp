// A motor and a limit as the solver sees them: one row with bounds.
#include "tests/oracle/test.h"

namespace {
const real h = real(1) / 60;
}  // namespace

TEST_CASE("I24 a motor gives h times its torque in a step however many iterations there are") {
  for (int iterations : {1, 10, 100}) {
    World world;
    const BodyId wall = world.add(static_body(vec3(0)));
    const BodyId rotor = world.add(body_with(1, vec3(2), vec3(0)));
    auto& motor = world.add<AnyJoint<1>>(wall, rotor);
    motor.J[0] = {vec3(0), vec3(0, 0, -1), vec3(0), vec3(0, 0, 1)};
    motor.target = {.rate = 10, .lower = -30, .upper = 30};
    SequentialImpulses solver;
    solver.iterations = iterations;
    for (int n = 1; n <= 50; ++n) {  // 30 N m on 2 kg m^2: a quarter rad/s a step
      step(world, solver, h);
      CHECK(double(world.bodies[rotor].w.z) ==
            Approx(std::min(10.0, 0.25 * n)).epsilon(tolerance(1e-12, 1e-5)));
    }
  }
}

TEST_CASE("a limit that lies ahead lets a body come up to it and no further") {
  for (const auto& [C, v, expected] : {std::tuple{0.05, -10.0, -3.0},  // stopped where C is 0
                                       std::tuple{0.05, -2.0, -2.0},   // does not get there
                                       std::tuple{-0.05, -2.0, 0.6},   // beta of the way back
                                       std::tuple{-0.05, 5.0, 5.0}}) {  // comes back by itself
    World world = weightless();
    const BodyId wall = world.add(static_body(vec3(0)));
    const BodyId body = world.add(ball(4, 1, vec3(0)));
    auto& limit = world.add<AnyJoint<1>>(wall, body);
    limit.J[0] = {vec3(-1, 0, 0), vec3(0), vec3(1, 0, 0), vec3(0)};
    limit.C[0] = real(C);
    limit.target = {.beta = real(0.2), .lower = 0};
    world.bodies[body].v.x = real(v);
    step_once(world, h);
    CHECK(double(world.bodies[body].v.x) == Approx(expected).epsilon(tolerance(1e-12, 1e-5)));
  }
}
