// Islands on lanes beside the list's order, step by step from the same state: what the solver keeps
// from one step to the next must change no result, whatever comes and goes.
#include "bench/tasks.h"
#include "contacts/ground_contact.h"
#include "engine/kept/state.h"
#include "engine/steps/step.h"
#include "joints/ball_joint.h"
#include "joints/hinge_joint.h"
#include "tests/checker/catch.h"
#include "tests/oracle/allocations.h"
#include "tests/oracle/oracle.h"
#include "tests/oracle/packings.h"

using namespace joints;
using namespace joints::testing;

namespace {

const real h = real(1) / 60;
const StepOptions warm{.warm_start = true};

// Two worlds made alike. A step of both: one by a solver that has gone all the way, with lanes or
// interleaved, the other from the same state in the list's order.
template <class Make>
struct Beside {
  World by_islands, by_list;
  PackedImpulses islands;
  SequentialImpulses list;
  double most = 0;  // the largest difference of a velocity after a step [m/s or rad/s]
  int changes = 0;  // steps in which blocks came or went

  explicit Beside(const Make& make, Packing packing = Packing::automatic)
      : by_islands(make()), by_list(make()) {
    islands.packing = packing;
    islands.iterations = list.iterations = 10;
  }
  void steps(int count) {
    for (int n = 0; n < count; ++n) {
      restore(by_list, save(by_islands));
      const int before = islands.packed().groupings();
      step(by_islands, islands, h, warm);
      step(by_list, list, h, warm);
      changes += islands.packed().groupings() > before;
      most = std::max(most, difference(velocities(snapshot(by_islands.bodies)),
                                       velocities(snapshot(by_list.bodies))));
    }
  }
  template <class Change>
  void both(const Change& change) {
    change(by_islands);
    change(by_list);
  }
};

// Chains of hinges with narrow limits, of unequal lengths and masses.
World limited_chains(unsigned seed) {
  Random random(seed);
  World world;
  for (int chain = 0; chain < 2 * lane_count + 1; ++chain) {
    BodyId before = world.add(static_body(vec3(0, 0, real(2 * chain))));
    const int links = 3 + int(random.uniform(0, 4));
    for (int k = 1; k <= links; ++k) {
      const vec3 x(real(k), 0, real(2 * chain));
      Body body = box(random.uniform(1, 3), vec3(real(0.8), real(0.3), real(0.2)), x);
      body.w = random.vector(2);
      const BodyId id = world.add(body);
      world.add<HingeJoint>(before, id, x - vec3(real(0.5), 0, 0), vec3(0, 0, 1))
          .set_limits(real(-0.3), real(0.3));
      before = id;
    }
  }
  return world;
}

}  // namespace

TEST_CASE("ragdolls in random poses land on lanes as in the list's order") {
  for (const unsigned seed : {1u, 2u, 3u})
    for (const Packing packing : {Packing::automatic, Packing::interleaved}) {
      CAPTURE(seed, int(packing));
      Beside beside([&] { return bench::random_ragdolls(2 * lane_count + 1, seed).world; },
                    packing);
      beside.steps(120);
      CHECK(beside.most < tolerance(1e-11, 2e-3));
      CHECK(beside.changes > 60);
      CHECK(beside.islands.packed().placings() == 1);
      CHECK(beside.islands.packed().order().width == (on_lanes(packing) ? lane_count : 1));
    }
}

TEST_CASE("chains whose limits come and go move on lanes as in the list's order") {
  for (const unsigned seed : {4u, 5u, 6u})
    for (const Packing packing : {Packing::automatic, Packing::interleaved}) {
      CAPTURE(seed, int(packing));
      Beside beside([&] { return limited_chains(seed); }, packing);
      beside.steps(150);
      CHECK(beside.most < tolerance(1e-11, 2e-3));
      CHECK(beside.changes > 60);
      CHECK(beside.islands.packed().placings() == 1);
    }
}

TEST_CASE("islands that are joined, cut or set back still move as in the list's order") {
  for (const unsigned seed : {7u, 8u}) {
    Beside beside([&] { return limited_chains(seed); });
    const PackedBlocks& packed = beside.islands.packed();
    const State before = (beside.steps(20), save(beside.by_islands));
    beside.steps(20);
    restore(beside.by_islands, before);  // with the places of later
    beside.steps(40);
    CHECK(packed.placings() == 1);

    beside.both([](World& world) {  // the first joint between two bodies that move
      for (const auto& joint : world.joints())
        if (!world.bodies[joint->body1].is_static()) return world.remove(*joint);
    });
    beside.steps(20);
    CHECK(packed.placings() == 2);
    beside.both([](World& world) {
      const BodyId a = world.joints()[3]->body2, b = world.joints()[20]->body2;
      const vec3 anchor = (world.bodies[a].x + world.bodies[b].x) / real(2);
      world.add<BallJoint>(a, b, point_at(world.bodies[a], world.bodies[b], anchor));
    });
    beside.steps(20);
    CHECK(packed.placings() == 3);
    beside.both([](World& world) { world.remove(world.joints()[12]->body2); });
    beside.steps(20);
    beside.both([](World& world) {  // in the slot of the one that was removed
      const BodyId id = world.add(box(1, vec3(1), vec3(0, -5, 0)));
      const BodyId other = world.joints()[2]->body2;
      world.add<BallJoint>(id, other, point_at(world.bodies[id], world.bodies[other],
                                               world.bodies[other].x));
    });
    beside.steps(20);
    CHECK(beside.most < tolerance(1e-11, 2e-3));
    CHECK(packed.placings() == 5);
    CHECK(packed.order().columns);
  }
}

TEST_CASE("once the vectors have grown no step of ragdolls or of limits allocates") {
  const auto settled = [&](World world, auto solver) {
    solver.iterations = 10;
    const State begin = save(world);
    for (int n = 0; n < 150; ++n) step(world, solver, h, warm);
    restore(world, begin);  // once more through all that comes and goes
    return allocations_of([&] {
      for (int n = 0; n < 150; ++n) step(world, solver, h, warm);
    });
  };
  for (const unsigned seed : {9u, 10u}) {
    const auto dolls = [&] { return bench::random_ragdolls(2 * lane_count + 1, seed).world; };
    CHECK(settled(dolls(), PackedImpulses()) == 0);
    CHECK(settled(dolls(), SequentialImpulses()) == 0);
    CHECK(settled(limited_chains(seed), PackedImpulses()) == 0);
    CHECK(settled(limited_chains(seed), SequentialImpulses()) == 0);
  }
}
