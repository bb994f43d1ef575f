// Builds and runs stacks.
#include "bench/stacks.h"

#include <chrono>
#include <cmath>

namespace joints::bench {

namespace {

struct Built {
  World world;
  std::vector<BodyId> boxes;
};

Built build(const Stack& stack) {
  Built out;
  BodyId below = out.world.add(static_body(vec3(0)));
  Top top;
  double height = 0;
  for (int k = 0; k < stack.count; ++k) {
    const real edge = real(stack.kind == "shrinking" ? 1 - 0.5 * k / stack.count : 1.0);
    const bool heavy = stack.kind == "heavy top" && k == stack.count - 1;
    const double overlap = stack.kind == "overlapping" && k > 0 ? 0.3 : 0.0;
    const vec3 x(0, real(height - overlap) + edge / 2, 0);
    const BodyId box = out.world.add(joints::box(heavy ? 1000 : 10, vec3(edge), x));
    out.world.add<GroundContact>(below, box, top, box_outline(vec3(edge)));
    out.boxes.push_back(box);
    height += double(edge) - overlap;
    below = box, top = box_top(vec3(edge));
  }
  if (stack.kind == "slope")
    out.world.gravity = real(9.81) * vec3(-std::sin(real(0.05)), -std::cos(real(0.05)), 0);
  return out;
}

}  // namespace

std::vector<std::string> stack_kinds() {
  return {"equal", "shrinking", "heavy top", "slope", "overlapping"};
}

Standing run_stack(const Stack& stack, const std::string& solver, const std::string& setting,
                   double seconds) {
  const bool guide = setting == "guide", finer = setting == "finer";
  require(guide || finer || setting == "hard", "setting: guide, finer or hard");
  Built built = build(stack);
  for (const auto& joint : built.world.joints()) {
    if (setting == "hard") joint->beta = 1;
    else joint->frequency = guide ? 60 : 240, joint->damping = 10;
  }
  Way way{.warm = !(setting == "hard"), .beta = real(setting == "hard" ? 1 : 0.2),
          .substeps = finer ? 16 : 4};
  way.loop = solver == "lanes" ? Loop::lanes : solver == "direct" ? Loop::direct : Loop::rows;
  const Step step = way.setting(way.substeps * (setting == "hard" ? 8 : 4)).make();

  const auto began = std::chrono::steady_clock::now();
  Standing out;
  std::vector<vec3> first, settled;
  for (const BodyId id : built.boxes) first.push_back(built.world.bodies[id].x);
  const int steps = int(60 * seconds);
  for (int n = 0; n < steps; ++n) {
    if (n == std::min(600, steps / 6))
      for (const BodyId id : built.boxes) settled.push_back(built.world.bodies[id].x);
    step(built.world, real(1) / 60);
    for (const BodyId id : built.boxes)
      out.fastest = std::max(out.fastest, double(length(built.world.bodies[id].v)));
  }
  out.stands = true;
  for (std::size_t k = 0; k < first.size(); ++k) {
    const vec3 x = built.world.bodies[built.boxes[k]].x, moved = x - settled[k];
    out.drift = std::max(out.drift, std::hypot(double(moved.x), double(moved.z)));
    out.sag = std::max(out.sag, double(first[k].y - x.y));
    out.stands = out.stands && std::abs(x.x) < 0.2 && std::abs(x.z) < 0.2 &&
                 (stack.kind == "overlapping" || std::abs(x.y - first[k].y) < 0.2);
  }
  out.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return out;
}

}  // namespace joints::bench
