// Stacks of boxes with the setting of the guide: what stands for a minute, and how far it sags.
#include "bench/stacks.h"
#include "tests/oracle/test.h"

using joints::bench::run_stack;
using joints::bench::Standing;

namespace {

// Four seconds of a tower that is bent a little at first: by which factor the bend has grown.
double growth(int count, double edge, double frequency) {
  World world;
  BodyId below = world.add(static_body(vec3(0)));
  Top top;
  const vec3 size{real(edge)};
  for (int k = 0; k < count; ++k) {
    const double bend = 1e-4 * edge * k * k / (count * count);
    const BodyId box = world.add(
        joints::box(10, size, vec3(real(bend), real(edge * (k + 0.5)), 0)));
    auto& contact = world.add<GroundContact>(below, box, top, box_outline(size));
    contact.frequency = real(frequency), contact.damping = 1;
    below = box, top = box_top(size);
  }
  SequentialImpulses solver;
  solver.iterations = 30;
  for (int n = 0; n < 240; ++n)
    step(world, solver, real(1) / 60, {.warm_start = true, .substeps = 8});
  return std::abs(double(world.bodies[below].x.x)) / (1e-4 * edge);
}

}  // namespace

TEST_CASE("ten boxes stand on each other for a minute with every solver, and drift below 1 mm") {
  for (const char* solver : {"sequential", "lanes", "direct"}) {
    const Standing out = run_stack({"equal", 10}, solver, "guide");
    CAPTURE(solver, out.drift, out.sag);
    CHECK(out.stands);
    CHECK(out.drift < 1e-3);
    CHECK(out.sag == Approx(6.9e-3).epsilon(0.05));
  }
}

TEST_CASE("stacks of every kind stand with the setting of the guide") {
  for (const auto& [kind, count] : {std::pair{"equal", 2}, {"shrinking", 20}, {"heavy top", 3},
                                    {"slope", 10}, {"overlapping", 2}, {"overlapping", 10}}) {
    const Standing out = run_stack({kind, count}, "sequential", "guide", 20);
    CAPTURE(kind, count, out.drift, out.sag);
    CHECK(out.stands);
    if (std::string(kind) != "overlapping") CHECK(out.drift < 0.01);  // these still separate
    CHECK(out.fastest < 1);
  }
}

TEST_CASE("twenty boxes and stacks drawn by a seed stand on 8 substeps and drift below 5 mm",
          "[slow]") {
  for (const char* solver : {"sequential", "lanes", "direct"}) {
    std::vector<joints::bench::Stack> stacks{{"equal", 20}};
    for (unsigned seed = 2001; seed <= 2006; ++seed)
      stacks.push_back(joints::bench::drawn_stack(seed));
    for (const auto& stack : stacks) {
      const Standing out = run_stack(stack, solver, "taller", 20);
      CAPTURE(solver, stack.count, stack.seed, out.drift, out.sag);
      CHECK(out.stands);
      CHECK(out.drift < 5e-3);
    }
  }
}

TEST_CASE("a tower of soft contacts buckles as a column does under its own weight") {
  for (const auto& [count, edge] : {std::pair{8, 0.2}, {12, 1.0}, {20, 0.5}}) {
    const double f = joints::bench::buckling_frequency(count, edge);
    const double below = growth(count, edge, 0.7 * f), above = growth(count, edge, 1.25 * f);
    CAPTURE(count, edge, f, below, above);
    CHECK(below > 20);
    CHECK(above < 4);  // a column's bend grows by 1/(1 - 1/1.25^2) = 2.8
  }
}

TEST_CASE("three boxes do not stand on hard contacts that start cold") {
  CHECK_FALSE(run_stack({"equal", 3}, "sequential", "hard", 20).stands);
}
