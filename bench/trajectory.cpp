// References of whole scenes, and distances from them.
#include "bench/trajectory.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <stdexcept>

#include "bench/named.h"
#include "bench/start.h"

namespace joints::bench {

namespace {

constexpr double same = 1e-4;     // where bodies are apart by less, two runs agree [m]
constexpr double slight = 1e-9;   // relative change of the gravity
constexpr int coarsest = 16, finest = 256;  // parts of a step
constexpr double first_second = 1;

struct Ran {
  Track track{};
  double found = std::numeric_limits<double>::quiet_NaN();
  bool lost = false, refused = false;  // on the way; at once
};

// A run with `parts` steps in each of the span's.
Ran ran(const MakeScene& make_scene, const Setting& given, const Span& span, int parts = 1,
        double change = 0) {
  const Setting setting = with_same_start(given);
  BenchScene scene = make_scene();
  scene.world.gravity *= real(1 + change);
  if (setting.prepare) setting.prepare(scene.world);
  const Step step = setting.make();
  Ran out;
  out.track.frames.push_back(centres_of(scene.world));
  const std::clock_t begin = std::clock();
  try {
    for (int n = 0; n < span.steps; ++n) {
      for (int part = 0; part < parts; ++part) step(scene.world, span.h / real(parts));
      if (setting.show) setting.show(scene.world);
      out.track.frames.push_back(centres_of(scene.world));
    }
    if (scene.finding.value) out.found = scene.finding.value(scene);
  } catch (const std::runtime_error&) {
    out.lost = true;
  } catch (const std::invalid_argument&) {  // a loop, a bound
    out.refused = true;
  }
  out.track.us = 1e6 * double(std::clock() - begin) / CLOCKS_PER_SEC;
  return out;
}

std::size_t frames_in(double seconds, const Span& span) {
  return std::size_t(std::lround(seconds / double(span.h))) + 1;
}

}  // namespace

std::string KnownMotion::kind(double seconds) const {
  return until > seconds - 1e-6 ? "followed" : grown > same ? "chaotic" : lost ? "given up"
         : reference.hurried ? "hurried" : "impacts";
}

KnownMotion motion_of(const MakeScene& make_scene, const Span& span, double patience) {
  std::vector<std::string> roads;
  for (const std::string road : {"rk4", "tree-rk4"})  // the better one last
    if (!ran(make_scene, setting_named(road), {.h = span.h / finest, .steps = 1}).refused)
      roads.push_back(road);
  if (roads.empty()) roads = {"shake"};
  KnownMotion out;
  std::string road;
  int parts = 0;
  out.reference = refine(
      [&](int n) -> std::optional<Track> {
        const int next = coarsest << (n / int(roads.size()));
        if (next > finest) return std::nullopt;
        road = roads[std::size_t(n) % roads.size()], parts = next;
        Ran run = ran(make_scene, setting_named(road), span, parts);
        if (run.lost && road == "rk4" && roads.size() == 1) {
          roads = {road = "shake"};
          run = ran(make_scene, setting_named(road), span, parts);
        }
        out.lost = run.lost;
        return std::move(run.track);
      },
      std::size_t(span.steps) + 1, same, patience);
  for (const std::string& one : roads) out.roads += (out.roads.empty() ? "" : " ") + one;
  const auto& [before, track, frames, hurried] = out.reference;
  if (frames > 0) out.until = double(frames - 1) * double(span.h);
  out.agree = apart(before, track, frames);
  out.agree_first = apart(before, track, std::min(frames, frames_in(first_second, span)));
  if (parts > 0) {
    const Track changed = ran(make_scene, setting_named(road), span, parts, slight).track;
    out.grown = apart(track, changed, track.frames.size());
  }
  return out;
}

Astray astray(const MakeScene& make_scene, const Setting& setting, const Span& span,
              const KnownMotion& motion, bool uncertain) {
  const auto& [before, reference, frames, hurried] = motion.reference;
  const Ran run = ran(make_scene, setting, span);
  Astray out;
  out.refused = run.refused;
  out.found = run.found;
  const auto off = [&](std::size_t most) {  // a run that ends early is infinitely far away
    const std::size_t compared = std::min(frames, most);
    if (compared < 2) return std::numeric_limits<double>::quiet_NaN();
    return run.track.frames.size() < compared ? std::numeric_limits<double>::infinity()
                                              : apart(run.track, reference, compared);
  };
  out.first = off(frames_in(first_second, span));
  out.all = off(frames);
  if (!uncertain || std::isnan(run.found)) return out;
  double least = run.found, most = run.found;
  for (const double change : {-2 * slight, -slight, slight, 2 * slight}) {
    const double found = ran(make_scene, setting, span, 1, change).found;
    least = std::min(least, found), most = std::max(most, found);
  }
  out.range = (most - least) / 2;
  return out;
}

}  // namespace joints::bench
