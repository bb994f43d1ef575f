// Cases of the stability suite on rotations and long runs: X7, X8 of a free box, X17.
#include <algorithm>
#include <cmath>

#include "bench/suite.h"

namespace joints::bench {

namespace {

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
    hinge = &world.add<HingeJoint>(wall, body, anchor, vec3(1, 2, -1));
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

void spinning(bool, const Tell& tell) {
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
      poses(all_of(scene.world.bodies), at);
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
