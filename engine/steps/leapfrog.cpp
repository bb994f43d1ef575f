// Forces act from the middle of the last step to the middle of this one.
#include "engine/steps/leapfrog.h"

#include <utility>

#include "engine/kept/state.h"
#include "engine/rotation/free_rotation.h"
#include "engine/steps/soft.h"

namespace joints {

real Leapfrog::integrate_forces(World& world, real h) const {
  const real duration = (world.last_h + h) / 2;
  joints::integrate_forces(world.bodies, world.gravity, duration);  // Eq. 9-9
  return duration;
}

Bodies velocities_at_pose_time(World& world, Solver& solver, bool warm_start) {
  if (world.last_h == 0) return world.bodies;
  const State now = save(world);
  const real half = world.last_h / 2;
  Blocks& blocks = world.blocks;
  joints::integrate_forces(world.bodies, world.gravity, half);
  for (Body& body : world.bodies) use_own_rate(body);
  blocks.clear();
  for (const auto& joint : world.joints()) joint->append(world.bodies, blocks);
  for (Block& block : blocks.list)
    if (block.corrects) block.settings = without_feedback(block.settings);
  const real before = std::exchange(blocks.impulse_duration, half);
  solver.prepare(world.bodies, blocks, 0, half);
  solver.warm_start(world.bodies, warm_start ? half / before : real(0));
  solver.solve(world.bodies);
  const Bodies out = world.bodies;
  restore(world, now);
  return out;
}

}  // namespace joints
