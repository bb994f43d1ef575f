// The stability suite, case X14: the same joint twice, closed loops, beams that are held at both
// ends. More rows than freedoms must not blow up nor change the motion.
#include "engine/kept/reaction.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;

long rank_of_rows(const World& world) {
  return rank_of(system_of(world.blocks, world.bodies.slots()).J, tolerance(1e-9, 1e-4));
}

// A box held to a wall by one joint or by the same joint twice.
template <class Add>
World held(int times, const vec3& gravity, Add add) {
  World world;
  world.gravity = gravity;
  const BodyId wall = world.add(static_body(vec3(0)));
  const BodyId body = world.add(box(3, vec3(1, real(0.6), real(0.4)), vec3(1, real(0.1), 0)));
  for (int k = 0; k < times; ++k) add(world, wall, body);
  return world;
}

// Both run side by side: the second is to do what the first does. Apart, two joints are as good as
// twice the iterations, so that they agree only as far as those have settled.
template <class Add>
void check_twice_is_once(const vec3& gravity, bool warm, bool whole, Add add) {
  const double near = whole ? tolerance(1e-9, 2e-3) : 2e-3;
  World once = held(1, gravity, add), twice = held(2, gravity, add);
  SequentialImpulses solver_once, solver_twice;
  StepOptions stepping{.warm_start = warm};
  double largest = 0;
  for (int n = 0; n < 300; ++n) {
    step(once, solver_once, h, stepping);
    step(twice, solver_twice, h, stepping);
    REQUIRE(all_finite(twice));
    largest = std::max(largest, largest_impulse(twice));
    const Body &a = once.bodies.at(1), &b = twice.bodies.at(1);
    CHECK(double(length(a.x - b.x)) < near);
    CHECK(double(length(a.w - b.w)) < 10 * near);
  }
  CHECK(largest < 3 * 10 * double(h) * 40);  // a few times the weight, swings included
  // both together bear what the one bears alone
  const Reaction one = reaction(*once.joints()[0], once.bodies);
  const Reaction first = reaction(*twice.joints()[0], twice.bodies);
  const Reaction second = reaction(*twice.joints()[1], twice.bodies);
  CHECK(double(length(first.force + second.force - one.force)) < 300 * near);
  CHECK(double(length(first.torque + second.torque - one.torque)) < 300 * near);
}

// What holds two bars together.
struct Pin {
  void (*add)(World& world, BodyId a, BodyId b, const vec3& anchor);
  const Point& (*point)(const Joint& joint);
  bool hinges;
};
template <bool whole>
void add_hinge(World& world, BodyId a, BodyId b, const vec3& anchor) {
  world.add<HingeJoint>(a, b, anchor, vec3(0, 0, 1)).whole = whole;
}
const Point& point_of_hinge(const Joint& joint) {
  return static_cast<const HingeJoint&>(joint).first;
}
const Pin pins[] = {
    {[](World& world, BodyId a, BodyId b, const vec3& anchor) {
       world.add<BallJoint>(a, b, point_at(world.bodies[a], world.bodies[b], anchor));
     },
     [](const Joint& joint) -> const Point& { return static_cast<const BallJoint&>(joint).part; },
     false},
    {add_hinge<true>, point_of_hinge, true},
    {add_hinge<false>, point_of_hinge, true}};

}  // namespace

TEST_CASE("X14 two identical hinges or sliders or welds do what one does") {
  for (bool warm : {false, true})
    for (bool whole : {true, false}) {
      CAPTURE(warm, whole);
      const vec3 anchor(real(0.2), 0, real(0.1)), down(0, real(-9.81), 0);
      const auto check = [&](const vec3& gravity, auto add) {
        check_twice_is_once(gravity, warm, whole || warm, add);
      };
      check(down, [=](World& world, BodyId a, BodyId b) {
        auto& hinge = world.add<HingeJoint>(a, b, anchor, vec3(0, real(0.3), 1));
        hinge.whole = whole || warm;  // apart and warm the blocks are out of the criterion
        hinge.set_limits(-unbounded, real(0.2));
      });
      check(down, [=](World& world, BodyId a, BodyId b) {
        auto& slider = world.add<SliderJoint>(a, b, anchor, vec3(1, -1, 0));
        slider.whole = whole || warm;
        slider.set_limits(-unbounded, 2);
      });
      check(down + vec3(1, 0, 0), [=](World& world, BodyId a, BodyId b) {
        world.add<FixedJoint>(a, b, anchor).whole = whole || warm;
      });
    }
}

TEST_CASE("X14 a four-bar of ball joints or hinges swings as far as its bars let it and closes") {
  // ground, two cranks of 1 m, a coupler of 2 m: three bodies, on hinges one freedom
  for (const Pin& kind : pins) {
    World world;
    const BodyId ground = world.add(static_body(vec3(0)));
    const auto bar = [&](const vec3& x, real length, const quat& q) {
      return world.add(box(length, vec3(length, real(0.1), real(0.1)), x, q));
    };
    const quat up = rotation(vec3(0, 0, 90 * degree));
    const BodyId left = bar(vec3(0, real(-0.5), 0), 1, up);
    const BodyId right = bar(vec3(2, real(-0.5), 0), 1, up);
    const BodyId coupler = bar(vec3(1, -1, 0), 2, quat(1, 0, 0, 0));
    kind.add(world, ground, left, vec3(0));
    kind.add(world, ground, right, vec3(2, 0, 0));
    kind.add(world, left, coupler, vec3(0, -1, 0));
    kind.add(world, right, coupler, vec3(2, -1, 0));
    world.bodies[coupler].v = vec3(2, 0, 0);
    world.bodies[left].w = world.bodies[right].w = vec3(0, 0, 2);
    world.bodies[left].v = world.bodies[right].v = vec3(1, 0, 0);
    SequentialImpulses solver;
    double highest = -1, impulse = 0, gap = 0;
    for (int n = 0; n < 600; ++n) {
      step(world, solver, h);
      REQUIRE(all_finite(world));
      if (n == 20 && kind.hinges) CHECK(rank_of_rows(world) == 17);  // of 20
      impulse = std::max(impulse, largest_impulse(world));  // weight of all is 0.65 N s a step
      highest = std::max(highest, double(world.bodies[coupler].x.y));
      for (const auto& joint : world.joints())
        gap = std::max(gap, double(length(kind.point(*joint).error(world.bodies[joint->body1],
                                                                   world.bodies[joint->body2]))));
    }
    // energy 2 kg 2 m/s and 2 x 1/3 kg m^2 (2 rad/s)^2 /2: lifts 2 kg by z and 2 kg by z/2
    CHECK(highest == Approx(-1 + (4 + 4.0 / 3) / (3 * 9.81)).epsilon(0.02));
    CHECK(impulse < 5);
    CHECK(gap < 0.02);
  }
}

TEST_CASE("X14 a beam that is welded at both ends stays where it is and bears its weight") {
  for (bool warm : {false, true}) {
    World world;
    std::vector<BodyId> ids;
    for (int k = 0; k < 5; ++k) {
      const vec3 x(real(k), 0, 0);
      ids.push_back(world.add(k == 0 || k == 4 ? static_body(x) : box(2, vec3(real(0.8)), x)));
    }
    std::vector<FixedJoint*> welds;
    for (std::size_t k = 1; k < 5; ++k)
      welds.push_back(&world.add<FixedJoint>(ids[k - 1], ids[k],
                                             vec3(real(k) - real(0.5), 0, 0)));
    SequentialImpulses solver;
    StepOptions stepping{.warm_start = warm};
    solver.iterations = 200;
    for (int n = 0; n < 300; ++n) {
      if (n == 60) world.bodies[ids[2]].v = vec3(3, 5, -8);  // a blow
      step(world, solver, h, stepping);
      REQUIRE(all_finite(world));
      REQUIRE(largest_impulse(world) < 200);
    }
    for (int k = 1; k < 4; ++k)
      CHECK(double(length(world.bodies[ids[std::size_t(k)]].x - vec3(real(k), 0, 0))) < 1e-3);
    const Reaction first = welds.front()->load(), last = welds.back()->load();
    CHECK(double(first.force.y - last.force.y) == Approx(6 * 9.81).epsilon(1e-3));
    CHECK(double(first.force.y) > 2 * 9.81);  // how they share it, rigid bodies leave open
    CHECK(double(-last.force.y) > 2 * 9.81);
  }
}

TEST_CASE("X14 four ball joints or hinges between static ends are kicked and stay in bounds") {
  for (const Pin& kind : pins) {
    World world;
    std::vector<BodyId> ids;
    for (int k = 0; k < 5; ++k) {
      const vec3 x(real(k), 0, 0);
      ids.push_back(world.add(k == 0 || k == 4 ? static_body(x) : box(1, vec3(real(0.8)), x)));
    }
    for (std::size_t k = 1; k < 5; ++k)  // anchors in the centre of the one before, as in T 5.1
      kind.add(world, ids[k - 1], ids[k], world.bodies[ids[k - 1]].x);
    SequentialImpulses solver;
    double impulse = 0, speed = 0;
    for (int n = 0; n < 600; ++n) {
      if (n == 60) world.bodies[ids[1]].v = vec3(3, 5, -8);
      step(world, solver, h);
      REQUIRE(all_finite(world));
      impulse = std::max(impulse, largest_impulse(world));
      if (n > 300)
        for (BodyId id : ids) speed = std::max(speed, double(length(world.bodies[id].v)));
    }
    CHECK(impulse < 100);
    CHECK(speed < 10);  // never faster than it was kicked
  }
}
