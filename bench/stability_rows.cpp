// Cases of the stability suite on rows and input: redundant rows X14, rates of the iterations X15,
// what is refused X16.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/suite.h"
#include "engine/instruments/rate.h"
#include "joints/distance_joint.h"
#include "joints/fixed_joint.h"

namespace joints::bench {

namespace {

double largest_impulse(const Blocks& blocks) {
  double largest = 0;
  for (const Block& block : blocks.list)
    for (int i = 0; i < block.rows; ++i)
      largest = std::max(largest, std::abs(double(block.impulse[i])));
  return largest;
}

// ---- X14 ----------------------------------------------------------------------------------------

Scene held(int times) {
  Scene scene;
  const BodyId wall = scene.world.add(static_body(vec3(0)));
  const BodyId body =
      scene.world.add(box(3, vec3(1, real(0.6), real(0.4)), vec3(1, real(0.1), 0)));
  for (int k = 0; k < times; ++k) join_by_ball(scene, wall, body, vec3(real(0.2), 0, real(0.1)));
  return scene;
}

void two_alike(const Tell& tell) {
  Scene once = held(1), twice = held(2);
  Watch one{once.world}, two{twice.world};
  const double difference = two.largest(300, h, [&] {
    one.step(h);
    return double(length(once.world.bodies.at(1).x - twice.world.bodies.at(1).x));
  });
  tell(compared({.id = "X14", .method = "cold 30",
                 .parameter = "difference of one ball joint and [of them]", .value = 2},
                0, difference, digits(1e-9, 2e-3)));
}

// Ground, two cranks of 1 m, a coupler of 2 m that is pushed at 2 m/s: how high it swings.
void four_bar(const Tell& tell) {
  Scene scene;
  World& world = scene.world;
  const quat up = rotation(vec3(0, 0, std::numbers::pi_v<real> / 2));
  const vec3 thin(1, real(0.1), real(0.1));
  const BodyId ground = world.add(static_body(vec3(0)));
  const BodyId left = world.add(box(1, thin, vec3(0, real(-0.5), 0), up));
  const BodyId right = world.add(box(1, thin, vec3(2, real(-0.5), 0), up));
  const BodyId coupler = world.add(box(2, vec3(2, real(0.1), real(0.1)), vec3(1, -1, 0)));
  join_by_ball(scene, ground, left, vec3(0));
  join_by_ball(scene, ground, right, vec3(2, 0, 0));
  join_by_ball(scene, left, coupler, vec3(0, -1, 0));
  join_by_ball(scene, right, coupler, vec3(2, -1, 0));
  world.bodies[coupler].v = vec3(2, 0, 0);
  world.bodies[left].w = world.bodies[right].w = vec3(0, 0, 2);
  world.bodies[left].v = world.bodies[right].v = vec3(1, 0, 0);
  Watch watch{world};
  double highest = -1, impulse = 0;
  for (int k = 0; k < 600; ++k) {
    watch.step(h);
    impulse = std::max(impulse, largest_impulse(watch.world.blocks));
    highest = std::max(highest, double(world.bodies[coupler].x.y));
  }
  // all its energy, a crank's moment being 1/3 kg m^2, lifts 2 kg by z and 2 kg by z/2
  const double expected = -1 + (0.5 * 2 * 4 + 2 * 0.5 * (1.01 / 12 + 0.25) * 4) / (3 * 9.81);
  tell(compared({.id = "X14", .method = "four-bar of balls, cold 30",
                 .parameter = "height it swings to [m], pushed at [m/s]", .value = 2},
                expected, watch.seen(highest), 0.02 * std::abs(expected)));
  tell(judged({.id = "X14", .method = "four-bar of balls, cold 30",
               .parameter = "largest impulse [N s], bound", .value = 5},
              watch.seen(impulse), impulse < 5));  // the weight of all is 0.65 N s a step
}

void between_static_ends(const Tell& tell) {
  for (bool warm : {false, true}) {
    Scene scene;
    std::vector<BodyId> ids;
    for (int k = 0; k < 5; ++k) {
      const vec3 x(real(k), 0, 0);
      ids.push_back(scene.world.add(k == 0 || k == 4 ? static_body(x)
                                                     : box(1, vec3(real(0.8)), x)));
      if (k > 0) join_by_ball(scene, ids[k - 1], ids[k], vec3(real(k - 1), 0, 0));
    }
    Watch watch{scene.world};
    watch.stepping.warm_start = warm;
    double impulse = 0, speed = 0;
    for (int k = 0; k < 600; ++k) {
      if (k == 60) scene.world.bodies[ids[1]].v = vec3(3, 5, -8);
      watch.step(h);
      impulse = std::max(impulse, largest_impulse(watch.world.blocks));
      if (k > 300)
        for (BodyId id : ids)
          speed = std::max(speed, double(length(scene.world.bodies[id].v)));
    }
    const std::string method = std::string("between static ends, kicked, ") +
                               (warm ? "warm 30" : "cold 30");
    const double kick = std::sqrt(98.0);
    tell(judged({.id = "X14", .method = method, .parameter = "largest impulse [N s], bound",
                 .value = 100},
                watch.seen(impulse), impulse < 100));
    tell(judged({.id = "X14", .method = method, .parameter = "speed later [m/s], kicked at",
                 .value = kick},
                watch.seen(speed), speed < kick));
  }
}

// ---- X15 ----------------------------------------------------------------------------------------

void rate_line(const Tell& tell, const char* method, const char* parameter, double value,
               double expected, World& world) {
  tell(compared({.id = "X15", .method = method, .parameter = parameter, .value = value}, expected,
                contraction_rate(world, 200000), digits(1e-4, 2e-3)));
}

}  // namespace

void redundant(bool, const Tell& tell) {
  two_alike(tell);
  four_bar(tell);
  between_static_ends(tell);
}

void iteration_rates(bool quick, const Tell& tell) {
  const vec3 down(0, -1, 0);
  for (double m2 : {1., 10., 100.}) {
    BenchScene scene = chain_of_masses({1, m2}, down);
    rate_line(tell, "two masses", "lower mass / upper mass", m2, m2 / (1 + m2), scene.world);
  }
  for (double n : {2., 3., 5., 10., 20., 50.}) {
    if (quick && n > 10) continue;
    BenchScene scene = chain_of_masses(std::vector<double>(std::size_t(n), 1), down);
    const double c = std::cos(std::numbers::pi / (2 * n));
    rate_line(tell, "equal masses", "how many", n, c * c, scene.world);
  }
  for (double r : {0.1, 0.5, 1.5, 3.0})
    for (bool fixed : {false, true}) {
      BenchScene scene;  // m = 2 kg, i = 0.7 kg m^2, the anchor r from its centre
      World& world = scene.world;
      const BodyId wall = world.add(static_body(vec3(0)));
      const BodyId body = world.add(body_with(2, vec3(real(0.7)), vec3(0, 0, real(r))));
      if (fixed) world.add<FixedJoint>(wall, body, vec3(0)).whole = false;
      else world.add<HingeJoint>(wall, body, vec3(0), vec3(1, 0, 0)).whole = false;
      kick(scene, false);
      rate_line(tell, fixed ? "fixed joint, two blocks" : "hinge, two blocks", "lever [m]", r,
                2 * r * r / (0.7 + 2 * r * r), world);
    }
}

// ---- X16 ----------------------------------------------------------------------------------------

void bad_input(bool, const Tell& tell) {
  World world;
  const BodyId a = world.add(static_body(vec3(0))), b = world.add(box(1, vec3(1), vec3(2, 0, 0)));
  auto& hinge = world.add<HingeJoint>(a, b, vec3(1, 0, 0), vec3(0, 0, 1));
  const real nan = std::numeric_limits<real>::quiet_NaN();
  SequentialImpulses solver;
  const struct {
    const char *what, *argument;  // the argument that the message has to name
    std::function<void()> call;
  } inputs[] = {
      {"a box of no mass", "mass", [&] { box(0, vec3(1), vec3(0)); }},
      {"a box with an edge of nan", "size", [&] { box(1, vec3(1, nan, 1), vec3(0)); }},
      {"a ball of negative radius", "radius", [&] { ball(1, -1, vec3(0)); }},
      {"a moment of inertia of 0", "inertia", [&] { body_with(1, vec3(1, 1, 0), vec3(0)); }},
      {"a place that is infinite", "x", [&] { box(1, vec3(1), vec3(unbounded, 0, 0)); }},
      {"a joint of a body with itself", "body2",
       [&] { world.add<PartJoint<Point>>(b, b, Point{}); }},
      {"a body that does not exist", "id",
       [&] { world.add<PartJoint<Point>>(a, BodyId{7, 1}, Point{}); }},
      {"a rod of no length", "length",
       [&] { world.add<DistanceJoint>(a, b, Distance{vec3(0), vec3(0), 0}); }},
      {"an anchor of nan", "anchor",
       [&] { world.add<PartJoint<Point>>(a, b, Point{vec3(nan), vec3(0)}); }},
      {"a hinge without an axis", "axis",
       [&] { world.add<HingeJoint>(a, b, vec3(0), vec3(0)); }},
      {"a hinge with an anchor of nan", "anchor",
       [&] { world.add<HingeJoint>(a, b, vec3(nan), vec3(1, 0, 0)); }},
      {"lower limit above the upper", "lower", [&] { hinge.set_limits(1, -1); }},
      {"a motor of negative strength", "strength", [&] { hinge.set_motor(1, -1); }},
      {"a motor speed of nan", "speed", [&] { hinge.set_motor(nan, 1); }},
      {"a step of 0", "h", [&] { joints::step(world, solver, 0); }},
      {"a step of nan", "h", [&] { joints::step(world, solver, nan); }},
      {"no iterations", "iterations",
       [&] {
         SequentialImpulses none;
         none.iterations = 0;
         step(world, none, h);
       }},
  };
  const std::size_t joints = world.joints().size();
  const int bodies = world.bodies.size();
  const Body before = world.bodies[b];
  for (const auto& [what, argument, call] : inputs) {
    double refused = 0;
    try {
      call();
    } catch (const std::invalid_argument& error) {
      refused = std::string(error.what()).find(argument) != std::string::npos ? 1 : 0.5;
    }
    const Body& now = world.bodies[b];
    if (world.joints().size() != joints || world.bodies.size() != bodies || now.x != before.x ||
        now.v != before.v)
      refused = 0;
    tell(compared({.id = "X16", .method = what, .parameter = std::string("refused: ") + argument},
                  1, refused, 0));
  }
}

}  // namespace joints::bench
