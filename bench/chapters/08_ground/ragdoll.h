// The ragdoll of chapter 8 (thesis, fig. 5.5): six boxes that fall.
#pragma once

#include <functional>

#include "chapters/08_ground/program/program.h"
#include "joints/fixed_joint.h"

namespace joints::chapter8 {

inline const vec3 torso_size{real(0.6), 1, real(0.4)};  ///< of a doll [m]
inline const vec3 head_size{real(0.35), real(0.4), real(0.35)};  ///< of a doll [m]
inline const vec3 arm_size{real(0.8), real(0.2), real(0.2)};  ///< of a doll [m]
inline const vec3 leg_size{real(0.25), 1, real(0.25)};  ///< of a doll [m]
/// Rotation from upright, so that feet and a hand land first.
inline const quat tilted = rotation(vec3(0, 0, real(1.1))) * rotation(vec3(real(0.4), 0, 0));

/// Joins a limb to the torso. \param anchor [m, world] \param along from the anchor to the limb's
/// centre, world \param across the doll's front, world \param arm false for a leg
using JoinLimb = std::function<Joint&(World& world, BodyId torso, BodyId limb, const vec3& anchor,
                                      const vec3& along, const vec3& across, bool arm)>;
/// A ball joint: the limb may point anywhere.
inline Joint& on_ball(World& world, BodyId torso, BodyId limb, const vec3& anchor, const vec3&,
                      const vec3&, bool) {
  return world.add<BallJoint>(torso, limb, anchor);
}

/// The bodies of a ragdoll and its contacts with the ground.
struct Doll {
  BodyId torso;  ///< connected to all others
  BodyId head;   ///< welded to the torso
  std::vector<BodyId> parts;             ///< all six
  std::vector<GroundContact*> contacts;  ///< one for each of them
};

/// The six boxes of chapter 5's ragdoll, without the grip: joints in shoulders and hips, the head
/// welded on, a contact with the ground for every box. There are no contacts between the
/// boxes: an arm can lie inside the torso. Its arms are stretched out along its own x.
/// \param centre of the torso [m] \param turn of the whole doll from upright \param beta of all
/// \param join makes shoulders and hips
inline Doll add_doll(Scene& scene, BodyId ground, const vec3& centre, const quat& turn, real beta,
                     const JoinLimb& join = on_ball) {
  Doll doll;
  World& world = scene.world;
  const auto part = [&](real mass, const vec3& size, const vec3& x) {
    doll.parts.push_back(scene.box(mass, size, centre + turn * x, turn));
    return doll.parts.back();
  };
  doll.torso = part(100, torso_size, vec3(0));
  doll.head = part(33, head_size, vec3(0, real(0.7), 0));
  const vec3 neck = centre + turn * vec3(0, real(0.5), 0);
  world.add<FixedJoint>(doll.torso, doll.head, neck).beta = beta;
  scene.mark(doll.torso, doll.head, neck);
  const auto limb = [&](const vec3& size, const vec3& x, const vec3& joint) {
    const BodyId id = part(25, size, x);
    const vec3 anchor = centre + turn * joint;
    const bool arm = &size == &arm_size;
    join(world, doll.torso, id, anchor, turn * (x - joint), turn * vec3(0, 0, 1), arm).beta = beta;
    scene.mark(doll.torso, id, anchor);
  };
  for (const real side : {real(1), real(-1)}) {
    limb(arm_size, vec3(side * real(0.75), real(0.45), 0), vec3(side * real(0.3), real(0.45), 0));
    limb(leg_size, vec3(side * real(0.17), real(-1.05), 0),
         vec3(side * real(0.17), real(-0.5), 0));
  }
  const std::array<vec3, 6> sizes{torso_size, head_size, arm_size, leg_size, arm_size, leg_size};
  for (std::size_t k = 0; k < doll.parts.size(); ++k) {
    doll.contacts.push_back(&stand(scene, ground, doll.parts[k], sizes[k], real(0.5)));
    doll.contacts.back()->beta = beta;
  }
  scene.energy_scale += 233 * 9.81 * double(centre.y);
  return doll;
}

/// A ragdoll in the air, which falls.
struct Ragdoll : Doll {
  Scene scene{.name = "ragdoll", .energy_scale = 0};  ///< world, solver, measurements, appearance
  BodyId ground;  ///< on which it falls

  /// Makes it. \param height of the torso's centre [m] \param turn of the whole doll from upright
  /// \param join makes shoulders and hips
  explicit Ragdoll(const Choice& choice, real height = 2, const quat& turn = tilted,
                   const JoinLimb& join = on_ball) {
    scene.solver.iterations = choice.iterations;
    scene.stepping.warm_start = true;
    ground = add_ground(scene, 5);
    static_cast<Doll&>(*this) = add_doll(scene, ground, vec3(0, height, 0), turn, choice.beta,
                                        join);
  }
  /// The greatest speed of a centre [m/s].
  double fastest() const {
    double most = 0;
    for (const BodyId id : parts)
      most = std::max(most, double(length(scene.world.bodies[id].v)));
    return most;
  }
  /// The greatest angular speed [rad/s].
  double fastest_turn() const {
    double most = 0;
    for (const BodyId id : parts)
      most = std::max(most, double(length(scene.world.bodies[id].w)));
    return most;
  }
  /// True if every box is slower than 1 mm/s and 1 mrad/s.
  bool rests() const { return fastest() < 1e-3 && fastest_turn() < 1e-3; }
};

}  // namespace joints::chapter8
