// The stability suite, cases X9 and X10 of chapters 1 and 2: levers of a kilometre, worlds a
// thousand kilometres from the origin, masses from a grain to a mountain, a rod like a needle.
#include "bench/orders.h"
#include "engine/instruments/measure.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;

// A body on a ball joint `lever` away from its centre, the joint at `place` in the world; hanging
// plumb below it, or thrown to the side at `speed`.
struct Pendulum {
  World world;
  BodyId wall, body;
  BallJoint* joint;
  Pendulum(const Body& shape, const vec3& lever, const vec3& place, real speed) {
    Body hanging = shape;
    const real angle = std::atan2(lever.x, lever.y);
    hanging.q = rotation(vec3(0, 0, angle));  // turns the lever upright; it lies in the xy plane
    hanging.x = place - to_world(hanging, lever);
    hanging.v = vec3(speed, 0, 0);
    hanging.w = vec3(0, 0, speed / length(lever));
    wall = world.add(static_body(place));
    body = world.add(hanging);
    joint = &world.add<BallJoint>(wall, body, Point{vec3(0), lever});
  }
  double gap() const {
    return double(length(joint->part.error(world.bodies[wall], world.bodies[body])));
  }
  bool is_finite() const {
    const Body& b = world.bodies[body];
    return finite(b.x) && finite(b.q) && finite(b.v) && finite(b.w);
  }
  // The largest gap and the largest w^2 over the given number of steps.
  std::pair<double, double> run(int steps) {
    SequentialImpulses solver;
    double largest = 0, w2 = 0;
    for (int n = 0; n < steps; ++n) {
      step(world, solver, h);
      REQUIRE(is_finite());
      largest = std::max(largest, gap());
      w2 = std::max(w2, double(dot(world.bodies[body].w, world.bodies[body].w)));
    }
    return {largest, w2};
  }
};

// Truncation of a straight step, fed back with beta 0.2: w^2 r h^2 / (2 beta).
double truncation(double w2, double r) { return w2 * r * double(h) * double(h) / 0.4; }

const vec3 levers[] = {vec3(0, 1, 0), vec3(real(0.6), real(0.8), 0), vec3(1, real(0.01), 0)};

}  // namespace

TEST_CASE("X9 a body that hangs a kilometre below its joint hangs still") {
  for (const vec3& lever : levers)
    for (real mass : {1, 1000}) {
      Pendulum pendulum(box(mass, vec3(1), vec3(0)), real(1000) * lever, vec3(0), 0);
      const double rounding_of_a_kilometre = 4 * double(epsilon) * 1000;
      CHECK(pendulum.run(600).first < rounding_of_a_kilometre);
    }
}

TEST_CASE("X9 a body that swings a kilometre from its joint keeps the truncation of the step") {
  for (const vec3& lever : levers)
    for (real mass : {1, 1000}) {
      Pendulum pendulum(box(mass, vec3(1), vec3(0)), real(1000) * lever, vec3(0), 50);
      const auto [gap, w2] = pendulum.run(600);
      CHECK(gap == Approx(truncation(w2, 1000)).epsilon(tolerance(0.02, 0.1)));
      CHECK(std::abs(double(pendulum.world.bodies[pendulum.body].x.x)) > 300);  // it does swing
    }
}

TEST_CASE("X9 a thousand kilometres from the origin a pendulum hangs and swings as it does there") {
  const vec3 far(real(1e6), real(-1e6), real(1e6));
  const double last_digit = double(epsilon) * 1e6;  // [m]
  for (const vec3& lever : levers) {
    Pendulum still(box(3, vec3(1), vec3(0)), lever, far, 0);
    CHECK(still.run(600).first < 4 * last_digit);
    Pendulum thrown(box(3, vec3(1), vec3(0)), lever, far, 4);
    Pendulum here(box(3, vec3(1), vec3(0)), lever, vec3(0), 4);
    const auto [gap, w2] = here.run(600);
    CHECK(gap == Approx(truncation(w2, double(length(lever)))).epsilon(0.15));
    CHECK(gap > 5e-3);
    CHECK(std::abs(thrown.run(600).first - gap) < 4 * last_digit);
  }
}

TEST_CASE("X10 a ball joint holds a grain and a mountain where it holds a brick") {
  for (double mass : {1e-6, 1e-3, 1.0, 215.0, 217.0, 1e6, 1e9})
    for (double lever : {0.0, 0.5, 100.0}) {
      INFO("mass " << mass << " kg, lever " << lever << " m");
      World world;
      const BodyId wall = world.add(static_body(vec3(0)));
      const BodyId body = world.add(box(real(mass), vec3(1, real(0.5), real(0.1)),
                                        vec3(0, -real(lever), 0)));
      auto& joint = world.add<BallJoint>(wall, body, Point{vec3(0), vec3(0, real(lever), 0)});
      SequentialImpulses solver;
      for (int n = 0; n < 60; ++n) step(world, solver, h);
      CHECK(std::abs(double(world.bodies[body].x.y) + lever) <
            4 * double(epsilon) * (1 + lever));
      CHECK(double(joint.impulse()[1] / h) / mass == Approx(9.81).epsilon(tolerance(1e-9, 1e-4)));
    }
}

TEST_CASE("X10 a rod holds a grain to a mountain and a grain hangs from it") {
  for (const auto& [upper, lower] : {std::pair{1e9, 1e-6}, {1e9, 1.0}, {1.0, 1e-6}}) {
    World world;
    const BodyId wall = world.add(static_body(vec3(0)));
    const BodyId a = world.add(ball(real(upper), 1, vec3(0, -1, 0)));
    const BodyId b = world.add(ball(real(lower), real(0.1), vec3(0, -2, 0)));
    world.add<CentreDistanceJoint>(wall, a, CentreDistance{1});
    auto& joint = world.add<CentreDistanceJoint>(a, b, CentreDistance{1});
    SequentialImpulses solver;
    for (int n = 0; n < 60; ++n) step(world, solver, h);
    CHECK(double(world.bodies[a].x.y) == Approx(-1).epsilon(tolerance(1e-12, 1e-5)));
    CHECK(double(world.bodies[b].x.y) == Approx(-2).epsilon(tolerance(1e-12, 1e-5)));
    CHECK(-double(joint.impulse()[0] / h) / lower == Approx(9.81).epsilon(tolerance(1e-9, 1e-4)));
  }
}

TEST_CASE("X10 a chain with masses from 1e9 down to 1e-6 kg hangs still and swings finitely") {
  for (bool heavy_first : {true, false})
    for (const vec3& along : {vec3(0, -1, 0), vec3(1, 0, 0)})
      for (const bench::Order order :
           {bench::Order::forward, bench::Order::backward, bench::Order::alternating}) {
        World world;
        std::vector<BodyId> ids{world.add(static_body(vec3(0)))};
        for (int k = 0; k < 16; ++k) {
          const real mass = real(std::pow(10.0, heavy_first ? 9 - k : k - 6));
          const vec3 x = (real(k) + real(0.5)) * along;
          ids.push_back(world.add(box(mass, vec3(real(0.4), real(0.3), real(0.2)), x)));
          const BodyId before = ids[ids.size() - 2];
          world.add<BallJoint>(before, ids.back(),
                               point_at(world.bodies[before], world.bodies[ids.back()],
                                        x - real(0.5) * along));
        }
        const std::vector<Body> start = snapshot(world.bodies);
        bench::OrderedImpulses solver;
        solver.order = order;
        for (int n = 0; n < 600; ++n) {
          step(world, solver, h);
          for (const Body& b : snapshot(world.bodies))
            REQUIRE((finite(b.x) && finite(b.q) && finite(b.v) && finite(b.w)));
        }
        // 1e-6 kg that carries 1e9 kg cannot converge; 1e9 kg that carries 1e-6 kg must
        if (!heavy_first || along.x != 0) continue;
        for (std::size_t k = 1; k < ids.size(); ++k)
          CHECK(double(length(world.bodies[ids[k]].x - start[k].x)) < tolerance(1e-6, 1e-4));
      }
}

TEST_CASE("X10 a rod as thin as a needle swings without gaining energy") {
  // moments 1 : 1 : 1e-4, from one end
  Body needle = body_with(2, vec3(real(1) / 6, real(1.0 / 6e4), real(1) / 6), vec3(0));
  World world;
  needle.q = rotation(vec3(0, 0, real(1.2)));
  needle.x = to_world(needle, vec3(0, real(-0.5), 0));
  needle.w = to_world(needle, vec3(0, 3, 0));
  const BodyId wall = world.add(static_body(vec3(0))), body = world.add(needle);
  auto& joint = world.add<BallJoint>(wall, body, Point{vec3(0), vec3(0, real(0.5), 0)});
  SequentialImpulses solver;
  const auto energy = [&] {
    const Body& b = world.bodies[body];
    return kinetic_energy(b) + 2 * 9.81 * double(b.x.y);
  };
  const double before = energy(), scale = 2 * 9.81 * 0.5;
  double gained = 0, lost = 0, gap = 0;
  for (int n = 0; n < 600; ++n) {
    step(world, solver, h);
    REQUIRE(finite(world.bodies[body].w));
    gained = std::max(gained, energy() - before);
    lost = std::max(lost, before - energy());
    gap = std::max(gap, double(length(
                            joint.part.error(world.bodies[wall], world.bodies[body]))));
  }
  CHECK(gained < 0.02 * scale);
  CHECK(lost < 0.2 * scale);
  CHECK(gap < 0.01);
}
