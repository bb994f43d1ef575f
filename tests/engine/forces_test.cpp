// The forces that joints report under every stepping, whatever the lengths of the steps, and the
// velocities that belong to the poses.
#include <functional>

#include "bench/runge_kutta.h"
#include "engine/instruments/measure.h"
#include "engine/kept/reaction.h"
#include "engine/kept/state.h"
#include "engine/simd/packed.h"
#include "engine/steps/leapfrog.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;
const std::array<real, 6> lengths{h, h, h, 2 * h, 2 * h, h / 2};

using Move = std::function<void(World&, real)>;

// Every stepping, by every solver, and the Runge-Kutta method.
std::vector<std::pair<std::string, Move>> moves() {
  std::vector<std::pair<std::string, Move>> out;
  for (const bool warm : {false, true})
    for (const bool leapfrog : {false, true})
      for (const int substeps : {1, 3})
        for (const char* const solver : {"sequential", "packed", "direct", "direct, newton"}) {
          const std::string name = solver;
          std::shared_ptr<Solver> made;
          if (name == "sequential") made = std::make_shared<SequentialImpulses>();
          else if (name == "packed") made = std::make_shared<PackedImpulses>();
          else made = std::make_shared<DirectSolver>();
          if (name == "direct, newton") static_cast<DirectSolver&>(*made).newton = 8;
          const StepOptions how{.warm_start = warm, .substeps = substeps, .leapfrog = leapfrog};
          out.emplace_back(name + (warm ? ", warm" : ", cold") + (leapfrog ? ", leapfrog" : "") +
                               ", substeps " + std::to_string(substeps),
                           [made, how](World& world, real length) {
                             step(world, *made, length, how);
                           });
        }
  out.emplace_back("Runge-Kutta", [kutta = std::make_shared<RungeKutta>()](World& world,
                                                                           real length) {
    kutta->step(world, length);
  });
  return out;
}

// A body that hangs at rest below an anchor, by a joint of some kind, in gravity of any direction.
struct Weight {
  World world;
  Joint* joint = nullptr;
  double weight = 0;
  Weight(unsigned seed, int kind) {
    Random random(seed);
    const vec3 down = normalize(random.vector(1));
    world.gravity = real(9.81) * down;
    const real mass = std::exp(random.uniform(real(-3), real(5)));
    const real lever = random.uniform(real(0.2), real(2));
    weight = double(mass) * 9.81;
    const BodyId wall = world.add(static_body(random.vector(3)));
    const vec3 anchor = world.bodies[wall].x + random.vector(1);
    const BodyId id = world.add(box(mass, vec3(real(0.3), real(0.5), real(0.8)),
                                    anchor + lever * down, rotation(random.vector(2))));
    const Point point = point_at(world.bodies[wall], world.bodies[id], anchor);
    const vec3 across = normalize(cross(down, normalize(random.vector(1))));
    if (kind == 0) joint = &world.add<BallJoint>(wall, id, point);
    if (kind == 1) joint = &world.add<HingeJoint>(wall, id, anchor, across);
    if (kind == 2) joint = &world.add<FixedJoint>(wall, id, anchor);
    if (kind == 3) joint = &world.add<SliderJoint>(wall, id, anchor, across);
    if (kind == 4)
      joint = &world.add<DistanceJoint>(wall, id, Distance{point.anchor1_local, vec3(0), lever});
  }
  double force() const {
    return double(dot(reaction(*joint, world.bodies).force, -world.gravity)) / 9.81 / weight;
  }
};

}  // namespace

TEST_CASE("what hangs at rest reads its weight under every stepping and in steps of any length") {
  for (const auto& [name, move] : moves())
    for (unsigned seed = 1; seed <= 3; ++seed)
      for (int kind = 0; kind < 5; ++kind) {
        Weight one(seed, kind);
        for (const real length : lengths) {
          CAPTURE(name, seed, kind, double(length));
          move(one.world, length);
          REQUIRE(one.force() == Approx(1).epsilon(tolerance(1e-9, 2e-3)));
          if (kind == 2)
            CHECK(double(glm::length(static_cast<FixedJoint&>(*one.joint).load().force)) ==
                  Approx(one.weight).epsilon(tolerance(1e-9, 2e-3)));
        }
      }
}

TEST_CASE("motor and limit and spring read their forces under leapfrog in steps of any length") {
  for (unsigned seed = 1; seed <= 4; ++seed)
    for (const bool warm : {false, true})
      for (const bool direct : {false, true}) {
        SequentialImpulses iterated;
        DirectSolver at_once;
        iterated.iterations = 300;
        Solver& solver = direct ? static_cast<Solver&>(at_once) : iterated;
        const StepOptions how{.warm_start = warm, .leapfrog = true};
        CAPTURE(seed, warm, direct);
        Random random(seed);
        const real strength = random.uniform(real(0.5), real(20));
        Rotor rotor(real(0.5));
        rotor.hinge->set_motor(-9, strength);
        rotor.hinge->set_limits(0, 1);  // it stands at the lower one
        for (const real length : lengths) {
          step(rotor.world, solver, length, how);
          CHECK(double(rotor.hinge->motor_force() / strength) ==
                Approx(-1).epsilon(tolerance(1e-9, 1e-3)));
          if (is_float && direct) continue;  // the limit's share may be lost in its rounding
          CHECK(double(rotor.hinge->limit_force() / strength) ==
                Approx(1).epsilon(tolerance(1e-5, 1e-3)));  // bounded rows are softened
        }
        Weight hung(seed, 0);  // at rest at its spring's own length
        hung.joint->frequency = random.uniform(real(1), real(10));
        const real omega = 2 * std::numbers::pi_v<real> * hung.joint->frequency;
        hung.world.bodies.at(1).x += hung.world.gravity / (omega * omega);
        for (const real length : lengths) {
          step(hung.world, solver, length, how);
          CHECK(hung.force() == Approx(1).epsilon(tolerance(1e-9, 2e-3)));
        }
      }
}

TEST_CASE("a warm chain at rest stays at rest with one iteration in steps of any length") {
  for (const bool leapfrog : {false, true}) {
    World world;
    BodyId before = world.add(static_body(vec3(0)));
    for (int k = 0; k < 5; ++k) {
      const BodyId next = world.add(box(real(k + 1), vec3(real(0.3)), vec3(0, real(-k - 1), 0)));
      world.add<BallJoint>(before, next, point_at(world.bodies[before], world.bodies[next],
                                                  vec3(0, real(-k) - real(0.5), 0)));
      before = next;
    }
    SequentialImpulses solver;
    StepOptions how{.warm_start = true, .leapfrog = leapfrog};
    solver.iterations = 5000;
    for (int n = 0; n < 3; ++n) step(world, solver, h, how);
    solver.iterations = 1;
    for (const real length : lengths) {
      step(world, solver, length, how);
      CHECK(double(reaction(*world.joints()[0], world.bodies).force.y) ==
            Approx(15 * 9.81).epsilon(tolerance(1e-9, 2e-3)));
      const Bodies now = velocities_at_pose_time(world, solver, how.warm_start);
      for (const Body& body : all_of(leapfrog ? now : world.bodies))
        CHECK(double(glm::length(body.v)) < tolerance(1e-9, 1e-3));
    }
  }
}

TEST_CASE("a motor and a spring pull for half a step in synchronised velocities") {
  for (unsigned seed = 1; seed <= 4; ++seed)
    for (const bool warm : {false, true}) {
      Random random(seed);
      const StepOptions how{.warm_start = warm, .leapfrog = true};
      SequentialImpulses solver;
      solver.iterations = 300;
      const auto middles = [&](World& world, auto speed) {  // of a step, and between two
        step(world, solver, h / 4, how);
        const real before = speed(world.bodies);
        const real now = speed(velocities_at_pose_time(world, solver, warm));
        step(world, solver, h / 4, how);
        return std::pair{double(before + speed(world.bodies)) / 2, double(now)};
      };
      Rotor rotor;
      rotor.hinge->set_motor(9, random.uniform(real(0.5), real(20)));
      Weight hung(seed, 0);
      hung.joint->frequency = random.uniform(real(1), real(3));
      for (int n = 0; n < 5; ++n) {
        CAPTURE(seed, warm, n);
        const auto [turning, turns] =
            middles(rotor.world, [](const Bodies& bodies) { return bodies.at(1).w.z; });
        CHECK(turns == Approx(turning).epsilon(tolerance(1e-9, 1e-4)));
        const auto [falling, falls] = middles(hung.world, [&](const Bodies& bodies) {
          return dot(bodies.at(1).v, hung.world.gravity) / real(9.81);
        });
        CHECK(falls == Approx(falling).epsilon(0.05));
      }
    }
}

// A double pendulum of boxes, let go at rest.
namespace {
World pendulum(unsigned seed) {
  World world;
  Random random(seed);
  BodyId before = world.add(static_body(vec3(0)));
  vec3 at(0);
  for (int k = 0; k < 2; ++k) {
    const vec3 way = random.uniform(real(0.5), real(1)) * normalize(random.vector(1));
    const BodyId next = world.add(box(random.uniform(real(1), real(3)),
                                      vec3(real(0.4), real(0.3), real(0.2)), at + way));
    world.add<BallJoint>(before, next, point_at(world.bodies[before], world.bodies[next], at));
    before = next;
    at += real(2) * way;
  }
  return world;
}
}  // namespace

TEST_CASE("synchronised velocities have the energy to second order and leave the world alone") {
  if (is_float) return;  // rounding would hide it
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const auto error = [&](int rate, bool at_poses) {
      World world = pendulum(seed);
      DirectSolver solver, other = DirectSolver::velocities_only();
      solver.added_inertia = 0;
      const StepOptions how{.leapfrog = true};
      const double before = energy(all_of(world.bodies), world.gravity);
      double worst = 0;
      for (int n = 0; n < rate; ++n) {
        step(world, solver, real(1) / real(rate), how);
        const State then = save(world);
        const Bodies now = velocities_at_pose_time(world, other, how.warm_start);
        REQUIRE(save(world) == then);
        worst = std::max(worst, std::abs(energy(all_of(at_poses ? now : world.bodies),
                                                world.gravity) - before));
      }
      return worst;
    };
    CAPTURE(seed);
    const double fine = error(480, true);
    CHECK(fine < error(240, true) / 3);
    CHECK(fine < error(480, false) / 1.5);
  }
}
