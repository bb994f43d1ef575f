// Three machines of chapter 8 against what can be known beforehand: the parabola of a shot, the
// shape of a hanging bridge and its load, and how strong a motor must be to curl a chain up.
#include "bench/chapters/08_ground/bridge.h"
#include "bench/chapters/08_ground/cannon.h"
#include "bench/chapters/08_ground/curl.h"
#include "engine/instruments/rate.h"
#include "tests/oracle/test.h"

using namespace joints::chapter8;

namespace {

constexpr double g = 9.81;

void step(Scene& scene) { step(scene.world, scene.solver, h, scene.stepping); }
void run(Scene& scene, double seconds) {
  for (int n = int(std::lround(seconds * 60)); n > 0; --n) step(scene);
}
double fastest_of(const World& world) {
  double most = 0;
  for (const Body& body : snapshot(world.bodies)) most = std::max(most, double(length(body.v)));
  return most;
}

// The fastest body of the next second [m/s].
double fastest_from_now(Scene& scene) {
  double most = 0;
  for (int n = 0; n < 60; ++n) {
    step(scene);
    most = std::max(most, fastest_of(scene.world));
  }
  return most;
}

// ---- the cannon ---------------------------------------------------------------------------------

// A shot from the muzzle to the step in which it comes to the ground.
struct Flight {
  Cannon cannon{30};
  Body start;         // when it is let go
  Body before;        // one step before it lands
  int pushes = 0;     // steps until then
  int steps = 0;      // of the flight, the last one included
  double way = 0;     // of the carriage until it lets go [m]

  Flight() {
    while (cannon.hold) {
      step(cannon.scene);
      start = shot();
      way = double(cannon.rail->position(cannon.scene.world.bodies)) + 1;
      cannon.look();
      ++pushes;
    }
    for (; cannon.landing->touching() == 0 && steps < 1000; ++steps) {
      before = shot();
      step(cannon.scene);
    }
  }
  const Body& shot() const { return cannon.scene.world.bodies[cannon.shot]; }
};

// ---- the bridge ---------------------------------------------------------------------------------

// The bridge in statics: a polygon of equal planks whose ends are as far apart as the posts. A
// plank has the weight w in its middle, the load P at the fraction f of its length from its inner
// end, and the vertical force V at its outer end. Then tan(slope) = (V - w/2 - P f)/H.
struct Statics {
  double H = 0, sag = 0;  // horizontal pull [N], depth of the middle hinge below the outer ones [m]

  explicit Statics(double load, double half_base) {
    double half_span = 0;
    for (int k = 0; k < Bridge::planks / 2; ++k) half_span += std::cos(Bridge::bend * (k + 0.5));
    double low = 10, high = 1e6;
    for (int n = 0; n < 100; ++n) {
      H = std::sqrt(low * high);
      (reach(load, half_base) < half_span ? low : high) = H;
    }
  }

 private:
  // How far one half reaches with this H [m].
  double reach(double load, double half_base) {
    const double w = Bridge::plank_mass * g;
    double V = 0, x = 0;
    sag = 0;
    for (int k = 0; k < Bridge::planks / 2; ++k) {
      const double P = k == 0 ? load / 2 : 0;
      V += w + P;
      double slope = 0;
      for (int n = 0; n < 20; ++n)  // the crate stands on f = half_base / cos(slope)
        slope = std::atan((V - w / 2 - P * half_base / std::cos(slope)) / H);
      x += std::cos(slope);
      sag += std::sin(slope);
    }
    return x;
  }
};

// ---- the chain that curls up --------------------------------------------------------------------

// The torque that the k-th hinge from the end needs to lift the k cubes beyond it, if the hinges
// among these are bent to `bend` [N m].
double lifting(const Curl& curl, int k, double bend) {
  double end = 0, sum = 0;
  for (int cube = 0; cube < k; ++cube) {
    const double half = double(curl.distance) / 2 * std::cos(bend * cube);
    sum += Curl::cube_mass * g * (end + half);
    end += 2 * half;
  }
  return sum;
}

}  // namespace

TEST_CASE("a cannon's shot leaves with the motor's work and flies as far as its parabola says") {
  const Flight flight;
  const double slope = std::sqrt(0.5), a = 3500.0 / 60 - g * slope;  // of carriage and shot
  const vec3 v = flight.start.v;
  CHECK(double(length(v)) == Approx(a * double(h) * flight.pushes).epsilon(1e-4));
  CHECK(flight.way > 10);
  CHECK(flight.way < 11);

  // To the step: places after n of them; to the parabola: half a step is g h/2 of speed.
  const double n = flight.steps - 1, t = n * double(h);
  CHECK(double(flight.before.x.x) ==
        Approx(double(flight.start.x.x) + double(v.x) * t).epsilon(tolerance(1e-9, 1e-4)));
  CHECK(double(flight.before.x.y) ==
        Approx(double(flight.start.x.y) + double(v.y) * t - g * double(h * h) * n * (n + 1) / 2)
            .margin(tolerance(1e-8, 0.02)));
  const double edge = double(flight.cannon.shot_edge) * slope;  // its centre above its low edge
  const double fall = double(flight.start.x.y) - edge, up = double(v.y);
  const double range = double(v.x) * (up + std::sqrt(up * up + 2 * g * fall)) / g;
  CHECK(range > 100);
  CHECK(double(flight.shot().x.x - flight.start.x.x) == Approx(range).epsilon(0.02));
  CHECK(double(flight.shot().x.y) == Approx(edge).margin(1e-3));  // on its edge, and no deeper
}

TEST_CASE("a shot that falls further in a step than its own half is thick stops on the ground") {
  Flight flight;
  const double edge = double(flight.cannon.shot_edge);
  REQUIRE(-double(flight.before.v.y) * double(h) > edge * std::sqrt(0.5));
  double deepest = 0;
  for (int n = 0; n < 900; ++n) {
    step(flight.cannon.scene);
    deepest = std::max(deepest, penetration(flight.cannon.scene.world));
  }
  CHECK(deepest < 1e-4);
  CHECK(double(flight.shot().x.y) == Approx(edge / 2).margin(1e-4));  // flat
  CHECK(double(length(flight.shot().v)) < 1e-3);
  CHECK(double(length(flight.shot().w)) < 1e-3);
  CHECK(double(flight.cannon.rail->position(flight.cannon.scene.world.bodies)) ==
        Approx(-1).margin(1e-4));  // the carriage slid back
}

TEST_CASE("a bridge's planks give its load the weight of it, at rest and on average") {
  Bridge bridge(30);
  vec3 sum(0);
  const int steps = 600;
  double deepest = 0, widest_gap = 0;
  for (int n = 0; n < steps; ++n) {
    step(bridge.scene);
    sum += bridge.carried() / real(steps);
    deepest = std::max(deepest, penetration(bridge.scene.world));
    widest_gap = std::max(widest_gap, widest(bridge.scene));
  }
  const double weight = Bridge::crate_mass * g;
  CHECK(double(bridge.carried().y) == Approx(weight).epsilon(0.01));
  CHECK(std::abs(double(bridge.carried().x)) < 0.01 * weight);
  CHECK(double(sum.y) == Approx(weight).epsilon(0.01));  // it began at rest and ends at rest
  CHECK(fastest_of(bridge.scene.world) < 1e-3);
  CHECK(deepest < 1e-3);
  CHECK(widest_gap < 0.02);  // 0.011 while it catches the load, 0.0015 without one
  CHECK(widest(bridge.scene) < tolerance(1e-5, 1e-4));
}

TEST_CASE("a bridge hangs as deep as statics says, and deeper by as much under its load") {
  const double rub = 20;
  double before = 0;
  for (const bool loaded : {false, true}) {
    CAPTURE(loaded);
    Bridge bridge(30, loaded, real(rub));
    run(bridge.scene, 10);
    const Statics statics(loaded ? Bridge::crate_mass * g : 0, double(bridge.crate_size.x) / 2);
    // What the hinges' friction holds moves the line of the pull by rub/H, at the ends and in the
    // middle.
    CHECK(bridge.sag() == Approx(statics.sag).margin(2 * rub / statics.H));
    if (loaded) CHECK(bridge.sag() - before > 4 * rub / statics.H);
    before = bridge.sag();
  }
}

TEST_CASE("a bridge swings on while its hinges do not rub") {
  Bridge rubs(30, true, 20), free(30, true, 0);
  for (Bridge* bridge : {&rubs, &free}) run(bridge->scene, 9);
  CHECK(fastest_from_now(rubs.scene) < 1e-3);
  CHECK(fastest_from_now(free.scene) > 0.02);
}

TEST_CASE("a bridge rests under its load where the warm start is safe, not where it is not") {
  Bridge safe(30), unsafe(30, true, 20, real(0.2));
  for (Bridge* bridge : {&safe, &unsafe}) run(bridge->scene, 9);
  CHECK(fastest_from_now(safe.scene) < 1e-3);
  CHECK(fastest_from_now(unsafe.scene) > 0.5);
  if (is_float) return;  // the slowest error drowns in rounding
  for (HingeJoint* hinge : safe.hinges) hinge->set_motor(0, 0);
  const double left = std::pow(contraction_rate(safe.scene.world, 600), 30);
  CHECK(left * 1.02 < 1);  // Eq. 6-9
  CHECK(left * 1.2 > 1);
}

TEST_CASE("a chain curls up to a ring with motors that could not lift half of it while straight") {
  const double strength = 8000;
  Curl curl(30, real(strength));
  REQUIRE(strength < lifting(curl, 4, 0));
  double deepest = 0, widest_gap = 0, carried = 0;
  for (int n = 0; n < 600; ++n) {
    step(curl.scene);
    deepest = std::max(deepest, penetration(curl.scene.world));
    widest_gap = std::max(widest_gap, widest(curl.scene));
    if (n < 360) continue;  // on average of the last four seconds: it rocks
    for (const GroundContact* contact : curl.contacts)
      carried += double(reaction(*contact, curl.scene.world.bodies).force.y) / 240;
  }
  for (const HingeJoint* hinge : curl.hinges)
    CHECK(double(hinge->position(curl.scene.world.bodies) / degree) == Approx(45).margin(1));
  CHECK(double(length(curl.tip() - curl.tail())) < 0.1);  // the ring is closed
  CHECK(carried == Approx(Curl::cubes * Curl::cube_mass * g).epsilon(0.02));
  CHECK(deepest < 2e-3);
  CHECK(widest_gap < 0.015);  // 0.008 while the ends come down on each other
}

TEST_CASE("motors of 4000 N m bend as many hinges from each end as they can lift cubes") {
  const double strength = 4000, bend = 45 * double(degree);
  Curl curl(30, real(strength));
  REQUIRE(lifting(curl, 2, bend) < strength);
  REQUIRE(lifting(curl, 3, bend) > strength);
  run(curl.scene, 10);
  for (std::size_t k = 0; k < curl.hinges.size(); ++k) {
    CAPTURE(k);
    const double angle = double(curl.hinges[k]->position(curl.scene.world.bodies) / degree);
    CHECK(angle == Approx(k < 2 || k > 4 ? 45 : 0).margin(1));
  }
}
