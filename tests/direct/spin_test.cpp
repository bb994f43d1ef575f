// Wheels, rotors, gyroscopes and tops: energy and momentum of what rotates fast.
#include "engine/instruments/measure.h"
#include "joints/ball_joint.h"
#include "joints/hinge_joint.h"
#include "tests/direct/rigs.h"
#include "tests/oracle/test.h"

namespace {

// What a scene that no force acts on has changed after some time, as fractions.
struct Changes {
  double energy = 0;    // at most
  double momentum = 0;  // angular, at most
  int halved = 0;
};

Changes after(World&& world, int steps, real h, DirectSolver solver, const StepOptions& how) {
  const auto angular = [&] { return momentum(all_of(world.bodies)).angular; };
  const auto kinetic = [&] { return double(energy(all_of(world.bodies), vec3(0))); };
  const auto L = angular();
  const double T = kinetic();
  Changes out;
  for (int n = 0; n < steps; ++n) {
    step(world, solver, h, how);
    out.energy = std::max(out.energy, std::abs(kinetic() / T - 1));
    out.momentum = std::max(out.momentum, double(length(angular() - L) / length(L)));
    out.halved += solver.report().halved;
  }
  return out;
}

// A body with one to three rotors on hinges, drawn: sizes, masses, places, axles. Each rotor is
// balanced, and rotates by up to `turn` in a step; the body tumbles slowly.
World drawn_rotors(Random& random, real turn, real h) {
  World world;
  world.gravity = vec3(0);
  const real size = std::exp(random.uniform(-4, 3)), mass = std::exp(random.uniform(-4, 4));
  const vec3 edges = size * exp(random.vector(real(0.7)));
  const BodyId frame = world.add(box(mass, edges, size * random.vector(1), random.turn()));
  world.bodies[frame].w = real(0.1) * turn / h * random.vector(real(0.1));
  const int rotors = 1 + int(random.uniform(0, real(2.999)));
  for (int k = 0; k < rotors; ++k) {
    const vec3 axle = normalize(random.vector(1)), lever = size * random.vector(1);
    const real share = mass * std::exp(random.uniform(-5, 0));
    const real r = size * random.uniform(real(0.1), 1);
    const real along = share * r * r * random.uniform(real(0.4), 1);
    const real across = along * random.uniform(real(0.55), real(0.95));
    Body rotor = body_with(share, vec3(across, across, along), world.bodies[frame].x + lever);
    const vec3 z(0, 0, 1), about = cross(z, axle);
    const real angle = std::atan2(length(about), dot(z, axle));
    if (length(about) > 0) rotor.q = rotation(angle * normalize(about));
    const vec3 w = world.bodies[frame].w;
    rotor.w = w + random.uniform(real(0.3), 1) * turn / h * axle;
    rotor.v = world.bodies[frame].v + cross(w, lever);
    const BodyId id = world.add(rotor);
    world.add<HingeJoint>(frame, id, rotor.x, axle);
  }
  return world;
}

}  // namespace

TEST_CASE("a car's wheel at 100 km/h keeps energy and momentum on its axle") {
  const auto made = [] {
    World world;
    world.gravity = vec3(0);
    const BodyId car = world.add(box(1000, vec3(4, real(1.2), real(1.8)), vec3(0)));
    const vec3 hub(real(1.3), real(-0.5), 1);
    const BodyId wheel = world.add(body_with(20, vec3(real(0.6), real(0.6), real(1.1)), hub));
    world.add<HingeJoint>(car, wheel, hub, vec3(0, 0, 1));
    world.bodies[car].w = vec3(real(0.3), real(0.2), real(0.1));
    world.bodies[wheel].w = world.bodies[car].w + vec3(0, 0, 93);
    world.bodies[wheel].v = cross(world.bodies[car].w, hub);
    return world;
  };
  for (const StepOptions& how : {StepOptions{}, second_order}) {
    const Changes exact = after(made(), 600, sixtieth, with(8), how);
    CHECK(exact.energy < tolerance(1e-4, 1e-3));
    CHECK(exact.momentum < tolerance(1e-12, 1e-4));
    CHECK(exact.halved == 0);
    const Changes plain = after(made(), 600, sixtieth, with(0), how);
    CHECK(plain.energy < 0.03);  // a part of it is lost
    CHECK(plain.momentum < tolerance(1e-5, 1e-3));
  }
}

TEST_CASE("drawn rotors on a body in free flight keep energy and momentum up to 1 rad a step") {
  Random random(81);
  for (const double turn : {0.1, 0.5, 1.0})
    for (const real hertz : {real(60), real(240)}) {
      int held = 0, all = 0;
      double energy = 0, momentum = 0;
      for (int draw = 0; draw < 25; ++draw) {  // with added inertia every other time
        const Changes now = after(drawn_rotors(random, real(turn), 1 / hertz), 300, 1 / hertz,
                                  with(8, real(draw % 2 * 8)), second_order);
        ++all;
        held += now.energy < tolerance(1e-3, 1e-2) && now.momentum < tolerance(1e-9, 1e-3);
        energy = std::max(energy, now.energy);
        momentum = std::max(momentum, now.momentum);
      }
      INFO(turn << " rad a step at " << double(hertz) << " Hz: " << held << " of " << all
                << " held, energy changed by " << energy << ", momentum by " << momentum);
      CHECK(held >= (is_float ? all * 4 / 5 : all));
    }
}

TEST_CASE("at 2 rad a step drawn rotors keep their energy, or the step says it slowed them") {
  if (is_float) return;  // double has the digits to tell one from the other
  Random random(82);
  int slowed = 0, all = 0;
  for (const double turn : {1.5, 2.0})
    for (const real hertz : {real(60), real(240)})
      for (int draw = 0; draw < 25; ++draw) {
        const Changes now = after(drawn_rotors(random, real(turn), 1 / hertz), 300, 1 / hertz,
                                  with(8, real(draw % 2 * 8)), second_order);
        CAPTURE(turn, double(hertz), draw, now.energy, now.momentum, now.halved);
        if (draw % 2) CHECK(now.momentum < 1e-9);
        ++all;
        slowed += now.halved > 0;
        CHECK((now.halved > 0 || (now.energy < 2e-3 && now.momentum < 1e-6)));
      }
  INFO(slowed << " of " << all << " slowed down");
  CHECK(slowed < all / 10);
}

TEST_CASE("motors between bodies in free flight leave their angular momentum at zero") {
  Random random(83);
  for (int draw = 0; draw < 20; ++draw) {
    World world;
    world.gravity = vec3(0);
    const real size = std::exp(random.uniform(-4, 3)), mass = std::exp(random.uniform(-4, 4));
    std::vector<BodyId> ids;
    for (int k = 0; k < 4; ++k) {
      const real share = mass * std::exp(random.uniform(-3, 0));
      ids.push_back(world.add(box(share, size * exp(random.vector(real(0.7))),
                                  size * vec3(real(k), 0, 0) + size * random.vector(real(0.2)),
                                  random.turn())));
      if (k > 0)
        world
            .add<HingeJoint>(ids[std::size_t(k - 1)], ids.back(),
                             size * vec3(real(k) - real(0.5), 0, 0), random.vector(1))
            .set_motor(random.uniform(-10, 10), 1000 * mass * size * size);
    }
    feed_back_all(world);
    DirectSolver solver = with(8, real(draw % 2 * 8));
    double most = 0;
    for (int n = 0; n < 120; ++n) {
      step(world, solver, sixtieth, second_order);
      most = std::max(most, double(length(momentum(all_of(world.bodies)).angular)));
    }
    CAPTURE(draw, most);
    const double exact = draw % 2 ? 1e-12 : 1e-7;  // else a joint is open by what is not corrected
    CHECK(most < tolerance(exact, draw % 2 ? 1e-2 : 0.1) * double(10 * mass * size * size));
  }
}

TEST_CASE("a link that spins about the line of its joints is not braked by its load") {
  Random random(84);
  for (int draw = 0; draw < 20; ++draw) {
    World world;
    const real size = std::exp(random.uniform(-3, 2)), load = std::exp(random.uniform(1, 7));
    const BodyId hook = world.add(static_body(vec3(0)));
    const BodyId link =
        world.add(box(1, size * vec3(real(0.2), 1, real(0.2)), vec3(0, -size / 2, 0)));
    const BodyId weight = world.add(box(load, size * vec3(1), vec3(0, real(-1.5) * size, 0)));
    world.add<BallJoint>(hook, link, vec3(0));
    world.add<BallJoint>(link, weight, vec3(0, -size, 0));
    feed_back_all(world);
    const real spin = random.uniform(-20, 20);
    world.bodies[link].w = vec3(0, spin, 0);
    DirectSolver solver = with(8, 8);
    for (int n = 0; n < 60; ++n) step(world, solver, sixtieth, second_order);
    CAPTURE(draw, double(size), double(load));
    CHECK(double(world.bodies[link].w.y) ==
          Approx(double(spin)).epsilon(tolerance(1e-6, 1e-3)));
  }
}

TEST_CASE("a gyroscope precesses by m g r / (I w), and sinks by what its nutation takes") {
  for (const double rate : {20.0, 50.0, 100.0}) {
    World world;
    const BodyId wall = world.add(static_body(vec3(0)));
    const BodyId disc = world.add(
        body_with(1, vec3(real(0.09), real(0.09), real(0.18)), vec3(0, 0, real(0.5))));
    world.add<BallJoint>(wall, disc, point_at(world.bodies[wall], world.bodies[disc], vec3(0)));
    // steady: across = I + m r^2, L_spin P = m g r + (terms of P^2 that vanish for a level axis)
    const double precession = 9.81 * 0.5 / (0.18 * rate);
    world.bodies[disc].w = vec3(0, real(precession), real(rate));
    world.bodies[disc].v = cross(vec3(0, real(precession), 0), world.bodies[disc].x);
    DirectSolver solver = with(8);
    double turned = 0, lowest = 0;
    vec3 last = world.bodies[disc].x;
    for (int n = 0; n < 300; ++n) {
      step(world, solver, sixtieth, second_order);
      const vec3 x = world.bodies[disc].x;
      turned += std::atan2(double(last.z * x.x - last.x * x.z),
                           double(last.x * x.x + last.z * x.z));
      lowest = std::min(lowest, double(x.y));
      last = x;
    }
    INFO(rate << " rad/s: turned " << turned << " of " << 5 * precession << " rad, sank by "
              << -lowest << " m");
    CHECK(turned == Approx(5 * precession).epsilon(0.01));
    CHECK(lowest > -0.01);
  }
}
