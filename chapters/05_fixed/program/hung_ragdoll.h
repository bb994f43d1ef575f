// The ragdoll of chapter 5's program, which hangs by one hand. Read it; there is nothing to edit
// here.
#pragma once

#include "engine/instruments/scene.h"
#include "joints/fixed_joint.h"

/// \addtogroup chapter5
/// @{
namespace joints::chapter5 {

/// The six boxes of the thesis' fig. 5.5: balls in shoulders and hips, the head welded on.
struct HungRagdoll {
  static constexpr double mass = 233;  ///< of all boxes together [kg]
  Scene scene{.name = "ragdoll"};      ///< world, solver, measurements, appearance
  BallJoint* grip;                     ///< the joint of the hand by which it hangs

  /// The scene with these settings.
  explicit HungRagdoll(const Settings& settings) {
    scene.solver.iterations = settings.iterations;
    const BodyId torso = scene.box(100, vec3(real(0.6), 1, real(0.4)), vec3(0));
    const BodyId head = scene.box(33, vec3(real(0.35), real(0.4), real(0.35)),
                                  vec3(0, real(0.7), 0));
    const vec3 arm(real(0.8), real(0.2), real(0.2)), leg(real(0.25), 1, real(0.25));
    const auto limb = [&](const vec3& size, const vec3& x, const vec3& anchor) {
      const BodyId id = scene.box(25, size, x);
      auto& joint = scene.world.add<BallJoint>(
          torso, id, anchor);
      joint.beta = settings.beta;
      scene.mark(torso, id, anchor);
      return id;
    };
    const real side = real(0.3), shoulder = real(0.45);
    const BodyId right = limb(arm, vec3(real(0.75), shoulder, 0), vec3(side, shoulder, 0));
    limb(arm, vec3(real(-0.75), shoulder, 0), vec3(-side, shoulder, 0));
    for (const real x : {real(0.17), real(-0.17)})
      limb(leg, vec3(x, real(-1.05), 0), vec3(x, real(-0.5), 0));
    auto& neck = scene.world.add<FixedJoint>(torso, head,
                                             vec3(0, real(0.5), 0));
    neck.beta = settings.beta;
    neck.whole = settings.whole;
    scene.mark(torso, head, vec3(0, real(0.5), 0));
    const vec3 hand(real(1.15), shoulder, 0);
    const BodyId hook = scene.box(0, vec3(real(0.1)), hand);
    grip = &scene.world.add<BallJoint>(
        hook, right, hand);
    grip->beta = settings.beta;
    scene.mark(hook, right, hand);
    scene.energy_scale = mass * 9.81 * 1.5;
  }
};

}  // namespace joints::chapter5
/// @}
