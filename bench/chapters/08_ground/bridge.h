// A suspension bridge under a load, after the thesis' fig. 5.6.
#pragma once

#include "chapters/08_ground/program/program.h"
#include "engine/kept/reaction.h"
#include "joints/hinge_joint.h"

namespace joints::chapter8 {

/// Ten planks of 20 kg, hinged to each other and to two posts; a crate of 100 kg falls on them.
/// Each plank is a moving ground for the crate. Each hinge has friction: a motor with the target
/// speed 0 and little strength. Without it the bridge would go on swinging. Joints and
/// contacts start warm with a beta of 0.02. An iteration multiplies the slowest error of the loaded
/// bridge by 0.9971, and 0.9971^30 (1 + 0.2) = 1.10 is more than 1 (Eq. 6-9): with 0.2 bridge and
/// crate never come to rest, and with 10 iterations the crate falls through.
struct Bridge {
  static constexpr int planks = 10;  ///< how many
  static constexpr double plank_mass = 20, crate_mass = 100;  ///< [kg]
  static constexpr double bend = 0.08;  ///< between two planks at the start [rad]
  Scene scene{.name = "bridge"};  ///< world, solver, measurements, appearance
  vec3 plank_size = vec3(1, real(0.15), 2);               ///< [m]
  vec3 crate_size = vec3(real(1.2), 1, real(1.2));        ///< [m]
  real post_top = 3;                                      ///< height of the two outer hinges [m]
  std::vector<BodyId> plank;              ///< from left to right
  BodyId ground{};  ///< under the bridge
  BodyId crate{};   ///< the load
  std::vector<HingeJoint*> hinges;        ///< from left to right, those at the posts too
  std::vector<GroundContact*> contacts;  ///< of the crate, one per plank

  /// Makes it. \param iterations iterations per step \param loaded whether the crate is present
  /// \param rub greatest torque of a hinge's friction [N m] \param beta of all joints [1]
  explicit Bridge(int iterations, bool loaded = true, real rub = 20, real beta = real(0.02)) {
    scene.solver.iterations = iterations;
    scene.stepping.warm_start = true;
    scene.energy_scale = crate_mass * 9.81 * 2;
    ground = add_ground(scene, 14);
    const auto slope = [](int k) { return real(bend) * (real(k) - real(planks - 1) / 2); };
    real half_span = 0;  // the planks hang in an arc, so that the bridge does not fall at first
    for (int k = 0; k < planks; ++k) half_span += plank_size.x * std::cos(slope(k)) / 2;
    vec3 end(-half_span, post_top, 0);
    BodyId before = post(end, -1);
    for (int k = 0; k < planks; ++k) {
      const vec3 along(std::cos(slope(k)), std::sin(slope(k)), 0);
      plank.push_back(scene.box(real(plank_mass), plank_size,
                                end + plank_size.x / 2 * along, rotation(vec3(0, 0, slope(k)))));
      hinge(before, plank.back(), end, rub, beta);
      before = plank.back();
      end += plank_size.x * along;
    }
    hinge(before, post(end, 1), end, rub, beta);
    if (loaded) load(beta);
  }
  /// The sag: distance of the middle hinge below the outer ones [m].
  double sag() const {
    const Body& left = scene.world.bodies[plank[planks / 2 - 1]];
    return double(post_top - world_point(left, vec3(plank_size.x / 2, 0, 0)).y);
  }
  /// Force of the planks on the crate in the last step [N].
  vec3 carried() const {
    vec3 sum(0);
    for (const GroundContact* contact : contacts)
      sum += reaction(*contact, scene.world.bodies).force;
    return sum;
  }

 private:
  // Its inner upper edge is the hinge.
  BodyId post(const vec3& top, real side) {
    return scene.box(0, vec3(real(0.5), post_top, 2),
                     vec3(top.x + side * real(0.25), post_top / 2, 0));
  }
  void hinge(BodyId id1, BodyId id2, const vec3& anchor, real rub, real beta) {
    auto& joint = scene.world.add<HingeJoint>(id1, id2, anchor,
                                              vec3(0, 0, 1));
    joint.beta = beta;
    joint.set_motor(0, rub);
    scene.mark(id1, id2, anchor, vec3(0, 0, 1));
    hinges.push_back(&joint);
  }
  void load(real beta) {
    crate = scene.box(real(crate_mass), crate_size, vec3(0, post_top + real(1.5), 0));
    for (const BodyId id : plank) {  // contacts after all joints: they are solved last
      contacts.push_back(&scene.world.add<GroundContact>(id, crate, box_top(plank_size),
                                                         box_outline(crate_size)));
      contacts.back()->beta = beta;
    }
    stand(scene, ground, crate, crate_size, real(0.5)).beta = beta;  // should it go through
  }
};

}  // namespace joints::chapter8
