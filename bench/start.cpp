// Half a kick before the first step.
#include "bench/start.h"

#include <utility>

#include "direct/direct_solver.h"

namespace joints::bench {

namespace {

// Lets the forces act for a time [s], which may be negative.
void kick(World& world, real time) {
  for (Body& body : world.bodies) {
    if (body.is_static()) continue;
    body.v += time * (world.gravity + body.inverse_mass * body.force);
    body.w += time * (inverse_inertia(body) * body.torque);
  }
}

}  // namespace

Setting with_same_start(Setting setting) {
  if (setting.lag == 0) return setting;
  setting.make = [make = setting.make, lag = setting.lag, satisfy = setting.satisfy]() -> Step {
    return [=, step = make(), started = false](World& world, real h) mutable {
      if (!std::exchange(started, true)) {
        kick(world, -real(lag) * h);
        if (satisfy) satisfy_rows(world);
      }
      step(world, h);
    };
  };
  return setting;
}

void satisfy_rows(World& world) {
  Blocks rows;
  for (const auto& joint : world.joints()) joint->append(world.bodies, rows);
  std::erase_if(rows.list, [](const Block& block) {
    const RowSettings& last = block.settings;
    return !block.corrects || last.lower != -unbounded || last.upper != unbounded;
  });
  if (rows.list.empty()) return;
  DirectSolver solver = DirectSolver::velocities_only();
  solver.prepare(world.bodies, rows, 0, 1);
  solver.factor_now();
  solver.reach(world.bodies, rows, std::vector<real>(rows.C.size(), 0), 1e-12);
}

}  // namespace joints::bench
