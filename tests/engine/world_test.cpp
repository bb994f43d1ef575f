// What may change between two steps: bodies and joints come and go.
#include "engine/kept/joint_id.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;

// Three balls under a ceiling, each on a rod below the other.
struct Hanging {
  World world;
  BodyId ceiling, id[3];
  CentreDistanceJoint* rod[3];
  Hanging() {
    ceiling = world.add(static_body(vec3(0)));
    for (int k = 0; k < 3; ++k) {
      id[k] = world.add(ball(1, real(0.1), vec3(0, -real(k + 1), 0)));
      rod[k] = &world.add<CentreDistanceJoint>(k ? id[k - 1] : ceiling, id[k], CentreDistance{1});
    }
  }
};

double fall(const Hanging& hanging, int k) {
  return double(hanging.world.bodies[hanging.id[k]].v.y);
}

}  // namespace

TEST_CASE("one beta for a whole world is that of every joint, or nothing changes") {
  Hanging hanging;
  hanging.world.set_beta(real(0.7));
  for (const auto& joint : hanging.world.joints()) CHECK(joint->beta == real(0.7));
  for (const real bad : {real(-0.1), unbounded, std::numeric_limits<real>::quiet_NaN()})
    CHECK_THROWS_AS(hanging.world.set_beta(bad), std::invalid_argument);
  for (const auto& joint : hanging.world.joints()) CHECK(joint->beta == real(0.7));
}

TEST_CASE("a body that goes takes its joints along and what hung from it falls") {
  Hanging hanging;
  SequentialImpulses solver;
  StepOptions stepping{.warm_start = true};
  solver.iterations = 200;
  for (int n = 0; n < 20; ++n) step(hanging.world, solver, h, stepping);
  CHECK(std::abs(fall(hanging, 2)) < tolerance(1e-9, 1e-5));
  hanging.world.remove(hanging.id[1]);
  CHECK(hanging.world.joints().size() == 1);
  CHECK(hanging.world.joints()[0].get() == hanging.rod[0]);
  CHECK(hanging.world.bodies.size() == 3);
  const double before = fall(hanging, 2);
  step(hanging.world, solver, h, stepping);
  CHECK(fall(hanging, 2) - before == Approx(-9.81 / 60).epsilon(tolerance(1e-9, 1e-4)));
  CHECK(std::abs(fall(hanging, 0)) < tolerance(1e-9, 1e-5));
}

TEST_CASE("an id of a joint names it until the joint goes, and is then refused in words") {
  Hanging hanging, other;
  World& world = hanging.world;
  const JointId first = *hanging.rod[0], second = *hanging.rod[1], third = *hanging.rod[2];
  CHECK(&world[first] == hanging.rod[0]);
  CHECK(&world[JointId<>(*hanging.rod[1])] == hanging.rod[1]);
  world.remove(first);
  CHECK_FALSE(world.alive(first));
  CHECK(&world[third] == hanging.rod[2]);  // the others keep their ids
  const std::string gone = "joint: this world has no such joint (removed, or of another one)";
  CHECK_THROWS_WITH(world[first], gone);
  CHECK_THROWS_WITH(world.remove(first), gone);
  CHECK_THROWS_WITH(other.world[third], gone);
  CHECK_THROWS_WITH(world[JointId<BallJoint>()], gone);
  JointId<BallJoint> ball;
  ball.number = third.number;  // of another kind
  CHECK_THROWS_WITH(world[ball], gone);
  world.remove(hanging.id[2]);  // with the joints of this body
  CHECK_FALSE(world.alive(third));
  CHECK(world.joints().size() == 1);
  world.remove(second);
  CHECK(world.joints().empty());
  const auto& next = world.add<CentreDistanceJoint>(hanging.ceiling, hanging.id[0],
                                                    CentreDistance{1});
  CHECK(&world[JointId(next)] == &next);
  CHECK_FALSE(world.alive(first));  // its number is not given again
}

TEST_CASE("a slot that became free is given to the next body and old ids are refused") {
  Hanging hanging;
  Bodies& bodies = hanging.world.bodies;
  const BodyId old = hanging.id[1];
  hanging.world.remove(old);
  CHECK_FALSE(bodies.alive(old));
  CHECK_FALSE(bodies.used(int(old.slot)));
  CHECK(bodies.at(int(old.slot)).is_static());  // an empty slot is nothing that could fall
  CHECK_THROWS_AS(bodies[old], std::invalid_argument);
  CHECK_THROWS_AS(hanging.world.remove(old), std::invalid_argument);
  CHECK(bodies.size() == 3);
  const BodyId next = hanging.world.add(ball(5, 1, vec3(7, 0, 0)));
  CHECK(next.slot == old.slot);
  CHECK(next.generation != old.generation);
  CHECK(bodies.slots() == 4);
  CHECK(bodies.size() == 4);
  CHECK(bodies.alive(next));
  CHECK_FALSE(bodies.alive(old));
  CHECK_THROWS_AS(bodies.index(old), std::invalid_argument);
  CHECK_THROWS_AS(hanging.world.add<CentreDistanceJoint>(next, old, CentreDistance{1}),
                  std::invalid_argument);
  CHECK(hanging.world.joints().size() == 1);
  CHECK(bodies[next].x == vec3(7, 0, 0));
}

TEST_CASE("slots are used again and again and no two live bodies share one") {
  World world;
  std::vector<BodyId> living, dead;
  Random random(81);
  for (int round = 0; round < 500; ++round) {
    if (living.empty() || random.uniform(0, 1) < real(0.55)) {
      living.push_back(world.add(ball(1, 1, vec3(real(round), 0, 0))));
    } else {
      const auto k = std::size_t(random.uniform(0, real(living.size())));
      world.remove(living[k]);
      dead.push_back(living[k]);
      living.erase(living.begin() + long(k));
    }
    CHECK(world.bodies.size() == int(living.size()));
  }
  std::vector<int> taken(std::size_t(world.bodies.slots()), 0);
  for (BodyId id : living) CHECK(++taken[std::size_t(world.bodies.index(id))] == 1);
  for (BodyId id : dead) CHECK_FALSE(world.bodies.alive(id));
  CHECK(world.bodies.slots() < 500);
}

TEST_CASE("a joint that goes lets its body fall and a new one catches it") {
  Hanging hanging;
  SequentialImpulses solver;
  hanging.world.remove(*hanging.rod[2]);
  CHECK(hanging.world.joints().size() == 2);
  for (int n = 0; n < 6; ++n) step(hanging.world, solver, h);
  CHECK(fall(hanging, 2) == Approx(-0.981).epsilon(tolerance(1e-12, 1e-5)));
  const Body& last = hanging.world.bodies[hanging.id[2]];
  const CentreDistance rod{length(last.x - hanging.world.bodies[hanging.id[1]].x)};
  hanging.world.add<CentreDistanceJoint>(hanging.id[1], hanging.id[2], rod);
  solver.iterations = 500;
  step(hanging.world, solver, h);
  CHECK(std::abs(fall(hanging, 2)) < tolerance(1e-8, 1e-3));
}

TEST_CASE("what is set on a joint between two steps counts from the next step on") {
  Hanging hanging;
  SequentialImpulses solver;
  solver.iterations = 500;
  hanging.rod[2]->part.length = real(0.9);
  hanging.rod[2]->beta = real(0.5);
  step(hanging.world, solver, h);
  const Bodies& bodies = hanging.world.bodies;
  CHECK(double(length(bodies[hanging.id[2]].x - bodies[hanging.id[1]].x)) ==
        Approx(0.95).epsilon(tolerance(1e-8, 1e-4)));
  hanging.world.bodies[hanging.id[0]].v.x += 3;  // pushed: at right angles, so the rod lets it
  hanging.world.bodies[hanging.id[1]].v = hanging.world.bodies[hanging.id[2]].v = vec3(3, 0, 0);
  step(hanging.world, solver, h);
  CHECK(double(bodies[hanging.id[0]].x.x) == Approx(3.0 / 60).epsilon(0.05));
}

TEST_CASE("a world knows the most rows its joints can have") {
  Hanging hanging;
  auto& ball = hanging.world.add<BallJoint>(hanging.ceiling, hanging.id[2], Point{});
  auto& any = hanging.world.add<AnyJoint<6>>(hanging.id[0], hanging.id[2]);
  for (Row& row : any.J.row) row.w2 = vec3(1, 0, 0);
  SequentialImpulses solver;
  begin_step(hanging.world, solver, h);
  CHECK(hanging.world.blocks.rows() == 12);
  hanging.world.remove(ball);
  hanging.world.remove(hanging.id[2]);
  World other;
  CHECK_THROWS_AS(other.remove(*hanging.rod[0]), std::invalid_argument);
}

TEST_CASE("ids of another world are refused though they name a slot of this one") {
  for (int k = 0; k < 100; ++k) {
    World one, other;
    const BodyId a = one.add(static_body(vec3(0))), b = one.add(ball(1, 1, vec3(1)));
    const BodyId c = other.add(static_body(vec3(0))), d = other.add(ball(1, 1, vec3(1)));
    CHECK_FALSE(one.bodies.alive(c));
    CHECK_THROWS_AS(one.bodies[d], std::invalid_argument);
    CHECK_THROWS_AS(one.remove(d), std::invalid_argument);
    CHECK_THROWS_AS(other.add<CentreDistanceJoint>(a, b, CentreDistance{1}),
                    std::invalid_argument);
    CHECK_THROWS_AS(one.add<CentreDistanceJoint>(a, d, CentreDistance{1}), std::invalid_argument);
    const Bodies copy = one.bodies;
    CHECK(copy.alive(b));
    CHECK(one.bodies.id(1) == b);
  }
}

TEST_CASE("a beta that no joint may have is refused by the world and changes no joint") {
  Hanging hanging;
  for (const real beta : {real(-1), real(100), unbounded, std::numeric_limits<real>::quiet_NaN()}) {
    CHECK_THROWS_AS(hanging.world.set_beta(beta), std::invalid_argument);
    for (const auto& joint : hanging.world.joints()) CHECK(double(joint->beta) <= 1);
  }
}

TEST_CASE("an orientation that is written between two steps holds for the next rows") {
  Random random(4);
  for (int draw = 0; draw < 20; ++draw) {
    World world;
    const BodyId a = world.add(box(1, vec3(1, 2, 3), vec3(0)));
    const BodyId b = world.add(box(1, vec3(1), vec3(4)));
    const vec3 lever = random.vector(1);
    world.add<BallJoint>(a, b, Point{lever, vec3(0)});
    SequentialImpulses solver;
    step(world, solver, h);
    Body& body = world.bodies[a];
    body.q = rotation(random.vector(3));
    CHECK(to_world(body, lever) == body.q * lever);
    CHECK(inverse_inertia(body) == rotated_inverse_inertia(body));
    begin_step(world, solver, h);
    CHECK(length(world.blocks.J[0].w1 + skew(body.q * lever)[0]) < 10 * epsilon);
    CHECK(to_world(body, lever) == body.q * lever);
  }
}

TEST_CASE("a copy that is rotated while the rows are made has an orientation of its own") {
  Bodies bodies;
  const BodyId a = bodies.add(box(1, vec3(1, 2, 3), vec3(0)));
  const HeldMatrices held(bodies);
  Body copy = bodies[a], assigned;
  assigned = bodies[a];
  const vec3 lever(1, 2, 3);
  for (Body* body : {&copy, &assigned}) {
    body->q = rotation(vec3(1, 2, 3));
    CHECK(to_world(*body, lever) == body->q * lever);
    CHECK(inverse_inertia(*body) == rotated_inverse_inertia(*body));
  }
}

TEST_CASE("a loop over all joints may remove joints and bodies") {
  World world;
  const BodyId hub = world.add(box(1, vec3(1), vec3(0)));
  std::vector<BodyId> arms;
  for (int k = 0; k < 6; ++k) {
    arms.push_back(world.add(box(1, vec3(1), vec3(real(k + 1), 0, 0))));
    world.add<BallJoint>(hub, arms.back(), vec3(real(k), 0, 0));
    const BodyId other = k == 0 ? world.add(static_body(vec3(0))) : arms[std::size_t(k - 1)];
    world.add<BallJoint>(other, arms.back(), vec3(0, real(k), 0)).beta = 0;
  }
  const JointId<> last(*world.joints().back());
  int seen = 0;
  for (const auto& joint : world.joints()) {
    ++seen;
    if (joint->body1 == hub) world.remove(*joint);
    if (joint->body2 == arms[3] && world.bodies.alive(arms[3])) world.remove(arms[3]);
  }
  CHECK(seen == 12);
  CHECK(world.joints().size() == 4);  // without the two of that body
  CHECK(world.alive(last));
  CHECK(world[last].number() == last.number);
  for (const auto& joint : world.joints()) {
    CHECK(joint->beta == 0);
    CHECK_FALSE(joint->body2 == arms[3]);
  }
  for (const auto& joint : world.joints()) world.remove(*joint);
  CHECK(world.joints().empty());
  CHECK_FALSE(world.alive(last));
}
