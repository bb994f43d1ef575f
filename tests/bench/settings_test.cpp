// The settings of error against run time: what is said of them is so.
#include "bench/settings.h"
#include "tests/checker/catch.h"
#include "tests/oracle/oracle.h"

using namespace joints;
using namespace joints::testing;

namespace {

const bench::Way& way(const char* solver, const char* name,
                      const std::vector<bench::Way>& list) {
  for (const bench::Way& one : list)
    if (one.solver() == solver && one.name == name) return one;
  FAIL("no setting " << solver << " " << name);
  return list.front();
}

// How far a body that nothing holds has fallen after a second [m].
double fallen(bench::Step step) {
  World world;
  const BodyId body = world.add(ball(1, 1, vec3(0)));
  for (int n = 0; n < 60; ++n) step(world, real(1) / 60);
  return -double(world.bodies[body].x.y);
}

}  // namespace

TEST_CASE("no point of a front is beaten in both, and every other one is beaten or equalled") {
  Random random(7);
  std::vector<bench::Cost> costs;
  for (int k = 0; k < 200; ++k)  // few values, so that some are equal
    costs.push_back({std::round(double(random.uniform(1, 30))),
                     std::round(double(random.uniform(1, 30)))});
  costs.push_back({0, std::numeric_limits<double>::quiet_NaN()});
  const std::vector<int> front = bench::pareto_front(costs);
  REQUIRE(front.size() > 1);
  const auto no_worse = [&](int a, int b) {
    return costs[a].time <= costs[b].time && costs[a].error <= costs[b].error;
  };
  for (int k = 0; k < 200; ++k) {
    const bool on_it = std::find(front.begin(), front.end(), k) != front.end();
    int beaten_by = 0, no_worse_on_it = 0;
    for (int other = 0; other < 200; ++other)
      beaten_by += no_worse(other, k) && !no_worse(k, other);
    for (const int other : front) no_worse_on_it += no_worse(other, k);
    if (on_it) CHECK(beaten_by == 0);
    CHECK(no_worse_on_it > 0);
  }
  CHECK(std::count(front.begin(), front.end(), 200) == 0);
  CHECK(std::is_sorted(front.begin(), front.end(),
                       [&](int a, int b) { return costs[a].time < costs[b].time; }));
}

TEST_CASE("what is better by rounding alone and slower is in no front") {
  CHECK(bench::pareto_front({{1, 0.41}, {2, 0.41 - 1e-7}, {3, 0.40}}) == std::vector<int>{0, 2});
}

TEST_CASE("without half a kick a free fall is g h t / 2 too deep, with it exact") {
  const auto list = bench::ways();
  const double exact = 9.81 / 2, h = 1.0 / 60;
  const auto fall = [&](const char* solver, const char* name) {
    return fallen(way(solver, name, list).setting(10).make());
  };
  CHECK(fall("sequential impulses", "cold") - exact ==
        Approx(9.81 * h / 2).epsilon(tolerance(1e-9, 1e-3)));
  CHECK(fall("sequential impulses", "half a kick") ==
        Approx(exact).epsilon(tolerance(1e-12, 1e-5)));
  CHECK(fall("sequential impulses", "4 substeps") - exact ==
        Approx(9.81 * h / 8).epsilon(tolerance(1e-9, 1e-3)));
  CHECK(fall("packed", "omega 1.5 4 substeps half a kick") ==
        Approx(exact).epsilon(tolerance(1e-12, 1e-5)));
}

TEST_CASE("half a kick moves no static body") {
  World world;
  const BodyId wall = world.add(static_body(vec3(1, 2, 3)));
  bench::Step step = way("sequential impulses", "half a kick", bench::ways()).setting(1).make();
  step(world, real(1) / 60);
  CHECK(world.bodies[wall].x == vec3(1, 2, 3));
  CHECK(world.bodies[wall].v == vec3(0));
}

TEST_CASE("packed one at a time in the order of the list a chain moves as with the engine's rows") {
  const auto list = bench::ways();
  bench::BenchScene one = bench::cubes_on_hinges(2, 12), other = bench::cubes_on_hinges(2, 12);
  bench::Step rows = way("sequential impulses", "cold", list).setting(30).make();
  bench::Step packed = way("packed", "list", list).setting(30).make();
  for (int n = 0; n < 60; ++n) {
    rows(one.world, real(1) / 60);
    packed(other.world, real(1) / 60);
  }
  for (int slot = 0; slot < one.world.bodies.slots(); ++slot)
    CHECK(double(length(one.world.bodies.at(slot).x - other.world.bodies.at(slot).x)) <
          tolerance(1e-11, 1e-3));
}

TEST_CASE("substeps share the iterations of a step") {
  const auto list = bench::ways();
  const bench::Way& four = way("lanes", "islands 4 substeps", list);
  CHECK(four.setting(120).iterations == 30);
  CHECK(four.setting(1).iterations == 1);
  CHECK(way("lanes", "islands", list).setting(120).iterations == 120);
}
