// Limits and motors by the direct solver, over many steps (cases X11 to X13, S4).
#include "bench/families.h"
#include "tests/direct/rigs.h"
#include "tests/oracle/test.h"

namespace {

const real h = sixtieth;

// A rotor at rest, 5 degrees from its limits, and a weight at its end that is thrown away: how far
// it was beyond them, and how far it still is after 5 s [degrees].
struct Beyond {
  double most = -5, last = 0;
};
Beyond beyond_when_yanked(int newton, real weight, real speed) {
  Rotor rotor(real(0.5));
  rotor.hinge->set_limits(-5 * degree, 5 * degree);
  const BodyId thrown =
      rotor.world.add(body_with(weight, vec3(weight / 6), vec3(real(1.5), 0, 0)));
  rotor.world.add<BallJoint>(
      rotor.body, thrown,
      point_at(rotor.world.bodies[rotor.body], rotor.world.bodies[thrown], vec3(1, 0, 0)));
  rotor.world.bodies[thrown].v = vec3(0, speed, 0);
  feed_back_all(rotor.world);
  DirectSolver solver = with(newton);
  Beyond out;
  for (int n = 0; n < 300; ++n) {
    step(rotor.world, solver, h, second_order);
    REQUIRE(all_finite(rotor.world));
    out.last = std::abs(rotor.in_degrees()) - 5;
    out.most = std::max(out.most, out.last);
  }
  return out;
}

// Hinges about one axis in a row, each with limits, that all are hit in the same step.
struct Whip {
  World world;
  std::vector<HingeJoint*> hinges;

  explicit Whip(int count, real limit) {
    world.gravity = vec3(0);
    BodyId before = world.add(static_body(vec3(0)));
    for (int k = 1; k <= count; ++k) {
      const vec3 x(0, 0, real(1.5) * real(k));
      const BodyId id = world.add(box(1, vec3(real(0.4), real(0.4), 1), x));
      hinges.push_back(&world.add<HingeJoint>(before, id,
                                              x - vec3(0, 0, real(0.75)), vec3(1, 0, 0)));
      hinges.back()->set_limits(-limit, limit);
      before = id;
    }
    feed_back_all(world);
  }
  double beyond(double limit) const {  // [rad]
    double most = 0;
    for (const HingeJoint* hinge : hinges)
      most = std::max(most, std::abs(double(hinge->position(world.bodies))) - limit);
    return most;
  }
};

}  // namespace

TEST_CASE("X11 a joint beside its limit is held whatever its neighbour weighs") {
  for (const int newton : {0, 8})
    for (const real weight : {real(1), real(10), real(1000)})
      for (const real speed : {real(10), real(-100)}) {
        CAPTURE(newton, weight, speed);
        const Beyond beyond = beyond_when_yanked(newton, weight, speed);
        // Newton's method keeps the sides of all rows, and may carry a joint past a free limit
        CHECK(beyond.most < (newton == 0 ? tolerance(0.01, 0.1) : tolerance(2, 4)));
        CHECK(beyond.last < 0.01);
      }
}

TEST_CASE("a limit found late leaves its island to the solver that the joints have") {
  Rotor rotor(real(0.5));
  rotor.hinge->set_limits(-5 * degree, 5 * degree);
  const BodyId thrown = rotor.world.add(body_with(1, vec3(1), vec3(real(1.5), 0, 0)));
  rotor.world.add<BallJoint>(
      rotor.body, thrown,
      point_at(rotor.world.bodies[rotor.body], rotor.world.bodies[thrown], vec3(1, 0, 0)));
  DirectSolver solver;
  step(rotor.world, solver, h);
  solver.most_work = solver.report().multiplications / double(rotor.world.blocks.C.size());
  step(rotor.world, solver, h);
  CHECK_FALSE(solver.report().iterated);
  rotor.world.bodies[thrown].v = vec3(0, 100, 0);
  step(rotor.world, solver, h);
  CHECK(solver.report().multiplications > solver.most_work * rotor.world.blocks.rows());
  CHECK_FALSE(solver.report().iterated);
  CHECK(std::abs(rotor.in_degrees() - 5) < 0.01);
}

TEST_CASE("X11 a rotor stops at its limit however fast it comes") {
  for (const int newton : {0, 8})
    for (const double limit : {45.0, 179.0, 720.0})
      for (const double speed : {5.0, 100.0}) {
        CAPTURE(newton, limit, speed);
        Rotor rotor(real(0.5), real(speed));
        rotor.hinge->set_limits(-real(limit) * degree, real(limit) * degree);
        feed_back_all(rotor.world);
        DirectSolver solver = with(newton);
        double furthest = 0;
        for (int n = 0; n < int(60 * (limit * double(degree) / speed + 0.5)); ++n) {
          step(rotor.world, solver, h, second_order);
          furthest = std::max(furthest, rotor.in_degrees());
        }
        CHECK(std::abs(furthest - limit) < 0.01);
        CHECK(std::abs(rotor.in_degrees() - limit) < 0.01);
        CHECK(std::abs(double(rotor.rotor().w.z)) < 1e-3);
      }
}

TEST_CASE("S4ml a motor rests at its limit with all of its torque, for a minute") {
  for (const int newton : {0, 8}) {
    Crane crane(vec3(0, 1, 0));
    crane.hinge->set_motor(3, 500);
    crane.hinge->set_limits(-60 * degree, 60 * degree);
    feed_back_all(crane.world);
    DirectSolver solver = with(newton);
    double lowest = 1e9, highest = 0;
    for (int n = 0; n < 3600; ++n) {
      step(crane.world, solver, h, second_order);
      highest = std::max(highest, crane.in_degrees());
      if (n > 600) lowest = std::min(lowest, crane.in_degrees());
    }
    CHECK(std::abs(highest - 60) < 0.01);
    CHECK(std::abs(lowest - 60) < 0.01);
    CHECK(double(crane.hinge->motor_force()) == Approx(500).epsilon(1e-5));
    CHECK(double(crane.hinge->limit_force()) == Approx(-500).epsilon(1e-3));
    CHECK(solver.report().wrong == 0);
  }
}

TEST_CASE("X12 a motor gives its torque until the target is reached, and no more") {
  Rotor rotor;
  rotor.hinge->set_motor(100, 2);
  DirectSolver solver;
  for (int n = 1; n <= 60; ++n) step(rotor.world, solver, h, second_order);
  CHECK(double(rotor.rotor().w.z) == Approx(2 - double(h)).epsilon(1e-5));  // half a step late
  CHECK(double(rotor.hinge->motor_force()) == Approx(2).epsilon(1e-5));
  rotor.hinge->set_motor(real(2.01), 2);
  for (int n = 1; n <= 60; ++n) step(rotor.world, solver, h, second_order);
  CHECK(double(rotor.rotor().w.z) == Approx(2.01).epsilon(1e-5));
  CHECK(std::abs(double(rotor.hinge->motor_force())) < 1e-3);
}

TEST_CASE("equal limits hold a hinge and a slider as welds would") {
  for (const int newton : {0, 8}) {
    World world;
    const BodyId wall = world.add(static_body(vec3(0)));
    const BodyId a = world.add(box(3, vec3(1, real(0.5), real(0.7)), vec3(1, 0, 0)));
    const BodyId b = world.add(box(2, vec3(1, real(0.5), real(0.7)), vec3(2, 0, 0)));
    auto& hinge = world.add<HingeJoint>(wall, a, vec3(0), vec3(0, 0, 1));
    auto& slider = world.add<SliderJoint>(a, b, vec3(real(1.5), 0, 0), vec3(1, 1, 0));
    hinge.set_limits(0, 0);
    slider.set_limits(0, 0);
    feed_back_all(world);
    DirectSolver solver = with(newton);
    for (int n = 0; n < 300; ++n) step(world, solver, h, second_order);
    CHECK(std::abs(double(hinge.position(world.bodies))) < tolerance(1e-9, 1e-5));
    CHECK(std::abs(double(slider.position(world.bodies))) < tolerance(1e-9, 1e-5));
    CHECK(double(hinge.limit_force()) == Approx(9.81 * (3 + 2 * 2)).epsilon(1e-3));
  }
}

TEST_CASE("forty limits hit at once take more passes than a few, and are all right then") {
  for (const int newton : {0, 8}) {
    CAPTURE(newton);
    Whip whip(40, real(0.2));
    for (int slot = 1; slot < whip.world.bodies.slots(); ++slot)
      whip.world.bodies.at(slot).w = vec3(real(slot % 2 == 0 ? -10 : 10), 0, 0);
    DirectSolver solver = with(newton);
    int wrong = 0, passes = 0;
    double beyond = 0, last = 0;
    for (int n = 0; n < 300; ++n) {
      step(whip.world, solver, h, second_order);
      wrong = std::max(wrong, solver.report().wrong);
      passes = std::max(passes, solver.report().passes);
      beyond = std::max(beyond, whip.beyond(0.2));
      last = whip.beyond(0.2);
    }
    CHECK(all_finite(whip.world));
    CHECK(passes > 10);
    CHECK(wrong == 0);
    CHECK(beyond < (newton == 0 ? 1e-3 : 1e-2));
    CHECK(last < 1e-4);
  }
}

TEST_CASE("dolls of any size that land on their limits keep their joints, and take few passes",
          "[slow]") {
  for (const bench::Family& family : bench::contact_families())
    for (unsigned seed = 1; family.name == "limited dolls" && seed <= 24; ++seed)
      for (const real added : {real(0), real(8)}) {
        CAPTURE(seed, added);
        bench::Drawn scene = family.draw(seed);
        feed_back_all(scene.world);
        DirectSolver solver = with(8, added);
        double gap = 0;
        int wrong = 0, passes = 0;
        for (int n = 0; n < 180; ++n) {
          step(scene.world, solver, h, second_order);
          gap = std::max(gap, widest_gap(scene));
          wrong += solver.report().wrong;
          passes = std::max(passes, solver.report().passes);
        }
        CHECK(gap < tolerance(added > 0 ? 1e-6 : 1e-4, 1e-3));
        CHECK(wrong == 0);
        CHECK(passes < 60);
      }
}

TEST_CASE("in drawn arms every motor stays within its torque, and every limit pushes back") {
  for (unsigned seed = 1; seed <= 24; ++seed) {
    DirectSolver solver = seed % 2 ? with(0) : DirectSolver();
    CAPTURE(seed, solver.newton);
    Random random(seed);
    World world;
    std::vector<std::pair<HingeJoint*, real>> motors;  // with their torques
    BodyId before = world.add(static_body(vec3(0)));
    vec3 end(0);
    for (int k = 0; k < 24; ++k) {
      const vec3 place = end + vec3(0, 0, 1) + random.vector(real(0.3));
      const real mass = std::exp(random.uniform(0, 3));
      const BodyId id = world.add(box(mass, vec3(real(0.4), real(0.4), real(0.8)), place));
      auto& hinge = world.add<HingeJoint>(before, id, (place + end) / real(2),
                                          normalize(random.vector(1)));
      const real torque = std::exp(random.uniform(0, 8)), speed = random.uniform(-1, 1);
      hinge.set_motor(speed, torque);
      hinge.set_limits(random.uniform(real(-0.4), real(-0.05)),
                       random.uniform(real(0.05), real(0.4)));
      motors.push_back({&hinge, torque});
      before = id, end = place;
    }
    feed_back_all(world);
    int wrong = 0, passes = 0;
    double most = 0, pulled = 0;  // torque of a motor over its greatest one; of a limit outwards
    for (int n = 0; n < 100; ++n) {
      step(world, solver, h, second_order);
      wrong += solver.report().wrong;
      passes = std::max(passes, solver.report().passes);
      for (const auto& [hinge, torque] : motors) {
        most = std::max(most, std::abs(double(hinge->motor_force() / torque)));
        const real outward = hinge->position(world.bodies) > 0 ? 1 : -1;
        pulled = std::max(pulled, double(outward * hinge->limit_force()));
      }
    }
    CHECK(most < 1 + 1e-5);
    if (solver.newton == 0) CHECK(pulled <= 0);  // a pose is reached by a pull, too
    CHECK(wrong == 0);
    CHECK(passes < 100);
  }
}
