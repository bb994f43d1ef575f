// Exercise 8.2: cases drawn over scales and sides.
#pragma once

#include "chapters/08_ground/ground.h"
#include "tests/checker/drawn.h"

namespace joints::testing {

inline Drawn drawn_friction(Draw& d) {
  const double rate = d.size("|rate|", d.any_size(), "m/s");
  const double K = d.size("K", d.scale(12), "1/kg"), stops = std::abs(rate) / K;
  const double mu = d.size("mu", std::abs(d.number()), "");
  const double normal = d.size("normal", stops / mu * d.scale(3), "N s"), bound = mu * normal;
  const double before = d.old_sum(bound);
  d.side("the rate is negative", rate < 0);
  d.side("it sticks", std::abs(before - rate / K) < bound);
  real sum = real(before);
  const double change = double(friction_impulse(real(rate), real(K), real(mu), real(normal), sum));
  const double right = std::clamp(before - rate / K, -bound, bound);
  const double size = std::min(stops, bound);
  return {{"change", "new sum"}, {change / size, double(sum) / size},
          {(right - before) / size, right / size}, {10 + 1e-6 * (bound + stops) / size}};
}

}  // namespace joints::testing
