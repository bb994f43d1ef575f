// Joints that the engine has never heard of, and its calls to a joint: in which order, how often
// and which of their answers may change between two steps.
#include "engine/kept/state.h"
#include "tests/checker/fixtures.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;

// Keeps a point of body 2 in a plane that is fixed to body 1. n = R1 n_local, u = p2 - p1,
// C = u.n; J = (-n, -((r1+u) x n), n, r2 x n), exact at every pose.
struct Plane {
  vec3 anchor1_local{0}, anchor2_local{0}, normal_local{0, 1, 0};
  static constexpr int rows = 1;
  static constexpr bool one_sided = false;
  static constexpr Form form = Form::any;
  vec3 u(const Body& body1, const Body& body2) const {
    return world_point(body2, anchor2_local) - world_point(body1, anchor1_local);
  }
  real error(const Body& body1, const Body& body2) const {
    return dot(u(body1, body2), to_world(body1, normal_local));
  }
  Row jacobian(const Body& body1, const Body& body2) const {
    const vec3 n = to_world(body1, normal_local), r2 = to_world(body2, anchor2_local);
    return {-n, -cross(body2.x + r2 - body1.x, n), n, cross(r2, n)};
  }
  real K(const Body& body1, const Body& body2) const {
    return dense_K(to_jacobian(jacobian(body1, body2)), body1, body2)[0][0];
  }
};
void check(const Plane& plane) {
  require(length(plane.normal_local) > 0, "normal_local: must not be zero");
}

// A rope that runs over two fixed wheels: |p1| + |p2| = length, the bodies hang from its ends.
struct Pulley {
  vec3 wheel1{0}, wheel2{0};  // world
  real length = 1;
  static constexpr int rows = 1;
  static constexpr bool one_sided = false;
  static constexpr Form form = Form::any;
  real error(const Body& body1, const Body& body2) const {
    return glm::length(body1.x - wheel1) + glm::length(body2.x - wheel2) - length;
  }
  Row jacobian(const Body& body1, const Body& body2) const {
    return {direction(body1.x - wheel1), vec3(0), direction(body2.x - wheel2), vec3(0)};
  }
  real K(const Body& body1, const Body& body2) const {
    return body1.inverse_mass + body2.inverse_mass;
  }
};
void check(const Pulley&) {}

struct PlaneFixture {
  using Part = Plane;
  static constexpr Subject J{"", "the row J of a point in a plane"};
  static constexpr Subject K{"", "K of a point in a plane"};
  static constexpr std::array rows{"C"};
  static constexpr bool exact_when_broken = true;
  static Part make(const Pair& pair) {
    Plane part{vec3(0), vec3(real(0.3), real(0.2), real(-0.4)), normalize(vec3(1, 2, -1))};
    const vec3 p2 = world_point(pair.body2, part.anchor2_local);
    part.anchor1_local = to_local(pair.body1, p2 - pair.body1.x);
    return part;
  }
  static void move_freely(const Part& part, Pair& pair, Random& random) {
    const vec3 n = to_world(pair.body1, part.normal_local);
    pair.body2.x += cross(n, random.vector(1));
    turn_about(pair.body2, world_point(pair.body2, part.anchor2_local), random.turn());
  }
};

// Writes down what it is asked. activate_missed_limits adds the row that it held back.
class Probe : public Joint {
 public:
  std::string& log;
  char name;
  bool holds_back;
  mutable real impulse = 0;
  bool added = false;
  Probe(BodyId a, BodyId b, std::string& log, char name, bool holds_back)
      : Joint(a, b), log(log), name(name), holds_back(holds_back) {}
  void update_active_rows(const Bodies&, real) override {
    log += std::string("b") + name;
    added = false;
    impulse = 0;
  }
  void append(const Bodies& bodies, Blocks& blocks) const override {
    log += std::string("a") + name;
    if (!holds_back) row(bodies, blocks);
  }
  void activate_missed_limits(const Bodies& bodies, real, Blocks& blocks) override {
    log += std::string("s") + name;
    if (holds_back && !added) row(bodies, blocks), added = true;
  }

 private:
  void row(const Bodies& bodies, Blocks& blocks) const {
    blocks.append(bodies, body1, body2, CentreDistance{1}, {}, &impulse);
  }
};

}  // namespace

TEST_CASE("a point in a plane passes the numeric checker") {
  check_jacobian<PlaneFixture>();
  check_K<PlaneFixture>();
}

TEST_CASE("a box on a plane that turns slides down the plane and stays in it") {
  World world;
  const Body table = box(1000, vec3(4, 1, 4), vec3(0), rotation(vec3(0, 0, real(0.5))));
  const BodyId a = world.add(table), b = world.add(box(2, vec3(1, real(0.5), real(0.2)), vec3(0)));
  auto& joint = world.add<PartJoint<Plane>>(a, b, Plane{});
  world.gravity = vec3(0);
  world.bodies[a].w = vec3(0, real(0.3), real(0.2));
  world.bodies[b].v = vec3(1, 0, 0);
  SequentialImpulses solver;
  double largest = 0;
  for (int n = 0; n < 300; ++n) {
    step(world, solver, h);
    largest = std::max(largest, double(std::abs(joint.part.error(world.bodies[a],
                                                                 world.bodies[b]))));
  }
  CHECK(largest < 0.02);
  CHECK(double(length(world.bodies[b].x)) > 3);
}

TEST_CASE("two weights on a pulley fall with the difference of their weights") {
  // Atwood: 3 kg against 1 kg, a = g (3 - 1)/(3 + 1); the rope pulls with 2 m1 m2 g/(m1 + m2)
  World world;
  const BodyId light = world.add(ball(1, real(0.1), vec3(0, -3, 0)));
  const BodyId heavy = world.add(ball(3, real(0.1), vec3(1, -2, 0)));
  auto& joint = world.add<PartJoint<Pulley>>(light, heavy, Pulley{vec3(0), vec3(1, 0, 0), 5});
  SequentialImpulses solver;
  for (int n = 0; n < 30; ++n) step(world, solver, h);
  CHECK(double(world.bodies[heavy].v.y) == Approx(-9.81 / 2 * 0.5).epsilon(tolerance(1e-9, 1e-4)));
  CHECK(double(world.bodies[light].v.y) == Approx(9.81 / 2 * 0.5).epsilon(tolerance(1e-9, 1e-4)));
  CHECK(double(joint.impulse()[0] / h) == Approx(-1.5 * 9.81).epsilon(tolerance(1e-9, 1e-4)));
}

TEST_CASE("a step asks all joints to begin then for their blocks then for late limits") {
  World world;
  const BodyId wall = world.add(static_body(vec3(0)));
  const BodyId body = world.add(ball(2, 1, vec3(0, -1, 0)));
  std::string log;
  world.add<Probe>(wall, body, log, '1', false);
  world.add<Probe>(wall, body, log, '2', false);
  step_once(world, h);
  CHECK(log == "b1b2a1a2s1s2");
}

TEST_CASE("a block that comes with the late limits is solved and looked at again") {
  World world;
  const BodyId wall = world.add(static_body(vec3(0)));
  const BodyId body = world.add(ball(2, 1, vec3(0, -1, 0)));
  std::string log;
  Probe& probe = world.add<Probe>(wall, body, log, '1', true);
  SequentialImpulses solver;
  solver.iterations = 1;
  step(world, solver, h);
  CHECK(log == "b1a1s1s1");
  CHECK(double(probe.impulse / h) == Approx(-2 * 9.81).epsilon(tolerance(1e-12, 1e-5)));
  CHECK(std::abs(double(world.bodies[body].v.y)) < tolerance(1e-14, 1e-7));
}

TEST_CASE("a joint tells after a restored state, too, that neither of its bodies can move") {
  const auto built = [] {
    auto world = std::make_unique<World>();
    const BodyId a = world->add(static_body(vec3(0))), b = world->add(static_body(vec3(1, 0, 0)));
    world->add<CentreDistanceJoint>(a, b, CentreDistance{1});
    return world;
  };
  const auto stepped = built(), restored = built();
  SequentialImpulses solver;
  step(*stepped, solver, h);
  restore(*restored, save(*stepped));
  CHECK_FALSE(restored->joints()[0]->can_move());
}

TEST_CASE("a bound is carried if it is infinite and refused if it is no number") {
  for (const real bound : {real(3), unbounded, -unbounded}) {
    real carried = 0;
    StateStream(&bound).bound(carried);
    CHECK(carried == bound);
  }
  const real no_number = std::numeric_limits<real>::quiet_NaN();
  real carried = 0;
  CHECK_THAT(refusal([&] { StateStream(&no_number).bound(carried); }),
             Catch::Matchers::StartsWith("state: holds a bound"));
}

TEST_CASE("asking for blocks between the steps changes nothing") {
  const auto run = [](bool ask) {
    World world;
    const BodyId wall = world.add(static_body(vec3(0)));
    const BodyId a = world.add(box(1, vec3(1, real(0.5), real(0.2)), vec3(1, 0, 0)));
    const BodyId b = world.add(box(2, vec3(1, real(0.5), real(0.2)), vec3(2, 0, 0)));
    world.add<BallJoint>(wall, a, Point{vec3(0), vec3(-1, 0, 0)});
    world.add<RopeJoint>(a, b, Rope<Distance>{{vec3(0), vec3(0), real(1.1)}});
    world.add<DistanceJoint>(wall, b, Distance{vec3(0, 1, 0), vec3(0), real(2.5)});
    SequentialImpulses solver;
    StepOptions stepping{.warm_start = true};
    for (int n = 0; n < 60; ++n) {
      step(world, solver, h, stepping);
      if (!ask) continue;
      Blocks blocks;
      Bodies elsewhere = world.bodies;
      for (int slot = 0; slot < 3; ++slot) elsewhere.at(slot).x += vec3(real(slot), 5, -3);
      for (const auto& joint : world.joints()) joint->append(elsewhere, blocks);
      CHECK(blocks.rows() == 5);
    }
    return velocities(snapshot(world.bodies));
  };
  CHECK((run(true) == run(false)));
}
