// Algorithm 1 of the thesis: forces, blocks, impulses, poses.
#include "engine/step.h"

namespace joints {

// How often a step is solved again at most because impulses have changed the mean rate at which a
// body rotates (engine/rotation). A new rate changes the impulses, but less each time.
static constexpr int most_renewals = 3;

void step(World& world, Solver& solver, real h, bool warm_start, const StepMethod& method) {
  begin_step(world, solver, h, warm_start, method);
  solve_step(world, solver, h, method);
  end_step(world, solver, h, method);
}

void begin_step(World& world, Solver& solver, real h, bool warm_start, const StepMethod& method) {
  Blocks& blocks = world.blocks;
  const HeldMatrices matrices(world.bodies);  // for the rows and for their K
  const real duration = method.integrate_forces(world, h);
  const real before = blocks.last_impulse_duration = blocks.impulse_duration;
  blocks.impulse_duration = duration;
  world.last_h = h;

  const bool first_rows = blocks.J.empty();  // clear() leaves J as long as it was
  blocks.clear();
  for (const auto& joint : world.joints()) joint->begin_step(world.bodies, h, duration);
  for (const auto& joint : world.joints()) joint->append(world.bodies, blocks);
  if (first_rows) blocks.shrink_to_fit();  // once: later steps mostly have about as many rows
  method.change_blocks(blocks, 0);
  solver.prepare(world.bodies, blocks, 0, h);
  const real ratio = before == 0 ? real(1) : duration / before;
  solver.warm_start(world.bodies, warm_start ? ratio : real(0));
}

void solve_step(World& world, Solver& solver, real h, const StepMethod& method) {
  Blocks& blocks = world.blocks;
  for (int renewals = 0;;) {
    solver.solve(world.bodies);
    const int known = int(blocks.list.size());
    for (const auto& joint : world.joints())
      if (joint->can_move()) joint->activate_missed_limits(world.bodies, h, blocks);
    if (int(blocks.list.size()) > known) {
      method.change_blocks(blocks, known);
      solver.prepare(world.bodies, blocks, known, h);
    } else if (++renewals > most_renewals || !renew_mean_rates(world.bodies, h)) {
      return;
    }
  }
}

void StepMethod::move(World& world, Solver& solver, real h) const {
  solver.advance(world.bodies, h, [&world](Blocks& blocks, const std::vector<bool>* of) {
    for (const auto& joint : world.joints())
      if (!of || (*of)[joint->body1.slot] || (*of)[joint->body2.slot])
        joint->append(world.bodies, blocks);
  });
}

void end_step(World& world, Solver& solver, real h, const StepMethod& method) {
  method.move(world, solver, h);
  if (world.blocks.after_move) world.blocks.after_move(world, solver, h);
}

}  // namespace joints
