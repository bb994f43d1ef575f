// The machine of chapter 10's program: a motor drives a shaft, a universal joint, a gear and a
// screw, which lifts a nut. Read it; there is nothing to edit here.
#pragma once

#include "engine/instruments/scene.h"
#include "joints/driven_joints.h"

/// \addtogroup chapter10
/// @{
namespace joints::chapter10 {

/// Two shafts that meet at an angle, a wheel beside the second one, and a nut on the wheel's axle.
struct Machine {
  static constexpr double ratio = -0.5;  ///< turns of the wheel per turn of the second shaft
  static constexpr double lead = 0.25;   ///< travel of the nut per turn of the wheel [m]
  Scene scene{.name = "machine"};        ///< world, solver, measurements, appearance
  HingeJoint *drive, *driven, *axle;     ///< of first shaft, second shaft and wheel
  SliderJoint* rail;                     ///< keeps the nut from rotating

  /// Makes the scene. \param angle between the shafts [rad] \param speed of the motor [rad/s]
  Machine(const Settings& settings, real angle, real speed) {
    World& world = scene.world;
    scene.solver.iterations = settings.iterations;
    const vec3 along1(1, 0, 0), along2(std::cos(angle), 0, std::sin(angle)), up(0, 1, 0);
    const quat turned = rotation(vec3(0, -angle, 0));
    const vec3 beside = real(0.55) * up, nut_at = along2 * real(1.5) + beside;
    const BodyId wall = scene.box(0, vec3(real(0.1), real(0.3), real(0.3)), -real(1.3) * along1);
    const BodyId first = scene.box(4, vec3(1, real(0.16), real(0.16)), real(-0.6) * along1);
    const BodyId second = scene.box(4, vec3(1, real(0.16), real(0.16)), real(0.6) * along2, turned);
    const BodyId wheel = scene.box(6, vec3(real(0.12), real(0.6), real(0.6)),
                                   real(0.7) * along2 + beside, turned);
    const BodyId nut = scene.box(2, vec3(real(0.2), real(0.24), real(0.24)), nut_at, turned);
    const auto on_axle = [&](BodyId id, const vec3& axis) {
      const vec3 anchor = world.bodies[id].x;
      scene.mark(wall, id, anchor, axis);
      return &world.add<HingeJoint>(wall, id, anchor, axis);
    };
    drive = on_axle(first, along1);
    driven = on_axle(second, along2);
    axle = on_axle(wheel, along2);
    rail = &world.add<SliderJoint>(wall, nut, nut_at, along2);
    world.add<UniversalJoint>(first, second, vec3(0), up, cross(along2, up));
    scene.mark(first, second, vec3(0));
    world.add<GearJoint>(second, wheel, along2, along2, real(ratio));
    world.add<ScrewJoint>(wheel, nut, nut_at, along2, real(lead));
    drive->set_motor(speed, 500);
    world.set_beta(settings.beta);
    scene.energy_scale = 100;
  }
};

}  // namespace joints::chapter10
/// @}
