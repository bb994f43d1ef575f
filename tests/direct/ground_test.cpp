// Joints and contacts together: contacts with friction stay outside of the matrix and take turns
// with the joints in it, contacts without friction are inside.
#include "bench/chapters/08_ground/bridge.h"
#include "bench/chapters/08_ground/ragdoll.h"
#include "tests/direct/rigs.h"
#include "tests/ground/rigs.h"
#include "tests/oracle/test.h"

using namespace joints::chapter8;

namespace {

constexpr real sixty = real(1) / 60;

struct Fall {
  double gap = 0, fastest = 0, deepest = 0, lowest = 0;
  bool finite = true;
};

Fall ragdoll_falls(Solver& solver, real beta, const StepOptions& how) {
  Choice choice;
  choice.beta = beta;
  Ragdoll doll(choice);
  Fall out;
  for (int n = 0; n < 600; ++n) {
    step(doll.scene.world, solver, sixty, how);
    out.gap = std::max(out.gap, widest(doll.scene));
    out.deepest = std::max(out.deepest, penetration(doll.scene.world));
    out.finite = out.finite && joints::testing::all_finite(doll.scene.world);
  }
  out.fastest = doll.fastest();
  out.lowest = double(doll.scene.world.bodies[doll.torso].x.y);
  return out;
}

// Two boxes side by side on a slope, on a hinge across it: how far the first one slides down in a
// second [m].
double slides(Solver& solver, real slope, real friction) {
  Grounded pair = standing(0, slope);
  pair.contact->friction = friction;
  const quat turn = rotation(vec3(0, 0, slope));
  const BodyId other =
      pair.world.add(box(10, brick, turn * vec3(real(1.1), brick.y / 2, 0), turn));
  auto& contact =
      pair.world.add<GroundContact>(pair.ground, other, Top{}, box_outline(brick));
  contact.friction = friction;
  pair.world.add<HingeJoint>(pair.body, other,
                             turn * vec3(real(0.55), brick.y / 2, 0), vec3(0, 0, 1));
  for (int n = 0; n < 60; ++n) step(pair.world, solver, sixty);
  if (const auto* direct = dynamic_cast<const DirectSolver*>(&solver))
    CHECK(direct->report().passes == 1);  // one factor serves all alternations
  return -double(pair.place().x);
}

}  // namespace

TEST_CASE("a ragdoll falls, holds together far better than by iterations, and lies still") {
  SequentialImpulses iterations;
  const Fall iterated = ragdoll_falls(iterations, real(0.2), {.warm_start = true});
  for (const int newton : {0, 8}) {
    CAPTURE(newton);
    DirectSolver solver = with(newton);
    const Fall fall = ragdoll_falls(solver, 1, {.warm_start = true});
    INFO("gap " << fall.gap << " and " << iterated.gap << ", speed " << fall.fastest << ", deep "
                << fall.deepest << " and " << iterated.deepest);
    CHECK(fall.finite);
    CHECK(fall.gap < iterated.gap / 2);
    CHECK(fall.lowest < 0.6);
    CHECK(fall.fastest < 0.02);
    CHECK(fall.deepest < 0.04);
    solver.alternations = 60;  // joints and contacts take turns: more of them go less deep
    const double deepest = ragdoll_falls(solver, 1, {.warm_start = true}).deepest;
    CHECK(deepest < fall.deepest / 2);
  }
}

TEST_CASE("a crate that falls on a bridge of planks stays there, with added_inertia as without") {
  for (const int added_inertia : {0, 8}) {
    CAPTURE(added_inertia);
    DirectSolver solver = with(8);
    solver.added_inertia = real(added_inertia);
    Bridge bridge(30);
    bridge.scene.world.set_beta(1);
    double fastest = 0;  // it falls from 1.8 m above the planks, with 6.0 m/s at most
    for (int n = 0; n < 600; ++n) {
      step(bridge.scene.world, solver, sixty, {.leapfrog = true});
      fastest = std::max(fastest, double(length(bridge.scene.world.bodies[bridge.crate].v)));
    }
    const Body& crate = bridge.scene.world.bodies[bridge.crate];
    CHECK(fastest < 7);
    CHECK(length(crate.v) < 0.05);
    CHECK(crate.x.y > 2);
  }
}

TEST_CASE("friction holds two hinged boxes on a slope, and lets them slide on a steeper one") {
  for (const double slope : {0.2, 0.4, 0.6}) {
    CAPTURE(slope);
    SequentialImpulses many;
    many.iterations = 200;
    DirectSolver solver;
    const double mu = 0.5;
    const double expected = slides(many, real(slope), real(mu));
    const double found = slides(solver, real(slope), real(mu));
    const double a = std::max(0.0, 9.81 * (std::sin(slope) - mu * std::cos(slope)));
    CHECK(expected == Approx(a / 2).epsilon(0.06).margin(2e-3));
    CHECK(found == Approx(expected).epsilon(0.05).margin(2e-3));
  }
}

TEST_CASE("contacts without friction are rows of the matrix, with friction they are not") {
  for (const bool smooth : {true, false}) {
    Grounded box = standing();
    box.contact->friction = smooth ? real(0) : real(0.5);
    DirectSolver solver;
    for (int n = 0; n < 60; ++n) step(box.world, solver, sixty, second_order);
    CHECK((solver.report().multiplications > 0) == smooth);
    CHECK(double(box.place().y) == Approx(0.3).margin(1e-3));
    CHECK(double(length(box.velocity())) < 1e-3);
  }
}

TEST_CASE("a ball rebounds from smooth ground as from rough ground, and as without Newton") {
  for (const int newton : {0, 8})
    for (const real friction : {real(0), real(0.5)}) {
      CAPTURE(newton, friction);
      Grounded falling(ball(1, real(0.2), vec3(0, real(1.2), 0)), ball_outline(real(0.2)));
      falling.contact->friction = friction;
      falling.contact->restitution = real(0.7);
      DirectSolver solver = with(newton);
      double highest = 0, lowest = 1;
      bool landed = false;
      for (int n = 0; n < 90; ++n) {
        step(falling.world, solver, sixty);
        const double y = double(falling.it().x.y);
        landed = landed || y < 0.21;
        lowest = std::min(lowest, y);
        if (landed) highest = std::max(highest, y);
      }
      CHECK(highest - 0.2 == Approx(0.49).margin(0.06));  // the square of 0.7, of 1 m
      CHECK(lowest > 0.199);
    }
}

TEST_CASE("a chain that hangs to the ground lies on it, and loses no joint") {
  for (const int newton : {0, 8}) {
    CAPTURE(newton);
    Scene scene{.name = "on the ground"};
    const BodyId ground = add_ground(scene, 10);
    BodyId before = scene.box(0, vec3(real(0.2)), vec3(0, 2, 0));
    for (int k = 1; k <= 8; ++k) {
      const vec3 size(real(0.4), real(0.2), real(0.2)), x(real(0.5) * real(k), 2, 0);
      const BodyId id = scene.box(2, size, x);
      chapter9::on_hinge(scene, before, id, x - vec3(real(0.25), 0, 0), vec3(0, 0, 1));
      stand(scene, ground, id, size, real(0.5));
      before = id;
    }
    DirectSolver solver = with(newton);
    double gap = 0, deepest = 0;
    for (int n = 0; n < 600; ++n) {
      step(scene.world, solver, sixty);
      gap = std::max(gap, widest(scene));
      deepest = std::max(deepest, penetration(scene.world));
    }
    CHECK(joints::testing::all_finite(scene.world));
    CHECK(gap < 0.02);
    CHECK(deepest < 0.05);
    CHECK(double(scene.world.bodies[before].x.y) < 0.2);
  }
}

// Where the bodies of a mechanism are after two seconds.
// \param crate with it a crate falls beside them onto rough ground
static std::vector<vec3> places_beside(bool crate, unsigned seed, Solver& solver) {
  Random random(seed);
  World world = mechanism(random, 8, int(seed % 3));
  feed_back_all(world);
  if (crate) {
    const BodyId ground = world.add(static_body(vec3(20, 0, 0))),
                 box = world.add(joints::box(10, brick, vec3(20, 2, 0), random.turn()));
    world.add<GroundContact>(ground, box, Top{}, box_outline(brick)).friction = real(0.5);
  }
  for (int n = 0; n < 120; ++n) step(world, solver, sixty, second_order);
  std::vector<vec3> places;
  for (int k = 0; k < 8; ++k) places.push_back(world.bodies.at(k).x);
  return places;
}

TEST_CASE("a mechanism moves as without the crate that falls on rough ground beside it") {
  for (unsigned seed = 1; seed <= 30; ++seed)
    for (const bool careful : {false, true}) {
      CAPTURE(seed, careful);
      DirectSolver alone = with(careful ? 8 : 0, real(careful ? 8 : 0)), beside = alone;
      const std::vector<vec3> without = places_beside(false, seed, alone),
                              with_it = places_beside(true, seed, beside);
      for (std::size_t k = 0; k < without.size(); ++k)  // but for the order of the islands
        CHECK(double(length(with_it[k] - without[k])) < (sizeof(real) == 4 ? 1e-4 : 1e-12));
    }
}
