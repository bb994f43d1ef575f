// Builds and runs stacks.
#include "bench/stacks.h"

#include <cmath>
#include <ctime>

namespace joints::bench {

namespace {

struct Built {
  World world;
  std::vector<BodyId> boxes;
  std::vector<vec3> places;  // without sag and overlap
  double width = 1;          // of the lowest [m]
};

// A box on the last one. The places are those of boxes that touch; the box begins lower.
void put(Built& stack, double mass, const vec3& size, double lower, double friction, Top& top) {
  const BodyId below = stack.boxes.empty() ? stack.world.add(static_body(vec3(0)))
                                           : stack.boxes.back();
  const real base = stack.boxes.empty() ? 0 : stack.places.back().y + top.height;
  const vec3 place(0, base + size.y / 2, 0);
  const vec3 x = place - vec3(0, real(lower), 0);
  const BodyId box = stack.world.add(joints::box(real(mass), size, x));
  auto& contact = stack.world.add<GroundContact>(below, box, top, box_outline(size));
  contact.friction = real(friction);
  stack.boxes.push_back(box);
  stack.places.push_back(place);
  top = box_top(size);
}

Built build_drawn(const Stack& stack) {
  Built out;
  Draw draw(stack.seed);
  const int count = draw.whole(2, 20);
  out.width = draw.scale(0.2, 2);
  const double height = out.width * draw.number(0.5, 1.25);
  const double taper = draw.chance(0.5) ? 0 : draw.number(0, 0.5);
  const double friction = draw.number(0.2, 1), mass = draw.scale(1, 100);
  const bool masses = draw.chance(0.5);
  Top top;
  for (int k = 0; k < count; ++k) {
    const real edge = real(out.width * (1 - taper * k / count));
    const double higher = taper > 0 ? draw.number(0.7, 1) : 1;
    put(out, mass * (masses ? draw.scale(1, 10) : 1), vec3(edge, real(height * higher), edge), 0,
        friction, top);
  }
  return out;
}

Built build(const Stack& stack) {
  if (stack.kind == "drawn") return build_drawn(stack);
  Built out;
  Top top;
  const bool overlapping = stack.kind == "overlapping";
  for (int k = 0; k < stack.count; ++k) {
    const real edge = real(stack.kind == "shrinking" ? 1 - 0.5 * k / stack.count : 1.0);
    const bool heavy = stack.kind == "heavy top" && k == stack.count - 1;
    put(out, heavy ? 1000 : 10, vec3(edge), overlapping ? 0.3 * k : 0, 0.5, top);
  }
  if (overlapping)
    for (const auto& joint : out.world.joints())
      dynamic_cast<GroundContact&>(*joint).push = real(std::max(0.1, 0.8 / (stack.count - 1)));
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
  const bool hard = setting == "hard";
  require(hard || setting == "guide" || setting == "taller" || setting == "finer",
          "setting: guide, taller, finer or hard");
  const int substeps = setting == "taller" ? 8 : setting == "finer" ? 16 : 4;
  Built built = build(stack);
  for (const auto& joint : built.world.joints()) {
    if (hard) joint->beta = 1;
    else joint->frequency = real(15 * substeps), joint->damping = 10;
  }
  Way way{.warm = !hard, .beta = real(hard ? 1 : 0.2), .substeps = substeps};
  way.loop = solver == "lanes" ? Loop::lanes : solver == "direct" ? Loop::direct : Loop::rows;
  const Step step = way.setting(substeps * (hard ? 8 : 4)).make();

  const std::clock_t began = std::clock();
  Standing out;
  std::vector<vec3> settled;
  const int steps = int(60 * seconds);
  for (int n = 0; n < steps; ++n) {
    if (n == std::min(600, steps / 6))
      for (const BodyId id : built.boxes) settled.push_back(built.world.bodies[id].x);
    step(built.world, real(1) / 60);
    for (const BodyId id : built.boxes)
      out.fastest = std::max(out.fastest, double(length(built.world.bodies[id].v)));
  }
  out.stands = true;
  for (std::size_t k = 0; k < built.places.size(); ++k) {
    const vec3 x = built.world.bodies[built.boxes[k]].x, moved = x - settled[k];
    const vec3 off = x - built.places[k];
    out.drift = std::max(out.drift, std::hypot(double(moved.x), double(moved.z)));
    out.sag = std::max(out.sag, -double(off.y));
    out.stands = out.stands && double(length(off)) < 0.2 * built.width;
  }
  out.seconds = double(std::clock() - began) / CLOCKS_PER_SEC;
  return out;
}

}  // namespace joints::bench
