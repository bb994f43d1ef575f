// The mean force and torque of a joint on its bodies in the last step.
#pragma once

#include "engine/joint.h"

/// \addtogroup joint
/// @{
namespace joints {

/// A force and a torque about a point, which the function that returns it specifies.
struct Reaction {
  vec3 force{0};   ///< [N], world
  vec3 torque{0};  ///< [N m], world
};

/// The reaction on body 2 in the last step, with the torque about body 2's centre: J^T times the
/// mean forces (Joint::mean_force) of the live rows, with J at the present poses. Body 1 gets the
/// opposite force along the same line. Zero before the first step. The function allocates memory,
/// so do not call it in an inner loop.
inline Reaction reaction(const Joint& joint, const Bodies& bodies) {
  Blocks blocks;
  joint.append(bodies, blocks);
  Reaction out;
  for (const Block& block : blocks.list)
    for (int i = 0; i < block.rows; ++i) {
      const real force = joint.mean_force(block.impulse[i]);
      out.force += force * blocks.J[block.first + i].v2;
      out.torque += force * blocks.J[block.first + i].w2;
    }
  return out;
}

}  // namespace joints
/// @}
