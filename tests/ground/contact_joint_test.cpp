// The contact as a joint of the engine: which corners have rows, which of their data are kept, and
// the effects of projection, reaction, plan and removal.
#include "checker/numeric.h"
#include "engine/instruments/plan.h"
#include "engine/kept/reaction.h"
#include "engine/kept/state.h"
#include "tests/ground/rigs.h"
#include "tests/oracle/test.h"

using Catch::Matchers::StartsWith;

namespace {

const real h = real(1) / 60;
const real no_number = std::numeric_limits<real>::quiet_NaN();

// The blocks of a step that begins now.
std::vector<Block> blocks_now(Grounded& box) {
  Blocks out;
  box.contact->begin_step(box.world.bodies, h);
  box.contact->append(box.world.bodies, out);
  return out.list;
}

// A box that is turned over so that this many corners are lowest, at this gap.
Grounded with_lowest(int corners, real gap = 0) {
  const real lean = real(0.5);
  const vec3 turns[] = {vec3(0), vec3(lean, 0, lean), vec3(lean, 0, 0), vec3(0), vec3(0)};
  return {lowered(gap, rotation(turns[corners])), box_outline(brick)};
}

}  // namespace

TEST_CASE("X16 a contact of a body with itself or with none is refused") {
  Grounded box = standing();
  const auto add = [&](BodyId a, BodyId b) {
    return refusal([&] { box.world.add<GroundContact>(a, b, Top{}, box_outline(brick)); });
  };
  CHECK_THAT(add(box.body, box.body), StartsWith("body2:"));
  CHECK_THAT(add(box.ground, BodyId{7, 1}), StartsWith("body"));
  CHECK_THAT(add(BodyId{}, box.body), StartsWith("body"));
  CHECK(box.world.joints().size() == 1);
}

TEST_CASE("X16 an outline without corners or with too many, of no size or no number is refused") {
  Grounded box = standing();
  for (const int count : {0, -1, 9}) {
    Outline outline = box_outline(brick);
    outline.count = count;
    CHECK_THAT(refusal([&] {
                 box.world.add<GroundContact>(box.ground, box.body, Top{}, outline);
               }),
               StartsWith("outline:"));
  }
  for (const real bad : {real(0), real(-1), no_number, unbounded}) {
    CHECK_THAT(refusal([&] { ball_outline(bad); }), StartsWith("radius:"));
    for (int k = 0; k < 3; ++k) {
      vec3 size = brick;
      size[k] = bad;
      CHECK_THAT(refusal([&] { box_outline(size); }), StartsWith("size:"));
    }
  }
  CHECK(box.world.joints().size() == 1);
}

TEST_CASE("each corner that touches has friction, friction and normal, and no more than four do") {
  for (const auto& [lowest, corners] : {std::pair{1, 1}, {2, 2}, {4, 4}}) {
    Grounded box = with_lowest(lowest);
    const std::vector<Block> blocks = blocks_now(box);
    CHECK(box.contact->touching() == corners);
    REQUIRE(int(blocks.size()) == 3 * corners);
    for (std::size_t k = 0; k < blocks.size(); ++k) {
      CHECK(blocks[k].rows == 1);
      CHECK(blocks[k].settings.follows == int(k % 3 == 2 ? 0 : 2 - k % 3));
      CHECK(blocks[k].settings.holds_position == (k % 3 == 2));
    }
  }
  Grounded sunk = with_lowest(4, real(-2));  // all eight under the top
  CHECK(int(blocks_now(sunk).size()) == 3 * GroundContact::most_corners);
  CHECK(int(blocks_now(sunk).size()) == 3 * GroundContact::most_corners);
  sunk.contact->friction = 0;
  CHECK(int(blocks_now(sunk).size()) == GroundContact::most_corners);
}

TEST_CASE("of a sunk box the four deepest corners have the rows") {
  Grounded box = with_lowest(4, real(-2));
  Blocks blocks;
  box.contact->begin_step(box.world.bodies, h);
  box.contact->append(box.world.bodies, blocks);
  for (const Block& block : blocks.list)
    if (block.settings.follows == 0)
      CHECK(double(blocks.C[std::size_t(block.first)]) == Approx(-2));
}

TEST_CASE("a corner has rows from the step in which it would come within h times 0.1 m/s") {
  for (const auto& [gap, speed, expected] :
       {std::tuple{0.05, 0.0, 0}, {0.05, -2.8, 0}, {0.05, -2.95, 1}, {0.05, -3.1, 1},
        {-0.01, 0.8, 0}, {-0.01, 0.65, 1}}) {
    Grounded box = with_lowest(1, real(gap));
    box.it().v.y = real(speed);
    CAPTURE(gap, speed);
    CHECK(int(blocks_now(box).size()) == 3 * expected);
  }
  const real radius = real(0.1);  // of a ball, whose lowest point is as near as it may be
  for (const real reach : {real(0.9), real(1.1)}) {
    Grounded one(ball(1, radius, vec3(0, radius + reach * real(0.1) * h, 0)), ball_outline(radius));
    CHECK(blocks_now(one).size() == (reach < 1 ? 3u : 0u));
  }
}

TEST_CASE("a point has rows over the top and none beside it, along either axis") {
  const real radius = real(0.1);
  for (const vec3& x : {vec3(1, radius, 0), vec3(0, radius, 1), vec3(0, radius, 0)})
    for (const bool along_x : {false, true}) {
      Grounded one(ball(1, radius, x), ball_outline(radius), 0,
                   along_x ? Top{.half_x = real(0.5)} : Top{.half_z = real(0.5)});
      CHECK(blocks_now(one).size() == ((along_x ? x.x : x.z) == 0 ? 3u : 0u));
    }
}

TEST_CASE("who is far off is not looked at, and nobody who comes within a step is overlooked") {
  Random random(8);
  int near = 0, none = 0;
  for (int n = 0; n < 2000; ++n) {
    Grounded box(lowered(std::abs(random.vector(1).x), random.turn()), box_outline(brick),
                 real(0.3));
    for (const BodyId id : {box.ground, box.body}) {  // any velocities, of both bodies
      box.world.bodies[id].v = random.vector(40);
      box.world.bodies[id].w = random.vector(20);
    }
    box.it().x += vec3(random.vector(9).x, 0, random.vector(9).z);
    const Body &a = box.world.bodies[box.ground], &b = box.world.bodies[box.body];
    int expected = 0;  // corner by corner, by Eq. 8-4
    for (const vec3& local : box_outline(brick).corners) {
      const Corner corner{local};
      const Row J = corner.jacobian(a, b);
      const real rate = dot(J.v1, a.v) + dot(J.w1, a.w) + dot(J.v2, b.v) + dot(J.w2, b.w);
      expected += corner.error(a, b) + h * rate < real(0.1) * h;
    }
    box.contact->restitution = n % 2 == 0 ? real(0) : real(0.5);
    box.contact->begin_step(box.world.bodies, h);
    REQUIRE(box.contact->touching() == std::min(expected, GroundContact::most_corners));
    expected > 0 ? ++near : ++none;
  }
  CHECK(near > 300);  // both kinds have been met
  CHECK(none > 300);
}

TEST_CASE("X16 a friction that is negative or no number is refused when the step begins") {
  for (const real bad : {real(-0.1), no_number, unbounded}) {
    Grounded box = standing();
    box.contact->friction = bad;
    CHECK_THAT(refusal([&] { step(box.world, box.solver, h, box.stepping); }),
               StartsWith("joint 0: friction is"));
  }
}

TEST_CASE("two static bodies have no rows, however deep they are") {
  World world;
  const BodyId a = world.add(static_body(vec3(0))), b = world.add(static_body(vec3(0)));
  auto& contact = world.add<GroundContact>(a, b, Top{}, box_outline(brick));
  SequentialImpulses solver;
  StepOptions stepping{.projections = 1};
  step(world, solver, h, stepping);
  CHECK(contact.touching() == 0);
  CHECK(world.blocks.list.empty());
  CHECK(world.bodies[b].x == vec3(0));
}

TEST_CASE("warm, a box at rest needs one iteration; cold, one iteration lets it sink") {
  const auto sunk = [](bool warm) {
    Grounded box = standing();
    box.stepping.warm_start = warm;
    box.run(1, h);  // the impulses of the corners find their balance
    box.solver.iterations = 1;
    box.run(10, h);
    return std::abs(double(box.it().x.y) - double(brick.y) / 2);
  };
  CHECK(sunk(true) < tolerance(1e-9, 1e-4));
  CHECK(sunk(false) > 1e-3);
}

TEST_CASE("what a corner gave is forgotten when it leaves and comes again") {
  Grounded box = standing();
  box.stepping.warm_start = true;
  box.run(1, h);
  REQUIRE(touches(box.world.blocks).size() == 4);
  const vec3 rest = box.it().x;
  box.it().x.y += 1;
  step(box.world, box.solver, h, box.stepping);
  CHECK(box.contact->touching() == 0);
  box.it().x = rest;
  box.it().v = vec3(0);
  begin_step(box.world, box.solver, h, box.stepping);
  for (const Touch& touch : touches(box.world.blocks)) {
    CHECK(touch.normal == 0);
    CHECK(touch.friction() == 0);
  }
}

TEST_CASE("cached friction is projected onto the new tangents when the sliding turns") {
  Grounded box = with_lowest(1);
  box.contact->turned_tangents = true;
  const auto cached = [&] {
    Blocks blocks;
    box.contact->append(box.world.bodies, blocks);
    REQUIRE(blocks.list.size() == 3);
    return *blocks.list[0].impulse * blocks.J[0].v2 + *blocks.list[1].impulse * blocks.J[1].v2;
  };
  const auto first_direction = [&] {
    Blocks blocks;
    box.contact->append(box.world.bodies, blocks);
    return blocks.J[0].v2;
  };
  box.it().v = vec3(3, real(-0.5), 0);
  box.stepping.warm_start = true;
  begin_step(box.world, box.solver, h, box.stepping);
  for (int k = 0; k < 30; ++k) box.solver.iterate(box.world.bodies);
  const vec3 before = cached(), direction = first_direction();
  REQUIRE(double(length(before)) > 0.1);
  box.it().v = vec3(1, real(-0.5), 2);  // slides elsewhere now
  box.it().w = vec3(0);
  box.contact->begin_step(box.world.bodies, h);
  CHECK(double(dot(direction, first_direction())) < 0.9);
  CHECK(double(length(cached() - before)) < tolerance(1e-12, 1e-5) * double(length(before)));
  box.it().v = vec3(real(-0.003), real(-0.5), real(0.003));  // at rest: along what holds it
  box.contact->begin_step(box.world.bodies, h);
  CHECK(double(dot(first_direction(), before)) == Approx(-double(length(before))));
}

TEST_CASE("a box driven flat into the ground has rows of four corners, and none once it is gone") {
  Grounded box(lowered(1, quat(1, 0, 0, 0)), box_outline(brick));
  box.world.gravity = vec3(0);
  const BodyId stone = box.world.add(ball(100, real(0.1), box.it().x));
  box.world.bodies[stone].v.y = -200;
  box.world.add<BallJoint>(box.body, stone, Point{});
  step(box.world, box.solver, h, box.stepping);
  CHECK(box.contact->touching() == 4);
  box.it().x.y = 9;
  box.it().v = vec3(0);
  CHECK(blocks_now(box).empty());
}

TEST_CASE("a restored contact tells how many corners touch") {
  Grounded box = standing(), other = standing();
  box.run(0.1, h);
  restore(other.world, save(box.world));
  CHECK(other.contact->touching() == 4);
}

TEST_CASE("the late limits adds a corner that a neighbour drives into the ground") {
  // a fast stone lifts one end of a long box, which turns the other end into the ground
  const vec3 size(4, real(0.2), 1), end(-2, real(0.2), 0);
  const auto driven = [&](bool looks) {
    Grounded lever(box(1, size, vec3(0, real(0.2), 0)), box_outline(size));
    lever.world.gravity = vec3(0);
    const BodyId stone = lever.world.add(ball(100, real(0.1), end));
    lever.world.bodies[stone].v = vec3(0, 24, 0);
    lever.world.add<BallJoint>(lever.body, stone,
                               point_at(lever.it(), lever.world.bodies[stone], end));
    lever.solver.iterations = 300;
    if (looks) {
      step(lever.world, lever.solver, h, lever.stepping);
    } else {  // the same without the late limits
      begin_step(lever.world, lever.solver, h, lever.stepping);
      CHECK(lever.contact->touching() == 0);  // nothing of it moves yet
      for (int k = 0; k < 300; ++k) lever.solver.iterate(lever.world.bodies);
      end_step(lever.world, lever.solver, h, lever.stepping);
    }
    for (const Block& block : lever.world.blocks.list)  // directions of friction
      if (block.settings.follows != 0)
        CHECK(double(length(lever.world.blocks.J[std::size_t(block.first)].v2)) == Approx(1));
    return std::pair{lever.contact->touching(), double(lever.contact->gap(lever.world.bodies))};
  };
  CHECK(driven(false).second < -0.05);
  const auto [touching, gap] = driven(true);
  CHECK(touching == 2);
  CHECK(gap > -0.01);  // what the straight step leaves of a turn by 0.1 rad
}

TEST_CASE("projection lifts a sunk box to the ground and leaves places along it and velocities") {
  const real depth = real(0.01);
  Grounded box = standing(real(0.3));
  box.contact->beta = 0;
  box.world.gravity = vec3(0);
  box.it().x += vec3(0, -depth, 0);
  box.stepping.projections = 20;
  const vec3 before = box.it().x;
  step(box.world, box.solver, h, box.stepping);
  CHECK(double(box.contact->gap(box.world.bodies)) == Approx(0).margin(tolerance(1e-6, 1e-4)));
  CHECK(box.it().x.y > before.y);
  // each corner alone turns the box: what is left of the turns moves the centre by their square
  CHECK(double(std::abs(box.it().x.x) + std::abs(box.it().x.z)) < 1e-4);
  CHECK(double(length(box.it().v)) < tolerance(1e-12, 1e-6));
}

TEST_CASE("projection leaves a box over the ground where it is") {
  Grounded box = standing();
  box.world.gravity = vec3(0);
  box.it().x.y += real(1e-4);  // within reach: it has rows
  const Body before = box.it();
  box.stepping.projections = 5;
  step(box.world, box.solver, h, box.stepping);
  CHECK(box.contact->touching() == 4);
  CHECK(box.it().x == before.x);
  CHECK(box.it().q == before.q);
}

TEST_CASE("the reaction of the ground to a box at rest is its weight, on a slope too") {
  for (const real slope : {real(0), real(0.3)}) {
    Grounded box = standing(0, slope);
    box.stepping.warm_start = true;
    box.run(2, h);
    const Reaction found = reaction(*box.contact, box.world.bodies);
    CHECK(double(length(found.force - vec3(0, real(10 * g), 0))) < tolerance(1e-3, 2e-2));
    CHECK(double(length(found.torque)) < tolerance(1e-3, 2e-2));
  }
}

TEST_CASE("the plan counts a block for every row of a contact, and none in the air") {
  Grounded box = standing();
  box.run(0.1, h);
  CHECK(plan(box.world, false).line() ==
        "bodies 2 (1 static), blocks 12, rows 12");
  box.it().x.y = 5;
  box.run(0.1, h);
  CHECK_THAT(plan(box.world, false).line(), StartsWith("bodies 2 (1 static), blocks 0, rows 0"));
}

TEST_CASE("without its ground a box falls, and without the box nothing is left to do") {
  for (const bool take_ground : {true, false}) {
    Grounded box = standing();
    box.run(0.5, h);
    box.world.remove(take_ground ? box.ground : box.body);
    CHECK(box.world.joints().empty());
    for (int n = 0; n < 30; ++n) step(box.world, box.solver, h, box.stepping);
    if (take_ground) CHECK(double(box.it().x.y) < -0.5);
  }
  Grounded box = standing();
  box.run(0.5, h);
  box.world.remove(*box.contact);
  box.run(0.5, h);
  CHECK(double(box.it().x.y) < -0.5);
}

TEST_CASE("a contact solved row by row is the same: its blocks have one row each") {
  Random random(89);
  Grounded one(lowered(real(0.2), random.turn()), box_outline(brick)), other(one.it(),
                                                                            box_outline(brick));
  other.stepping.row_by_row = true;
  for (int n = 0; n < 120; ++n) {
    step(one.world, one.solver, h, one.stepping);
    step(other.world, other.solver, h, other.stepping);
  }
  CHECK(one.contact->touching() > 0);
  CHECK(one.it().x == other.it().x);
  CHECK(one.it().w == other.it().w);
}

TEST_CASE("the top of a box without size is refused") {
  for (const vec3& size : {vec3(0), vec3(1, -1, 1), vec3(1, unbounded, 1)})
    CHECK_THROWS_AS(box_top(size), std::invalid_argument);
}
