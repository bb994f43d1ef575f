// The comparison of methods: what it measures, what it recommends, and what it says of scenes that
// cannot be compared.
#include "comparison/compare.h"

#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <sstream>

#include "direct/direct_solver.h"
#include "joints/ball_joint.h"
#include "joints/hinge_joint.h"
#include "tests/compare/drawn.h"
#include "tests/compare/scene.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;

// A chain of boxes on hinges, level at first, its end of another mass.
World chain(int links, real size, real end) {
  World world;
  BodyId before = world.add(static_body(vec3(0)));
  for (int k = 1; k <= links; ++k) {
    const real mass = k == links ? end : real(1);
    const BodyId id = world.add(box(mass, size * vec3(1, real(0.3), real(0.3)),
                                    size * vec3(real(k) - real(0.5), 0, 0)));
    world.add<HingeJoint>(before, id, size * vec3(real(k) - 1, 0, 0), vec3(0, 0, 1));
    before = id;
  }
  return world;
}
const MethodResult& find(const Comparison& all, const std::string& name) {
  for (const MethodResult& one : all.methods)
    if (one.name == name) return one;
  FAIL("no method " << name);
  throw 0;
}

}  // namespace

TEST_CASE("a pendulum has a reference, and only reduced coordinates have no gap at all") {
  const Comparison found = compare([] { return chain(1, 1, 1); }, {.seconds = 1});
  CHECK(found.reference_until == Approx(1));
  CHECK(found.reference_apart < 1e-3 / 3);
  const MethodResult tree = find(found, "reduced, Runge-Kutta");
  CHECK(tree.failed.empty());
  CHECK(tree.gap < 100 * double(epsilon));
  CHECK(tree.distance < 1e-3);
  CHECK(std::abs(tree.energy) < 1e-3);
  CHECK(find(found, "30 iterations").gap > 100 * double(epsilon));
  REQUIRE(found.recommended >= 0);
  for (const MethodResult& one : found.methods)
    if (one.meets) CHECK(found.methods[std::size_t(found.recommended)].us <= one.us);
}

TEST_CASE("the gap of iterations on a heavy end is measured and does not meet the wish") {
  const Comparison found = compare([] { return chain(10, real(0.5), 200); }, {.seconds = 1});
  CHECK(find(found, "30 iterations").gap > 0.1);
  CHECK_FALSE(find(found, "30 iterations").meets);
  CHECK(find(found, "the default").meets);
  REQUIRE(found.recommended >= 0);
  CHECK(found.methods[std::size_t(found.recommended)].gap <= 1e-3);
}

TEST_CASE("on scenes that it does not know, what it recommends meets the wish ten times as long") {
  int none = 0;
  const unsigned scenes = 20;
  for (unsigned seed = 0; seed < scenes; ++seed) {
    const DrawnScene scene = drawn_scene(seed);
    const clock_t began = std::clock();
    const Comparison first = compare(scene.make, scene.wish);
    const double spent = double(std::clock() - began) / CLOCKS_PER_SEC;
    CAPTURE(seed, scene.kind, scene.size, spent, first.table());
    CHECK(spent < 60);
    none += first.recommended < 0;
    if (first.recommended < 0) continue;
    Wish longer = scene.wish;
    longer.seconds *= 10, longer.times = 1, longer.patience = 0;
    const MethodResult again =
        compare(scene.make, longer).methods[std::size_t(first.recommended)];
    CHECK(again.failed.empty());
    CHECK(again.gap <= longer.gap);
    CHECK(again.angle <= longer.angle);
    CHECK(again.depth <= longer.depth);
  }
  CHECK(none <= 4);
}

TEST_CASE("the guide's chain with its load is held to a millimetre by what is recommended") {
  const Comparison found = compare(make_world, {.seconds = 2});
  REQUIRE(found.recommended >= 0);
  CHECK(found.methods[std::size_t(found.recommended)].gap <= 1e-3);
  CHECK_FALSE(find(found, "30 iterations").meets);
}

TEST_CASE("a loop is refused by reduced coordinates in a sentence, and the others go on") {
  const auto loop = [] {
    World world = chain(3, 1, 1);
    const BodyId wall = world.add(static_body(vec3(3, 0, 0)));
    world.add<BallJoint>(world.bodies.id(3), wall, vec3(3, 0, 0));
    return world;
  };
  const Comparison found = compare(loop, {.seconds = 0.2});
  CHECK(find(found, "reduced coordinates").failed.find("closes a loop") != std::string::npos);
  CHECK_FALSE(find(found, "reduced coordinates").meets);
  CHECK(found.recommended >= 0);
  CHECK(found.table().find("closes a loop") != std::string::npos);
}

TEST_CASE("the table names the fastest method that meets the wish, or says that none does") {
  const Comparison good = compare([] { return chain(2, 1, 1); }, {.seconds = 0.3});
  REQUIRE(good.recommended >= 0);
  const MethodResult& best = good.methods[std::size_t(good.recommended)];
  CHECK(good.table().find(": " + best.name + ".") != std::string::npos);
  CHECK(good.table().find(best.code) != std::string::npos);
  const Comparison poor = compare([] { return chain(2, 1, 1); }, {.seconds = 0.3, .budget = 1e-6});
  CHECK(poor.recommended == -1);
  CHECK(poor.table().find("None meets the wish") != std::string::npos);
  poor.write_csv("compare_test.csv");
  std::ifstream file("compare_test.csv");
  std::stringstream text;
  text << file.rdbuf();
  CHECK(std::count(std::istreambuf_iterator<char>(text.rdbuf()), {}, '\n') ==
        long(poor.methods.size()) + 1);
  std::remove("compare_test.csv");
}

TEST_CASE("a method moves bodies to the last bit as it does without being measured") {
  World world = chain(4, 1, 1);
  DirectSolver solver;
  for (int n = 0; n < 29; ++n) step(world, solver, h, {.leapfrog = true});
  Wish wish{.seconds = 0.5};
  bool met = false;
  wish.control = [&](World& run, double) { met |= run.bodies.at(4).x == world.bodies.at(4).x; };
  compare([] { return chain(4, 1, 1); }, wish);
  CHECK(met);
}

TEST_CASE("a wish that makes no sense and a scene that cannot be stepped are told in words") {
  CHECK(refusal([] { compare([] { return chain(1, 1, 1); }, {.seconds = -1}); })
            .find("seconds is -1") != std::string::npos);
  const auto broken = [] {
    World world = chain(1, 1, 1);
    world.bodies.at(1).v.x = std::nan("");
    return world;
  };
  const Comparison found = compare(broken, {.seconds = 0.1});
  CHECK(found.recommended == -1);
  for (const MethodResult& one : found.methods) CHECK_FALSE(one.failed.empty());
}
