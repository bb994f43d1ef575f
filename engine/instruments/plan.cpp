// Counting what a step has to do.
#include "engine/instruments/plan.h"

namespace joints {

Plan plan(const World& world, bool warm_start, const Solver* solver) {
  Plan plan;
  Blocks blocks;
  for (int slot = 0; slot < world.bodies.slots(); ++slot) {
    if (!world.bodies.used(slot)) continue;
    ++plan.bodies;
    if (world.bodies.at(slot).is_static()) ++plan.static_bodies;
  }
  for (const auto& joint : world.joints()) {
    joint->append(world.bodies, blocks);
    const Joint::Stats extras = joint->stats();
    plan.limits += extras.limits;
    plan.live_limits += extras.live_limits;
    plan.motors += extras.motors;
  }
  plan.blocks = int(blocks.list.size());
  plan.rows = blocks.rows();
  plan.warm_start = warm_start;
  if (solver) plan.solver = solver->description(world.bodies, blocks);
  return plan;
}

std::string Plan::line() const {
  const auto text = [](int number) { return std::to_string(number); };
  return "bodies " + text(bodies) + " (" + text(static_bodies) + " static), blocks " +
         text(blocks) + ", rows " + text(rows) +
         (limits > 0 ? ", limits " + text(live_limits) + " of " + text(limits) : "") +
         (motors > 0 ? ", motors " + text(motors) : "") + (warm_start ? ", warm" : "") +
         (solver.empty() ? "" : ", " + solver);
}

}  // namespace joints
