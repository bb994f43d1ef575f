// Half a step of rotation before the bodies move, half of it after.
#include "engine/steps/leapfrog.h"

#include <utility>

#include "engine/kept/state.h"
#include "engine/steps/soft.h"

namespace joints {

real Leapfrog::integrate_forces(World& world, real h) const {
  const real duration = (world.last_h + h) / 2;
  kick(world.bodies, world.gravity, duration);  // Eq. 9-9
  return duration;
}

void Leapfrog::move(World& world, Solver& solver, real h) const {
  turn(world.bodies, h / 2);
  StepMethod::move(world, solver, h);
  turn(world.bodies, h / 2);
}

Bodies velocities_at_pose_time(World& world, Solver& solver, bool warm_start) {
  if (world.last_h == 0) return world.bodies;
  const State now = save(world);
  const real half = world.last_h / 2;
  Blocks& blocks = world.blocks;
  kick(world.bodies, world.gravity, half);
  blocks.clear();
  for (const auto& joint : world.joints()) joint->append(world.bodies, blocks);
  for (Block& block : blocks.list)
    if (block.corrects) block.target = without_feedback(block.target);
  const real before = std::exchange(blocks.impulse_duration, half);
  solver.prepare(world.bodies, blocks, 0, half);
  solver.warm_start(world.bodies, warm_start ? half / before : real(0));
  solver.solve(world.bodies);
  const Bodies out = world.bodies;
  restore(world, now);
  return out;
}

}  // namespace joints
