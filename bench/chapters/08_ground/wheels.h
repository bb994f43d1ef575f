// The self-driving wheels of chapter 8 (thesis, fig. 5.7).
#pragma once

#include <numbers>

#include "chapters/08_ground/program/program.h"
#include "joints/fixed_joint.h"
#include "joints/hinge_joint.h"

namespace joints::chapter8 {

/// Two wheels behind each other, and a beam from hub to hub. A wheel is a hub and six cubes welded
/// to it like spokes; a motor in each hub's hinge rotates it. There are no contacts between cubes
/// and beam: the cubes pass through it.
struct Wheels {
  static constexpr real edge = 1;         ///< of a cube [m]
  static constexpr real spoke = 3;        ///< from the hub to the centre of a cube [m]
  static constexpr real apart = 8;        ///< from hub to hub [m]
  static constexpr real cube_mass = 100;  ///< of each cube and each hub [kg]
  static constexpr real beam_mass = 100;  ///< [kg]
  /// Weight of one wheel and half of the beam [N].
  static constexpr double weight = double(7 * cube_mass + beam_mass / 2) * 9.81;

  /// From the hub to the corners of the wheel [m]: it rolls on twelve of them, two per cube.
  static double corner_radius() { return std::hypot(double(spoke + edge / 2), double(edge / 2)); }
  /// Half the angle at the hub of the gap between two cubes [rad].
  static double half_gap() {
    return std::numbers::pi / 6 - std::atan(double(edge / 2) / double(spoke + edge / 2));
  }
  /// The gap that the wheel bridges from cube to cube [m].
  static double chord() { return 2 * corner_radius() * std::sin(half_gap()); }
  /// Rolling radius: the distance of a wheel per radian of rotation [m]. A revolution moves it by
  /// its perimeter, six faces and six gaps.
  static double rolling_radius() {
    return (6 * double(edge) + 6 * chord()) / (2 * std::numbers::pi);
  }
  /// Least torque of a motor [N m]: a wheel that stands over a gap must tip over the corner in
  /// front of it, which is chord / 2 ahead of the hub: weight * chord / 2, 9.7 kN m. The 30 N m of
  /// the thesis' engine are 300 times too small.
  static double needed() { return weight * chord() / 2; }

  /// Of each motor [N m]: a quarter above the least torque. The reaction acts on the beam: the rear
  /// wheel carries 2 strength / apart, 3 of the 7.4 kN, more and the front wheel that much less.
  /// With weight * apart / 2 = 29 kN m or more the front wheel would lift off.
  static constexpr real strength = 12000;
  /// Of the motors [rad/s]. A corner cannot pull the wheel down: above
  /// sqrt(g / corner_radius) = 1.67 rad/s the wheel leaves the ground at the top of each corner, so
  /// at 3 rad/s it hops and does not roll.
  static constexpr real speed = 1;
  /// A step. The hubs are light compared with the bodies joined to them (with ten times the inertia
  /// of the hub the factor per iteration would be 0.86, not 0.98), and a warm start that does not
  /// converge within its step grows: with 60 iterations the wheels fly apart while they roll, with
  /// 80 and more they stay together. With fewer than `safe_iterations` they start cold.
  static constexpr int iterations = 300;
  static constexpr int safe_iterations = 100;  ///< per step, from which on a warm start is stable

  Scene scene{.name = "wheels"};  ///< world, solver, measurements, appearance
  BodyId ground;  ///< under both wheels
  BodyId beam;    ///< from hub to hub
  std::array<BodyId, 2> hubs;            ///< front one first
  std::array<HingeJoint*, 2> motors{};   ///< positive drives towards +x
  std::vector<GroundContact*> contacts;  ///< one for each cube, not for the hubs

  /// Makes the scene. \param friction coefficient of all cubes [1]
  explicit Wheels(const Choice& choice, real friction = 1) {
    scene.solver.iterations = choice.iterations;
    scene.stepping.warm_start = choice.iterations >= safe_iterations;
    ground = scene.box(0, vec3(56, real(0.2), 10), vec3(14, real(-0.1), 0));  // its top: y = 0
    World& world = scene.world;
    const real height = real(corner_radius() * std::cos(half_gap()));
    beam = scene.box(beam_mass, vec3(apart, real(0.3), real(0.3)), vec3(0, height, 0));
    std::vector<BodyId> cubes;
    for (const int wheel : {0, 1}) {
      const vec3 x(wheel == 0 ? apart / 2 : -apart / 2, height, 0);
      const BodyId hub = hubs[std::size_t(wheel)] = scene.box(cube_mass, vec3(edge), x);
      for (int k = 0; k < 6; ++k) {
        const quat turn = rotation(vec3(0, 0, real(k * std::numbers::pi / 3)));
        const vec3 out = turn * vec3(1, 0, 0);
        cubes.push_back(scene.box(cube_mass, vec3(edge), x + spoke * out, turn));
        const vec3 anchor = x + spoke / 2 * out;
        world.add<FixedJoint>(hub, cubes.back(), anchor).beta = choice.beta;
        scene.mark(hub, cubes.back(), anchor);
      }
      HingeJoint& hinge = world.add<HingeJoint>(beam, hub, x, vec3(0, 0, -1));
      hinge.beta = choice.beta;
      motors[std::size_t(wheel)] = &hinge;
      scene.mark(beam, hub, x, vec3(0, 0, -1));
    }
    for (const BodyId cube : cubes) {
      contacts.push_back(&stand(scene, ground, cube, vec3(edge), friction));
      contacts.back()->beta = choice.beta;
    }
    scene.energy_scale = 2 * weight * double(height);
  }
  /// Both motors. \param rate [rad/s], positive drives towards +x
  /// \param most strength of each [N m]
  void drive(real rate, real most) {
    for (HingeJoint* motor : motors) motor->set_motor(rate, most);
  }
  /// Mean torque of the two motors in the last step [N m].
  double torque() const {
    return double(motors[0]->motor_force() + motors[1]->motor_force()) / 2;
  }
  /// True if no cube touches the ground.
  bool flying() const {
    return std::all_of(contacts.begin(), contacts.end(),
                       [](const GroundContact* contact) { return contact->touching() == 0; });
  }
  /// Displacement of the middle of the beam [m].
  double place() const { return double(scene.world.bodies[beam].x.x); }
  /// Mean rotation of the two hubs [rad].
  double turned() const {
    const Bodies& bodies = scene.world.bodies;
    return double(motors[0]->position(bodies) + motors[1]->position(bodies)) / 2;
  }
};

}  // namespace joints::chapter8
