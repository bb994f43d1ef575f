// Whatever the settings: no body is ever NaN or infinite.
#include "tests/oracle/test.h"

TEST_CASE("speed clamp: a diverging chain stays finite for a thousand steps") {
  for (const real beta : {real(2.2), real(10)})
    for (const bool warm : {false, true})
      for (const int iterations : {1, 10}) {
        World world;
        BodyId before = world.add(static_body(vec3(0)));
        for (int k = 1; k <= 10; ++k) {
          const BodyId id = world.add(box(real(k), vec3(1, real(0.5), real(0.3)),
                                          vec3(real(k), 0, 0)));
          const vec3 anchor(real(k) - real(0.5), 0, 0);
          world.add<HingeJoint>(before, id, anchor, vec3(0, 0, 1)).beta = beta;
          before = id;
        }
        SequentialImpulses solver;
        StepOptions stepping;
        solver.iterations = iterations;
        stepping.warm_start = warm;
        double top = 0;
        for (int n = 0; n < 1000; ++n) {
          step(world, solver, real(1) / 60, stepping);
          for (const Body& body : snapshot(world.bodies)) {
            REQUIRE((finite(body.x) && finite(body.q) && finite(body.v) && finite(body.w)));
            top = std::max(top, double(length(body.v)));
          }
        }
        CHECK(top > 1e6);  // it does explode
        CHECK(top <= 3e8 * std::sqrt(3.0) * (1 + tolerance(1e-12, 1e-5)));
      }
}
