// The chain of cubes that several scenes of chapter 6 use.
#pragma once

#include <cmath>

#include "engine/instruments/scene.h"
#include "joints/ball_joint.h"

namespace joints::chapter6 {

/// Cubes 1 m apart in a row, the first static, each on a ball joint at the centre of the previous
/// one.
struct CubeChain {
  Scene scene;                     ///< the scene
  std::vector<BodyId> ids;         ///< its cubes, the static one first
  std::vector<BallJoint*> joints;  ///< one less than cubes

  /// Makes the scene. \param mass of a cube [kg] \param along from a cube to the next [m]
  CubeChain(const std::string& name, int links, real mass, const vec3& along, real beta)
      : scene{.name = name} {
    scene.energy_scale = 0;
    for (int k = 0; k <= links; ++k) {
      ids.push_back(scene.box(k == 0 ? 0 : mass, vec3(real(0.4)), real(k) * along));
      if (k > 0) add_joint(ids[std::size_t(k) - 1], ids.back(), beta);
      scene.energy_scale += double(mass) * 9.81 * k;
    }
  }
  /// Joins two bodies at the centre of the first.
  void add_joint(BodyId a, BodyId b, real beta) {
    World& world = scene.world;
    const vec3 anchor = world.bodies[a].x;
    joints.push_back(&world.add<BallJoint>(a, b, anchor));
    joints.back()->beta = beta;
    scene.mark(a, b, anchor);
  }
  /// One step of the scene's length.
  void step() { scene.step(); }
  /// Gap of joint k [m].
  double gap(std::size_t k) const {
    const BallJoint& joint = *joints[k];
    const Bodies& bodies = scene.world.bodies;
    return double(length(joint.part.error(bodies[joint.body1], bodies[joint.body2])));
  }
  /// The root of the sum of the squares of all gaps [m].
  double gap() const {
    double sum = 0;
    for (std::size_t k = 0; k < joints.size(); ++k) sum += gap(k) * gap(k);
    return std::sqrt(sum);
  }
};

}  // namespace joints::chapter6
