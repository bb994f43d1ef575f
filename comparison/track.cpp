// Tracks, and the refinement of a reference.
#include "comparison/track.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace joints {

namespace {

// Infinite where one of them is lost or has other bodies.
double between(const Centres& a, const Centres& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double most = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double gap = double(length(a[k] - b[k]));
    if (!(gap <= most)) most = std::isnan(gap) ? std::numeric_limits<double>::infinity() : gap;
  }
  return most;
}

}  // namespace

Centres centres_of(const World& world) {
  Centres out;
  for (int slot = 0; slot < world.bodies.slots(); ++slot)
    out.push_back(world.bodies.used(slot) ? world.bodies.at(slot).x : vec3(0));
  return out;
}

double apart(const Track& one, const Track& other, std::size_t frames) {
  double most = 0;
  for (std::size_t n = 0; n < std::min({frames, one.frames.size(), other.frames.size()}); ++n)
    most = std::max(most, between(one.frames[n], other.frames[n]));
  return most;
}

Reference refine(const std::function<std::optional<Track>(int n)>& run, std::size_t frames,
                 double most, double patience) {
  Reference out;
  for (int n = 0; !out.hurried; ++n) {
    std::optional<Track> next = run(n);
    if (!next) break;
    patience -= 1e-6 * next->us;
    out.before = std::exchange(out.track, std::move(*next));
    const std::size_t both = std::min(out.before.frames.size(), out.track.frames.size());
    for (out.frames = 0; out.frames < both; ++out.frames)
      if (!(between(out.before.frames[out.frames], out.track.frames[out.frames]) <= most)) break;
    if (out.frames == frames) break;
    out.hurried = !(patience > 0);
  }
  return out;
}

}  // namespace joints
