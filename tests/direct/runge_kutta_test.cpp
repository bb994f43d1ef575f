// The Runge-Kutta method outside chains: hubs and nets, springs, forces that depend on the state,
// and the forces of joints.
#include "bench/runge_kutta.h"
#include "engine/instruments/measure.h"
#include "engine/kept/reaction.h"
#include "engine/kept/state.h"
#include "tests/direct/rigs.h"
#include "tests/oracle/test.h"

using namespace joints::chapter9;

namespace {

const real h = sixtieth;

Column places(const Bodies& bodies) {
  Column out(6 * long(bodies.slots()));
  for (int slot = 0; slot < bodies.slots(); ++slot)
    for (int i = 0; i < 3; ++i) {
      out[6 * slot + i] = double(bodies.at(slot).x[i]);
      out[6 * slot + 3 + i] = double((bodies.at(slot).q * vec3(real(0.6), real(0.8), 0))[i]);
    }
  return out;
}

// By what power of two a step of half the length is better. \param run a motion at so many steps
double order(const std::function<Column(int rate)>& run, int rate) {
  const Column coarse = run(rate), middle = run(2 * rate), fine = run(4 * rate);
  CHECK((middle - fine).norm() > 1e-13);  // more than rounding
  return std::log2((coarse - middle).norm() / (middle - fine).norm());
}

double energy_of(const World& world) { return energy(all_of(world.bodies), world.gravity); }

// A hub with arms of any length on balls, in space, hub and arms moving as joints let them.
World hub(unsigned seed, int arms) {
  World world;
  Random random(seed);
  world.gravity = vec3(0);
  const BodyId middle = world.add(ball(random.uniform(1, 10), 1, vec3(0)));
  world.bodies[middle].w = random.vector(2);
  for (int k = 0; k < arms; ++k) {
    const vec3 way = normalize(random.vector(1));
    const real size = random.uniform(real(0.3), real(1.3));
    Body arm = box(random.uniform(real(0.5), 2), vec3(real(0.1), size, real(0.2)),
                   (1 + size / 2) * way);
    arm.w = random.vector(1);
    arm.v = cross(world.bodies[middle].w, way) - cross(arm.w, -(size / 2) * way);
    const BodyId id = world.add(arm);
    world.add<BallJoint>(middle, id, point_at(world.bodies[middle], world.bodies[id], way));
  }
  return world;
}

}  // namespace

TEST_CASE("the Runge-Kutta method holds hubs of which the solver alone would iterate") {
  for (const int arms : {45, 100}) {
    World world = hub(unsigned(arms), arms);
    DirectSolver solver;
    begin_step(world, solver, h);
    REQUIRE(solver.report().iterated);
    world = hub(unsigned(arms), arms);
    const double before = energy_of(world);
    const Momentum start = momentum(all_of(world.bodies));
    RungeKutta kutta;
    for (int n = 0; n < 20; ++n) kutta.step(world, h / 4);
    CHECK(energy_of(world) == Approx(before).epsilon(tolerance(1e-5, 1e-3)));
    const Momentum end = momentum(all_of(world.bodies));
    CHECK(glm::length(end.angular - start.angular) < tolerance(1e-6, 1e-2) * before);
    for (const auto& joint : world.joints()) {
      Blocks blocks;
      joint->append(world.bodies, blocks);
      for (const real C : blocks.C) REQUIRE(std::abs(double(C)) < tolerance(1e-9, 1e-3));
    }
  }
}

TEST_CASE("the Runge-Kutta method refuses in words what takes too much work or finds no poses") {
  World large = hub(7, 300);
  const State before = save(large);
  RungeKutta kutta;
  CHECK(refusal([&] { kutta.step(large, h); }).find("most_work") != std::string::npos);
  CHECK(save(large) == before);
  // a net of balls held at its corners: some rows depend on others, and it cannot sag
  Scene taut = net(4);
  for (const int slot : {0, 3, 12, 15})
    taut.world.bodies.at(slot) = static_body(taut.world.bodies.at(slot).x);
  std::string words;
  State last;
  try {
    for (int n = 0; n < 100; ++n) {
      last = save(taut.world);
      kutta.step(taut.world, h);
      REQUIRE(std::abs(energy_of(taut.world)) < 10);
    }
  } catch (const std::runtime_error& error) {
    words = error.what();
    CHECK(save(taut.world).bodies == last.bodies);
  }
  if (!is_float) CHECK(words.find("shorter step") != std::string::npos);  // in float it sags
}

TEST_CASE("the Runge-Kutta method refuses whatever acts on a free coordinate, and says so") {
  for (unsigned seed = 1; seed <= 10; ++seed)
    for (const int what : {0, 1, 2, 3}) {
      CAPTURE(seed, what);
      Random random(seed);
      World world;
      const BodyId wall = world.add(static_body(vec3(0)));
      const BodyId a = world.add(box(1, vec3(real(0.3)), random.vector(1)));
      const auto set = [&](auto& free) {
        const real size = random.uniform(1, 100);
        if (what == 0) free.set_spring({.stiffness = size});
        if (what == 1) free.set_spring({.damping = size});
        if (what == 2) free.set_friction(size);
        if (what == 3) free.set_limits(-size, size);
      };
      if (seed % 2 == 0) set(world.add<HingeJoint>(wall, a, vec3(0), random.vector(1)));
      else set(world.add<SliderJoint>(wall, a, vec3(0), random.vector(1)));
      const State before = save(world);
      RungeKutta kutta;
      CHECK(refusal([&] { kutta.step(world, h); }).find("spring of a coordinate") !=
            std::string::npos);
      CHECK(save(world) == before);
    }
}

TEST_CASE("the Runge-Kutta method refuses forces that add or remove bodies or joints") {
  for (const int what : {0, 1, 2}) {
    CAPTURE(what);
    World world = hub(3, 4);
    RungeKutta kutta;
    kutta.forces = [&](Bodies&, real) {
      if (what == 0) world.add(ball(1, 1, vec3(9)));
      if (what == 1) world.remove(*world.joints().front());
      if (what == 2) world.remove(world.joints().front()->body2);
    };
    CHECK(refusal([&] { kutta.step(world, h); }).find("forces:") == 0);
  }
}

TEST_CASE("the Runge-Kutta method refuses a hub of 1,000 arms, and a net of 30 x 30 it moves or "
          "refuses") {
  World large = hub(8, 1000);
  const State before = save(large);
  RungeKutta kutta;
  CHECK(refusal([&] { kutta.step(large, h); }).find("most_work") != std::string::npos);
  CHECK(save(large) == before);
  Scene wide = net(30);
  const double start = energy_of(wide.world);
  State last;
  try {
    for (int n = 0; n < 10; ++n) {
      last = save(wide.world);
      kutta.step(wide.world, h);
    }
    CHECK(std::abs(energy_of(wide.world) - start) < tolerance(1e-3, 10));
    CHECK(widest_gap(wide) < tolerance(1e-9, 1e-3));
  } catch (const std::exception& error) {
    INFO(error.what());
    CHECK(std::string(error.what()).find("world:") == 0);
    CHECK(save(wide.world).bodies == last.bodies);
  }
}

TEST_CASE("the Runge-Kutta method is of order 4 on springs and on forces of state and time") {
  if (is_float) return;  // rounding hides it
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const auto run = [&](int rate, int what) {
      Random random(seed);
      World world;
      const BodyId wall = world.add(static_body(vec3(0)));
      const auto add = [&](const vec3& x) {
        return world.add(body_with(random.uniform(1, 3), vec3(real(0.2), real(0.3), real(0.4)), x,
                                   random.turn()));
      };
      const BodyId a = add(vec3(1, 0, 0)), b = add(vec3(2, real(0.2), 0));
      auto& first = world.add<HingeJoint>(wall, a, vec3(real(0.2)), random.vector(1));
      world.add<FixedJoint>(a, b, vec3(real(1.5), 0, real(0.1)));
      if (what == 0) {  // springs in the place of both
        first.frequency = random.uniform(real(0.5), 2);
        first.damping = random.uniform(real(0), real(0.5));
        world.joints()[1]->frequency = random.uniform(1, 2);
        world.joints()[1]->damping = real(0.1);
      }
      RungeKutta kutta;
      real t = 0;
      const real k = random.uniform(5, 20), push = random.uniform(1, 5);
      if (what == 1)
        kutta.forces = [&](Bodies& bodies, real time) {  // a spring that hardens, drag, a drive
          Body& body = bodies[b];
          body.force = -k * dot(body.x, body.x) * body.x - real(0.3) * length(body.v) * body.v;
          body.torque = vec3(0, push * std::sin(5 * (t + time)), 0) - real(0.2) * body.w;
        };
      for (int n = 0; n < rate / 2; ++n) {
        kutta.step(world, real(1) / real(rate));
        t += real(1) / real(rate);
      }
      return places(world.bodies);
    };
    for (const int what : {0, 1}) {
      CAPTURE(seed, what);
      CHECK(order([&](int rate) { return run(rate, what); }, 160) == Approx(4).margin(0.3));
    }
  }
}

TEST_CASE("a spring of the Runge-Kutta method is the limit of soft rows in short steps") {
  if (is_float) return;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const auto made = [&] {
      Random random(seed);
      World world;
      const BodyId wall = world.add(static_body(vec3(0)));
      const BodyId a = world.add(body_with(2, vec3(real(0.2), real(0.3), real(0.4)),
                                           vec3(1, 0, 0), random.turn()));
      auto& weld = world.add<FixedJoint>(wall, a, random.vector(real(0.5)));
      weld.frequency = random.uniform(1, 3);
      weld.damping = random.uniform(real(0), real(0.4));
      return world;
    };
    World exact = made(), stepped = made();
    RungeKutta kutta;
    SequentialImpulses solver;
    for (int n = 0; n < 50; ++n) kutta.step(exact, real(0.01));
    for (int n = 0; n < 5000; ++n) step(stepped, solver, real(1e-4), {.warm_start = true});
    CHECK((places(exact.bodies) - places(stepped.bodies)).largest() < 2e-3);
    const Reaction one = reaction(*exact.joints()[0], exact.bodies);
    const Reaction other = reaction(*stepped.joints()[0], stepped.bodies);
    CHECK(double(length(one.force - other.force)) < 0.05 * double(length(other.force)) + 1);
    CHECK(double(exact.last_h) == 0.01);
  }
}

TEST_CASE("joints report the mean force of a Runge-Kutta step as short steps do") {
  if (is_float) return;
  Scene long_steps = heavy_chain(4, 3), short_steps = heavy_chain(4, 3);
  RungeKutta kutta;
  DirectSolver solver = shake();
  for (int n = 0; n < 30; ++n) {
    kutta.step(long_steps.world, real(1) / 120);
    std::vector<vec3> mean(long_steps.world.joints().size(), vec3(0));
    for (int k = 0; k < 20; ++k) {
      step(short_steps.world, solver, real(1) / 2400, second_order);
      for (std::size_t j = 0; j < mean.size(); ++j)
        mean[j] += reaction(*short_steps.world.joints()[j], short_steps.world.bodies).force /
                   real(20);
    }
    for (std::size_t j = 0; j < mean.size(); ++j)
      CHECK(double(length(reaction(*long_steps.world.joints()[j], long_steps.world.bodies).force -
                          mean[j])) < 0.03 * double(length(mean[j])) + 1e-3 * 9.81);
  }
}
