// The reaction of a joint, J^T times the mean forces of its rows.
#include "engine/reaction.h"

namespace joints {

Reaction reaction(const Joint& joint, const Bodies& bodies) {
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
