// The families of what spins, is moved by the program, folds in short links or is held in place.
#include <algorithm>
#include <numbers>

#include "bench/draw.h"
#include "bench/families.h"
#include "engine/instruments/measure.h"
#include "engine/kept/kinematic.h"
#include "joints/driven_joints.h"

namespace joints::bench {

namespace {

constexpr double fall = 9.81;   // [m/s^2]
constexpr double hertz = 60;    // rates are drawn as angles per such a step

Drawn weightless() {
  Drawn out;
  out.world.gravity = vec3(0);
  return out;
}

// A vector that a draw scales up to `most`.
vec3 any(Draw& draw, double most) { return real(draw.number(0, most)) * draw.direction(); }

// The rotation that turns the z axis to a unit vector.
quat from_z(const vec3& to) {
  const vec3 about = cross(vec3(0, 0, 1), to);
  const real sine = length(about);
  return sine > 0 ? rotation(std::atan2(sine, to.z) / sine * about) : quat(1, 0, 0, 0);
}

// A body in free flight with one to three balanced rotors on hinges, which rotate by 0.1 to 2.5 rad
// in a step; the body itself tumbles slowly.
Drawn rotors(Draw draw) {
  Drawn scene = weightless();
  World& world = scene.world;
  const double size = draw.scale(0.02, 20), mass = draw.scale(0.02, 50);
  const real rate = real(draw.scale(0.1, 2.5) * hertz);
  const vec3 edges = real(size) * vec3(real(draw.number(0.5, 2)), real(draw.number(0.5, 2)),
                                       real(draw.number(0.5, 2)));
  const BodyId frame = scene.box(real(mass), edges, any(draw, size), draw.rotation());
  const vec3 tumble = rate * any(draw, 0.01), middle = world.bodies[frame].x;
  world.bodies[frame].w = tumble;
  for (int k = draw.whole(1, 3); k > 0; --k) {
    const vec3 axle = draw.direction(), lever = any(draw, size);
    const double share = mass * draw.scale(0.007, 1), radius = size * draw.number(0.1, 1);
    const real along = real(share * radius * radius * draw.number(0.4, 1));
    const real across = along * real(draw.number(0.55, 0.95));
    Body rotor = body_with(real(share), vec3(across, across, along), middle + lever);
    rotor.q = from_z(axle);
    rotor.w = tumble + real(draw.number(0.3, 1)) * rate * axle;
    rotor.v = cross(tumble, lever);
    join_by_hinge(scene, frame, world.add(rotor), rotor.x, axle);
  }
  scene.energy_scale = energy(all_of(world.bodies), vec3(0));
  scene.momentum_scale = double(length(momentum(all_of(world.bodies)).angular));
  return scene;
}

// A top on a ball joint that leans anyhow, and rotates by 0.1 to 2.5 rad in a step.
Drawn top(Draw draw) {
  Drawn scene;
  const double reach = draw.scale(0.05, 2), mass = draw.scale(0.1, 10);
  const real along = real(mass * reach * reach * draw.number(0.1, 1));
  const real across = along * real(draw.number(0.55, 2));
  const vec3 axis = draw.direction();
  Body body = body_with(real(mass), vec3(across, across, along), real(reach) * axis);
  body.q = from_z(axis);
  body.w = real(draw.scale(0.1, 2.5) * hertz) * axis;
  const BodyId ground = scene.box(0, vec3(real(0.1)), vec3(0)), id = scene.world.add(body);
  join_by_ball(scene, ground, id, vec3(0));
  scene.energy_scale = fall * mass * reach + double(dot(body.w, body.w) * along) / 2;
  return scene;
}

// Four boxes in free flight between which motors start.
Drawn motors_in_flight(Draw draw) {
  Drawn scene = weightless();
  scene.keeps_energy = false, scene.driven = true;
  const double size = draw.scale(0.02, 20), mass = draw.scale(0.02, 50);
  scene.momentum_scale = 10 * mass * size * size;  // of the motors' speeds
  scene.energy_scale = 10 * scene.momentum_scale;
  BodyId before{};
  for (int k = 0; k < 4; ++k) {
    const vec3 edges = real(size) * vec3(real(draw.number(0.5, 2)), real(draw.number(0.5, 2)),
                                         real(draw.number(0.5, 2)));
    const vec3 x = real(size) * (vec3(real(k), 0, 0) + any(draw, 0.2));
    const BodyId next = scene.box(real(mass * draw.scale(0.05, 1)), edges, x, draw.rotation());
    if (k > 0)
      join_by_hinge(scene, before, next, real(size) * vec3(real(k) - real(0.5), 0, 0),
                    draw.direction())
          .set_motor(real(draw.number(-10, 10)), real(1000 * mass * size * size));
    before = next;
  }
  return scene;
}

// Adds a joint whose point is held, and of whose angles a draw locks none to two.
void add_point_joint(Draw& draw, World& world, BodyId a, BodyId b, const vec3& anchor,
                     const vec3& axis, const vec3& across) {
  const int kind = draw.whole(0, 6);
  if (kind == 0) {
    world.add<UniversalJoint>(a, b, anchor, across, cross(axis, across));
  } else if (kind == 1) {
    world.add<ConeTwistJoint>(a, b, anchor, axis, across, real(4)).twist().set_limits(0, 0);
  } else {
    auto& six = world.add<SixDofJoint>(a, b, anchor, axis, across);
    six.slide1().set_limits(0, 0);
    six.slide2().set_limits(0, 0);
    six.slide3().set_limits(0, 0);
    if (kind >= 4) six.twist().set_limits(0, 0);
    if (kind == 3 || kind == 5) six.swing2().set_limits(0, 0);
    if (kind == 6) six.swing3().set_limits(0, 0);
  }
}

// 16 links of 2 to 10 cm in a zigzag, which fold at sixty steps per second.
Drawn short_links(Draw draw) {
  Drawn scene;
  scene.keeps_energy = false, scene.seconds = 4;
  const double size = draw.number(0.02, 0.1);
  BodyId before = scene.box(0, vec3(real(size)), vec3(0));
  vec3 end(0);
  for (int k = 0; k < 16; ++k) {
    const vec3 d = draw.direction(), across = normalize(cross(d, vec3(real(0.3), real(0.1), 1)));
    const double mass = draw.scale(0.3, 3);
    const BodyId link = scene.box(real(mass), real(size) * vec3(real(0.3), real(0.3), 1),
                                  end + real(size / 2) * d, from_z(d));
    add_point_joint(draw, scene.world, before, link, end, d, across);
    before = link, end += real(size) * d;
    scene.energy_scale += fall * mass * size * (k + 1);
  }
  return scene;
}

// A platform that the program carries about and rotates, and a chain that hangs from it.
Drawn carried(Draw draw) {
  Drawn scene;
  scene.keeps_energy = false, scene.driven = true;
  const double size = draw.scale(0.1, 3), turns = draw.number(0, 1);
  const vec3 sway = real(size) * draw.direction(), about = draw.direction();
  const real pace = real(draw.number(0.5, 4));
  Body platform = static_body(vec3(0));
  platform.kinematic = true;
  const BodyId carrier = scene.world.add(platform);
  BodyId before = carrier;
  const int links = draw.whole(1, 6);
  for (int k = 0; k < links; ++k) {
    const vec3 top(0, real(-k * size), 0);
    const double mass = draw.scale(0.1, 100);
    const BodyId link = scene.box(real(mass), vec3(real(0.3 * size)),
                                  top - vec3(0, real(size / 2), 0));
    if (draw.chance(0.5)) join_by_ball(scene, before, link, top);
    else join_by_hinge(scene, before, link, top, draw.direction());
    before = link;
    scene.energy_scale += fall * mass * size * links;
  }
  scene.control = [=, time = real(0)](World& world, real step) mutable {
    time += step;
    const real phase = pace * time;
    move_to(world.bodies[carrier], std::sin(phase) * sway,
            rotation(real(turns) * (1 - std::cos(phase)) * about), step);
  };
  return scene;
}

// An arm that stands out from a wall, which friction or a motor at rest holds with 5 % in reserve.
Drawn held_arm(Draw draw) {
  Drawn scene;
  scene.keeps_energy = false;
  const double reach = draw.scale(0.1, 5), mass = draw.scale(0.1, 1000);
  const double strength = 1.05 * fall * mass * reach / 2;
  const BodyId wall = scene.box(0, vec3(real(0.1)), vec3(0));
  const double turn = draw.number(0, 2 * std::numbers::pi);
  const vec3 out(real(std::cos(turn)), 0, real(std::sin(turn)));
  const vec3 edges(real(reach), real(0.1 * reach), real(0.1 * reach));
  const BodyId arm = scene.box(real(mass), edges, real(reach / 2) * out,
                               rotation(real(-turn) * vec3(0, 1, 0)));
  HingeJoint& hinge = join_by_hinge(scene, wall, arm, vec3(0), cross(out, vec3(0, 1, 0)));
  if (draw.chance(0.5)) hinge.set_friction(real(strength));
  else hinge.set_motor(0, real(strength));
  scene.energy_scale = fall * mass * reach;
  scene.miss = [=](const World& world) { return std::abs(double(world.bodies[arm].x.y)); };
  return scene;
}

}  // namespace

std::vector<Family> motion_families() {
  const auto of = [](auto make) { return [make](unsigned seed) { return make(Draw(seed)); }; };
  return {{"rotors", 200, of(rotors)},
          {"tops", 100, of(top)},
          {"motors in flight", 100, of(motors_in_flight)},
          {"short links", 100, of(short_links)},
          {"carried chains", 100, of(carried)},
          {"held arms", 100, of(held_arm)}};
}

}  // namespace joints::bench
