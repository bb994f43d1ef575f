// Algorithm 1 of the thesis: forces, blocks, impulses, poses.
#include "engine/step.h"

#include "engine/input.h"
#include "engine/projection.h"

namespace joints {

namespace {

// Constraint softness for the blocks from number `first` on that hold a position.
void soften(Blocks& blocks, int first, const Stepping& how) {
  if (how.frequency == 0) return;
  for (std::size_t k = std::size_t(first); k < blocks.list.size(); ++k)
    if (RowTarget& target = blocks.list[k].target;
        target.holds_position && target.frequency == 0) {
      target.frequency = how.frequency;
      target.damping = how.damping;
      blocks.list[k].softened = true;
    }
}

}  // namespace

void step(World& world, Solver& solver, real h, const Stepping& how) {
  require(how.substeps > 0, "substeps: there must be at least one");
  for (int substep = 0; substep < how.substeps; ++substep) {
    const real h_sub = h / real(how.substeps);
    begin_step(world, solver, h_sub, how);
    solver.solve(world.bodies);
    for (;;) {  // late limits: the new velocities would pass them within this step
      const int known = int(world.blocks.list.size());
      for (const auto& joint : world.joints())
        if (joint->can_move()) joint->late_limits(world.bodies, h_sub, world.blocks);
      if (int(world.blocks.list.size()) == known) break;
      soften(world.blocks, known, how);
      solver.prepare(world.bodies, world.blocks, known, h_sub);
      solver.solve(world.bodies);
    }
    end_step(world, solver, h_sub, how);
  }
}

void begin_step(World& world, Solver& solver, real h, const Stepping& how) {
  check_input(world, solver, h, how);

  const bool first = world.last_h == 0;
  const real ratio = !how.warm_start ? real(0) : first ? real(1) : h / world.last_h;
  Bodies& bodies = world.bodies;
  world.blocks.acted = world.blocks.acting;
  world.blocks.acting = how.leapfrog ? (world.last_h + h) / 2 : h;
  if (how.leapfrog)
    kick(bodies, world.gravity, (world.last_h + h) / 2);  // Eq. 9-9
  else
    integrate_forces(bodies, world.gravity, h);
  world.last_h = h;

  world.blocks.clear();
  for (const auto& joint : world.joints()) joint->begin_step(bodies, h);
  for (const auto& joint : world.joints()) joint->append(bodies, world.blocks);
  soften(world.blocks, 0, how);
  solver.prepare(bodies, world.blocks, 0, h);
  solver.warm_start(bodies, ratio);
}

void end_step(World& world, Solver& solver, real h, const Stepping& how) {
  if (how.leapfrog) turn(world.bodies, h / 2);
  solver.advance(world.bodies, h, [&world](Blocks& blocks) {
    for (const auto& joint : world.joints()) joint->append(world.bodies, blocks);
  });
  if (how.leapfrog) turn(world.bodies, h / 2);
  for (int i = 0; i < how.projections; ++i) project_positions(world);
  check_motion(world.bodies);
}

}  // namespace joints
