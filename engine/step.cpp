// Algorithm 1 of the thesis: forces, blocks, impulses, poses.
#include "engine/step.h"

#include <utility>

#include "engine/input.h"
#include "engine/projection.h"
#include "engine/state.h"

namespace joints {

namespace {

// Constraint softness for the blocks that have none of their own.
void soften(Blocks& blocks, const Stepping& how) {
  if (how.frequency == 0) return;
  for (Block& block : blocks.list)
    if (block.corrects)
      block.target.frequency = how.frequency, block.target.damping = how.damping;
}

// Shortens the errors of one-sided rows by their slop, and to the length that the largest speed can
// correct.
void ease(Blocks& blocks, real h) {
  for (const auto& [k, slop, push] : blocks.tolerances) {
    const Block& block = blocks.list[std::size_t(k)];
    real& C = blocks.C[std::size_t(block.first + block.rows - 1)];
    if (C > 0) continue;
    C = std::min(C + slop, real(0));
    const real rate = step_target(block.target, h, blocks.acts(h)).rate;
    if (rate * C < -push) C = -push / rate;
  }
  blocks.tolerances.clear();
}

// The end of an impact. The bodies have moved, so the gaps are closed: a first solve stops the
// rows, a second one reverses them, with impulses of at most `ratio` times those that stopped them.
// This is the lesser of Newton's and Poisson's hypothesis, and adds no energy. The accumulated
// impulses continue those of the step and stay positive.
void reverse(World& world, Solver& solver, real h) {
  Blocks& blocks = world.blocks;
  for (const Block& block : blocks.list)
    if (block.target.one_sided()) {
      const int last = block.first + block.rows - 1;
      real& C = blocks.C[std::size_t(last)];
      C = std::max(real(0), C + h * row_velocity(blocks.J[std::size_t(last)],
                                                world.bodies.at(block.body1),
                                                world.bodies.at(block.body2)));
    }
  solver.prepare(world.bodies, blocks, 0, h);
  solver.solve(world.bodies);
  for (const auto& [k, rate, ratio] : blocks.reversals) {
    Block& block = blocks.list[std::size_t(k)];
    block.target.rate = rate;
    block.target.upper = (1 + ratio) * block.impulse[block.rows - 1] / blocks.acts(h);
  }
  solver.prepare(world.bodies, blocks, 0, h);
  solver.solve(world.bodies);
}

// Prepares the blocks from number `first` on, which have just been appended.
void prepare(World& world, Solver& solver, int first, real h, const Stepping& how) {
  soften(world.blocks, how);
  ease(world.blocks, h);
  solver.prepare(world.bodies, world.blocks, first, h);
}

// begin_step() without the validation.
void begin(World& world, Solver& solver, real h, const Stepping& how) {
  Bodies& bodies = world.bodies;
  const HeldMatrices matrices(bodies);  // for the rows and for their K
  real &acted = world.blocks.acted, &acting = world.blocks.acting;
  acted = acting;
  acting = how.leapfrog ? (world.last_h + h) / 2 : h;
  const real ratio = !how.warm_start ? real(0) : acted == 0 ? real(1) : acting / acted;
  how.leapfrog ? kick(bodies, world.gravity, acting)  // Eq. 9-9
               : integrate_forces(bodies, world.gravity, h);
  world.last_h = h;

  const bool first_rows = world.blocks.J.empty();  // it keeps those of former steps
  world.blocks.clear();
  for (const auto& joint : world.joints()) joint->begin_step(bodies, h, acting);
  for (const auto& joint : world.joints()) joint->append(bodies, world.blocks);
  if (first_rows) world.blocks.shrink_to_fit();  // mostly these rows remain
  prepare(world, solver, 0, h, how);
  solver.warm_start(bodies, ratio);
}

}  // namespace

void step(World& world, Solver& solver, real h, const Stepping& how) {
  require(how.substeps > 0, "substeps: there must be at least one");
  const real h_sub = h / real(how.substeps);
  check_input(world, solver, h_sub, how);  // once for all substeps
  for (int substep = 0; substep < how.substeps; ++substep) {
    begin(world, solver, h_sub, how);
    solver.solve(world.bodies);
    for (;;) {  // late limits: the new velocities would pass them within this step
      const int known = int(world.blocks.list.size());
      for (const auto& joint : world.joints())
        if (joint->can_move()) joint->late_limits(world.bodies, h_sub, world.blocks);
      if (int(world.blocks.list.size()) == known) break;
      prepare(world, solver, known, h_sub, how);
      solver.solve(world.bodies);
    }
    end_step(world, solver, h_sub, how);
  }
}

Bodies synchronised(World& world, Solver& solver, const Stepping& how) {
  if (!how.leapfrog || world.last_h == 0) return world.bodies;
  const State now = save(world);
  const real half = world.last_h / 2;
  Blocks& blocks = world.blocks;
  kick(world.bodies, world.gravity, half);
  blocks.clear();
  for (const auto& joint : world.joints()) joint->append(world.bodies, blocks);
  for (Block& block : blocks.list)
    if (block.corrects) block.target = without_feedback(block.target);
  const real acted = std::exchange(blocks.acting, half);
  solver.prepare(world.bodies, blocks, 0, half);
  solver.warm_start(world.bodies, how.warm_start ? half / acted : real(0));
  solver.solve(world.bodies);
  const Bodies out = world.bodies;
  restore(world, now);
  return out;
}

void begin_step(World& world, Solver& solver, real h, const Stepping& how) {
  check_input(world, solver, h, how);
  begin(world, solver, h, how);
}

void end_step(World& world, Solver& solver, real h, const Stepping& how) {
  if (how.leapfrog) turn(world.bodies, h / 2);
  solver.advance(world.bodies, h, [&world](Blocks& blocks, const std::vector<bool>* of) {
    for (const auto& joint : world.joints())
      if (!of || (*of)[joint->body1.slot] || (*of)[joint->body2.slot])
        joint->append(world.bodies, blocks);
  });
  if (how.leapfrog) turn(world.bodies, h / 2);
  if (!world.blocks.reversals.empty()) reverse(world, solver, h);
  for (int i = 0; i < how.projections; ++i) project_positions(world);
  check_motion(world.bodies);
}

}  // namespace joints
