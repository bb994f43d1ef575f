// Sliders and welds outside the scenes of their chapters: which results depend on the anchor and
// which do not, few iterations, limits on a rail that spins, moments that are not equal.
#include "direct/direct_solver.h"
#include "engine/instruments/measure.h"
#include "engine/kept/input.h"
#include "joints/part_joint.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;

}  // namespace

TEST_CASE("a weld's load about its seam does not depend on the anchor, and breaking does not") {
  for (unsigned seed = 1; seed <= 6; ++seed)
    for (const bool direct : {false, true}) {
      std::vector<vec3> torques, about_anchor;
      vec3 expected(0);
      for (const real out : {real(-1), real(0), real(1.5), real(3)}) {
        Random random(seed);
        const vec3 seam = random.vector(2), way = normalize(random.vector(1));
        const real mass = random.uniform(1, 10), reach = random.uniform(real(0.5), 2);
        World world;
        world.gravity = random.vector(10);
        const BodyId wall = world.add(static_body(seam - way));
        const BodyId beam = world.add(box(mass, vec3(1, real(0.5), real(0.3)), seam + reach * way,
                                          random.turn()));
        auto& weld = world.add<FixedJoint>(wall, beam, seam + out * way);
        SequentialImpulses iterated;
        DirectSolver at_once;
        for (int n = 0; n < 5; ++n)
          step(world, direct ? static_cast<Solver&>(at_once) : iterated, h);
        torques.push_back(weld.load(world.bodies, seam).torque);
        about_anchor.push_back(weld.load().torque);
        expected = cross(seam + reach * way - seam, -mass * world.gravity);
        const Strength strength{.torque = length(expected) * real(0.999)};
        CHECK(breaks(weld.load(world.bodies, seam), strength));
      }
      for (const vec3& torque : torques)
        CHECK(double(length(torque - expected)) < tolerance(1e-9, 1e-3) * double(length(expected)));
      CHECK(double(length(about_anchor[3] - about_anchor[0])) > 0.1 * double(length(expected)));
    }
}

TEST_CASE("a beam that is let go loads its wall with more than its weight, however it is solved") {
  for (const int iterations : {10, 30, 100}) {
    World world;
    BodyId before = world.add(static_body(vec3(0)));
    FixedJoint* wall = nullptr;
    for (int k = 0; k < 10; ++k) {
      const BodyId next = world.add(box(1, vec3(1), vec3(real(k) + real(0.5), 0, 0)));
      auto& weld = world.add<FixedJoint>(before, next, vec3(real(k), 0, 0));
      if (k == 0) wall = &weld;
      before = next;
    }
    SequentialImpulses solver;
    solver.iterations = iterations;
    double most = 0;
    for (int n = 0; n < 600; ++n) {
      step(world, solver, h);
      most = std::max(most, double(wall->load().torque.z));
    }
    CAPTURE(iterations, most);
    CHECK(most > 1.15 * 490.5);  // the more iterations, the shorter the swing, and the higher
    CHECK(most < 1.7 * 490.5);
  }
}

TEST_CASE("a slider's limit on a rail that spins is passed by h^2 omega^2 x over 2 beta") {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    Random random(seed);
    const real omega = random.uniform(2, 10), limit = random.uniform(real(0.5), 2);
    const real beta = random.uniform(real(0.2), 1), length = real(1) / random.uniform(60, 240);
    World world = weightless();
    const BodyId rail = world.add(static_body(vec3(0)));
    const BodyId cart = world.add(box(1, vec3(real(0.2)), vec3(limit, 0, 0)));
    world.bodies[rail].w = world.bodies[cart].w = vec3(0, 0, omega);
    world.bodies[cart].v = vec3(0, omega * limit, 0);
    auto& slider = world.add<SliderJoint>(rail, cart, vec3(0), vec3(1, 0, 0));
    slider.set_limits(-unbounded, 0);  // where it is now
    slider.beta = beta;
    SequentialImpulses solver;
    double past = 0;
    for (int n = 0; n < 600; ++n) {
      step(world, solver, length);
      // a static body does not turn by itself
      world.bodies[rail].q = normalize(rotation(length * vec3(0, 0, omega)) * world.bodies[rail].q);
      past = double(slider.position(world.bodies));
    }
    const double step_angle = double(length * omega);
    CAPTURE(seed, double(omega), double(limit), double(beta), past);
    CHECK(past / (step_angle * step_angle * double(limit) / 2 / double(beta)) ==
          Approx(1).margin(0.15));
  }
}

TEST_CASE("a pair far off its lock gains angular momentum as 1 over h if its moments differ") {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const auto gained = [&](int rate, bool equal) {
      Random random(seed);
      World world = weightless();
      const auto add = [&](const vec3& x) {
        const vec3 moments = equal ? vec3(real(0.3)) : vec3(real(0.2), real(0.4), real(0.5));
        return world.add(body_with(2, moments, x, random.turn()));
      };
      const BodyId a = add(vec3(0)), b = add(vec3(1, 0, 0));
      world.add<PartJoint<RotationLock>>(a, b, lock_of(world.bodies[a], world.bodies[b]));
      const vec3 axis = normalize(random.vector(1));
      world.bodies[b].q = rotation(real(170.0 / 180) * std::numbers::pi_v<real> * axis) *
                          world.bodies[b].q;
      SequentialImpulses solver;
      double most = 0;
      for (int n = 0; n < 60; ++n) {
        step(world, solver, real(1) / real(rate));
        most = std::max(most, glm::length(momentum(all_of(world.bodies)).angular));
      }
      return most;
    };
    CAPTURE(seed);
    CHECK(gained(240, false) / gained(60, false) == Approx(4).margin(0.4));
    CHECK(gained(240, true) < tolerance(1e-9, 1e-2));
  }
}

TEST_CASE("welds and sliders hold up to the farthest anchor that is taken") {
  for (const bool slides : {false, true})
    for (const bool direct : {false, true})
      for (unsigned seed = 1; seed <= 3; ++seed)
        for (const real share : {real(0.9), real(1.2)}) {
          Random random(seed);
          const bool swapped = seed % 2 == 0;
          const real far = share * std::sqrt(max_lever_share / 6);
          World world;
          const vec3 way = normalize(vec3(random.uniform(-1, 1), 0, random.uniform(-1, 1)));
          const BodyId wall = world.add(static_body(vec3(0)));
          const BodyId cube = world.add(box(1, vec3(1), far * way));
          const vec3 across = cross(way, vec3(0, 1, 0));
          const auto add = [&] {
            const auto [one, two] = swapped ? std::pair{cube, wall} : std::pair{wall, cube};
            if (slides) world.add<SliderJoint>(one, two, vec3(0), across);
            else world.add<FixedJoint>(one, two, vec3(0));
          };
          const std::string words = refusal(add);
          CAPTURE(slides, direct, seed, double(far));
          if (share > 1) {
            CHECK(words.find("nearer to the body's centre") != std::string::npos);
            continue;
          }
          REQUIRE(words == "accepted");
          SequentialImpulses iterated;
          DirectSolver at_once;
          for (int n = 0; n < 60; ++n)
            step(world, direct ? static_cast<Solver&>(at_once) : iterated, h);
          if (slides) {  // the anchor of body 1 is where body 2 slides to
            const BodyId other = swapped ? wall : cube;
            world.bodies[other].x += real(1.2) / share * far * across;
            CHECK((refusal([&] { check_input(world, h); }) == "accepted") == !swapped);
            world.bodies[other].x -= real(1.2) / share * far * across;
          }
          CHECK(std::abs(double(world.bodies[cube].x.y)) < 0.05);
        }
}
