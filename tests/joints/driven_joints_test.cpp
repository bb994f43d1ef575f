// Joints with several free coordinates: their rows beside differences, what their coordinates
// measure, limits in every direction, drives, locks, and the forces.
#include "checker/check_part.h"
#include "engine/kept/state.h"
#include "joints/driven_joints.h"
#include "joints/fixed_joint.h"
#include "tests/joints/three_solvers.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60, pi = std::numbers::pi_v<real>;

// A wall and a body, not in a special pose.
struct Two {
  World world = weightless();
  BodyId wall, body;
  explicit Two(Random& random) {
    wall = world.add(static_body(vec3(0), random.turn()));
    body = world.add(box(random.uniform(1, 4), vec3(1, real(0.5), real(0.3)), vec3(0),
                         random.turn()));
  }
  Body& it() { return world.bodies[body]; }
};

}  // namespace

TEST_CASE("swing and length of a joint have the slope of their error wherever they are made") {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    Random random(seed);
    const CheckSettings exact{.seed = 50 * seed, .exact_when_broken = !testing::is_float};
    const vec3 a1 = drawn_direction(random), a2 = drawn_direction(random);
    const vec3 n1 = normalize(cross(a1, drawn_direction(random)));
    // In float a difference near half a turn is too coarse.
    const real most = seed == 1 ? real(1e-4) : testing::is_float ? real(1.5) : real(2.9);
    const auto swung = [&](PoseRandom& draw) {  // by up to 166 degrees
      PosePair pair = any_pose(draw);
      const vec3 from = to_world(pair.body1, a1);
      const vec3 about = normalize(cross(from, draw.vector(1) + vec3(0, 3, 0)));
      const quat swing = rotation(draw.uniform(-most, most) * about);
      pair.body2.q = swing * rotation(draw.uniform(-3, 3) * from) *
                     rotation(pi * normalize(from + to_world(pair.body1, a2))) * pair.body1.q;
      return pair;
    };
    for (const PartReport& report :
         {check_part(SwingAngle{a1, n1, a2}, swung, exact),
          check_part(Length{random.vector(1), random.vector(1) + vec3(9, 0, 0)}, any_pose,
                     exact)}) {
      INFO(report.text());
      if (report["poses"].holds) CHECK(report.good());
      CHECK(report["J"].right == report["J"].poses);
      CHECK(report["rank"].right == report["rank"].poses);
      CHECK(report["broken J"].right >= report["broken J"].poses - (testing::is_float ? 4 : 0));
    }
  }
}

TEST_CASE("an angle that is held has the slope of its error at every swing, half a turn too") {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    Random random(seed);
    const vec3 a1 = drawn_direction(random), n1 = normalize(cross(a1, drawn_direction(random)));
    const CheckSettings settings{.seed = 70 * seed, .exact_when_broken = !testing::is_float};
    const HeldAngle twist{{a1, random.turn(), 0}, random.uniform(-4, 4), seed % 2 ? real(1) : -1};
    for (const PartReport& report :
         {check_part(twist, any_pose, settings),
          check_part(HeldSwing{{a1, n1, drawn_direction(random)}}, any_pose, settings)}) {
      INFO(report.text());
      CHECK(report["J"].right == report["J"].poses);
      CHECK(report["rank"].right == report["rank"].poses);
      CHECK(report["broken J"].right >= report["broken J"].poses - (testing::is_float ? 4 : 0));
    }
    // where C = 0 the row has length 1: at half a turn of swing, too
    const vec3 across = normalize(cross(a1, drawn_direction(random)));
    PosePair pair{ball(1, 1, vec3(0)), ball(1, 1, vec3(0))};
    pair.body1.q = random.turn();
    pair.body2.q = pair.body1.q * rotation(pi * across) * rotation(twist.at * a1) *
                   twist.angle.start;
    CHECK(double(twist.error(pair.body1, pair.body2)) == Approx(0).margin(tolerance(1e-14, 1e-5)));
    CHECK(double(length(twist.jacobian(pair.body1, pair.body2).w2)) ==
          Approx(1).epsilon(tolerance(1e-13, 1e-5)));
  }
}

TEST_CASE("the two angles of a universal joint are those of its pins, with limits and motors") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    Two two(random);
    const vec3 pin1 = drawn_direction(random), pin2 = normalize(cross(pin1, random.vector(1)));
    auto& joint = two.world.add<UniversalJoint>(two.wall, two.body, vec3(0), pin1, pin2);
    const real a = random.uniform(real(-2.5), real(2.5)), b = random.uniform(real(-2.5), real(2.5));
    const quat start = two.it().q;
    two.it().q = rotation(a * pin1) * rotation(b * pin2) * start;
    CAPTURE(seed, a, b);
    const double few = tolerance(1e-9, 1e-4);
    CHECK(double(joint.angle1().position(two.world.bodies)) == Approx(double(a)).margin(few));
    CHECK(double(joint.angle2().position(two.world.bodies)) == Approx(double(b)).margin(few));
    for (const auto& solver : three_solvers(100)) {
      two.it().q = start;
      two.it().w = two.it().v = vec3(0);
      joint.angle1().set_motor(2, 50);
      joint.angle1().set_limits(-1, real(0.7));
      joint.angle2().set_servo(real(-0.4), 3, 50);
      for (int n = 0; n < 120; ++n) step(two.world, *solver, h, {.warm_start = true});
      CHECK(double(joint.angle1().position(two.world.bodies)) == Approx(0.7).margin(2e-3));
      CHECK(double(joint.angle2().position(two.world.bodies)) == Approx(-0.4).margin(2e-3));
      CHECK(double(joint.angle1().motor_force()) == Approx(50).epsilon(1e-3));
      CHECK(double(joint.angle1().limit_force()) == Approx(-50).epsilon(tolerance(2e-2, 1e-1)));
    }
  }
}

TEST_CASE("a shoulder is stopped by its cone and by its twist in every direction") {
  double beyond = 0, twisted = 0;
  int cases = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    const real limit = random.uniform(real(0.2), real(1.5)), most = random.uniform(real(0.2), 1);
    const vec3 axis = drawn_direction(random), across = random.vector(1);
    const vec3 throw_ = real(100) * normalize(random.vector(1));
    for (const auto& solver : three_solvers(30)) {
      Random again(seed);
      Two two(again);
      auto& joint = two.world.add<ConeTwistJoint>(two.wall, two.body, vec3(0), axis, across, limit);
      joint.twist().set_limits(-most, most);
      const vec3 moving = to_local(two.it(), axis);
      two.it().w = throw_;
      for (int n = 0; n < 60; ++n) {
        step(two.world, *solver, h, {.warm_start = true});
        const vec3 now = to_world(two.it(), moving);
        const double swing = std::atan2(double(length(cross(axis, now))), double(dot(axis, now)));
        beyond = std::max(beyond, swing - double(limit));
        twisted = std::max(twisted, std::abs(double(joint.twist().position(two.world.bodies))) -
                                        double(most));
      }
      ++cases;
    }
  }
  CAPTURE(cases, beyond * 180 / double(pi), twisted * 180 / double(pi));
  CHECK(beyond < 0.5 * double(pi) / 180);
  CHECK(twisted < 0.5 * double(pi) / 180);
}

TEST_CASE("limits of the angles of any joint stop 100 rad/s within half a degree") {
  const auto beyond = [](const auto& angle, const Bodies& bodies) {
    const double x = double(angle.position(bodies));
    return std::max(x - double(angle.limits().upper), double(angle.limits().lower) - x);
  };
  for (const bool six : {false, true}) {
    int all = 0, held = 0;
    double worst = 0;
    for (unsigned seed = 1; seed <= 100; ++seed)
      for (const auto& solver : three_solvers(30)) {
        Random random(seed);
        Two two(random);
        Bodies& bodies = two.world.bodies;
        const vec3 first = drawn_direction(random), second = random.vector(1);
        const auto limit = [&](auto& angle) {
          const real below = random.uniform(real(0.2), real(0.8));
          angle.set_limits(-below, random.uniform(real(0.2), real(0.8)));
        };
        std::function<double()> most;
        if (six) {
          auto& joint = two.world.add<SixDofJoint>(two.wall, two.body, vec3(0), first, second);
          joint.slide1().set_limits(0, 0);
          joint.slide2().set_limits(0, 0);
          joint.slide3().set_limits(0, 0);
          limit(joint.twist()), limit(joint.swing2()), limit(joint.swing3());
          most = [&] {
            return std::max({beyond(joint.twist(), bodies), beyond(joint.swing2(), bodies),
                             beyond(joint.swing3(), bodies)});
          };
        } else {
          auto& joint = two.world.add<UniversalJoint>(two.wall, two.body, vec3(0), first, second);
          limit(joint.angle1()), limit(joint.angle2());
          most = [&] {
            return std::max(beyond(joint.angle1(), bodies), beyond(joint.angle2(), bodies));
          };
        }
        two.it().w = real(100) * normalize(random.vector(1));
        double past = 0;
        for (int n = 0; n < 60; ++n) {
          step(two.world, *solver, h, {.warm_start = true});
          past = std::max(past, most() * 180 / double(pi));
        }
        ++all;
        held += past < 0.5;
        worst = std::max(worst, past);
      }
    INFO((six ? "six degrees: " : "universal: ") << held << " of " << all << " held, worst "
                                                << worst << " degrees");
    CHECK(held == all);
  }
}

TEST_CASE("the drives of a shoulder take it to any orientation within its cone") {
  for (unsigned seed = 1; seed <= 15; ++seed) {
    Random random(seed);
    const vec3 axis = drawn_direction(random), across = random.vector(1);
    const real one = random.uniform(real(-0.6), real(0.6)), two_ = random.uniform(real(-0.6), 0);
    const real turn = random.uniform(-1, 1);
    for (const auto& solver : three_solvers(100)) {
      Random again(seed);
      Two two(again);
      auto& joint = two.world.add<ConeTwistJoint>(two.wall, two.body, vec3(0), axis, across, 1);
      joint.twist().set_servo(turn, 2, 40);
      joint.swing1().set_servo(one, 2, 40);
      joint.swing2().set_spring({.stiffness = 20, .damping = 8, .rest = two_, .strength = 40});
      for (int n = 0; n < 600; ++n) step(two.world, *solver, h, {.warm_start = true});
      CAPTURE(seed, one, two_, turn);
      CHECK(double(joint.twist().position(two.world.bodies)) == Approx(double(turn)).margin(2e-3));
      CHECK(double(joint.swing1().position(two.world.bodies)) == Approx(double(one)).margin(2e-3));
      CHECK(double(joint.swing2().position(two.world.bodies)) == Approx(double(two_)).margin(2e-3));
    }
  }
}

TEST_CASE("the torque of a cone is all that changes the angular momentum of what it stops") {
  int late = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    World world = weightless();
    const BodyId wall = world.add(static_body(vec3(0)));
    const BodyId ball_ = world.add(ball(2, real(0.5), vec3(0)));
    const vec3 axis = drawn_direction(random);
    auto& cone = world.add<ConeJoint>(wall, ball_, axis, real(0.4));
    world.bodies[ball_].w = random.uniform(5, 100) * normalize(random.vector(1));
    const double inertia = 1 / double(world.bodies[ball_].inverse_inertia_local.x);
    const vec3 start = world.bodies[ball_].w;
    for (const auto& solver : three_solvers(100)) {
      world.bodies[ball_].q = quat(1, 0, 0, 0);
      for (int n = 0; n < 20; ++n) {
        if (n % 4 == 0) world.bodies[ball_].w += start;
        const vec3 before = world.bodies[ball_].w;
        step(world, *solver, h);
        const vec3 change = real(inertia) * (world.bodies[ball_].w - before) / h;
        CAPTURE(seed, n);
        CHECK(double(length(cone.torque() - change)) <=
              tolerance(1e-8, 2e-2) * (1 + double(length(change))));  // of nearly parallel rows
        if (length(change) > 1) {
          CHECK(cone.forces()[0] > 0);
          late += cone.forces()[0] > cone.impulse()[0] / h * real(1.01);
        }
      }
    }
  }
  CHECK(late > 10);
}

TEST_CASE("six locked coordinates are a weld") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const vec3 anchor = random.vector(real(0.5));
    for (const auto& solver : three_solvers(200)) {
      Random again(seed);
      Two two(again);
      auto& joint = two.world.add<SixDofJoint>(two.wall, two.body, anchor,
                                                   drawn_direction(again), again.vector(1));
      const auto lock = [](auto& free) { free.set_limits(0, 0); };
      lock(joint.slide1()), lock(joint.slide2()), lock(joint.slide3());
      lock(joint.twist()), lock(joint.swing2()), lock(joint.swing3());
      two.world.gravity = vec3(0, -9, 0);
      const quat start = two.it().q;
      for (int n = 0; n < 120; ++n) step(two.world, *solver, h, {.warm_start = true});
      CAPTURE(seed);
      CHECK(double(length(two.it().x)) < 1e-3);
      CHECK(std::abs(double(dot(two.it().q, start))) > 1 - 1e-6);
      const vec3 force(joint.slide1().limit_force(), joint.slide2().limit_force(),
                       joint.slide3().limit_force());
      CHECK(double(length(force)) == Approx(9 / double(two.it().inverse_mass)).epsilon(1e-2));
    }
  }
}

TEST_CASE("each of six coordinates is free, limited, locked or driven beside any others") {
  enum Use { loose, limited, locked, driven };
  int held = 0, reached = 0;
  double worst_lock = 0, worst_limit = 0, worst_drive = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    for (const auto& solver : three_solvers(200)) {
      Random random(seed);
      Two two(random);
      auto& joint = two.world.add<SixDofJoint>(two.wall, two.body, vec3(0),
                                                   drawn_direction(random), random.vector(1));
      // free ones: the first displacement and the twist alone, so that the swing stays small
      std::array<Use, 6> use;
      for (int k = 0; k < 6; ++k)
        use[std::size_t(k)] = Use(int(random.uniform(k % 3 == 0 ? 0 : 1, real(3.999))));
      const auto each = [&](const auto& call) {
        call(joint.slide1(), use[0]), call(joint.slide2(), use[1]), call(joint.slide3(), use[2]);
        call(joint.twist(), use[3]), call(joint.swing2(), use[4]), call(joint.swing3(), use[5]);
      };
      each([](auto& free, Use how) {
        if (how == limited) free.set_limits(real(-0.3), real(0.2));
        if (how == locked) free.set_limits(0, 0);
        if (how == driven) free.set_servo(real(0.25), 1, 200);
      });
      two.it().v = random.vector(2), two.it().w = random.vector(2);
      for (int n = 0; n < 300; ++n) step(two.world, *solver, h, {.warm_start = true});
      each([&](auto& free, Use how) {
        const double x = double(free.position(two.world.bodies));
        if (how == locked) worst_lock = std::max(worst_lock, std::abs(x)), ++held;
        if (how == limited) worst_limit = std::max({worst_limit, -0.3 - x, x - 0.2});
        if (how == driven) worst_drive = std::max(worst_drive, std::abs(x - 0.25)), ++reached;
      });
    }
  }
  CAPTURE(held, reached);
  CHECK(worst_lock < 5e-3);
  CHECK(worst_limit < 5e-3);
  CHECK(worst_drive < 5e-3);
  CHECK(held > 100);
  CHECK(reached > 100);
}

TEST_CASE("a rope on a winch holds its load and lifts it at the speed of the drum") {
  for (const auto& solver : three_solvers(100)) {
    World world;
    const BodyId ceiling = world.add(static_body(vec3(0)));
    const BodyId load = world.add(box(5, vec3(real(0.4)), vec3(0, -3, 0)));
    auto& rope = world.add<StrutJoint>(ceiling, load, vec3(0), vec3(0, real(-2.8), 0));
    CHECK(double(rope.length().position(world.bodies)) == Approx(2.8));
    rope.length().set_limits(0, 3);
    for (int n = 0; n < 180; ++n) step(world, *solver, h, {.warm_start = true});
    CHECK(double(rope.length().position(world.bodies)) == Approx(3).margin(1e-3));
    CHECK(double(rope.length().limit_force()) == Approx(-5 * 9.81).epsilon(1e-3));
    rope.length().set_motor(real(-0.5), 100);
    for (int n = 0; n < 120; ++n) step(world, *solver, h, {.warm_start = true});
    CHECK(double(rope.length().position(world.bodies)) == Approx(2).margin(1e-2));
    CHECK(double(rope.length().motor_force()) == Approx(-5 * 9.81).epsilon(1e-3));
    CHECK(rope.length().limit_force() == 0);
  }
}

TEST_CASE("joints of several coordinates go on from a state, and refuse what they cannot be") {
  const auto make = [] {
    World world = weightless();
    const BodyId wall = world.add(static_body(vec3(0)));
    const BodyId body = world.add(box(2, vec3(1, real(0.5), real(0.3)), vec3(0)));
    auto& joint = world.add<ConeTwistJoint>(wall, body, vec3(0), vec3(1, 0, 0), vec3(0, 1, 0),
                                            real(0.5));
    joint.twist().set_limits(-1, 1);
    joint.swing1().set_spring({.stiffness = 10});
    world.bodies[body].w = vec3(3, 4, 5);
    return world;
  };
  SequentialImpulses solver;
  World one = make(), other = make();
  for (int n = 0; n < 37; ++n) step(one, solver, h, {.warm_start = true});
  restore(other, save(one));
  const auto torque = [](World& world) {
    return dynamic_cast<ConeTwistJoint&>(*world.joints()[0]).cone_torque();
  };
  CHECK(torque(one) == torque(other));
  for (int n = 0; n < 50; ++n) {
    step(one, solver, h, {.warm_start = true}), step(other, solver, h, {.warm_start = true});
    REQUIRE(one.bodies.at(1).w == other.bodies.at(1).w);
  }
  const BodyId a = one.bodies.id(0), b = one.bodies.id(1);
  const vec3 x(1, 0, 0), y(0, 1, 0);
  CHECK(refusal([&] { one.add<ConeTwistJoint>(a, b, vec3(0), x, x, real(1)); }) != "accepted");
  CHECK(refusal([&] { one.add<ConeTwistJoint>(a, b, vec3(0), x, y, real(0)); }) != "accepted");
  CHECK(refusal([&] { one.add<SixDofJoint>(a, b, vec3(0), vec3(0), y); }) != "accepted");
  CHECK(refusal([&] { one.add<StrutJoint>(a, b, vec3(unbounded, 0, 0), x); }) != "accepted");
  CHECK(one.joints().size() == 1);
}
