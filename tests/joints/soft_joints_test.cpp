// Joints with a frequency and a damping ratio in place of beta: oscillators whose motion is known.
#include "contacts/ground_contact.h"
#include "direct/direct_solver.h"
#include "engine/simd/packed.h"
#include "tests/oracle/test.h"

namespace {

constexpr double pi = std::numbers::pi, g = 9.81;

// A number that swings about zero.
struct Swing {
  double period = 0;  // [s]
  double kept = 0;    // share of the amplitude that a period leaves
};

// Read off the first five times at which `x` goes up through zero, and its maxima between them.
template <class Step, class X>
Swing watch(Step one_step, X x, double h, int most) {
  std::vector<double> times, tops;
  double top = 0;
  for (int n = 1; n <= most && times.size() < 5; ++n) {
    const double before = x();
    one_step();
    const double now = x();
    top = std::max(top, now);
    if (before >= 0 || now < 0) continue;
    if (!times.empty()) tops.push_back(top);
    top = 0;
    times.push_back((n - now / (now - before)) * h);
  }
  REQUIRE(times.size() == 5);
  return {(times[4] - times[0]) / 4, std::pow(tops[3] / tops[0], 1.0 / 3)};
}

// What a spring and damper do by implicit Euler in steps of h: x' = x + h v' and
// v' (1 + 2 zeta omega h + omega^2 h^2) = v - h omega^2 x. In short steps, the damped oscillator.
Swing implicit(double frequency, double damping, double h) {
  const double omega = 2 * pi * frequency, stiff = omega * omega * h * h;
  const double det = 1 / (1 + 2 * damping * omega * h + stiff);
  const double half_trace = (1 + det - stiff * det) / 2;
  const double period = 2 * pi * h / std::acos(half_trace / std::sqrt(det));
  return {period, std::pow(det, period / h / 2)};
}

// A ball of 2 kg that a joint of one kind holds to the wall; y is zero where it is held.
struct Held {
  World world;
  BodyId wall, body;
  Joint* joint = nullptr;
  double rest = 0;
  explicit Held(int kind) {
    wall = world.add(static_body(vec3(0)));
    body = world.add(ball(2, real(0.3), vec3(0)));
    Body& it = world.bodies[body];
    if (kind == 0)
      joint = &world.add<BallJoint>(wall, body, Point{});
    else if (kind == 1)
      joint = &world.add<FixedJoint>(wall, body, vec3(0));
    else if (kind == 2)
      joint = &world.add<HingeJoint>(wall, body, vec3(0), vec3(0, 1, 0));
    else if (kind == 3)
      joint = &world.add<SliderJoint>(wall, body, vec3(0), vec3(1, 0, 0));
    else
      it.x.y = -2, rest = -2,
      joint = &world.add<DistanceJoint>(wall, body, Distance{vec3(0), vec3(0), 2});
  }
  double y() { return double(world.bodies[body].x.y) - rest; }
};

}  // namespace

TEST_CASE("the formula of the implicit spring is the damped oscillator where steps are short") {
  const Swing found = implicit(2, 0.1, 1e-6);
  CHECK(found.period == Approx(0.5 / std::sqrt(1 - 0.01)).epsilon(1e-4));
  CHECK(found.kept == Approx(std::exp(-2 * pi * 0.1 / std::sqrt(1 - 0.01))).epsilon(1e-4));
}

TEST_CASE("a soft joint of any kind swings with its frequency and decays by its damping ratio") {
  const real h = real(1) / 500;
  for (int kind = 0; kind < 5; ++kind)
    for (const auto& [frequency, damping] : {std::pair{2.0, 0.0}, {2.0, 0.1}, {0.7, 0.2}}) {
      CAPTURE(kind, frequency, damping);
      Held held(kind);
      held.world.gravity = vec3(0);
      held.joint->frequency = real(frequency);
      held.joint->damping = real(damping);
      held.world.bodies[held.body].v = vec3(0, -1, 0);
      SequentialImpulses solver;
      const Swing swing = watch([&] { step(held.world, solver, h); }, [&] { return held.y(); },
                                double(h), 10000);
      const Swing spring = implicit(frequency, damping, double(h));
      CHECK(swing.period == Approx(spring.period).epsilon(2e-3));
      CHECK(swing.kept == Approx(spring.kept).epsilon(2e-2));
    }
}

TEST_CASE("a soft joint gives way under a load by g over the square of its frequency") {
  const real h = real(1) / 60;
  SequentialImpulses rows;
  PackedImpulses packed;
  DirectSolver direct;
  for (Solver* solver : {static_cast<Solver*>(&rows), static_cast<Solver*>(&packed),
                         static_cast<Solver*>(&direct)})
    for (int kind = 0; kind < 5; ++kind)
      for (const double frequency : {1.0, 5.0}) {
        CAPTURE(kind, frequency);
        Held held(kind);
        held.joint->frequency = real(frequency);
        for (int n = 0; n < 600; ++n)
          step(held.world, *solver, h, {.warm_start = true, .projections = 2});
        CHECK(held.y() == Approx(-g / std::pow(2 * pi * frequency, 2)).epsilon(1e-3));
      }
}

TEST_CASE("a soft rope is slack until it is taut and then stretches by the load") {
  const real h = real(1) / 200;
  World world;
  const BodyId wall = world.add(static_body(vec3(0)));
  const BodyId weight = world.add(ball(2, real(0.1), vec3(0, -1, 0)));
  auto& rope = world.add<RopeJoint>(wall, weight, Rope<Distance>{{vec3(0), vec3(0), 2}});
  rope.frequency = 1;
  rope.damping = real(0.3);
  SequentialImpulses solver;
  for (int n = 0; n < 80; ++n) step(world, solver, h);  // 0.4 s: it has fallen 0.78 m
  CHECK(double(world.bodies[weight].v.y) == Approx(-0.4 * g).epsilon(1e-3));
  double lowest = 0, least = 0;
  for (int n = 0; n < 4000; ++n) {
    step(world, solver, h);
    lowest = std::min(lowest, double(world.bodies[weight].x.y));
    least = std::min(least, double(rope.impulse()[0]));
  }
  CHECK(least == 0);  // it never pushes
  CHECK(lowest < -2.4);
  CHECK(double(world.bodies[weight].x.y) ==
        Approx(-2 - g / std::pow(2 * pi, 2)).epsilon(1e-3));
}

TEST_CASE("limits of a soft hinge give way and its motor does not") {
  const real h = real(1) / 200;
  for (const bool whole : {false, true}) {
    Rotor rotor;  // 1 kg m^2
    rotor.hinge->whole = whole;
    rotor.hinge->frequency = 2;
    rotor.hinge->set_motor(3, 10);
    rotor.run(10, h);
    CHECK(double(rotor.rotor().w.z) == Approx(10 * 10 * double(h)).epsilon(1e-3));
    rotor.run(90, h);
    CHECK(double(rotor.rotor().w.z) == Approx(3).epsilon(1e-3));
    rotor.hinge->set_limits(-1, real(rotor.angle()));
    const double limit = rotor.angle();
    rotor.run(2000, h);
    CHECK(rotor.angle() - limit == Approx(10 / std::pow(4 * pi, 2)).epsilon(1e-2));
  }
}

TEST_CASE("a crate on a soft contact sinks in by its weight") {
  World world;
  const vec3 size(1, real(0.6), real(0.8));
  const BodyId ground = world.add(static_body(vec3(0)));
  const BodyId crate = world.add(box(10, size, vec3(0, size.y / 2, 0)));
  auto& contact = world.add<GroundContact>(ground, crate, Top{}, box_outline(size));
  contact.frequency = 10;
  SequentialImpulses solver;
  for (int n = 0; n < 300; ++n) step(world, solver, real(1) / 60, {.warm_start = true});
  const double sunk = -double(contact.gap(world.bodies));
  // the spring of a corner is made for the effective mass there, which need not be a quarter of the
  // crate
  CHECK(sunk > 0.25 * g / std::pow(20 * pi, 2));
  CHECK(sunk < 4 * g / std::pow(20 * pi, 2));
}

TEST_CASE("the step's softness is for joints that have none of their own") {
  for (const bool own : {false, true}) {
    Held held(0);
    if (own) held.joint->frequency = 1;
    SequentialImpulses solver;
    for (int n = 0; n < 600; ++n) step(held.world, solver, real(1) / 60, {.frequency = 3});
    CHECK(held.y() == Approx(-g / std::pow(2 * pi * (own ? 1 : 3), 2)).epsilon(1e-3));
  }
}
