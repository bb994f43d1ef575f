// Bodies that the program moves: the step carries them to the place, and joints feel their motion,
// with every solver and every way to step.
#include <functional>
#include <string>

#include "bench/runge_kutta.h"
#include "engine/kept/kinematic.h"
#include "engine/kept/reaction.h"
#include "engine/kept/state.h"
#include "engine/steps/two_pass_impulses.h"
#include "joints/ball_joint.h"
#include "joints/fixed_joint.h"
#include "joints/hinge_joint.h"
#include "tests/joints/three_solvers.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;
using OneStep = std::function<void(World&)>;

struct Way {
  std::string name;
  OneStep step;
};

// All solvers of rows, each with all ways to step; the classical Runge-Kutta method has its own.
std::vector<Way> all_ways() {
  std::vector<Way> out;
  std::vector<std::shared_ptr<Solver>> solvers;
  for (auto& solver : three_solvers(10)) solvers.push_back(std::move(solver));
  for (int k = 0; k < 2; ++k) {
    const auto two_pass = std::make_shared<TwoPassImpulses>();
    (k == 0 ? two_pass->relax_iterations : two_pass->split_iterations) = 10;
    two_pass->iterations = 10;
    solvers.push_back(two_pass);
  }
  const auto exact = std::make_shared<DirectSolver>();
  exact->newton = 8;
  solvers.push_back(exact);
  for (std::size_t k = 0; k < solvers.size(); ++k)
    for (const int substeps : {1, 4, 16})
      for (const bool leapfrog : {false, true})
        out.push_back({"solver " + std::to_string(k) + ", " + std::to_string(substeps) +
                           " substeps" + (leapfrog ? ", leapfrog" : ""),
                       [=, solver = solvers[k]](World& world) {
                         step(world, *solver, h, {.substeps = substeps, .leapfrog = leapfrog});
                       }});
  if (!is_float)
    out.push_back({"Runge-Kutta", [method = std::make_shared<RungeKutta>()](World& world) {
                     method->step(world, h);
                   }});
  return out;
}

BodyId add_moved(World& world, const vec3& x, const quat& q = quat(1, 0, 0, 0)) {
  Body body = static_body(x, q);
  body.kinematic = true;
  return world.add(body);
}

}  // namespace

TEST_CASE("a load hangs straight below a trolley that moves at ten metres a second", "[engine]") {
  const real far = real(10) * 2;
  for (const Way& way : all_ways()) {
    World world;
    const BodyId trolley = add_moved(world, vec3(0));
    const BodyId load = world.add(box(100, vec3(real(0.5)), vec3(0, -2, 0)));
    auto& ball = world.add<BallJoint>(trolley, load, vec3(0));
    world.bodies[trolley].v = world.bodies[load].v = vec3(10, 0, 0);
    double swing = 0, force = 0;
    for (int n = 0; n < 120; ++n) {
      way.step(world);
      const vec3 hangs = world.bodies[load].x - world.bodies[trolley].x - vec3(0, -2, 0);
      swing = std::max(swing, double(length(hangs)));
      force = std::max(force, std::abs(double(reaction(ball, world.bodies).force.y) - 981));
    }
    INFO(way.name);
    CHECK(swing < tolerance(1e-9, 1e-4));
    CHECK(force < tolerance(1e-6, 0.1));
    CHECK(std::abs(double(world.bodies[trolley].x.x - far)) < tolerance(1e-9, 1e-4));
  }
}

TEST_CASE("a load on a lift that gains speed is held by m (g + a)", "[engine]") {
  const real a = 3;
  for (const Way& way : all_ways()) {
    if (way.name == "Runge-Kutta") continue;  // a jump of a velocity is a blow, which it excludes
    World world;
    const BodyId lift = add_moved(world, vec3(0));
    const BodyId load = world.add(box(20, vec3(1), vec3(0, 1, 0)));
    auto& weld = world.add<FixedJoint>(lift, load, vec3(0, real(0.5), 0));
    double off = 0;
    for (int n = 0; n < 60; ++n) {
      const bool halved = n == 0 && way.name.find("leapfrog") != std::string::npos;
      world.bodies[lift].v.y += a * h;
      way.step(world);
      if (way.name.find(" 1 substeps") == std::string::npos || halved) continue;
      off = std::max(off, std::abs(double(reaction(weld, world.bodies).force.y) -
                                   20 * (9.81 + double(a))));
    }
    INFO(way.name);
    CHECK(off < tolerance(1e-6, 0.05));
    CHECK(std::abs(double(world.bodies[load].x.y - world.bodies[lift].x.y) - 1) <
          tolerance(1e-9, 1e-4));
  }
}

TEST_CASE("a step ends with every moved body where it was sent, whatever the solver", "[engine]") {
  Random random(50);
  for (const Way& way : all_ways()) {
    World world;
    const BodyId hand = add_moved(world, random.vector(2), random.turn());
    const vec3 at = world.bodies[hand].x;
    const BodyId held = world.add(box(2, vec3(real(0.3), real(0.2), real(0.1)), at));
    world.add<BallJoint>(hand, held, at);
    double off = 0, gap = 0;
    for (int n = 0; n < 60; ++n) {
      const vec3 x = world.bodies[hand].x + random.vector(real(0.02));
      const quat q = normalize(random.turn(real(0.2)) * world.bodies[hand].q);
      move_to(world.bodies[hand], x, n % 2 == 0 ? q : -q, h);
      way.step(world);
      const Body& now = world.bodies[hand];
      off = std::max({off, double(length(now.x - x)), 1 - std::abs(double(dot(now.q, q)))});
      gap = std::max(gap, double(length(now.x - world.bodies[held].x)));
    }
    INFO(way.name);
    CHECK(off < tolerance(1e-12, 1e-5));
    CHECK(gap < 0.01);
  }
}

TEST_CASE("what is fixed to a platform follows it in any rotation", "[engine]") {
  for (int draw = 0; draw < 20; ++draw)
    for (const int substeps : {1, 4, 16})
      for (const bool leapfrog : {false, true}) {
        Random random(5000 + unsigned(draw));
        World world;
        const real size = std::pow(real(10), random.uniform(-2, 2));
        const BodyId platform = add_moved(world, random.vector(size), random.turn());
        Body load = box(real(std::pow(real(10), random.uniform(-2, 2))),
                        size * vec3(real(0.2), real(0.5), real(0.3)),
                        world.bodies[platform].x + random.vector(size), random.turn());
        Body& moved = world.bodies[platform];
        moved.w = random.vector(6);
        moved.v = random.vector(10 * size);
        load.w = moved.w;
        load.v = point_velocity(moved, load.x - moved.x);
        const vec3 local = to_local(moved, load.x - moved.x);
        const quat turned = conjugate(moved.q) * load.q;
        const BodyId on_it = world.add(load);
        world.add<FixedJoint>(platform, on_it, world.bodies[platform].x);
        world.set_beta(1);
        DirectSolver solver;
        solver.newton = 8;
        solver.tolerance = 1e-7 * std::min(1.0, double(size));
        double off = 0;
        for (int n = 0; n < 120; ++n) {
          step(world, solver, h, {.substeps = substeps, .leapfrog = leapfrog});
          const Body &a = world.bodies[platform], &b = world.bodies[on_it];
          off = std::max({off, double(length(b.x - world_point(a, local)) / size),
                          double(2 * length(vec3((conjugate(a.q * turned) * b.q).x,
                                                 (conjugate(a.q * turned) * b.q).y,
                                                 (conjugate(a.q * turned) * b.q).z)))});
        }
        INFO("draw " << draw << ", " << substeps << " substeps, leapfrog " << leapfrog);
        CHECK(off < tolerance(1e-9, 1e-4));
      }
}

TEST_CASE("no joint and no force changes the velocity of a moved body", "[engine]") {
  for (const Way& way : all_ways()) {
    World world;
    const BodyId lift = add_moved(world, vec3(0));
    const BodyId load = world.add(box(1e6, vec3(1), vec3(2, 0, 0)));
    world.add<HingeJoint>(lift, load, vec3(0), vec3(0, 0, 1));
    world.bodies[lift].v = vec3(1, 2, 3);
    world.bodies[load].v = vec3(1, 2, 3);
    for (int n = 0; n < 10; ++n) way.step(world);
    INFO(way.name);
    CHECK(world.bodies[lift].v == vec3(1, 2, 3));
    CHECK(world.bodies[lift].w == vec3(0));
  }
}

TEST_CASE("a saved world with moved bodies goes on to the bit", "[engine]") {
  const auto make = [](World& world) {
    const BodyId hand = add_moved(world, vec3(0));
    const BodyId held = world.add(box(1, vec3(real(0.2), real(0.3), real(0.4)), vec3(0, -1, 0)));
    world.add<BallJoint>(hand, held, vec3(0));
    world.bodies[hand].v = vec3(1, 0, 0), world.bodies[hand].w = vec3(0, 1, 0);
  };
  World first, second;
  make(first), make(second);
  DirectSolver solver, other;
  for (int n = 0; n < 20; ++n) step(first, solver, h);
  restore(second, save(first));
  for (int n = 0; n < 20; ++n) step(first, solver, h), step(second, other, h);
  CHECK(save(first) == save(second));
}

TEST_CASE("a body that forces move cannot be sent to a place", "[engine]") {
  World world;
  Body body = box(1, vec3(1), vec3(0));
  body.kinematic = true;
  CHECK_THROWS_WITH(world.add(body), ContainsSubstring("only a static body can be"));
  body.kinematic = false;
  CHECK_THROWS_WITH(move_to(body, vec3(1), quat(1, 0, 0, 0), h),
                    ContainsSubstring("only a kinematic body"));
  Body lift = static_body(vec3(0));
  lift.kinematic = true;
  for (const real wrong : {real(0), real(-1), unbounded})
    CHECK_THROWS_WITH(move_to(lift, vec3(1), quat(1, 0, 0, 0), wrong), ContainsSubstring("h is"));
  CHECK_THROWS_WITH(move_to(lift, vec3(unbounded), quat(1, 0, 0, 0), h),
                    ContainsSubstring("finite"));
}

TEST_CASE("a belt stays where it is and carries along all the same", "[engine]") {
  World world;
  world.gravity = vec3(0);
  const BodyId belt = world.add(static_body(vec3(0)));
  const BodyId load = world.add(box(1, vec3(1), vec3(0)));
  world.add<BallJoint>(belt, load, vec3(0)).beta = 0;
  world.bodies[belt].v = vec3(2, 0, 0);
  SequentialImpulses solver;
  step(world, solver, h);
  CHECK(world.bodies[belt].x == vec3(0));
  CHECK(std::abs(double(world.bodies[load].v.x) - 2) < tolerance(1e-12, 1e-5));
}
