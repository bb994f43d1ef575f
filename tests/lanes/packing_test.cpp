// How the solver packs a step's blocks: every packing has an order of its own and keeps all else,
// the groups are computed once, and a step then takes no memory from the heap.
#include "engine/kept/state.h"
#include "tests/oracle/allocations.h"
#include "tests/oracle/beside.h"
#include "tests/oracle/packings.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;

// Joints of every kind in chains that share one static body: driven, limited, in one block or in
// several, soft, one-sided. The chains are alike but for their masses and places.
struct Zoo {
  World world;
  BodyId wall;
  std::vector<BodyId> ids;
  std::vector<Joint*> joints;
  explicit Zoo(int chains, bool bounded = true) {
    wall = world.add(static_body(vec3(0)));
    Random random(81);
    for (int chain = 0; chain < chains; ++chain) {
      BodyId before = wall;
      for (int k = 1; k <= 14; ++k) {
        const vec3 x(real(k), 0, real(4 * chain));
        Body body = k % 4 == 0 ? ball(real(1 + chain), real(0.4), x)
                               : box(real(1 + k % 3), vec3(real(0.8), real(0.4), real(0.3)), x);
        if (k % 4 != 0) body.q = random.turn(real(0.3));
        body.v = random.vector(real(0.5));
        body.w = random.vector(real(0.5));
        ids.push_back(world.add(body));
        join(k, before, ids.back(), bounded);
        before = ids.back();
      }
    }
  }
  void join(int k, BodyId a, BodyId b, bool bounded) {
    Bodies& bodies = world.bodies;
    const vec3 anchor = bodies[b].x - vec3(real(0.5), 0, 0), along(1, real(k % 2), real(0.4));
    const vec3 at1 = to_local(bodies[a], anchor - bodies[a].x);
    switch (k) {
      case 1: case 2: case 3: case 4: {
        auto& hinge = world.add<HingeJoint>(a, b, anchor, along);
        hinge.whole = k % 2 == 0;
        if (bounded && k > 1) hinge.set_motor(4, 3);
        if (bounded && k > 2) hinge.set_limits(real(0.05), 1);  // passed from the beginning
        return keep(hinge);
      }
      case 5: case 6: case 7: {
        auto& slider = world.add<SliderJoint>(a, b, anchor, along);
        slider.whole = k % 2 == 0;
        if (bounded && k > 5) slider.set_motor(2, 20), slider.set_limits(real(0.02), 1);
        return keep(slider);
      }
      case 8: return keep(world.add<BallJoint>(a, b, point_at(bodies[a], bodies[b], anchor)));
      case 9: return keep(world.add<FixedJoint>(a, b, anchor));
      case 10: world.add<FixedJoint>(a, b, anchor).whole = false; return;
      case 11: return keep(world.add<DistanceJoint>(a, b, Distance{at1, vec3(0), real(0.5)}));
      case 12: return keep(world.add<CentreDistanceJoint>(a, b, CentreDistance{1}));
      case 13:
        if (!bounded) return keep(world.add<CentreDistanceJoint>(a, b, CentreDistance{1}));
        return keep(world.add<CentreRopeJoint>(a, b, Rope<CentreDistance>{{real(0.95)}}));
      default: {  // a soft tie of two points, and a soft row that turns, with bounds
        auto& tie = world.add<AnyJoint<3>>(a, b);
        tie.J = to_jacobian(point_at(bodies[a], bodies[b], anchor).jacobian(bodies[a], bodies[b]));
        tie.target = {.frequency = 5, .damping = real(0.5)};
        auto& turn = world.add<AnyJoint<1>>(a, b);
        turn.J[0] = {vec3(0), -along, vec3(0), along};
        turn.target = {.frequency = 8};
        if (bounded) turn.target.lower = -1, turn.target.upper = 1;
      }
    }
  }
  void keep(Joint& joint) { joints.push_back(&joint); }
};

PackedImpulses solver_of(Packing packing) {
  PackedImpulses solver;
  solver.packing = packing;
  return solver;
}

// Ten chains of three boxes on hinges that share a static body, all lanes but two in use.
World whips() {
  World world;
  const BodyId wall = world.add(static_body(vec3(0), rotation(vec3(1, 2, 3))));
  for (int chain = 0; chain < 10; ++chain) {
    BodyId before = wall;
    for (int k = 1; k <= 3; ++k) {
      const vec3 x(real(k), 0, real(chain));
      const BodyId id = world.add(box(1, vec3(real(0.8), real(0.4), real(0.3)), x));
      world.add<HingeJoint>(before, id, x - vec3(real(0.5), 0, 0), vec3(0, 1, 1));
      before = id;
    }
  }
  return world;
}

}  // namespace

TEST_CASE("packed in the order of the list every joint moves as with the scalar solver") {
  for (const bool warm : {false, true}) {
    Zoo scalar(2), packed(2);
    SequentialImpulses one;
    PackedImpulses other = solver_of(Packing::list);
    StepOptions stepping{.warm_start = warm};
    stepping.projections = 1;
    for (int n = 0; n < 20; ++n) {
      step(scalar.world, one, h, stepping);
      step(packed.world, other, h, stepping);
      CHECK(speeds_apart(packed.world, scalar.world) < tolerance(1e-9, 2e-2));
    }
    const std::vector<int>& blocks = other.packed().order().blocks;
    CHECK(std::is_sorted(blocks.begin(), blocks.end()));
    CHECK(other.packed().order().width == 1);
  }
}

TEST_CASE("islands interleaved one block at a time change nothing to the last bit") {
  Zoo in_list(3), in_turns(3);
  PackedImpulses list = solver_of(Packing::list), islands = solver_of(Packing::interleaved);
  for (int n = 0; n < 20; ++n) {
    step(in_list.world, list, h);
    step(in_turns.world, islands, h);
    CHECK(same_bodies(in_list.world, in_turns.world));
  }
  const std::vector<int>& turns = islands.packed().order().blocks;
  const int each = int(turns.size()) / 3;
  std::vector<int> island, place;  // of each block in turn: of which chain, and where in it
  for (const int block : turns) island.push_back(block / each), place.push_back(block % each);
  CHECK(std::is_sorted(place.begin(), place.end()));
  for (std::size_t k = 1; k < island.size(); ++k) CHECK(island[k] != island[k - 1]);
}

TEST_CASE("a static body that ten islands in columns share stays to the last bit") {
  World world = whips(), in_list = whips();
  const Body before = world.bodies.at(0);
  PackedImpulses columns, list = solver_of(Packing::list);
  for (int n = 0; n < 60; ++n) {
    step(world, columns, h);
    step(in_list, list, h);
  }
  const LaneOrder& order = columns.packed().order();
  REQUIRE(order.columns);
  CHECK(std::count(order.bodies.begin(), order.bodies.end(), 0) == 0);  // zeros stand for it
  CHECK(order.groups() == 3 * ((10 + lane_count - 1) / lane_count));
  const Body& after = world.bodies.at(0);
  CHECK((after.x == before.x && after.q == before.q && after.v == vec3(0) && after.w == vec3(0)));
  CHECK(same_bodies(world, in_list));
}

TEST_CASE("blocks are put into groups again when one comes, goes or changes its kind") {
  for (const Packing packing : packings)
    for (const bool warm : {false, true}) {
      CAPTURE(int(packing), warm);
      World kept = whips(), fresh = whips();
      PackedImpulses solver = solver_of(packing);
      const auto steps = [&](int count) {  // beside it, a solver that is new
        for (int n = 0; n < count; ++n) {
          PackedImpulses another = solver_of(packing);
          step(fresh, another, h, {.warm_start = warm});
          step(kept, solver, h, {.warm_start = warm});
          CHECK(same_bodies(kept, fresh));
        }
        return solver.packed().groupings();
      };
      const auto both = [&](auto change) { change(kept), change(fresh); };
      const auto hinge = [](World& world) -> HingeJoint& {
        return static_cast<HingeJoint&>(*world.joints()[7]);
      };
      const int places = packing == Packing::automatic || packing == Packing::interleaved;
      CHECK(steps(20) == 1);
      both([](World& world) { world.gravity = vec3(1, 2, 3); });
      CHECK(steps(5) == 1);  // other numbers, the same structure
      both([&](World& world) {
        hinge(world).set_limits(hinge(world).position(world.bodies) + 1, unbounded);
      });
      CHECK(steps(5) == 2);  // a limit is live: its block has a sixth row
      both([&](World& world) { hinge(world).clear_limits(); });
      CHECK(steps(5) == 3);
      CHECK(solver.packed().placings() == places);
      both([](World& world) { world.remove(*world.joints()[4]); });
      CHECK(steps(5) == 4);
      both([](World& world) {
        Body& body = world.bodies.at(14);
        body.inverse_mass = 0;
        body.inverse_inertia_local = body.v = body.w = vec3(0);
      });
      CHECK(steps(5) == 5);
      both([](World& world) {
        for (int slot = 1; slot < world.bodies.slots(); ++slot)
          if (!world.bodies.at(slot).is_static())
            world.bodies.at(slot).inverse_inertia_local = vec3(20);
      });
      CHECK(steps(5) == 6);  // round: one number says an inertia
      both([&](World& world) { hinge(world).set_motor(1, 1); });
      CHECK(steps(5) == 7);
      both([](World& world) { world.add(ball(1, 1, vec3(0, 50, 0))); });
      CHECK(steps(5) == 7);  // nothing holds it
      CHECK(solver.packed().placings() == 3 * places);  // when an island was cut, and anchored
      both([](World& world) {
        const BodyId a = world.bodies.id(18), b = world.bodies.id(24);
        const vec3 anchor = (world.bodies[a].x + world.bodies[b].x) / real(2);
        world.add<BallJoint>(a, b, point_at(world.bodies[a], world.bodies[b], anchor));
      });
      CHECK(steps(5) == 8);
      CHECK(solver.packed().placings() == 4 * places);  // it connects two chains
      both([](World& world) {
        Body& body = world.bodies.at(14);
        body.inverse_mass = 1;
        body.inverse_inertia_local = vec3(10);
      });
      CHECK(steps(5) == 9);
      CHECK(solver.packed().placings() == 5 * places);  // it had no place
    }
}

TEST_CASE("once its vectors have grown no step allocates in any packing") {
  for (const Packing packing : packings)
    for (const bool warm : {false, true}) {
      CAPTURE(int(packing), warm);
      World few = whips();
      Zoo zoo(2);
      auto& swinging = static_cast<HingeJoint&>(*few.joints()[7]);
      swinging.set_limits(real(-0.2), real(0.2));  // a limit that comes and goes
      int arranged = 0;
      for (World* world : {&few, &zoo.world}) {
        PackedImpulses solver = solver_of(packing);
        StepOptions stepping{.warm_start = warm};
        stepping.projections = 1;
        const State begin = save(*world);
        for (int n = 0; n < 120; ++n) step(*world, solver, h, stepping);
        const int before = solver.packed().groupings();
        restore(*world, begin);  // once more through all that comes and goes
        CHECK(allocations_of([&] {
                for (int n = 0; n < 120; ++n) step(*world, solver, h, stepping);
              }) == 0);
        arranged += solver.packed().groupings() - before;
      }
      CHECK(arranged > 0);
    }
}

TEST_CASE("momentum is kept in every packing") {
  for (const Packing packing : packings)
    for (const double relaxation : {1.0, 1.7}) {
      Zoo zoo(3);
      World& world = zoo.world;
      world.gravity = vec3(0);
      for (std::size_t k = 0; k < 3; ++k) world.remove(*zoo.joints[k * (zoo.joints.size() / 3)]);
      const std::vector<Body> before = snapshot(world.bodies);
      const auto momentum = [&](const std::vector<Body>& bodies) {  // where they stood before
        std::array<dvec3, 2> sum{dvec3(0), dvec3(0)};
        for (std::size_t k = 1; k < bodies.size(); ++k) {
          const dvec3 p = dvec3(bodies[k].v) / double(bodies[k].inverse_mass);
          sum[0] += p;
          sum[1] += cross(dvec3(before[k].x), p) + dvec3(angular_momentum(bodies[k]));
        }
        return sum;
      };
      PackedImpulses solver = solver_of(packing);
      solver.relaxation = real(relaxation);
      step(world, solver, h);
      const auto after = momentum(snapshot(world.bodies)), expected = momentum(before);
      CHECK(length(after[0] - expected[0]) < tolerance(1e-10, 1e-2));
      CHECK(length(after[1] - expected[1]) < tolerance(1e-10, 1e-2));
      CHECK(speeds_apart(world, before) > 0.1);
      CHECK(world.bodies.at(0).x == vec3(0));
    }
}

TEST_CASE("a refused setting is named and nothing has moved") {
  Zoo zoo(1), as_before(1);
  const real inf = unbounded, nan = std::numeric_limits<real>::quiet_NaN();
  const auto check = [&](auto solver, const std::string& name, auto set) {
    set(solver);
    const std::string words = refusal([&] { step(zoo.world, solver, h); });
    CHECK((words.starts_with(name + ": ") || words.starts_with(name + " is ")));
    CHECK(same_bodies(zoo.world, as_before.world));
  };
  const auto check_all = [&](auto solver) {
    for (const real bad : {real(0), real(-1), nan, inf, -inf})
      check(solver, "relaxation", [&](auto& s) { s.relaxation = bad; });
    for (const int bad : {0, -3}) check(solver, "iterations", [&](auto& s) { s.iterations = bad; });
    CHECK(refusal([&] {
            step(zoo.world, solver, h, {.projections = -1});
          }).starts_with("projections: "));
    CHECK(refusal([&] { step(zoo.world, solver, h, {.substeps = 0}); }).starts_with("substeps: "));
    for (const real bad : {real(-1), nan, inf})
      CHECK(refusal([&] {
              step(zoo.world, solver, h, {.frequency = bad});
            }).starts_with("frequency is "));
    for (const real bad : {real(0), real(-0.1), nan, inf})
      CHECK(refusal([&] { step(zoo.world, solver, bad); }).starts_with("h is "));
    CHECK(same_bodies(zoo.world, as_before.world));
    Zoo another(1);
    solver.relaxation = real(1.9);
    CHECK(refusal([&] { step(another.world, solver, h); }) == "accepted");
    CHECK_FALSE(same_bodies(another.world, as_before.world));
  };
  check_all(SequentialImpulses());
  check_all(PackedImpulses());
}
