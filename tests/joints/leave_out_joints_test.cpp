// What a hinge, a slider or a weld does not need at a moment costs nothing: no row for a limit that
// is far away, for a motor that is off or for bodies that cannot move, no linear half of rows that
// only turn.
#include "engine/instruments/plan.h"
#include "tests/oracle/allocations.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;
const vec3 along(1, 2, 2);  // axis of the hinges, direction of the sliders

// A static body and one that moves, joined by one joint in a pose that is not special.
template <class J>
struct One {
  World world;
  BodyId base, body;
  J& joint;
  explicit One(bool static_body2 = false)
      : base(world.add(static_body(vec3(0), rotation(vec3(1, 0, real(0.5)))))),
        body(world.add(static_body2 ? static_body(vec3(1, 0, 0))
                                    : box(2, vec3(1, real(0.5), real(0.2)), vec3(1, 0, 0)))),
        joint(make()) {
    world.gravity = vec3(0);
  }
  J& make() {
    if constexpr (std::is_same_v<J, FixedJoint>)
      return world.add<J>(base, body, vec3(real(0.5), 0, 0));
    else
      return world.add<J>(base, body, vec3(real(0.5), 0, 0), along);
  }
  // Gives the free coordinate this rate [rad/s or m/s].
  void drive(real rate) {
    const vec3 a = normalize(along);
    Body& b = world.bodies[body];
    if constexpr (std::is_same_v<J, HingeJoint>) {
      b.w = rate * a;
      b.v = cross(b.w, vec3(real(0.5), 0, 0));
    } else {
      b.v = rate * a;
    }
  }
  // The blocks of a step that begins now.
  std::vector<Block> blocks() {
    Blocks out;
    joint.begin_step(world.bodies, h);
    joint.append(world.bodies, out);
    return out.list;
  }
  int rows() {
    int count = 0;
    for (const Block& block : blocks()) count += block.rows;
    return count;
  }
};

template <class J>
void check_limit_and_motor_rows() {
  for (bool whole : {false, true}) {
    One<J> one;
    one.joint.whole = whole;
    const int rigid_blocks = whole ? 1 : 2;
    const auto blocks = [&] { return int(one.blocks().size()); };
    CHECK(one.rows() == 5);
    CHECK(blocks() == rigid_blocks);

    one.joint.set_limits(-1, 1);  // far away on both sides
    CHECK(one.rows() == 5);
    CHECK(blocks() == rigid_blocks);
    one.joint.set_motor(7, 0);  // off, whatever its speed
    CHECK(one.rows() == 5);
    CHECK(blocks() == rigid_blocks);

    one.joint.set_motor(7, 3);
    CHECK(one.rows() == 6);
    CHECK(blocks() == rigid_blocks + 1);
    one.drive(100);  // reaches the upper limit in this step
    CHECK(one.rows() == 7);
    CHECK(blocks() == (whole ? 2 : 4));
    one.drive(-100);
    CHECK(one.rows() == 7);

    one.joint.set_motor(7, 0);
    one.drive(0);
    CHECK(one.rows() == 5);
    one.joint.set_limits(0, 1);  // at rest at the lower one
    CHECK(one.rows() == 6);
    one.joint.set_limits(real(0.3), real(0.3));  // equal: held there, from however far
    CHECK(one.rows() == 6);
    one.joint.clear_limits();
    CHECK(one.rows() == 5);
  }
}

template <class J>
void check_nothing_between_statics() {
  for (bool whole : {false, true}) {
    One<J> one(true);
    one.joint.whole = whole;
    if constexpr (!std::is_same_v<J, FixedJoint>) {
      one.joint.set_limits(0, 0);
      one.joint.set_motor(1, 1);
    }
    CHECK(one.blocks().empty());
    SequentialImpulses solver;
    step(one.world, solver, h);
    CHECK(one.world.blocks.list.empty());  // no late limits either
    CHECK(one.world.blocks.rows() == 0);
    CHECK(plan(one.world, false).rows == 0);
    if constexpr (!std::is_same_v<J, FixedJoint>) one.joint.set_limits(1, 2);  // 1 away from them
    step(one.world, solver, h);
    CHECK(one.world.blocks.list.empty());
    CHECK(plan(one.world, false).live_limits == 0);
  }
}

// A joint at rest, 0.05 from its upper limit, whose body a neighbour drives at `rate`.
// Returns how many blocks the late limits added.
template <class J>
int late_blocks(real rate, bool limited) {
  One<J> one;
  if (limited) one.joint.set_limits(-1, real(0.05));
  auto& neighbour = one.world.template add<AnyJoint<1>>(one.base, one.body);
  const Body &base = one.world.bodies[one.base], &body = one.world.bodies[one.body];
  neighbour.J[0] = one.joint.coordinate().jacobian(base, body);
  neighbour.target = {.rate = rate, .lower = -100000, .upper = 100000};
  Blocks before;
  for (const auto& joint : one.world.joints()) {
    joint->begin_step(one.world.bodies, h);
    joint->append(one.world.bodies, before);
  }
  SequentialImpulses solver;
  step(one.world, solver, h);
  const real next = one.joint.position(one.world.bodies);
  if (limited) CHECK(double(next) < 0.05 + tolerance(1e-4, 1e-4));  // the late row held it
  return int(one.world.blocks.list.size() - before.list.size());
}

template <class J>
void check_late_limits() {
  CHECK(late_blocks<J>(0, true) == 0);
  CHECK(late_blocks<J>(real(2.9), true) == 0);   // 0.048 in a step: just not there
  CHECK(late_blocks<J>(real(3.1), true) == 1);   // 0.052: past it
  CHECK(late_blocks<J>(real(-3.1), true) == 0);  // the other limit is far away
  CHECK(late_blocks<J>(real(-90), true) == 1);   // and this reaches it
  CHECK(late_blocks<J>(20, false) == 0);
}

// Hinges, sliders and welds in a chain, some limited, some driven, some as several blocks.
struct Machine {
  World world;
  std::vector<BodyId> ids;
  std::vector<HingeJoint*> hinges;
  std::vector<SliderJoint*> sliders;
  Machine() {
    ids.push_back(world.add(static_body(vec3(0))));
    for (int k = 1; k <= 8; ++k) {
      ids.push_back(world.add(box(1, vec3(real(0.8), real(0.4), real(0.3)), vec3(real(k), 0, 0))));
      const BodyId a = ids[std::size_t(k) - 1], b = ids.back();
      const vec3 anchor(real(k) - real(0.5), 0, 0), axis(0, real(k % 2), 1);
      if (k % 3 == 1)
        hinges.push_back(&world.add<HingeJoint>(a, b, anchor, axis));
      else if (k % 3 == 2)
        sliders.push_back(&world.add<SliderJoint>(a, b, anchor, axis));
      else
        world.add<FixedJoint>(a, b, anchor).whole = k % 2 == 0;
    }
    hinges[1]->whole = sliders[0]->whole = false;
  }
  void set_in_motion(real speed) {
    for (HingeJoint* hinge : hinges) {
      hinge->set_limits(real(-0.3), real(0.3));
      hinge->set_motor(speed, 40);
    }
    for (SliderJoint* slider : sliders) {
      slider->set_limits(real(-0.1), real(0.2));
      slider->set_motor(-speed, 60);
    }
  }
};

}  // namespace

TEST_CASE("a hinge has no row for a limit out of reach or a motor without strength") {
  check_limit_and_motor_rows<HingeJoint>();
}

TEST_CASE("a slider has no row for a limit out of reach or a motor without strength") {
  check_limit_and_motor_rows<SliderJoint>();
}

TEST_CASE("hinge and slider and weld between two static bodies append nothing") {
  check_nothing_between_statics<HingeJoint>();
  check_nothing_between_statics<SliderJoint>();
  check_nothing_between_statics<FixedJoint>();
}

TEST_CASE("a late limit gets a row only when a neighbour drives the joint past it") {
  check_late_limits<HingeJoint>();
  check_late_limits<SliderJoint>();
}

TEST_CASE("what only turns says so and keeps the velocity to the last bit") {
  One<HingeJoint> hinge;
  hinge.joint.whole = false;
  hinge.joint.set_limits(0, 1);
  hinge.joint.set_motor(1, 1);
  const std::vector<Block> list = hinge.blocks();
  REQUIRE(list.size() == 4);
  CHECK(list[0].form == Form::angular);  // motor
  CHECK(list[1].form == Form::angular);  // limit
  CHECK(list[2].form == Form::point);
  CHECK(list[3].form == Form::angular);  // axis
  hinge.joint.whole = true;
  const std::vector<Block> in_one = hinge.blocks();
  REQUIRE(in_one.size() == 2);
  CHECK(in_one[0].form == Form::angular);
  CHECK(in_one[1].form == Form::point);

  One<SliderJoint> slider;
  slider.joint.whole = false;
  slider.joint.set_limits(0, 1);
  slider.joint.set_motor(1, 1);
  const std::vector<Block> rows = slider.blocks();
  REQUIRE(rows.size() == 4);
  for (std::size_t k : {0, 1, 2}) CHECK(rows[k].form == Form::any);  // motor, limit, line
  CHECK(rows[3].form == Form::angular);                               // lock

  One<FixedJoint> fixed;
  fixed.joint.whole = false;
  REQUIRE(fixed.blocks().size() == 2);
  CHECK(fixed.blocks()[0].form == Form::point);
  CHECK(fixed.blocks()[1].form == Form::angular);

  // a motor alone, on a body that flies: it is turned and its flight is not touched
  World world = weightless();
  const BodyId base = world.add(static_body(vec3(0)));
  const BodyId body = world.add(box(2, vec3(1, real(0.5), real(0.2)), vec3(1, 0, 0)));
  auto& motor = world.add<AnyJoint<1>>(base, body);
  motor.J[0] = hinge.joint.coordinate().jacobian(world.bodies[base], world.bodies[body]);
  motor.target = {.rate = 5, .lower = -100, .upper = 100};
  const vec3 v(real(0.1), real(0.2), real(0.3));
  world.bodies[body].v = v;
  SequentialImpulses solver;
  step(world, solver, h);
  CHECK(world.bodies[body].v == v);
  CHECK(length(world.bodies[body].w) > 1);
}

TEST_CASE("the plan line counts limits that have a row and limits that wait and running motors") {
  Machine machine;  // 3 hinges, 3 sliders, 2 welds, of which hinge 2, slider 1 and weld 1 apart
  CHECK(plan(machine.world, false).line() ==
        "bodies 9 (1 static), blocks 11, rows 42");
  machine.hinges[0]->set_limits(-1, 1);             // waits
  machine.hinges[1]->set_limits(0, 1);              // has a row
  machine.sliders[2]->set_limits(0, 0);             // always has a row
  machine.hinges[2]->set_motor(3, 0);               // off
  machine.sliders[0]->set_motor(real(0.001), 100);  // runs
  machine.world.gravity = vec3(0);
  step_once(machine.world, h);
  CHECK(plan(machine.world, true).line() ==
        "bodies 9 (1 static), blocks 13, rows 45, limits 2 of 3, motors 1, warm");
}

TEST_CASE("driven joints take nothing from the heap once all their rows have been live") {
  for (bool warm : {false, true})
    for (bool row_by_row : {false, true}) {
      Machine machine;
      SequentialImpulses solver;
      StepOptions stepping;
      solver.iterations = 5;
      stepping.warm_start = warm;
      stepping.row_by_row = row_by_row;
      step(machine.world, solver, h, stepping);  // no limit, no motor so far
      int most_live = 0;
      long taken = 0;
      for (int n = 0; n < 240; ++n) {
        if (n == 120) taken = 0;
        if (n % 40 == 0)  // switched on, then turned round
          taken += allocations_of([&] { machine.set_in_motion(n % 80 == 0 ? 3 : -3); });
        taken += allocations_of([&] { step(machine.world, solver, h, stepping); });
        most_live = std::max(most_live, plan(machine.world, warm).live_limits);
      }
      CHECK(taken == 0);
      CHECK(most_live > 0);  // rows did come and go
      CHECK(finite(machine.world.bodies[machine.ids.back()].x));
    }
}
