// Cases of the stability suite on a rotor and a crane: X8 of a hinge, X11, X12, X13.
#include <algorithm>
#include <cmath>

#include "bench/suite.h"
#include "joints/part_joint.h"

namespace joints::bench {

namespace {

std::string words(const char* format, double number) {
  char out[96];
  std::snprintf(out, sizeof out, format, number);
  return out;
}

// A rotor of 1 kg and 1 kg m^2 on a hinge about z, its centre `lever` beside it, no gravity.
struct Rotor {
  World world;
  BodyId wall, body;
  HingeJoint* hinge;
  Watch watch{world};
  Rotor(real lever, real speed) {
    world.gravity = vec3(0);
    wall = world.add(static_body(vec3(0)));
    body = world.add(body_with(1, vec3(1), vec3(lever, 0, 0)));
    hinge = &world.add<HingeJoint>(wall, body, vec3(0), vec3(0, 0, 1));
    world.bodies[body].w = vec3(0, 0, speed);
    world.bodies[body].v = vec3(0, speed * lever, 0);
  }
  Rotor(const Rotor&) = delete;
  double in_degrees() const { return double(hinge->position(world.bodies) / degree); }
  // The furthest that it came in so many steps [degrees].
  double furthest(int steps) {
    return watch.largest(steps, h, [&] { return std::abs(in_degrees()); });
  }
};

}  // namespace

void spinning_hinge(bool quick, const Tell& tell) {
  for (bool whole : {true, false})
    for (bool warm : {false, true}) {
      Rotor rotor(real(0.5), 1000);
      rotor.hinge->whole = whole;
      rotor.watch.stepping.warm_start = warm;
      const double before = kinetic_energy(rotor.world.bodies[rotor.body]);
      const double most = rotor.watch.largest(quick ? 60 : 600, h, [&] {
        return kinetic_energy(rotor.world.bodies[rotor.body]) / before;
      });
      tell(judged({.id = "X8", .method = std::string(whole ? "whole" : "apart") +
                                         (warm ? ", warm 30" : ", cold 30"),
                   .parameter = "most energy / start, hinge 0.5 m beside, spin [rad/s]",
                   .value = 1000},
                  most, most < 1.02));
    }
}

void limits_hit(bool quick, const Tell& tell) {
  for (double speed : {5., 30., 100.})
    for (double limit : {45., 170., 179., 350., 720.})
      for (real lever : {real(0), real(0.5)})
        for (bool whole : {true, false}) {
          if (quick && (speed < 100 || !whole)) continue;
          Rotor rotor(lever, real(speed));
          rotor.hinge->whole = whole;
          rotor.hinge->set_limits(-real(limit) * degree, real(limit) * degree);
          const double most =
              rotor.furthest(int(60 * (limit * double(degree) / speed + 0.5)));
          Line line = compared(
              {.id = "X11",
               .method = std::string(whole ? "whole" : "apart") +
                         (lever > 0 ? ", hinge 0.5 m beside" : ", hinge on its axis"),
               .parameter = words("furthest angle [deg] at %g rad/s, limit [deg]", speed),
               .value = limit},
              limit, most, 0.5);
          if (line.status == "ok" && most > limit + (whole ? 0.01 : 0.5)) line.status = "off";
          tell(line);
        }
  for (double weight : {1., 10.})
    for (double speed : {10., 100.})
      for (int iterations : {30, 300})
        for (bool whole : {true, false}) {
          if (quick && weight > 1) continue;
          Rotor rotor(real(0.5), 0);
          rotor.hinge->whole = whole;
          rotor.hinge->set_limits(-5 * degree, 5 * degree);
          rotor.watch.solver.iterations = iterations;
          const BodyId thrown = rotor.world.add(
              body_with(real(weight), vec3(real(weight / 6)), vec3(real(1.5), 0, 0)));
          const Bodies& bodies = rotor.world.bodies;
          rotor.world.add<PartJoint<Point>>(
              rotor.body, thrown, point_at(bodies[rotor.body], bodies[thrown], vec3(1, 0, 0)));
          rotor.world.bodies[thrown].v = vec3(0, real(speed), 0);
          tell(compared(
              {.id = "X11",
               .method = std::string(whole ? "whole, " : "apart, ") + std::to_string(iterations),
               .parameter = words("furthest angle [deg] at rest 5 deg away, yanked by %g times its "
                                  "weight at [m/s]", weight),
               .value = speed},
              5, rotor.furthest(300), whole ? 0.01 : 0.5));
        }
}

void motors(bool quick, const Tell& tell) {
  for (int rate : {60, 240, 1000})
    for (int iterations : {1, 10, 100})
      for (bool whole : {true, false}) {
        if (quick && (rate > 60 || !whole)) continue;
        Rotor rotor(0, 0);
        rotor.hinge->whole = whole;
        rotor.hinge->set_motor(100, 2);
        rotor.watch.solver.iterations = iterations;
        for (int k = 0; k < rate; ++k) rotor.watch.step(real(1) / real(rate));
        tell(compared({.id = "X12",
                       .method = std::string(whole ? "whole, " : "apart, ") +
                                 std::to_string(iterations),
                       .parameter = "speed after 1 s [rad/s], steps a second",
                       .value = double(rate)},
                      2, rotor.watch.seen(double(rotor.world.bodies[rotor.body].w.z)),
                      digits(5e-4, 2e-3)));
      }
}

void motors_into_limits(bool quick, const Tell& tell) {
  for (int iterations : {1, 10, 30})
    for (bool whole : {true, false})
      for (bool warm : {false, true}) {
        if (quick && (!whole || iterations > 1)) continue;
        BenchScene scene = motor_into_limit();
        HingeJoint& hinge = hinge_of(scene);
        hinge.whole = whole;
        Watch watch{scene.world};
        watch.solver.iterations = iterations;
        watch.stepping.warm_start = warm;
        double speed = 0, low = 1e9, high = -1e9;
        for (int k = 0; k < 3600; ++k) {
          watch.step(h);
          if (k < 600) continue;
          const double angle = double(hinge.position(scene.world.bodies) / degree);
          speed = std::max(speed, std::abs(double(hinge.speed(scene.world.bodies))));
          low = std::min(low, angle);
          high = std::max(high, angle);
        }
        const std::string method = std::string(whole ? "whole, " : "apart, ") +
                                   (warm ? "warm " : "cold ") + std::to_string(iterations);
        const double furthest = high - 60 > 60 - low ? high : low;
        Line angle = compared({.id = "X13", .method = method,
                               .parameter = "furthest angle from 60 [deg], limit [deg]",
                               .value = 60},
                              60, watch.seen(furthest), 0.01);
        Line at_rest = compared({.id = "X13", .method = method,
                                 .parameter = "speed at rest [rad/s], limit [deg]", .value = 60},
                                0, watch.seen(speed), digits(1e-6, 1e-3));
        const Rates rates = rates_of([&] {
          BenchScene again = motor_into_limit();
          again.forbidden = glm::dvec3(0);  // hinge and limit, blocks apart: all their modes
          hinge_of(again).whole = whole;
          return again;
        });
        for (Line* line : {&angle, &at_rest}) {
          add_criterion(*line, {.iterations = iterations, .warm = warm}, rates);
          tell(*line);
        }
      }
}

}  // namespace joints::bench
