// Stacks of boxes with the setting of the guide: what stands for a minute, and how far it sags.
#include "bench/stacks.h"
#include "tests/oracle/test.h"

using joints::bench::run_stack;
using joints::bench::Standing;

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
  for (const auto& [kind, count] : {std::pair{"equal", 2}, {"equal", 20}, {"shrinking", 20},
                                    {"heavy top", 3}, {"slope", 10}, {"overlapping", 2}}) {
    const Standing out = run_stack({kind, count}, "sequential", "guide", 20);
    CAPTURE(kind, count, out.drift, out.sag);
    CHECK(out.stands);
    CHECK(out.drift < 0.01);
  }
}

TEST_CASE("three boxes do not stand on hard contacts that start cold") {
  CHECK_FALSE(run_stack({"equal", 3}, "sequential", "hard", 20).stands);
}
