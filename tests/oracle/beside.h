// Two worlds side by side, or the bodies of two loops: how far apart they are.
#pragma once

#include <algorithm>
#include <span>

#include "tests/oracle/rigs.h"

namespace joints::testing {

inline std::span<const Body> bodies_of(const World& world) { return all_of(world.bodies); }
inline std::span<const Body> bodies_of(std::span<const Body> bodies) { return bodies; }

/// True if all bodies have the same places and velocities, to the bit.
bool same_bodies(const auto& one, const auto& other) {
  return std::ranges::equal(bodies_of(one), bodies_of(other), [](const Body& a, const Body& b) {
    return same_bits(a.x, b.x) && same_bits(a.q, b.q) && same_bits(a.v, b.v) && same_bits(a.w, b.w);
  });
}

/// The largest of what `difference` says of two bodies, as far as the shorter list goes.
double largest(const auto& one, const auto& other, const auto& difference) {
  const std::span<const Body> a = bodies_of(one), b = bodies_of(other);
  double most = 0;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
    most = std::max(most, difference(a[k], b[k]));
  return most;
}
/// The largest distance of two places [m].
double apart(const auto& one, const auto& other) {
  return largest(one, other,
                 [](const Body& a, const Body& b) { return double(length(a.x - b.x)); });
}
/// The largest difference of two velocities [m/s] or angular velocities [rad/s].
double speeds_apart(const auto& one, const auto& other) {
  return largest(one, other, [](const Body& a, const Body& b) {
    return std::max(double(length(a.v - b.v)), double(length(a.w - b.w)));
  });
}

}  // namespace joints::testing
