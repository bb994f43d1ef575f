// Iterations until nothing changes.
#include "engine/instruments/rate.h"

#include <algorithm>
#include <cmath>

#include "engine/kept/state.h"

namespace joints {

static void check_most(int most) {
  require(most > 1, "most: a rate needs at least two iterations");
}

double contraction_rate(const std::function<double()>& iterate, int most) {
  check_most(most);
  std::vector<double> sizes;
  while (int(sizes.size()) < most) {
    const double size = iterate();
    if (size == 0) break;
    sizes.push_back(size);
  }
  const std::size_t last = sizes.size();
  if (last < 2) return 0;  // solved at once
  const std::size_t first = std::min(last - 2, last - 1 - last / 10);
  return std::pow(sizes[last - 1] / sizes[first], 1.0 / double(last - 1 - first));
}

double contraction_rate(World& world, int most, real h, SequentialImpulses solver,
                        const StepOptions& how) {
  check_most(most);  // before anything changes
  const State as_it_was = save(world);
  begin_step(world, solver, h, how);
  std::vector<double> before(world.blocks.C.size(), 0.0);
  const double rounding = std::max(1e-11, 200 * double(epsilon));  // of a change, by the impulses
  const double rate = contraction_rate(
      [&] {
        solver.iterate(world.bodies);
        double sum = 0, largest = 0;  // of the change, and of the impulses it is compared with
        std::size_t at = 0;
        for (const Block& block : world.blocks.list)
          for (int i = 0; i < block.rows; ++i, ++at) {
            const double now = double(block.impulse[i]);
            sum += (now - before[at]) * (now - before[at]);
            largest = std::max(largest, std::abs(now));
            before[at] = now;
          }
        const double size = std::sqrt(sum);
        return size <= rounding * largest ? 0 : size;
      },
      most);
  restore(world, as_it_was);
  return rate;
}

}  // namespace joints
