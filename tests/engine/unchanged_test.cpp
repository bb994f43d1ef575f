// A step looks over all that it is about to use before it changes anything: what it refuses leaves
// the world as it was, bit by bit, and an overflow is reported and stays in its place.
#include <functional>

#include "bench/runge_kutta.h"
#include "direct/direct_solver.h"
#include "engine/kept/input.h"
#include "engine/simd/packed.h"
#include "tests/oracle/picture.h"
#include "tests/oracle/test.h"

using Catch::Matchers::StartsWith;

namespace {

const real h = real(1) / 60;
const real no_number = std::numeric_limits<real>::quiet_NaN();

// A ground, and above it a body on each kind of joint, all of them under way.
struct Zoo {
  World world;
  BodyId ground, free;
  BallJoint* ball;
  DistanceJoint* rod;
  HingeJoint* hinge;
  SliderJoint* slider;
  FixedJoint* weld;
  GroundContact* contact;
  SequentialImpulses solver;
  StepOptions how{.warm_start = true};

  Zoo() {
    ground = world.add(static_body(vec3(0)));
    free = world.add(box(2, vec3(1), vec3(20, 9, 0)));
    ball = &world.add<BallJoint>(ground, some(1), Point{vec3(2, 5, 0), vec3(0, 1, 0)});
    rod = &world.add<DistanceJoint>(ground, some(2), Distance{vec3(4, 5, 0), vec3(0), 1});
    hinge = &world.add<HingeJoint>(ground, some(3), vec3(6, 5, 0), vec3(0, 0, 1));
    hinge->set_limits(real(-0.1), 30);
    slider = &world.add<SliderJoint>(ground, some(4), vec3(8, 4, 0), vec3(1, 0, 0));
    slider->set_motor(1, 10);
    weld = &world.add<FixedJoint>(ground, some(5), vec3(10, 4, 0));
    const BodyId box = some(6);
    world.bodies[box].x.y = real(0.5);
    contact = &world.add<GroundContact>(ground, box, Top{}, box_outline(vec3(1)));
    for (int n = 0; n < 5; ++n) step(world, solver, h, how);
  }
  BodyId some(int k) {
    return world.add(box(real(k), vec3(1), vec3(real(2 * k), 4, 0)));
  }
  std::string refused() { return refusal([&] { step(world, solver, h, how); }); }
};

// What a step of a spoilt zoo says. It says it again at every try, and nothing has changed.
std::string said(const std::function<void(Zoo&)>& spoil) {
  Zoo zoo;
  spoil(zoo);
  const std::string before = bits_of(zoo.world), words = zoo.refused();
  const auto unchanged = [&] { return bits_of(zoo.world) == before; };
  CHECK(unchanged());
  zoo.how.substeps = 3;
  zoo.how.leapfrog = true;
  CHECK(zoo.refused() == words);
  CHECK(refusal([&] { begin_step(zoo.world, zoo.solver, h, zoo.how); }) == words);
  CHECK(unchanged());
  return words;
}

}  // namespace

TEST_CASE("a step refuses a body by slot, member and value and changes no bit of the world") {
  const auto body = [](auto spoil) {
    return said([&](Zoo& zoo) { spoil(zoo.world.bodies[zoo.free]); });
  };
  CHECK(Zoo().refused() == "accepted");
  CHECK(body([](Body& b) { b.v = vec3(no_number, 0, 0); }) ==
        "body 1: v is (nan, 0, 0); must be finite");
  CHECK_THAT(body([](Body& b) { b.x.z = unbounded; }), StartsWith("body 1: x is ("));
  CHECK_THAT(body([](Body& b) { b.w.y = -unbounded; }), StartsWith("body 1: w is ("));
  CHECK_THAT(body([](Body& b) { b.force.y = unbounded; }), StartsWith("body 1: force is ("));
  CHECK_THAT(body([](Body& b) { b.torque.x = no_number; }), StartsWith("body 1: torque is ("));
  CHECK_THAT(body([](Body& b) { b.q = quat(1, real(0.01), 0, 0); }), StartsWith("body 1: q is ("));
  CHECK_THAT(body([](Body& b) { b.inverse_mass = -1; }), StartsWith("body 1: inverse_mass is -1"));
  CHECK_THAT(body([](Body& b) { b.inverse_mass = 0; }),
             StartsWith("body 1: inverse_inertia_local is ("));
  for (int k = 0; k < 3; ++k)
    for (const real bad : {unbounded, real(-1), real(0)})
      CHECK_THAT(body([=](Body& b) { b.inverse_inertia_local[k] = bad; }),
                 StartsWith("body 1: inverse_inertia_local is ("));
  CHECK_THAT(said([](Zoo& zoo) { zoo.world.bodies[zoo.ground].v.x = no_number; }),
             StartsWith("body 0: v is (nan, 0, 0)"));
}

TEST_CASE("a step refuses a joint by number, member and value and changes no bit of the world") {
  CHECK_THAT(said([](Zoo& zoo) { zoo.world.bodies.remove(zoo.hinge->body2); }),
             StartsWith("joint 2: body2: this id names no body"));
  CHECK_THAT(said([](Zoo& zoo) { zoo.weld->body2 = zoo.weld->body1; }),
             StartsWith("joint 4: body2: a joint needs two different bodies"));
  for (const real bad : {no_number, unbounded, real(-0.1), real(11)})
    CHECK_THAT(said([=](Zoo& zoo) { zoo.hinge->beta = bad; }), StartsWith("joint 2: beta is "));
  for (const real bad : {no_number, unbounded, real(-0.1)}) {
    CHECK_THAT(said([=](Zoo& zoo) { zoo.rod->frequency = bad; }), StartsWith("joint 1: frequency"));
    CHECK_THAT(said([=](Zoo& zoo) { zoo.rod->damping = bad; }), StartsWith("joint 1: damping is "));
  }
  for (const real bad : {no_number, unbounded}) {
    CHECK_THAT(said([=](Zoo& zoo) { zoo.ball->part.anchor2_local.x = bad; }),
               StartsWith("joint 0: anchor2_local is ("));
    CHECK_THAT(said([=](Zoo& zoo) { zoo.rod->part.anchor1_local.z = bad; }),
               StartsWith("joint 1: anchor1_local is ("));
    CHECK_THAT(said([=](Zoo& zoo) { zoo.hinge->first.anchor1_local.x = bad; }),
               StartsWith("joint 2: anchor1_local is ("));
    CHECK_THAT(said([=](Zoo& zoo) { zoo.hinge->second.b_local.y = bad; }),
               StartsWith("joint 2: b_local is ("));
    CHECK_THAT(said([=](Zoo& zoo) { zoo.hinge->second.c_local.y = bad; }),
               StartsWith("joint 2: c_local is ("));
    Zoo zoo;
    HingeAngle angle = zoo.hinge->coordinate(), count = angle;
    Slide slide = zoo.slider->coordinate();
    angle.start.w = count.expected = slide.a1_local.x = bad;
    CHECK_THAT(refusal([&] { zoo.hinge->set_coordinate(angle); }), StartsWith("start is ("));
    CHECK_THAT(refusal([&] { zoo.hinge->set_coordinate(count); }), StartsWith("expected is "));
    CHECK_THAT(refusal([&] { zoo.slider->set_coordinate(slide); }), StartsWith("a1_local is ("));
    CHECK_THAT(said([=](Zoo& zoo) { zoo.slider->first.n1_local.x = bad; }),
               StartsWith("joint 3: n1_local is ("));
    CHECK_THAT(said([=](Zoo& zoo) { zoo.slider->first.n2_local.x = bad; }),
               StartsWith("joint 3: n2_local is ("));
    CHECK_THAT(said([=](Zoo& zoo) { zoo.weld->weld.second.start.x = bad; }),
               StartsWith("joint 4: start is ("));
    CHECK_THAT(said([=](Zoo& zoo) { zoo.contact->friction = bad; }),
               StartsWith("joint 5: friction is "));
    CHECK_THAT(said([=](Zoo& zoo) { zoo.contact->restitution = bad; }),
               StartsWith("joint 5: restitution is "));
    CHECK_THAT(said([=](Zoo& zoo) { zoo.contact->top.height = bad; }),
               StartsWith("joint 5: top.height is "));
  }
  CHECK(said([](Zoo& zoo) { zoo.contact->friction = -1; }) ==
        "joint 5: friction is -1; must be finite and not negative [1]");
  CHECK_THAT(said([](Zoo& zoo) { zoo.contact->restitution = 50; }),
             StartsWith("joint 5: restitution is 50"));
  CHECK_THAT(said([](Zoo& zoo) { zoo.contact->top.half_x = no_number; }),
             StartsWith("joint 5: top.half_x is nan"));
  CHECK_THAT(said([](Zoo& zoo) { zoo.rod->part.length = 0; }),
             StartsWith("joint 1: length is 0"));
}

TEST_CASE("a contact with a top or an outline that is no number is not added") {
  Zoo zoo;
  const auto add = [&](const Top& top, const Outline& outline) {
    const std::string before = bits_of(zoo.world);
    const std::string words =
        refusal([&] { zoo.world.add<GroundContact>(zoo.ground, zoo.free, top, outline); });
    const bool unchanged = bits_of(zoo.world) == before;
    CHECK(unchanged);
    return words;
  };
  const Outline good = box_outline(vec3(1));
  Outline bad = good;
  bad.corners[3].y = no_number;
  CHECK_THAT(add(Top{}, bad), StartsWith("outline.corners is ("));
  CHECK_THAT(add(Top{}, {.count = 1, .radius = no_number}), StartsWith("outline.radius is nan"));
  CHECK_THAT(add({.height = unbounded}, good), StartsWith("top.height is inf"));
  CHECK_THAT(add({.half_x = no_number}, good), StartsWith("top.half_x is nan"));
  CHECK_THAT(add({.half_z = -1}, good), StartsWith("top.half_z is -1"));
  CHECK_THAT(add({.depth = no_number}, good), StartsWith("top.depth is nan"));
}

TEST_CASE("a step refuses bad gravity and bad settings before its first substep") {
  CHECK_THAT(said([](Zoo& zoo) { zoo.world.gravity.x = unbounded; }), StartsWith("gravity is ("));
  for (const real bad : {no_number, real(-1), std::numeric_limits<real>::denorm_min()})
    CHECK_THAT(said([=](Zoo& zoo) { zoo.world.last_h = bad; }), StartsWith("last_h is "));
  for (const real bad : {real(2), real(3)})
    CHECK_THAT(said([=](Zoo& zoo) { zoo.solver.relaxation = bad; }), StartsWith("relaxation is "));
  CHECK_THAT(said([](Zoo& zoo) { zoo.how.projections = -1; }), StartsWith("projections:"));
  for (const real bad : {no_number, unbounded, real(-0.1)})
    CHECK_THAT(said([=](Zoo& zoo) { zoo.how.damping = bad; }), StartsWith("damping is "));
  CHECK_THAT(said([](Zoo& zoo) {
               zoo.how.frequency = std::numeric_limits<real>::min();
               zoo.how.damping = 0;
             }),
             StartsWith("frequency is "));
  Zoo zoo;
  const std::string before = bits_of(zoo.world);
  const auto unchanged = [&] { return bits_of(zoo.world) == before; };
  for (const real bad : {std::numeric_limits<real>::denorm_min(), real(1e-10), real(1e10),
                         std::numeric_limits<real>::max()})
    CHECK_THAT(refusal([&] { step(zoo.world, zoo.solver, bad); }), StartsWith("h is "));
  CHECK_THAT(refusal([&] { step(zoo.world, zoo.solver, real(1e-8), {.substeps = 100}); }),
             StartsWith("h is "));
  for (const real bound : {shortest_step, longest_step})
    CHECK(refusal([&] { check_input(zoo.world, bound); }) == "accepted");
  CHECK(unchanged());
}

TEST_CASE("the Runge-Kutta method refuses without changing a bit, too") {
  Zoo zoo;
  RungeKutta method;
  const auto refused = [&] {
    const std::string before = bits_of(zoo.world);
    const std::string words = refusal([&] { method.step(zoo.world, h); });
    const bool unchanged = bits_of(zoo.world) == before;
    CHECK(unchanged != (words == "accepted"));
    return words;
  };
  CHECK_THAT(refused(), StartsWith("world:"));  // it has limits
  zoo.world.remove(*zoo.hinge);
  zoo.world.remove(*zoo.slider);
  CHECK_THAT(refused(), StartsWith("world:"));  // and a contact
  zoo.world.remove(*zoo.contact);
  zoo.world.bodies[zoo.free].w.x = no_number;
  CHECK_THAT(refused(), StartsWith("body 1: w is (nan"));
  zoo.world.bodies[zoo.free].w.x = 1;
  CHECK(refused() == "accepted");
}

namespace {

// Two boxes that hang from one ceiling, and a third one that falls. A force of the largest number
// makes the first one's velocity infinite.
struct Shared {
  World world;
  BodyId ceiling, pushed, quiet, falling;
  Shared() {
    ceiling = world.add(static_body(vec3(0)));
    pushed = add(-1);
    quiet = add(1);
    falling = world.add(box(1, vec3(1), vec3(0, -5, 0)));
  }
  BodyId add(real x) {
    const BodyId id = world.add(box(real(0.5), vec3(1), vec3(x, -1, 0)));
    world.add<HingeJoint>(ceiling, id, vec3(x, 0, 0), vec3(0, 0, 1));
    return id;
  }
};

// What a step says that overflows; "" where none does.
std::string overflow(const std::function<void()>& step) {
  try {
    step();
  } catch (const std::overflow_error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

namespace {

// A number of one body overflows in a step.
template <class S>
void spreads_no_further() {
  Shared spoilt, whole;
  S solver, other;
  const StepOptions how{.warm_start = true};
  spoilt.world.bodies[spoilt.pushed].force.x = std::numeric_limits<real>::max();
  const std::string words = overflow([&] { step(spoilt.world, solver, h, how); });
  CHECK_THAT(words, StartsWith("body 1: "));
  CHECK_THAT(words, ContainsSubstring("overflowed"));
  step(whole.world, other, h, how);
  const auto same = [&](BodyId id) {
    const int slot = int(id.slot);  // the same in both
    return bytes_of(spoilt.world.bodies.at(slot)) == bytes_of(whole.world.bodies.at(slot));
  };
  CHECK(same(spoilt.ceiling));
  CHECK(same(spoilt.quiet));
  CHECK(same(spoilt.falling));

  const std::string before = bits_of(spoilt.world);  // no step before it is gone
  CHECK_THAT(refusal([&] { step(spoilt.world, solver, h, how); }), StartsWith("body 1: "));
  const bool unchanged = bits_of(spoilt.world) == before;
  CHECK(unchanged);
  spoilt.world.remove(spoilt.pushed);
  whole.world.remove(whole.pushed);
  for (int n = 0; n < 60; ++n) {
    CHECK(overflow([&] { step(spoilt.world, solver, h, how); }) == "");
    step(whole.world, other, h, how);
  }
  CHECK(same(spoilt.ceiling));
  CHECK(same(spoilt.quiet));
  CHECK(same(spoilt.falling));
}

}  // namespace

TEST_CASE("a number that overflows within a step is told with its body and spreads no further") {
  spreads_no_further<SequentialImpulses>();
  spreads_no_further<PackedImpulses>();
  spreads_no_further<DirectSolver>();
}

TEST_CASE("of a pose or a velocity that is no number, whichever it is, the end of a step tells") {
  for (int k = 0; k < 13; ++k) {
    Zoo zoo;
    CHECK(overflow([&] { check_motion(zoo.world.bodies); }) == "");
    Body& body = zoo.world.bodies[zoo.free];
    real& one = k < 3 ? body.x[k] : k < 7 ? body.q[k - 3] : k < 10 ? body.v[k - 7] : body.w[k - 10];
    one = no_number;
    CHECK_THAT(overflow([&] { check_motion(zoo.world.bodies); }), StartsWith("body 1: "));
  }
}

TEST_CASE("put right again, a body that overflowed goes on cold as if nothing had been") {
  const auto check = [](auto solver) {
    Shared spoilt, whole;
    const Body good = whole.world.bodies[whole.pushed];
    spoilt.world.bodies[spoilt.pushed].force.x = std::numeric_limits<real>::max();
    CHECK(overflow([&] { step(spoilt.world, solver, h, {.warm_start = true}); }) != "");
    for (int slot = 0; slot < whole.world.bodies.slots(); ++slot)
      spoilt.world.bodies.at(slot) = whole.world.bodies.at(slot);
    spoilt.world.bodies[spoilt.pushed] = good;
    for (int n = 0; n < 10; ++n) {
      CHECK(overflow([&] { step(spoilt.world, solver, h); }) == "");
      step(whole.world, solver, h);
    }
    CHECK(bytes_of(spoilt.world.bodies[spoilt.pushed]) ==
          bytes_of(whole.world.bodies[whole.pushed]));
    const auto forces = [](const Shared& shared) {
      return static_cast<const HingeJoint&>(*shared.world.joints().front()).forces();
    };
    CHECK(forces(spoilt) == forces(whole));
  };
  check(SequentialImpulses());
  check(PackedImpulses());
}

TEST_CASE("what overflows is told at the end of its substep, whichever solver moved the bodies") {
  SequentialImpulses sequential;
  PackedImpulses packed;
  DirectSolver direct;
  for (Solver* solver : {static_cast<Solver*>(&sequential), static_cast<Solver*>(&packed),
                         static_cast<Solver*>(&direct)})
    for (const bool free : {false, true}) {
      Shared shared;
      const BodyId id = free ? shared.falling : shared.pushed;
      shared.world.bodies[id].force.y = std::numeric_limits<real>::max();
      shared.world.bodies[id].inverse_mass = 10;
      CHECK_THAT(overflow([&] { step(shared.world, *solver, h, {.substeps = 4}); }),
                 ContainsSubstring("overflowed"));
      CHECK(shared.world.last_h == h / 4);
    }
  Shared shared;
  RungeKutta method;
  shared.world.bodies[shared.falling].inverse_mass = 10;
  shared.world.bodies[shared.falling].force.y = std::numeric_limits<real>::max();
  CHECK_THAT(overflow([&] { method.step(shared.world, h); }), StartsWith("body 3: "));
}
