// Everything that acts on a free coordinate, alone and together: motor and friction, servo, spring,
// damper. Families drawn by seeds, for angles and displacements, with every kind of solver.
#include "engine/kept/state.h"
#include "joints/driven_joints.h"
#include "tests/joints/three_solvers.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;

// A sledge on a rail, or a wheel on an axle, with an outer force or torque along its coordinate.
struct Driven {
  World world = weightless();
  BodyId wall = world.add(static_body(vec3(0))), body;
  SliderJoint* slider = nullptr;
  HingeJoint* hinge = nullptr;
  Driven(bool turns, real mass, real load) {
    body = world.add(box(mass, vec3(1, real(0.5), real(0.2)), vec3(0)));
    const vec3 axis(0, 0, 1);
    if (turns) hinge = &world.add<HingeJoint>(wall, body, vec3(0), axis);
    else slider = &world.add<SliderJoint>(wall, body, vec3(0), axis);
    (turns ? world.bodies[body].torque : world.bodies[body].force) = load * axis;
  }
  // Calls a function with the coordinate, whichever it is.
  template <class Use>
  auto with(const Use& use) { return hinge ? use(*hinge) : use(*slider); }
  double speed() {
    return with([&](auto& free) { return double(free.speed(world.bodies)); });
  }
  double position() {
    return with([&](auto& free) { return double(free.position(world.bodies)); });
  }
};

const double few = testing::is_float ? 2e-3 : 1e-6;

}  // namespace

TEST_CASE("a motor and friction together give the force of both at every speed") {
  int stuck = 0, running = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const bool turns = seed % 2 == 0;
    const real mass = random.uniform(1, 5), load = random.uniform(-4, 4);
    const real strength = random.uniform(1, 20), friction = random.uniform(1, 20);
    const real target = random.uniform(real(0.2), 2) * (seed % 3 == 0 ? -1 : 1);
    const double sign = target < 0 ? -1 : 1, along = sign * double(load);
    const double surplus = double(strength) + along - double(friction);
    if (std::abs(surplus) < 0.5 || along > double(strength + friction) - 0.5 ||
        along + double(strength + friction) < 0.5)
      continue;  // too near to the edge between rest and motion, or it runs away
    for (const auto& solver : three_solvers(40)) {
      Driven one(turns, mass, load);
      one.with([&](auto& free) { free.set_motor(target, strength), free.set_friction(friction); });
      for (int n = 0; n < 1500; ++n) step(one.world, *solver, h, {.warm_start = true});
      CAPTURE(seed, turns, load, strength, friction, target);
      const double motor = one.with([](auto& free) { return double(free.motor_force()); });
      const double rub = one.with([](auto& free) { return double(free.friction_force()); });
      CHECK(motor + rub + double(load) == Approx(0).margin(100 * few));
      if (surplus > 0) {
        CHECK(one.speed() == Approx(double(target)).margin(few));
        CHECK(rub == Approx(-sign * double(friction)).epsilon(few));
      } else {
        CHECK(one.speed() == Approx(0).margin(few));
        CHECK(motor == Approx(sign * double(strength)).epsilon(few));
      }
      (surplus > 0 ? running : stuck)++;
    }
  }
  CHECK(running > 30);
  CHECK(stuck > 15);
}

TEST_CASE("a spring of k and c sags by F / k, and the suspension by 98.1 mm") {
  for (unsigned seed = 0; seed <= 30; ++seed) {
    Random random(seed);
    const bool suspension = seed == 0, turns = !suspension && seed % 2 == 0;
    const real mass = suspension ? real(200) : std::exp(random.uniform(-2, 7));
    const real w = random.uniform(2, 20);  // [rad/s]
    const real k = suspension ? real(20000) : mass * w * w;
    const real load = suspension ? real(200 * -9.81) : k * random.uniform(real(-0.5), real(0.5));
    const real c = suspension ? real(1500) : real(1.2) * std::sqrt(k * mass);
    const double sag = double(load) / double(k);
    for (const auto& solver : three_solvers(40))
      for (const bool leapfrog : {false, true}) {
        Driven one(turns, mass, load);
        one.with([&](auto& free) { free.set_spring({.stiffness = k, .damping = c}); });
        double before = 0, worst = 0;
        for (int n = 0; n < 3000; ++n) {
          step(one.world, *solver, h, {.warm_start = true, .leapfrog = leapfrog});
          if (n > 2900) worst = std::max(worst, std::abs(one.position() - before));
          before = one.position();
        }
        CAPTURE(seed, turns, mass, k, c, load, leapfrog);
        CHECK(one.position() == Approx(sag).epsilon(1e-4));
        CHECK(worst < 1e-3 * std::abs(sag));
        CHECK(one.with([](auto& free) { return double(free.spring_force()); }) ==
              Approx(-double(load)).epsilon(1e-3));
        if (suspension) CHECK(1000 * one.position() == Approx(-98.1).margin(0.01));
      }
  }
}

TEST_CASE("a spring swings with the frequency of k, and a damper alone lets go at F / c") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const real mass = random.uniform(1, 50), w = random.uniform(1, 6);
    for (const auto& solver : three_solvers(40)) {
      CAPTURE(seed, mass, w);
      Driven one(false, mass, 0);
      one.slider->set_spring({.stiffness = w * w * mass, .rest = real(0.5)});
      const real fine = real(1) / 4000;
      const int steps = int(std::numbers::pi / double(w * fine));  // half a period
      for (int n = 0; n < steps; ++n) step(one.world, *solver, fine);
      CHECK(one.position() == Approx(1).margin(tolerance(6e-3, 4e-2)));
      const real c = random.uniform(1, 20), load = random.uniform(-5, 5);
      Driven damped(false, mass, load);
      damped.slider->set_spring({.damping = c});
      for (int n = 0; n < 4000; ++n) step(damped.world, *solver, real(0.1));
      CHECK(damped.speed() == Approx(double(load) / double(c)).epsilon(1e-3));
    }
  }
}

TEST_CASE("a servo reaches its target within its speed and holds it against a load") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const bool turns = seed % 2 == 0;
    const real target = random.uniform(-12, 12), fastest = random.uniform(1, 8);
    const real load = random.uniform(-20, 20);
    for (const auto& solver : three_solvers(40)) {
      CAPTURE(seed, turns, target, fastest, load);
      Driven one(turns, random.uniform(1, 5), load);
      one.with([&](auto& free) { free.set_servo(target, fastest, 500); });
      double most = 0;
      for (int n = 0; n < 1200; ++n) {
        step(one.world, *solver, h, {.warm_start = true});
        most = std::max(most, std::abs(one.speed()));
      }
      CHECK(most < double(fastest) + 1e-2);
      CHECK(one.position() == Approx(double(target)).margin(turns ? 1e-3 : 1e-4));
      CHECK(one.with([](auto& free) { return double(free.motor_force()); }) ==
            Approx(-double(load)).margin(1e-2));
    }
  }
}

TEST_CASE("a spring with a strength is a drive that gives way beyond it") {
  for (const double load : {5.0, 9.0, 11.0, 20.0})
    for (const auto& solver : three_solvers(40)) {
      Driven one(false, 2, real(load));
      one.slider->set_spring({.stiffness = 100, .damping = 40, .rest = 1, .strength = 10});
      for (int n = 0; n < 600; ++n) step(one.world, *solver, h, {.warm_start = true});
      CAPTURE(load);
      if (load < 10) CHECK(one.position() == Approx(1 + load / 100).epsilon(1e-3));
      else CHECK(one.speed() > 1);
      CHECK(double(one.slider->spring_force()) == Approx(-std::min(load, 10.0)).epsilon(1e-3));
    }
}

TEST_CASE("a world with every drive goes on from its state as if it had never been saved") {
  const auto make = [] {
    Driven one(true, 3, 2);
    one.hinge->set_limits(-1, 20);
    one.hinge->set_spring({.stiffness = 3, .damping = real(0.1), .rest = 4, .strength = 40});
    one.hinge->set_servo(9, 2, 10);
    one.hinge->set_friction(3);
    return one;
  };
  const StepOptions warm{.warm_start = true};
  SequentialImpulses solver;
  Driven one = make();
  for (int n = 0; n < 200; ++n) step(one.world, solver, h, warm);
  Driven other = make();
  auto& again = dynamic_cast<HingeJoint&>(*other.world.joints()[0]);
  restore(other.world, save(one.world));
  CHECK(again.friction_force() == one.hinge->friction_force());
  CHECK(again.spring_force() == one.hinge->spring_force());
  for (int n = 0; n < 200; ++n) {
    step(one.world, solver, h, warm), step(other.world, solver, h, warm);
    REQUIRE(again.position(other.world.bodies) == one.hinge->position(one.world.bodies));
  }
}

TEST_CASE("settings that no drive can have are refused and change nothing") {
  Driven one(false, 1, 0);
  SliderJoint& slider = *one.slider;
  slider.set_spring({.stiffness = 1});
  slider.set_servo(2, 3, 4);
  for (const Spring& bad : {Spring{-1}, Spring{1, -1}, Spring{1, 1, unbounded},
                            Spring{1, 1, 0, -1}, Spring{unbounded}})
    CHECK(refusal([&] { slider.set_spring(bad); }) != "accepted");
  CHECK(refusal([&] { slider.set_servo(unbounded, 1, 1); }) != "accepted");
  CHECK(refusal([&] { slider.set_servo(1, -1, 1); }) != "accepted");
  CHECK(slider.spring().stiffness == 1);
  CHECK(slider.motor().speed == 3);
  CHECK(slider.motor().strength == 4);
}
