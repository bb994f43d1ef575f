// Cases of the stability suite on rods, ropes and balls: X2 of one joint, X5, X6, X9, X10.
#include <algorithm>
#include <cmath>

#include "bench/suite.h"
#include "joints/distance_joint.h"

namespace joints::bench {

namespace {

// A body on a ball joint `lever` away from its centre, hanging plumb at `place`, thrown at `speed`.
// Turned and its lever askew, so that rounding has something to do.
struct Hanging : Scene {
  BodyId wall, body;
  Hanging(const Body& shape, real lever, const vec3& place, real speed) {
    Body hanging = shape;
    hanging.q = rotation(vec3(0, 0, std::atan2(real(0.6), real(0.8))));
    hanging.x = place - to_world(hanging, lever * vec3(real(0.6), real(0.8), 0));
    hanging.v = vec3(speed, 0, 0);
    hanging.w = lever > 0 ? vec3(0, 0, speed / lever) : vec3(0);
    wall = world.add(static_body(place));
    body = world.add(hanging);
    join_by_ball(*this, wall, body, place);
  }
  double gap() const { return joints::gap(marks.front(), poses(world.bodies)); }
  double largest_gap(int steps) {
    return Watch{world}.largest(steps, h, [&] { return gap(); });
  }
};

}  // namespace

void feedback_of_one(bool quick, const Tell& tell) {
  for (double beta : {.05, .1, .2, .5, .9, 1., 1.1, 1.5, 1.9, 1.99, 2., 2.05, 2.2}) {
    if (quick && beta > 1) continue;
    Hanging one(box(3, vec3(1), vec3(0)), 1, vec3(0), 0);
    one.world.gravity = vec3(0);
    one.world.joints().front()->beta = real(beta);
    one.world.bodies[one.body].x.y += digits(1e-4, 1e-2);
    Watch watch{one.world};
    double worst = std::abs(1 - beta), first = one.gap();
    for (int k = 0; k < 20; ++k) {  // the ratio that is furthest off, as long as there is a gap
      const double before = one.gap();
      if (before < 1e-3 * first || before > 0.1) break;
      watch.step(h);
      const double ratio = one.gap() / before;
      if (std::abs(ratio - std::abs(1 - beta)) > std::abs(worst - std::abs(1 - beta)))
        worst = ratio;
    }
    tell(compared({.id = "X2", .method = "one ball joint", .parameter = "beta, one joint",
                   .value = beta},
                  std::abs(1 - beta), watch.seen(worst), digits(1e-3, 5e-3)));
  }
}

void coincident_points(bool, const Tell& tell) {
  {
    World world;  // falls freely: the rod has no direction to push in
    const BodyId a = world.add(ball(1, real(0.1), vec3(1, 2, 3)));
    const BodyId b = world.add(ball(2, real(0.1), vec3(1, 2, 3)));
    world.gravity = vec3(0);
    auto& rod = world.add<DistanceJoint>(a, b, Distance{vec3(0), vec3(0), 1});
    const double impulse =
        Watch{world}.largest(60, h, [&] { return std::abs(double(rod.impulse()[0])); });
    tell(compared({.id = "X5", .method = "rod, ends in one point",
                   .parameter = "impulse, rod of [m]", .value = 1},
                  0, impulse, 0));
  }
  for (bool warm : {false, true}) {
    World world;  // falls g h^2 in the first step, in which it has no direction, and comes back
    const BodyId wall = world.add(static_body(vec3(0)));
    const BodyId body = world.add(ball(2, real(0.1), vec3(0)));
    world.add<CentreRopeJoint>(wall, body, Rope<CentreDistance>{{0}});
    Watch watch{world};
    watch.stepping.warm_start = warm;
    const double lowest =
        watch.largest(600, h, [&] { return double(length(world.bodies[body].x)); });
    const double expected = 9.81 / 3600;
    tell(compared({.id = "X5", .method = warm ? "rope of 0 m, warm" : "rope of 0 m, cold",
                   .parameter = "lowest point, rope of [m]", .value = 0},
                  expected, lowest, 1e-3 * expected));
  }
}

void static_bodies(bool, const Tell& tell) {
  for (bool warm : {false, true}) {
    World world;
    const BodyId a = world.add(static_body(vec3(0))), b = world.add(static_body(vec3(5, 0, 0)));
    world.add<DistanceJoint>(a, b, Distance{vec3(0), vec3(0), 1});
    world.add<HingeJoint>(a, b, vec3(1, 0, 0), vec3(0, 1, 0)).set_motor(3, 500);
    world.bodies[b].q = rotation(vec3(0, 3, 1));
    const Body start = world.bodies[b];
    Watch watch{world};
    watch.stepping.warm_start = warm;
    for (int k = 0; k < 1000; ++k) watch.step(h);
    const Body& end = world.bodies[b];
    const bool still = end.x == start.x && end.q == start.q && world.bodies[a].x == vec3(0);
    const double speed = double(length(end.v) + length(end.w) + length(world.bodies[a].v));
    tell(compared({.id = "X6", .method = warm ? "warm" : "cold", .parameter = "speed after steps",
                   .value = 1000},
                  0, still ? watch.seen(speed) : none, 0));
  }
}

void far_away(bool quick, const Tell& tell) {
  const Body cube = box(3, vec3(1), vec3(0));
  for (double lever : {1., 10., 100., 1000.}) {
    Hanging still(cube, real(lever), vec3(0), 0);
    tell(compared({.id = "X9", .method = "hanging", .parameter = "lever [m]", .value = lever}, 0,
                  still.largest_gap(quick ? 60 : 600), 4 * double(epsilon) * lever));
    Hanging thrown(cube, real(lever), vec3(0), real(1.6 * std::sqrt(lever)));
    const double expected = 1.6 * 1.6 * double(h) * double(h) / 0.4;  // v^2 h^2 / (2 beta r)
    tell(compared({.id = "X9", .method = "swinging", .parameter = "lever [m]", .value = lever},
                  expected, thrown.largest_gap(600),
                  0.1 * expected + 4 * double(epsilon) * lever));
  }
  for (double far : {1e3, 1e6}) {
    const vec3 place(real(far), real(-far), real(far));
    const double last_digit = double(epsilon) * far;
    Hanging still(cube, 1, place, 0);
    tell(compared({.id = "X9", .method = "hanging", .parameter = "distance of the origin [m]",
                   .value = far},
                  0, still.largest_gap(quick ? 60 : 600), 4 * last_digit));
    Hanging thrown(cube, 1, place, real(1.6));
    const double expected = 1.6 * 1.6 * double(h) * double(h) / 0.4;
    tell(compared({.id = "X9", .method = "swinging", .parameter = "distance of the origin [m]",
                   .value = far},
                  expected, thrown.largest_gap(600), 0.1 * expected + 4 * last_digit));
  }
}

namespace {

// A rod of moments 1 : 1 : 1e-4 swings from its end and spins about its length.
BenchScene needle() {
  Body body = body_with(2, vec3(real(1) / 6, real(1.0 / 6e4), real(1) / 6), vec3(0));
  body.q = rotation(vec3(0, 0, real(1.2)));
  body.x = to_world(body, vec3(0, real(-0.5), 0));
  body.w = to_world(body, vec3(0, 3, 0));
  BenchScene scene;
  scene.energy_scale = 2 * 9.81 * 0.5;
  scene.tip_mask = glm::dvec3(0);
  const BodyId wall = scene.world.add(static_body(vec3(0))), id = scene.world.add(body);
  join_by_ball(scene, wall, id, vec3(0));
  return scene;
}

}  // namespace

void masses_apart(bool quick, const Tell& tell) {
  for (double mass : {1e-6, 1e-3, 1., 1e3, 1e6, 1e9}) {
    World world;
    const BodyId wall = world.add(static_body(vec3(0)));
    const BodyId body = world.add(box(real(mass), vec3(1, real(0.5), real(0.1)),
                                      vec3(0, real(-0.5), 0)));
    auto& joint = world.add<PartJoint<Point>>(wall, body, Point{vec3(0), vec3(0, real(0.5), 0)});
    Watch watch{world};
    for (int k = 0; k < 60; ++k) watch.step(h);
    tell(compared({.id = "X10", .method = "force per mass", .parameter = "mass on a ball [kg]",
                   .value = mass},
                  9.81, watch.seen(double(joint.forces()[1]) / mass), digits(1e-8, 1e-3)));
  }
  std::vector<double> up, down;
  for (int k = 0; k < 16; ++k) {
    up.push_back(std::pow(10, k - 6));
    down.insert(down.begin(), up.back());
  }
  BenchScene light = chain_of_masses(down, vec3(0, -1, 0));
  Watch watch{light.world};
  for (int k = 0; k < (quick ? 60 : 600); ++k) watch.step(h);
  double shift = 0;
  for (int k = 1; k <= 16; ++k)
    shift = std::max(shift, double(length(light.world.bodies.at(k).x - vec3(0, real(-k), 0))));
  tell(compared({.id = "X10", .method = "chain that hangs, heaviest on top",
                 .parameter = "mass of the last [kg]", .value = 1e-6},
                0, watch.seen(shift), digits(1e-6, 1e-4)));
  if (Watch::directly) return;  // it is among the methods
  for (const Method& method : methods()) {
    if (!method.whole || (quick && method.iterations != 10)) continue;
    for (const std::vector<double>& masses : {down, up})
      tell(of_run({.id = "X10", .method = method.name,
                   .parameter = masses[0] > 1 ? "level, heaviest first: last [kg]"
                                              : "level, lightest first: last [kg]",
                   .value = masses.back()},
                  run([&masses] { return chain_of_masses(masses, vec3(1, 0, 0)); },
                      setting_of(method), 1)));
  }
  tell(of_run({.id = "X10", .method = "needle, cold 30", .parameter = "ratio of moments",
               .value = 1e4},
              run(needle, setting_of({.name = "cold 30"}), 1)));
}

}  // namespace joints::bench
