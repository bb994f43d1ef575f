// Cases of the stability suite on hinges: X7, X8, X11, X12, X13, X17.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/stability.h"

namespace joints::bench {

namespace {

const real h = real(1) / 60;
const real degree = std::numbers::pi_v<real> / 180;

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
    hinge = &world.add<HingeJoint>(world.bodies, wall, body, vec3(0), vec3(0, 0, 1));
    world.bodies[body].w = vec3(0, 0, speed);
    world.bodies[body].v = vec3(0, speed * lever, 0);
  }
  Rotor(const Rotor&) = delete;
  double in_degrees() const { return double(hinge->position(world.bodies) / degree); }
  // The furthest that it came in so many steps [degrees].
  double furthest(int steps) {
    double most = -1e9;
    for (int k = 0; k < steps; ++k) {
      watch.step(h);
      most = std::max(most, std::abs(in_degrees()));
    }
    return watch.seen(most);
  }
};

// A hinge whose body has been turned away from its axis.
struct Bent {
  World world;
  BodyId wall, body;
  HingeJoint* hinge;
  Watch watch{world};
  Bent(real angle, bool whole) {
    world.gravity = vec3(0);
    const vec3 anchor(real(0.3), real(0.2), real(-0.1));
    wall = world.add(static_body(vec3(0), rotation(vec3(real(0.4), -1, real(0.3)))));
    body = world.add(body_with(2, vec3(1, real(0.7), real(0.5)),
                               anchor + vec3(real(0.3), real(-0.4), real(0.2)),
                               rotation(vec3(1, 2, 0))));
    hinge = &world.add<HingeJoint>(world.bodies, wall, body, anchor, vec3(1, 2, -1));
    hinge->whole = whole;
    const quat turn = rotation(angle * normalize(cross(axis1(), vec3(0, 0, 1))));
    Body& turned = world.bodies[body];
    turned.x = anchor + turn * (turned.x - anchor);
    turned.q = normalize(turn * turned.q);
  }
  Bent(const Bent&) = delete;
  vec3 axis1() const { return to_world(world.bodies[wall], hinge->second.a1_local); }
  double off() const {
    const vec3 axis2 = to_world(world.bodies[body], cross(hinge->second.b_local,
                                                          hinge->second.c_local));
    return std::atan2(double(length(cross(axis1(), axis2))), double(dot(axis1(), axis2)));
  }
};

}  // namespace

void bent_hinges(bool quick, const Tell& tell) {
  for (double angle : {90., 179.9, 180.})
    for (bool whole : {true, false}) {
      if (quick && !whole) continue;
      const std::string method = whole ? "whole" : "apart";
      Bent bent(real(angle) * degree, whole), other(real(angle) * degree, whole);
      other.world.bodies[other.body].q = -other.world.bodies[other.body].q;
      double apart = 0;
      for (int k = 0; k < 180; ++k) {
        bent.watch.step(h);
        other.watch.step(h);
        const Body &a = bent.world.bodies[bent.body], &b = other.world.bodies[other.body];
        apart = std::max(apart, double(length(a.x - b.x) + length(a.v - b.v) + length(a.w - b.w)));
      }
      tell(compared({.id = "X7", .method = method,
                     .parameter = "axis error after 3 s [rad], bent by [deg]", .value = angle},
                    0, bent.watch.seen(bent.off()), 2e-3));
      tell(compared({.id = "X7", .method = method,
                     .parameter = "difference of q and -q, bent by [deg]", .value = angle},
                    0, other.watch.seen(apart), 0));
    }
}

namespace {

const glm::dvec3 moments(1, 2, 2.5);

// A torque-free step as others do it, in the body's axes: explicit, or implicit by Newton.
glm::dvec3 euler_step(const glm::dvec3& w, bool implicit) {
  const double t = double(h);
  if (!implicit) return w - t * (cross(w, moments * w) / moments);
  glm::dvec3 next = w;
  for (int k = 0; k < 20; ++k) {
    const glm::dvec3 f = moments * (next - w) + t * cross(next, moments * next);
    glm::dmat3 D;
    for (int i = 0; i < 3; ++i) {
      glm::dvec3 e(0);
      e[i] = 1;
      D[i] = moments * e + t * (cross(e, moments * next) + cross(next, moments * e));
    }
    next -= inverse(D) * f;
  }
  return next;
}

double spin_energy(const glm::dvec3& w) { return 0.5 * dot(w, moments * w); }

}  // namespace

void spinning(bool quick, const Tell& tell) {
  for (double speed : {1., 10., 50., 200.}) {
    const double share = speed > 50 ? 0.05 : 0.01;
    const glm::dvec3 start(0.01 * speed, 0.01 * speed, speed);
    const glm::dvec3 about(start.x, start.z, start.y);  // the middle moment's axis is y
    World world;
    world.gravity = vec3(0);
    const BodyId id = world.add(body_with(1, vec3(moments), vec3(0)));
    world.bodies[id].w = vec3(about);
    const double before = kinetic_energy(world.bodies[id]);
    Watch watch{world};
    double furthest = 1;
    for (int k = 0; k < 600; ++k) {
      watch.step(h);
      const double ratio = kinetic_energy(world.bodies[id]) / before;
      if (std::abs(ratio - 1) > std::abs(furthest - 1)) furthest = ratio;
    }
    const std::string parameter = "energy / start, spin [rad/s]";
    tell(compared({.id = "X8", .method = "implicit midpoint (the engine)", .parameter = parameter,
                   .value = speed},
                  1, watch.seen(furthest), share));
    for (bool implicit : {false, true}) {  // shown beside it
      glm::dvec3 w = about;
      for (int k = 0; k < 600 && spin_energy(w) < 1e6 * spin_energy(about); ++k)
        w = euler_step(w, implicit);
      tell(compared({.id = "X8",
                     .method = implicit ? "implicit Euler (for comparison)"
                                        : "explicit Euler (for comparison)",
                     .parameter = parameter, .value = speed},
                    1, spin_energy(w) / spin_energy(about), share));
    }
  }
  for (bool whole : {true, false})
    for (bool warm : {false, true}) {
      Rotor rotor(real(0.5), 1000);
      rotor.hinge->whole = whole;
      rotor.watch.solver.warm_start = warm;
      const double before = kinetic_energy(rotor.world.bodies[rotor.body]);
      double most = 0;
      for (int k = 0; k < (quick ? 60 : 600); ++k) {
        rotor.watch.step(h);
        most = std::max(most, kinetic_energy(rotor.world.bodies[rotor.body]) / before);
      }
      tell(judged({.id = "X8", .method = std::string(whole ? "whole" : "apart") +
                                         (warm ? ", warm 30" : ", cold 30"),
                   .parameter = "most energy / start, hinge 0.5 m beside, spin [rad/s]",
                   .value = 1000},
                  rotor.watch.seen(most), most < 1.02));
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
        Scene scene = motor_into_limit();
        HingeJoint& hinge = hinge_of(scene);
        hinge.whole = whole;
        Watch watch{scene.world};
        watch.solver.iterations = iterations;
        watch.solver.warm_start = warm;
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
          Scene again = motor_into_limit();
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

void a_long_time(bool quick, const Tell& tell) {
  constexpr int minute = 3600;
  const int minutes = quick ? 3 : 278;  // 1,000,800 steps
  for (bool whole : {true, false}) {
    if (quick && !whole) continue;
    Scene scene;
    const BodyId frame = scene.world.add(static_body(vec3(0)));
    const BodyId leaf =
        scene.world.add(box(20, vec3(1, 2, real(0.05)), vec3(real(0.5), 0, 0)));
    HingeJoint& door = join_by_hinge(scene, frame, leaf, vec3(0), vec3(0, 1, 0));
    door.whole = whole;
    door.set_limits(0, 110 * degree);
    Watch watch{scene.world};
    watch.solver.iterations = 10;
    struct Measures {
      double gap = 0, energy = 0;
    } first, now;
    std::vector<Pose> at;
    for (int k = 0; k < minutes * minute; ++k) {
      if (k % 300 == 0) door.set_motor(k % 600 != 0 ? -2 : 2, 50);
      watch.step(h);
      poses(scene.world.bodies, at);
      now.gap = std::max(now.gap, gap(scene.marks.front(), at));
      now.energy = std::max(now.energy, kinetic_energy(scene.world.bodies[leaf]) +
                                            20 * 9.81 * at[leaf.slot].x.y);
      if ((k + 1) % minute != 0 || k + 1 == minutes * minute) continue;
      if (k + 1 == minute) first = now;
      now = {};
    }
    const std::string method = whole ? "whole, cold 10" : "apart, cold 10";
    tell(compared({.id = "X17", .method = method,
                   .parameter = "gap of the last minute against the first's [m], steps",
                   .value = double(minutes) * minute},
                  first.gap, watch.seen(now.gap), 1e-3 * first.gap + digits(1e-12, 1e-6)));
    tell(compared({.id = "X17", .method = method,
                   .parameter = "energy of the last minute against the first's [J], steps",
                   .value = double(minutes) * minute},
                  first.energy, watch.seen(now.energy), digits(1e-6, 1e-3) * first.energy));
  }
}

}  // namespace joints::bench
