// What stands, slides and rolls on the ground, against the laws of the textbook: rest, the way of a
// sliding box, the angle at which a slope lets go, a ball that rolls, a ground that moves.
#include "tests/ground/rigs.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;
const double pi = std::numbers::pi;
real radians(double degrees) { return real(degrees * pi / 180); }

// How far it ever was from its first place, and how fast.
struct Rest {
  double farthest = 0, fastest = 0;
  Rest(Grounded&& box, double seconds) {
    const vec3 first = box.it().x;
    for (int n = 0; n < int(seconds * 60); ++n) {
      step(box.world, box.solver, h, box.stepping);
      const Body& body = box.it();
      farthest = std::max(farthest, double(length(body.x - first)));
      fastest = std::max({fastest, double(length(body.v)), double(length(body.w))});
    }
  }
};

// Way and direction of a box that is pushed along the ground until it rests.
struct Slide {
  double way = 0, across = 0;
  Slide(double speed, double direction, double mu, real step = h) {
    Grounded box = standing();
    const vec3 along(real(std::cos(direction)), 0, real(std::sin(direction)));
    box.contact->friction = real(mu);
    box.it().v = real(speed) * along;
    box.run(1.2 * speed / (mu * g), step);
    way = double(dot(box.it().x, along));
    across = double(length(cross(box.it().x - vec3(0, brick.y / 2, 0), along)));
  }
};

}  // namespace

TEST_CASE("a box at rest stays where it stands for a minute, warm and cold") {
  // float: the weight of a step, 1.6 N s, is a sum of impulses of 24 bits each; what rounding
  // leaves of the velocity is 1e-7 of the 0.16 m/s that a step brings, in every one of 3600 steps
  for (const bool warm : {true, false})
    for (const real turned : {real(0), real(0.4)}) {
      Grounded box = standing(turned);
      box.stepping.warm_start = warm;
      const Rest rest(std::move(box), 60);
      CAPTURE(warm, turned);
      CHECK(rest.farthest < tolerance(1e-6, 1e-3));
      CHECK(rest.fastest < tolerance(1e-6, 1e-4));
    }
}

TEST_CASE("a box that slides at 10 m/s comes to rest after v^2/(2 mu g), whatever its direction") {
  for (const double mu : {0.3, 0.6})
    for (int k = 0; k < 8; ++k) {
      const Slide slide(10, 2 * pi * k / 8, mu);
      const double expected = 100 / (2 * mu * g), stepped = expected - 10 * double(h) / 2;
      CAPTURE(mu, k);
      CHECK(slide.way == Approx(expected).epsilon(0.01));
      CHECK(slide.way == Approx(stepped).epsilon(1e-3));  // every step moves with its end's speed
      CHECK(slide.across < tolerance(1e-6, 1e-2));
    }
}

TEST_CASE("with directions of friction that do not turn a box slides too short by 1 over root 2") {
  const auto way = [](bool turned) {
    Grounded box = standing();
    box.contact->turned_tangents = turned;
    box.it().v = vec3(5, 0, 5);
    box.run(4, h);
    return double(length(vec3(box.it().x.x, 0, box.it().x.z)));
  };
  // 50 is v^2; and the half step of each way, v h/2 = 0.059 m
  CHECK(way(true) == Approx(50 / g - 0.059).epsilon(0.005));
  CHECK(way(false) / way(true) == Approx(std::sqrt(0.5)).epsilon(0.005));
}

TEST_CASE("a slope lets a box go half a degree above arctan(mu) and not half a degree below") {
  const vec3 flat(1, real(0.2), 1);  // does not tip over
  for (const double mu : {0.2, 0.5, 0.9})
    for (const double turned : {0.0, 0.5}) {
      const auto way = [&](double degrees) {
        Grounded slope(box(10, flat, vec3(0, flat.y / 2, 0), rotation(vec3(0, real(turned), 0))),
                       box_outline(flat), radians(degrees));
        slope.contact->friction = real(mu);
        slope.run(10, h);
        CHECK(double(slope.place().y) == Approx(0.1).margin(1e-3));
        return -double(slope.place().x);
      };
      const double limit = std::atan(mu) * 180 / pi, a = (limit + 0.5) * pi / 180;
      CAPTURE(mu, turned);
      CHECK(way(limit - 0.5) < tolerance(1e-5, 1e-3));  // it settles at first
      const double downhill = g * (std::sin(a) - mu * std::cos(a)) * 100 / 2;
      // the small difference of two large forces; steps of h add h/(10 s)
      CHECK(way(limit + 0.5) == Approx(downhill).epsilon(tolerance(0.005, 0.02)));
    }
}

TEST_CASE("without friction a box slides down a slope as fast as it would fall") {
  Grounded slope = standing(0, radians(20));
  slope.contact->friction = 0;
  slope.run(2, h);
  CHECK(-double(slope.velocity().x) ==
        Approx(g * std::sin(20 * pi / 180) * 2).epsilon(tolerance(1e-9, 1e-4)));
}

TEST_CASE("a ball rolls down a slope with 5/7 of g sin, and slides where friction is too weak") {
  const real radius = real(0.25);
  for (const auto& [degrees, mu] :
       {std::pair{20.0, 0.5}, {40.0, 0.3}, {40.0, 0.15}, {60.0, 0.3}}) {
    Grounded slope(ball(3, radius, vec3(0, radius, 0)), ball_outline(radius), radians(degrees));
    slope.contact->friction = real(mu);
    slope.run(2, h);
    const double a = degrees * pi / 180, v = -double(slope.velocity().x);
    const double slip = v - double(slope.it().w.z) * double(radius);
    CAPTURE(degrees, mu);
    if (std::tan(a) < 3.5 * mu) {
      CHECK(v == Approx(g * std::sin(a) * 2 * 5 / 7).epsilon(1e-3));
      CHECK(std::abs(slip) < tolerance(1e-6, 1e-3) * v);
    } else {
      CHECK(v == Approx(g * (std::sin(a) - mu * std::cos(a)) * 2).epsilon(1e-3));
      CHECK(slip > 0.1 * v);
    }
  }
}

TEST_CASE("a heavy ground that moves carries a box along with it") {
  // no gravity: a force presses the box down, so that the ground need not be held up
  World world = weightless();
  Body slab = box(real(1e6), vec3(100, 1, 100), vec3(0, real(-0.5), 0));
  slab.v = vec3(3, 0, 0);
  Body load = box(10, brick, vec3(0, brick.y / 2, 0));
  load.force = vec3(0, real(-10 * g), 0);
  const BodyId ground = world.add(slab), body = world.add(load);
  world.add<GroundContact>(ground, body, box_top(vec3(100, 1, 100)), box_outline(brick));
  SequentialImpulses solver;
  for (int n = 0; n < 120; ++n) step(world, solver, h);
  // the slab of 1e6 kg gives the box 30 N s and loses 3e-5 m/s; it sinks at 2e-4 m/s
  CHECK(double(length(world.bodies[body].v - vec3(3, 0, 0))) < 1e-3);
  const double behind = double(world.bodies[ground].x.x - world.bodies[body].x.x);
  CHECK(behind == Approx(9 / (2 * 0.5 * g)).epsilon(0.06));  // 3 m/s h/2 of 0.917 m are 3 %
}

TEST_CASE("a box that slides over the edge of the ground falls, one that stops before does not") {
  for (const auto& [speed, falls] : {std::pair{7.0, true}, {4.0, false}}) {
    const vec3 size(4, 1, 4);  // the top ends at x = 2 m
    Grounded box = {joints::box(10, brick, vec3(-1, (1 + brick.y) / 2, 0)), box_outline(brick), 0,
                    box_top(size)};
    box.it().v = vec3(real(speed), 0, 0);
    box.run(2, h);
    CAPTURE(speed);
    CHECK((double(box.it().x.y) < -3) == falls);
    CHECK((double(box.it().x.x) > 2) == falls);
    if (!falls) CHECK(double(box.it().x.y) == Approx(0.8).margin(1e-3));
  }
}

TEST_CASE("a corner beside the ground is not lifted onto its top") {
  Grounded beside(lowered(real(-1.2), quat(1, 0, 0, 0)), box_outline(brick), 0,
                  {real(0), 2, 2, real(0.5)});
  beside.run(0.1, h);
  CHECK(beside.contact->touching() == 0);
  CHECK(double(beside.it().v.y) == Approx(-g * 0.1).epsilon(1e-4));
}
