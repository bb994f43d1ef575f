// Wheels, rotors, gyroscopes and tops: energy and momentum of what rotates fast.
#include "bench/families.h"
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

// Draws of a family, and how many of them keep what a predicate asks.
struct Count {
  int held = 0, all = 0, told = 0, silent = 0;  // silent: neither held nor told
  double energy = 0, momentum = 0, gap = 0;     // at most
};
template <class Keeps>
Count count(const char* name, int hertz, const DirectSolver& settings, const Keeps& keeps) {
  Count out;
  for (const bench::Family& family : bench::motion_families())
    for (unsigned seed = 501; family.name == name && seed <= 540; ++seed) {
      DirectSolver solver = settings;
      bool told = false;
      const auto one_step = [&](World& world, real h) {
        step(world, solver, h, second_order);
        told |= !solver.report().sentences().empty();
      };
      const bench::Outcome now = run_drawn(family.draw(seed), one_step, true, 1.0 / hertz);
      const bool held = now.finite && keeps(now);
      ++out.all, out.held += held, out.told += told, out.silent += !held && !told;
      out.energy = std::max({out.energy, now.gain, std::abs(now.loss)});
      out.momentum = std::max(out.momentum, now.momentum);
      out.gap = std::max(out.gap, now.gap);
    }
  return out;
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

TEST_CASE("drawn rotors in free flight keep energy and momentum up to 2.5 rad a step", "[slow]") {
  for (const int hertz : {60, 240})
    for (const real added : {real(8), real(0)}) {
      const double momentum = tolerance(1e-12, 1e-3);
      const Count now = count("rotors", hertz, with(8, added), [=](const bench::Outcome& out) {
        return std::max(out.gain, std::abs(out.loss)) < tolerance(1e-3, 1e-2) &&
               out.momentum < momentum;
      });
      INFO(hertz << " Hz, added inertia " << double(added) << ": " << now.held << " of " << now.all
                 << " held, energy changed by " << now.energy << ", momentum by " << now.momentum);
      CHECK(now.all == 40);
      CHECK(now.held >= (is_float ? now.all * 4 / 5 : now.all));
    }
}

TEST_CASE("rotors and tops beyond 2.5 rad a step gain no energy, or the step says so", "[slow]") {
  for (const char* name : {"rotors", "tops"})
    for (const int hertz : {30, 20, 12, 6}) {
      const Count now = count(name, hertz, with(8, 8), [](const bench::Outcome& out) {
        return out.gain < 0.01 && out.gap < tolerance(1e-3, 1e-2);
      });
      INFO(name << " at " << hertz << " Hz: " << now.held << " of " << now.all << " held, "
                << now.told << " told, " << now.silent << " neither, energy changed by "
                << now.energy << ", momentum by " << now.momentum << ", gap " << now.gap);
      CHECK(now.silent == 0);
    }
}

TEST_CASE("motors between bodies in free flight leave their angular momentum at zero") {
  for (const real added : {real(8), real(0)}) {
    const double most = tolerance(1e-12, 0.1);
    const Count now = count("motors in flight", 60, with(8, added),
                            [=](const bench::Outcome& out) { return out.momentum < most; });
    INFO("added inertia " << double(added) << ": " << now.held << " of " << now.all << " held, "
                          << now.momentum);
    CHECK(now.all == 40);
    CHECK(now.held == now.all);
  }
}

TEST_CASE("tops lean and precess without a gain of energy, and drawn chains of short links fold",
          "[slow]") {
  for (const real added : {real(8), real(0)}) {
    const Count tops = count("tops", 60, with(8, added), [](const bench::Outcome& out) {
      return out.gain < 0.01 && out.gap < tolerance(1e-6, 1e-3);
    });
    INFO("added inertia " << double(added) << ": " << tops.held << " of " << tops.all << " tops, "
                          << tops.energy);
    CHECK(tops.held == tops.all);
    const Count links = count("short links", 60, with(8, added), [](const bench::Outcome& out) {
      return out.gap < tolerance(2e-5, 2e-3);  // of links of 2 to 10 cm
    });
    INFO(links.held << " of " << links.all << " chains held, widest gap " << links.gap);
    CHECK(links.held >= (is_float ? links.all - 2 : links.all));
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
