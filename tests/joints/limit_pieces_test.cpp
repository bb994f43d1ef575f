// The reader's pieces of chapter 3 in a whole hinge: it stops at its limits.
#include "checker/numeric.h"
#include "tests/oracle/test.h"

TEST_CASE("a limit has a row from a gap of h times its rate and 0.1 on, on either side") {
  const real h = real(1) / 60;
  for (const real rate : {real(-3), real(0), real(0.2)})
    for (const real share : {real(0.9), real(1.1)})
      for (const real sign : {real(1), real(-1)}) {
        const real gap = share * h * (std::abs(rate) + real(0.1));
        const LimitRow row = limit_row({-1, 1}, sign * (gap - 1), -sign * std::abs(rate), h);
        CHECK(row.sign == sign);
        CHECK(row.live == (share < 1));
      }
}

TEST_CASE("a hinge with limits at 60 degrees either way stops there within a hundredth") {
  const real degree = std::numbers::pi_v<real> / 180, h = real(1) / 60;
  for (const bool whole : {true, false})
    for (const real speed : {real(1), real(-1), real(5), real(-5), real(20), real(-80)}) {
      World world = weightless();
      const BodyId post = world.add(static_body(vec3(0), rotation(vec3(1, real(0.5), 2))));
      const BodyId door = world.add(box(3, vec3(1, real(0.1), 2), vec3(real(0.5), 0, 0)));
      auto& hinge = world.add<HingeJoint>(post, door, vec3(0), vec3(0, 0, 1));
      hinge.whole = whole;
      hinge.set_limits(-60 * degree, 60 * degree);
      Body& body = world.bodies[door];
      body.w = vec3(0, 0, speed);
      body.v = cross(body.w, body.x);
      SequentialImpulses solver;
      solver.iterations = 30;
      real furthest = 0;
      for (int n = 0; n < 180; ++n) {
        step(world, solver, h);
        furthest = std::max(furthest, std::abs(hinge.position(world.bodies)));
      }
      INFO("speed " << speed << (whole ? ", one block" : ", blocks apart"));
      CHECK(double(furthest / degree) < 60.01);
      CHECK(double(hinge.position(world.bodies) / degree) ==
            Approx(speed > 0 ? 60 : -60).margin(0.01));
      CHECK(double(length(body.w)) < 1e-3);
    }
}
