// The islands of the direct solver: each moves as it does alone.
#include "bench/families.h"
#include "tests/direct/rigs.h"
#include "tests/oracle/allocations.h"
#include "tests/oracle/beside.h"
#include "tests/oracle/test.h"

namespace {

constexpr int bodies_of_arm = 4;

// An arm of three bodies on a wall, with a motion of its own by its number, and `links` more at the
// end.
struct Arm {
  int number;
  int links = 0;
  bool bounded = false;  // a motor that pushes into a limit, and a soft joint
};

void add(World& world, const Arm& arm) {
  Random random(unsigned(70 + arm.number));
  std::vector<BodyId> ids{world.add(static_body(vec3(0, 0, real(3 * arm.number))))};
  std::vector<vec3> axes;
  for (int k = 1; k < bodies_of_arm + arm.links; ++k) {
    const vec3 x(real(k), 0, real(3 * arm.number));
    ids.push_back(world.add(box(random.uniform(1, 3), vec3(1, real(0.3), real(0.4)), x)));
    axes.push_back(vec3(random.uniform(-1, 1), 0, 1));
    Body& body = world.bodies[ids.back()];
    if (!arm.bounded) body.v = random.vector(1), body.w = random.vector(2);
  }
  std::vector<HingeJoint*> hinges;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const vec3 anchor = world.bodies[ids[k + 1]].x - vec3(real(0.5), 0, 0);
    hinges.push_back(&world.add<HingeJoint>(ids[k], ids[k + 1], anchor, axes[k]));
  }
  feed_back_all(world);
  if (!arm.bounded) return;
  hinges[0]->set_limits(real(-0.1) * real(arm.number), real(0.1));
  hinges[0]->set_motor(arm.number % 2 == 0 ? real(2) : real(-2), 200);
  hinges[2]->frequency = 3;
}

// How far the bodies from `slot` on are from those of a world that has nothing else.
double difference(const World& together, int slot, const World& alone) {
  const std::span<const Body> these = bodies_of(together).subspan(std::size_t(slot));
  return std::max(apart(these, alone), speeds_apart(these, alone));
}

// A world of arms after 60 steps.
World moved(const std::vector<Arm>& arms, int newton = 0) {
  World world;
  for (const Arm& arm : arms) add(world, arm);
  DirectSolver solver = with(newton);
  for (int n = 0; n < 60; ++n) step(world, solver, sixtieth, second_order);
  return world;
}

double difference_from_alone(const std::vector<Arm>& arms, int newton) {
  const World together = moved(arms, newton);
  double most = 0;
  int slot = 0;
  for (const Arm& arm : arms) {
    const World alone = moved({arm}, newton);
    most = std::max(most, difference(together, slot, alone));
    slot += alone.bodies.slots();
  }
  return most;
}

// A body on two rods from a wall: side by side, or one beside the other's end.
void add_rods(World& world, real apart, real z) {
  const BodyId wall = world.add(static_body(vec3(0, 0, z)));
  const BodyId body = world.add(box(2, vec3(real(0.5)), vec3(2, 0, z)));
  for (const real y : {real(0), apart})
    world.add<DistanceJoint>(wall, body, Distance{.anchor1_local = vec3(0, y, 0),
                                                  .anchor2_local = vec3(0, y, 0), .length = 2});
  world.bodies[body].v = vec3(0, 1, 0);
  feed_back_all(world);
}

}  // namespace

TEST_CASE("islands move as each does alone, to the last digit") {
  for (const int newton : {0, 8}) {
    CAPTURE(newton);
    CHECK(difference_from_alone({{0}, {1}}, newton) == 0);
    CHECK(difference_from_alone({{0}, {1, 1}, {2}, {3, 2}, {4, 1}}, newton) == 0);
    CHECK(difference_from_alone({{0, 0, true}, {1, 0, true}, {2}}, newton) == 0);
  }
}

TEST_CASE("a row that depends on others in one island alone is dropped in that one alone") {
  for (const bool second : {false, true}) {
    CAPTURE(second);
    World together, dependent, free;
    add_rods(together, second ? real(0.1) : real(0), 0);
    add_rods(together, second ? real(0) : real(0.1), 5);
    add_rods(dependent, 0, second ? 5 : 0);
    add_rods(free, real(0.1), second ? 0 : 5);
    DirectSolver both, one, other;
    step(together, both, sixtieth, second_order);
    step(dependent, one, sixtieth, second_order);
    step(free, other, sixtieth, second_order);
    CHECK(both.dependent() == 1);
    CHECK(one.dependent() == 1);
    CHECK(other.dependent() == 0);
    CHECK(difference(together, second ? 2 : 0, dependent) == 0);
    CHECK(difference(together, second ? 0 : 2, free) == 0);
  }
}

TEST_CASE("the report counts every island") {
  World one, three;
  add(one, {0});
  for (int k = 0; k < 3; ++k) add(three, {k});
  DirectSolver solver_of_one, solver_of_three;
  step(one, solver_of_one, sixtieth, second_order);
  step(three, solver_of_three, sixtieth, second_order);
  CHECK(solver_of_one.report().multiplications > 0);
  CHECK(solver_of_three.report().multiplications == 3 * solver_of_one.report().multiplications);
}

TEST_CASE("an island whose bodies are slowed down, or that is iterated, changes no other island") {
  const std::vector<Arm> arms{{0}, {1, 1, true}, {2}};
  const auto run = [&](World world, const std::vector<Arm>& with_arms, bool hub) {
    for (const Arm& arm : with_arms) add(world, arm);
    feed_back_all(world);
    world.bodies.at(0).w = vec3(0, 0, real(1e-3));  // a static body keeps its velocity
    DirectSolver solver = shake();
    int halved = 0;
    for (int n = 0; n < 60; ++n) {
      step(world, solver, sixtieth, second_order);
      halved += solver.report().halved;
      CHECK(solver.report().iterated == hub);
    }
    CHECK((halved > 0) == !hub);
    if (!hub) CHECK(world.bodies.at(0).w == vec3(0, 0, real(1e-3)));
    return world;
  };
  for (const bool hub : {false, true}) {
    CAPTURE(hub);
    const auto made = [&] {
      if (hub) return chapter9::star(60).world;
      for (const bench::Family& family : bench::joint_families())
        if (family.name == "beads") return family.draw(2).world;
      return World();
    };
    const World together = run(made(), arms, hub), without = run(made(), {}, hub);
    CHECK(difference(together, 0, without) == 0);
    int slot = without.bodies.slots();
    for (const Arm& arm : arms) {
      const World alone = moved({arm}, 8);
      CHECK(difference(together, slot, alone) == 0);
      slot += alone.bodies.slots();
    }
  }
}

TEST_CASE("limits that come and go in chains of hinges take little memory later") {
  for (const int chains : {1, 10})
    for (const int newton : {0, 8}) {
      CAPTURE(chains, newton);
      World world;
      std::vector<HingeJoint*> hinges;
      for (int chain = 0; chain < chains; ++chain) {
        BodyId before = world.add(static_body(vec3(real(5 * chain), 0, 0)));
        for (int k = 1; k <= 100 / chains; ++k) {
          const vec3 x(real(5 * chain), 0, real(1.5) * real(k));
          const BodyId id = world.add(box(100, vec3(1), x));
          hinges.push_back(&world.add<HingeJoint>(before, id, x - vec3(0, 0, real(0.75)),
                                                  vec3(1, 0, 0)));
          hinges.back()->set_limits(0, 0);  // at first all of them act
          before = id;
        }
      }
      feed_back_all(world);
      DirectSolver solver = with(newton);
      int changes = 0, rows = 0;
      const auto run = [&](int steps) {
        changes = 0;
        for (int n = 0; n < steps; ++n) {
          step(world, solver, sixtieth, second_order);
          changes += world.blocks.rows() != rows;
          rows = world.blocks.rows();
        }
      };
      run(5);
      for (HingeJoint* hinge : hinges) hinge->set_limits(real(-0.3), real(0.3));
      for (int slot = 0; slot < world.bodies.slots(); ++slot)
        if (Body& body = world.bodies.at(slot); !body.is_static())
          body.w = vec3(real(0.3) * real(13 * slot % 11 - 5), 0, 0);
      run(300);
      CHECK(allocations_of([&] { run(200); }) <= 16);  // lists that still grow
      CHECK(changes > 2);
    }
}
