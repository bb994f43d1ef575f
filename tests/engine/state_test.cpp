// A world that is saved and restored, into itself or into another one built alike, goes on as if
// nothing had been: to the bit, with everything a joint may keep.
#include "contacts/ground_contact.h"
#include "direct/direct_solver.h"
#include "engine/kept/reaction.h"
#include "engine/kept/state.h"
#include "tests/oracle/packings.h"
#include "tests/oracle/test.h"

using Catch::Matchers::StartsWith;

namespace {

const real h = real(1) / 60;

bool same(const std::vector<real>& one, const std::vector<real>& other) {
  return one.size() == other.size() &&
         std::memcmp(one.data(), other.data(), one.size() * sizeof(real)) == 0;
}
bool same(const State& one, const State& other) {
  return one == other && same(one.bodies, other.bodies) && same(one.joints, other.joints);
}

// Every kind of joint, with whatever it can keep: a wheel that counts its turns, arms between
// limits that are now far, now hit, a slow door that need not look for its limits, a slider with a
// motor between stops, a plate on two welds, rods and ropes, a crate and a ball that jump on the
// ground.
World machine() {
  World world;
  const BodyId ground = world.add(static_body(vec3(0)));
  const auto bar = [&](real x, real y, real z) {
    return world.add(box(2, vec3(real(0.9), real(0.2), real(0.3)), vec3(x, y, z)));
  };
  const auto hinge = [&](BodyId a, BodyId b, const vec3& anchor, const vec3& axis) -> HingeJoint& {
    return world.add<HingeJoint>(a, b, anchor, axis);
  };
  const BodyId gone = bar(0, 0, 0);  // its slot stays empty
  const BodyId wheel = bar(real(-3.5), 5, 0), arm = bar(real(0.5), 5, 0);
  const BodyId forearm = bar(real(1.5), 5, 0), hand = bar(real(2.5), 5, 0);
  hinge(ground, wheel, vec3(-4, 5, 0), vec3(0, 0, 1)).set_motor(9, 60);
  hinge(ground, arm, vec3(0, 5, 0), vec3(0, 0, 1)).set_limits(-2, 2);
  auto& elbow = hinge(arm, forearm, vec3(1, 5, 0), vec3(0, real(0.2), 1));
  elbow.set_limits(-1, real(0.5));
  elbow.whole = false;
  elbow.set_friction(real(0.3));
  world.add<BallJoint>(forearm, hand,
                       point_at(world.bodies[forearm], world.bodies[hand], vec3(2, 5, 0)));
  const BodyId sledge = bar(-4, 8, 3), plate = bar(-4, real(7.8), 3), foot = bar(-4, real(7.6), 3);
  const vec3 rail(1, 1, 0);
  auto& slider = world.add<SliderJoint>(ground, sledge, vec3(-4, 8, 3), rail);
  slider.set_limits(real(-0.2), 1);
  slider.set_motor(2, 70);
  world.add<FixedJoint>(sledge, plate, vec3(-4, 8, 3));
  auto& weld = world.add<FixedJoint>(plate, foot, vec3(-4, real(7.7), 3));
  weld.whole = false;
  weld.frequency = 6;
  weld.damping = real(0.1);
  const BodyId swing = bar(5, 3, 0), bob = bar(5, 2, 1);
  world.add<DistanceJoint>(ground, swing, Distance{vec3(5, 5, 0), vec3(real(0.4), 0, 0), 2});
  world.add<RopeJoint>(swing, bob, Rope<Distance>{{vec3(0), vec3(real(0.1), 0, 0), real(1.2)}});
  const vec3 size(1, real(0.6), real(0.8));
  const BodyId crate = world.add(box(10, size, vec3(-8, 2, 0), rotation(vec3(1, 0, real(0.5)))));
  const BodyId ball = world.add(joints::ball(3, real(0.3), vec3(8, 3, 0)));
  auto& contact = world.add<GroundContact>(ground, crate, Top{}, box_outline(size));
  contact.restitution = real(0.5);
  world.add<GroundContact>(ground, ball, Top{}, ball_outline(real(0.3))).restitution = real(0.95);
  const BodyId door = bar(real(0.5), 5, 5);
  hinge(ground, door, vec3(0, 5, 5), vec3(0, 1, 0)).set_limits(-1, 1);
  Random random(20);
  push_at_random(world.bodies, random);
  world.bodies[door].w = vec3(0, real(0.05), 0);
  world.bodies[door].v = vec3(0, 0, real(-0.025));
  world.bodies[hand].force = vec3(0, 3, real(0.5));
  world.bodies[ball].torque = vec3(0, real(0.2), 0);
  world.remove(gone);
  return world;
}

// What became of a world, now and then in a thousand steps.
std::vector<State> run(World& world, Solver& solver, const StepOptions& how) {
  std::vector<State> out;
  for (int n = 1; n <= 1000; ++n) {
    step(world, solver, h, how);
    if (n % 50 == 0 || n < 10) out.push_back(save(world));
  }
  return out;
}

template <class S>
S few(S solver) {
  solver.iterations = 6;
  return solver;
}
template <class S>
void goes_on_the_same(const S& settings, const StepOptions& how) {
  World world = machine();
  S solver = settings;
  for (int n = 0; n < 333; ++n) step(world, solver, h, how);
  const State then = save(world);
  CHECK(same(save(world), then));
  const std::vector<State> first = run(world, solver, how);
  REQUIRE(all_finite(world));
  REQUIRE(!same(first.front(), first.back()));
  begin_step(world, solver, h, how);  // a step that is not finished leaves nothing
  restore(world, then);
  CHECK(same(save(world), then));
  const std::vector<State> again = run(world, solver, how);
  World other = machine();
  S fresh = settings;
  restore(other, then);
  const std::vector<State> elsewhere = run(other, fresh, how);
  for (std::size_t k = 0; k < first.size(); ++k) {
    CAPTURE(k);
    REQUIRE(same(again[k], first[k]));
    REQUIRE(same(elsewhere[k], first[k]));
  }
}

// The corners of all contacts that have rows.
int touching(const World& world) {
  int count = 0;
  for (const auto& joint : world.joints())
    if (const auto* contact = dynamic_cast<const GroundContact*>(joint.get()))
      count += contact->touching();
  return count;
}

// Forces and torques of all joints [N, N m].
std::vector<vec3> reactions(const World& world) {
  std::vector<vec3> out;
  for (const auto& joint : world.joints()) {
    const Reaction one = reaction(*joint, world.bodies);
    out.push_back(one.force);
    out.push_back(one.torque);
  }
  return out;
}

const StepOptions warm{.warm_start = true};
const StepOptions all{.warm_start = true, .substeps = 2, .projections = 2};

}  // namespace

TEST_CASE("a restored world goes on to the bit with Sequential Impulses however it steps") {
  for (const bool row_by_row : {false, true})
    for (StepOptions how : {warm, all, StepOptions{.leapfrog = true},
                         StepOptions{.warm_start = true, .frequency = 8}}) {
      CAPTURE(row_by_row, how.substeps, how.leapfrog, double(how.frequency));
      SequentialImpulses solver;
      how.row_by_row = row_by_row;
      goes_on_the_same(few(solver), how);
    }
}

TEST_CASE("a world can be restored at every moment of a bounce into one at any other moment") {
  SequentialImpulses solver;
  World world = machine(), other = machine();
  int touched = 0, moved_exactly = 0;
  for (int n = 0; n < 300; ++n) {
    step(world, solver, h, all);
    restore(other, save(world));
    REQUIRE(touching(other) == touching(world));
    REQUIRE(reactions(other) == reactions(world));
    touched += touching(world) > 0;
    for (int k = 0; k < 4; ++k) step(other, solver, h, all);
    const State later = save(other);
    for (int k = 0; k < 40; ++k) step(other, solver, h, {.substeps = 3});
    const State now = save(world);
    for (int k = 0; k < 4; ++k) step(world, solver, h, all);
    moved_exactly += same(save(world), later);
    restore(world, now);
  }
  CHECK(moved_exactly == 300);
  CHECK(touched > 50);
  CHECK(touched < 250);
}

TEST_CASE("a restored world goes on to the bit with every packing") {
  for (const Packing packing : packings)
    for (const StepOptions& how : {warm, all}) {
      CAPTURE(int(packing), how.substeps);
      PackedImpulses solver;
      solver.packing = packing;
      goes_on_the_same(few(solver), how);
    }
}

TEST_CASE("a restored world goes on to the bit with the direct solver, a new one or the same") {
  for (const int newton : {0, 8})
    for (const real added_inertia : {real(0), real(8)})
      for (const StepOptions& how : {warm, StepOptions{.leapfrog = true}}) {
        CAPTURE(newton, double(added_inertia), how.leapfrog);
        DirectSolver solver;
        solver.newton = newton;
        solver.added_inertia = added_inertia;
        goes_on_the_same(solver, how);
        World world = machine(), other = machine();
        DirectSolver fresh = solver;
        for (int n = 0; n < 60; ++n) step(world, solver, h, how);
        restore(other, save(world));
        for (int n = 0; n < 30; ++n) {
          step(world, solver, h, how);
          step(other, fresh, h, how);
        }
        CHECK(same(save(world), save(other)));
      }
}

TEST_CASE("restoring brings back forces and limits and motors but not what a world is built of") {
  Rotor rotor(0, 2);
  rotor.hinge->set_limits(-1, 3);
  rotor.hinge->set_motor(2, 5);
  rotor.rotor().force = vec3(1, 2, 3);
  const State then = save(rotor.world);
  rotor.hinge->set_limits(-2, 2);
  rotor.hinge->set_friction(1);
  rotor.hinge->beta = real(0.7);
  rotor.rotor() = body_with(4, vec3(4), vec3(9));
  rotor.run(3, h);
  restore(rotor.world, then);
  CHECK(double(rotor.hinge->limits().lower) == -1);
  CHECK(double(rotor.hinge->motor().speed) == 2);
  CHECK(rotor.rotor().force == vec3(1, 2, 3));
  CHECK(rotor.rotor().x == vec3(0));
  CHECK(double(rotor.rotor().inverse_mass) == 0.25);
  CHECK(rotor.hinge->beta == real(0.7));
  CHECK(rotor.world.last_h == 0);
  CHECK(rotor.world.blocks.list.empty());
}

TEST_CASE("the force that a joint tells of is that of the step before the world was saved") {
  World world = machine(), other = machine();
  SequentialImpulses solver;
  for (int n = 0; n < 100; ++n) step(world, solver, h, warm);
  restore(other, save(world));
  const auto& wheel = dynamic_cast<const HingeJoint&>(*world.joints().front());
  const auto& restored = dynamic_cast<const HingeJoint&>(*other.joints().front());
  CHECK(length(vec3(wheel.forces()[0], wheel.forces()[1], wheel.forces()[2])) > 1);
  CHECK(wheel.forces() == restored.forces());
  CHECK(wheel.motor_force() == restored.motor_force());
  CHECK(wheel.position(world.bodies) > 3);  // turns and all
  CHECK(wheel.position(world.bodies) == restored.position(other.bodies));
  CHECK(wheel.coordinate().expected == restored.coordinate().expected);
}

TEST_CASE("limits come back to a joint whose motor had been switched off") {
  const auto door = [](real lower, real upper, real speed) {
    World world;
    const BodyId post = world.add(static_body(vec3(0)));
    const BodyId leaf = world.add(box(3, vec3(1, real(0.1), 2), vec3(real(0.5), 0, 0)));
    auto& hinge = world.add<HingeJoint>(post, leaf, vec3(0), vec3(0, 0, 1));
    if (lower < upper) hinge.set_limits(lower, upper);
    hinge.set_motor(speed, 0);
    return world;
  };
  World limited = door(real(-0.3), real(0.3), 0), off = door(0, 0, 1);
  SequentialImpulses solver;
  step(limited, solver, h);
  for (int n = 0; n < 3; ++n) step(off, solver, h);
  restore(off, save(limited));
  for (World* world : {&limited, &off})
    for (int n = 0; n < 120; ++n) step(*world, solver, h);
  const auto& hinge = static_cast<const HingeJoint&>(*off.joints().front());
  CHECK(double(hinge.position(off.bodies)) == Approx(-0.3).margin(0.01));
  CHECK(same(save(off), save(limited)));
}

TEST_CASE("the state of a world of another shape is refused and nothing has changed") {
  const State good = save(machine());
  World world = machine();
  SequentialImpulses solver;
  for (int n = 0; n < 10; ++n) step(world, solver, h, warm);
  const State before = save(world);
  const auto said = [&](const State& bad) {
    const std::string words = refusal([&] { restore(world, bad); });
    CHECK(same(save(world), before));
    CHECK(world.blocks.list.size() > 10);
    return words;
  };
  World more = machine();
  more.add(static_body(vec3(0)));
  CHECK(said(save(more)) == "state: has 14 bodies; this world has 13");
  World moved = machine();
  moved.remove(moved.joints().front()->body2);
  moved.add(static_body(vec3(0)));
  moved.add(static_body(vec3(0)));  // as many bodies, and no slot empty
  moved.remove(moved.joints().front()->body2);
  CHECK_THAT(said(save(moved)), StartsWith("state: has a body in slot 1; "));
  World fewer = machine();
  fewer.remove(*fewer.joints().front());
  CHECK(said(save(fewer)) == "state: has 11 joints; this world has 12");
  World other = machine();
  const Joint& ball = *other.joints().back();
  other.add<BallJoint>(ball.body1, ball.body2, Point{});
  other.remove(ball);
  CHECK_THAT(said(save(other)), StartsWith("state: joint 11 holds the bodies in slots 0 and 13 and "
                                           "has 6 numbers; this world's holds the bodies in "));
  State cut = good;
  cut.bodies.pop_back();
  CHECK(said(cut) == "state: has 246 numbers of bodies; this world has 247");
  cut = good;
  cut.joints.pop_back();
  CHECK_THAT(said(cut), StartsWith("state: has "));
  CHECK(refusal([&] { restore(world, good); }) == "accepted");
}

TEST_CASE("a state with altered numbers is refused and nothing has changed") {
  World world = machine();
  SequentialImpulses solver;
  for (int n = 0; n < 50; ++n) step(world, solver, h, all);
  const State good = save(world);
  const std::size_t blocks = world.blocks.list.size();
  const auto refused = [&](auto change) {
    State bad = good;
    change(bad);
    const std::string words = refusal([&] { restore(world, bad); });
    return words != "accepted" && same(save(world), good) && world.blocks.list.size() == blocks;
  };
  const real nan = std::numeric_limits<real>::quiet_NaN();
  for (std::size_t k = 0; k < good.bodies.size(); ++k)
    for (const real x : {nan, unbounded, -unbounded}) {
      CAPTURE(k, double(x));
      REQUIRE(refused([&](State& state) { state.bodies[k] = x; }));
    }
  for (std::size_t k = 0; k < good.joints.size(); ++k) {
    CAPTURE(k);
    REQUIRE(refused([&](State& state) { state.joints[k] = nan; }));
  }
  std::size_t first = 0;  // of a joint: two lengths, whether it can move, impulses, signs and more
  for (const auto& shape : good.shapes) {
    CAPTURE(first);
    for (const real x : {real(0.5), real(2), real(-1), real(3e9)})
      REQUIRE(refused([&](State& state) { state.joints[first + 2] = x; }));
    for (const std::size_t length : {first, first + 1})
      REQUIRE(refused([&](State& state) { state.joints[length] = -h; }));
    REQUIRE(refused([&](State& state) {
      state.joints[first + 3] = shape[2] > 9 ? nan : unbounded;
    }));
    first += std::size_t(shape[2]);
  }
  for (std::size_t k = 0; k < good.shapes.size(); ++k)
    for (int i = 0; i < 3; ++i)
      for (const int by : {1, -1, 1 << 30})
        REQUIRE(refused([&](State& state) { state.shapes[k][std::size_t(i)] += by; }));
  for (std::size_t k = 0; k < good.slots.size(); ++k)
    REQUIRE(refused([&](State& state) { state.slots[k] = -1; }));
  for (const real x : {nan, unbounded, -h}) {
    CHECK(refused([&](State& state) { state.last_h = x; }));
    CHECK(refused([&](State& state) { state.impulse_duration = x; }));
  }
  CHECK(refused([](State& state) { state.bodies[3] *= 2; }));  // of a q
  CHECK(refusal([&] { restore(world, good); }) == "accepted");
}

TEST_CASE("limits and motors that no joint can have are refused when a world is restored") {
  const auto said = [](real what, real by) {
    Rotor rotor;
    rotor.hinge->set_limits(-1, 3);
    rotor.hinge->set_motor(2, 5);
    State state = save(rotor.world);
    const auto place = std::find(state.joints.begin(), state.joints.end(), what);
    REQUIRE(place != state.joints.end());
    *place = by;
    const std::string words = refusal([&] { restore(rotor.world, state); });
    CHECK(double(rotor.hinge->limits().upper) == 3);
    CHECK(double(rotor.hinge->motor().strength) == 5);
    return words;
  };
  CHECK_THAT(said(3, -2), StartsWith("lower: must not be above upper"));
  CHECK_THAT(said(5, -5), StartsWith("strength is -5"));
  CHECK_THAT(said(2, unbounded), StartsWith("state: holds a number that is not finite"));
}
