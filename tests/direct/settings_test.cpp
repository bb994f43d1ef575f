// When the direct solver leaves a world to iterations, worlds with nothing to solve, and input that
// the solver and the Runge-Kutta method reject.
#include "bench/runge_kutta.h"
#include "joints/ball_joint.h"
#include "tests/direct/rigs.h"
#include "tests/oracle/test.h"

using namespace joints::chapter9;

namespace {

const real h = sixtieth;

void run(World& world, Solver& solver, int steps) {
  for (int n = 0; n < steps; ++n) step(world, solver, h, second_order);
}

}  // namespace

TEST_CASE("a hub with too many arms is left to iterations, unless any work is welcome") {
  for (const int arms : {40, 100}) {
    CAPTURE(arms);
    Scene dear = star(arms), cheap = star(arms);
    for (Scene* scene : {&dear, &cheap}) scene->world.bodies.at(1).w = vec3(1, 3, 1);
    DirectSolver exact = shake(), frugal = shake();
    exact.most_work = unbounded;
    frugal.most_work = 500;
    const Watched right = watch(dear, exact, 0.25, double(h));
    const Watched iterated = watch(cheap, frugal, 0.25, double(h));
    CHECK(exact.report().multiplications > 500 * 3.0 * arms);
    CHECK_FALSE(exact.report().iterated);
    CHECK(frugal.report().iterated);
    CHECK(frugal.report().multiplications == 0);  // nobody looked for an order
    CHECK(frugal.dependent() == 0);
    CHECK(right.gap < tolerance(1e-6, 1e-3));
    CHECK(iterated.finite);
    CHECK(iterated.gap > tolerance(1000, 3) * right.gap);
  }
}

TEST_CASE("a net whose factor is too dear is left to iterations, and no more when it is not") {
  Scene scene = net(8);
  DirectSolver solver;
  run(scene.world, solver, 1);
  CHECK_FALSE(solver.report().iterated);
  const double work = solver.report().multiplications / double(scene.world.blocks.C.size());
  solver.most_work = work * 0.9;
  run(scene.world, solver, 1);
  CHECK(solver.report().iterated);
  CHECK(solver.report().multiplications == 0);
  solver.most_work = work * 1.1;
  run(scene.world, solver, 1);
  CHECK_FALSE(solver.report().iterated);
}

TEST_CASE("what a step cannot hold it says in words, and nothing where it holds everything") {
  const auto says = [](const DirectSolver& solver, const char* words) {
    const std::vector<std::string> all = solver.report().sentences();
    return std::any_of(all.begin(), all.end(), [&](const std::string& one) {
      return one.find(words) != std::string::npos;
    });
  };
  Scene net8 = net(8);
  DirectSolver frugal, calm = shake();
  frugal.most_work = 1;
  run(net8.world, frugal, 1);
  CHECK(says(frugal, "most_work"));
  run(net8.world, calm, 20);
  CHECK(calm.report().sentences().empty());

  World rods;  // of one and of two metres between the same two centres
  const BodyId a = rods.add(static_body(vec3(0))), b = rods.add(ball(1, 1, vec3(1, 0, 0)));
  rods.add<CentreDistanceJoint>(a, b, CentreDistance{1});
  rods.add<CentreDistanceJoint>(a, b, CentreDistance{2});
  DirectSolver open = shake();
  run(rods, open, 1);
  CHECK(says(open, "contradict"));

  World torn;
  const BodyId hook = torn.add(static_body(vec3(0))), bob = torn.add(ball(1, 1, vec3(0, -1, 0)));
  torn.add<BallJoint>(hook, bob, vec3(0));
  DirectSolver tears;
  run(torn, tears, 10);
  CHECK(tears.report().sentences().empty());
  torn.bodies[bob].x += vec3(5, 0, 0);
  run(torn, tears, 1);
  CHECK(says(tears, "was open by 5 "));

  World fast;
  fast.gravity = vec3(0);
  const BodyId frame = fast.add(box(1, vec3(1), vec3(0)));
  const vec3 moments(real(0.02), real(0.03), real(0.05));
  const BodyId rotor = fast.add(body_with(1, moments, vec3(1, 0, 0)));
  fast.bodies[rotor].w = vec3(150, 200, 100);
  fast.add<HingeJoint>(frame, rotor, vec3(1, 0, 0), vec3(0, 0, 1));
  DirectSolver slowed = shake();
  bool said = false;
  for (int n = 0; n < 30; ++n) run(fast, slowed, 1), said = said || says(slowed, "shorter step");
  CHECK(said);
}

TEST_CASE("the estimate of a hub's work is of the third power of its arms") {
  const auto work = [](int arms) {
    Scene scene = star(arms);
    DirectSolver solver;
    solver.most_work = unbounded;
    step(scene.world, solver, h);
    return solver.report().multiplications;
  };
  CHECK(work(80) / work(40) == Approx(8).epsilon(0.15));
}

TEST_CASE("worlds without joints, or with joints between static bodies alone, step as they would") {
  for (const bool with_joint : {false, true})
    for (const int newton : {0, 8}) {
      World world;
      const BodyId a = world.add(static_body(vec3(0))), b = world.add(static_body(vec3(1, 0, 0)));
      const BodyId free = world.add(box(1, vec3(1), vec3(5, 0, 0)));
      if (with_joint) world.add<HingeJoint>(a, b, vec3(0), vec3(0, 0, 1));
      DirectSolver solver = with(newton);
      run(world, solver, 60);
      CHECK(double(world.bodies[free].v.y) == Approx(-9.81 * 59.5 / 60).epsilon(1e-4));
      CHECK(double(world.bodies[free].x.y) == Approx(-9.81 / 2).epsilon(1e-4));
      CHECK(world.bodies[a].x == vec3(0));
      CHECK(world.bodies[b].v == vec3(0));
      CHECK(solver.dependent() == 0);
    }
}

TEST_CASE("settings without sense are refused by name, and nothing moves") {
  const auto said = [](auto set) {
    Scene scene = heavy_chain(2, 1);
    DirectSolver solver;
    set(solver);
    const std::string words = refusal([&] { step(scene.world, solver, h, second_order); });
    CHECK(scene.world.last_h == 0);  // it has not begun
    return words.substr(0, words.find_first_of(": "));
  };
  const real nan = std::numeric_limits<real>::quiet_NaN();
  CHECK(said([](DirectSolver& s) { s.newton = -1; }) == "newton");
  CHECK(said([](DirectSolver& s) { s.alternations = 0; }) == "alternations");
  CHECK(said([](DirectSolver& s) { s.added_inertia = -1; }) == "added_inertia");
  CHECK(said([=](DirectSolver& s) { s.added_inertia = nan; }) == "added_inertia");
  CHECK(said([](DirectSolver& s) { s.added_inertia = unbounded; }) == "added_inertia");
  CHECK(said([](DirectSolver& s) { s.most_work = -1; }) == "most_work");
  CHECK(said([=](DirectSolver& s) { s.most_work = double(nan); }) == "most_work");
  CHECK(said([](DirectSolver& s) { s.fallback.iterations = -1; }) == "iterations");
}

TEST_CASE("the Runge-Kutta method leaves a static body where it is, and a belt its velocity") {
  World world;
  const BodyId belt = world.add(static_body(vec3(0)));
  const BodyId body = world.add(ball(1, real(0.1), vec3(0, -1, 0)));
  world.add<BallJoint>(belt, body, Point{vec3(0), vec3(0, 1, 0)});
  world.bodies[belt].v = vec3(1, 0, 0);
  RungeKutta kutta;
  for (int n = 0; n < 10; ++n) kutta.step(world, h);
  CHECK(world.bodies[belt].x == vec3(0));
  CHECK(world.bodies[belt].v == vec3(1, 0, 0));
}

TEST_CASE("the Runge-Kutta method refuses steps, limits, motors and ropes that it cannot follow") {
  const auto said = [](real length, auto change) {
    Scene scene = heavy_chain(2, 1);
    const BodyId end = scene.world.bodies.id(1);
    HingeJoint& hinge = on_hinge(scene, end, scene.world.add(box(1, vec3(1), vec3(0, 1, 0))),
                                 vec3(0, real(0.5), 0), vec3(0, 0, 1));
    change(hinge);
    RungeKutta kutta;
    const std::string words = refusal([&] { kutta.step(scene.world, length); });
    return words.substr(0, words.find_first_of(": "));
  };
  const auto leave = [](HingeJoint&) {};
  CHECK(said(h, leave) == "accepted");
  CHECK(said(0, leave) == "h");
  CHECK(said(-h, leave) == "h");
  CHECK(said(unbounded, leave) == "h");
  CHECK(said(h, [](HingeJoint& hinge) { hinge.set_limits(-1, 1); }) == "world");
  CHECK(said(h, [](HingeJoint& hinge) { hinge.set_motor(1, 1); }) == "world");

  World hanging;  // a rope's row is bounded
  const BodyId wall = hanging.add(static_body(vec3(0)));
  const BodyId body = hanging.add(ball(1, real(0.1), vec3(0, -1, 0)));
  hanging.add<CentreRopeJoint>(wall, body, Rope<CentreDistance>{{1}});
  RungeKutta kutta;
  CHECK(refusal([&] { kutta.step(hanging, h); }).find("bounds") != std::string::npos);
  CHECK(hanging.bodies[body].x == vec3(0, -1, 0));
}
