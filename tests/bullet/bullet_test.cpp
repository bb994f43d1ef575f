// Our contacts at the points of Bullet: the scenes of ./wb bench --contacts.
#include "bench/peers/heaps.h"
#include "tests/oracle/test.h"

using bench::Heaped;

namespace {

// Runs one with our setting. 0 s: as long as it lasts.
Heaped run(const std::string& name, double seconds = 0, int substeps = 4, bool ahead = true) {
  for (const bench::Heap& heap : bench::heaps())
    if (heap.name == name)
      return bench::run_heap(heap, bench::our_contacts(substeps, ahead), seconds);
  FAIL("there is no heap " << name);
  return {};
}

}  // namespace

TEST_CASE("stacks of ten cubes, of turned cubes, of drawn boxes stand still on Bullet's points") {
  for (const auto& [name, seconds, substeps, most] :
       {std::tuple("ten cubes", 20, 4, 1e-4), {"ten turned cubes", 60, 4, 1e-4},
        {"twenty cubes", 20, 8, 1e-3}, {"thirty drawn stacks", 20, 4, 1e-3}}) {
    CAPTURE(name);
    const Heaped stack = run(name, seconds, substeps);
    CHECK(stack.fallen == 0);
    CHECK(stack.drift < most);
  }
}

TEST_CASE("points one step ahead reduce the penetration of boxes thrown along the ground") {
  const Heaped ahead = run("ten thrown boxes"), present = run("ten thrown boxes", 0, 4, false);
  CAPTURE(ahead.deepest, present.deepest);
  CHECK(ahead.deepest < 0.4 * present.deepest);
  CHECK(ahead.fallen + present.fallen == 0);
}

TEST_CASE("capsules fall on their sides and lie") {
  const Heaped capsules = run("eight capsules");
  CHECK(capsules.fallen == 0);
  CHECK(capsules.depth < 1e-3);
}

TEST_CASE("a ragdoll lands on a ragdoll, and both hold together and come to rest") {
  const Heaped dolls = run("ragdoll on ragdoll");
  CHECK(dolls.gap < 0.1);
  CHECK(dolls.fastest < 0.1);
  CHECK(dolls.fallen == 0);
}

TEST_CASE("200 bodies fall on a heap: none falls through, and nearly all come to rest") {
  const Heaped many = run("200 bodies");
  CAPTURE(many.deepest, many.depth, many.moving);
  CHECK(many.fallen == 0);
  CHECK(many.deepest < 0.3);
  CHECK(many.depth < 0.01);
  CHECK(many.moving < 20);
}
