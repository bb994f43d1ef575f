// Position projection: what it holds, what it leaves alone, and that it costs nothing when off.
#include "engine/steps/projection.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;
const real degree = std::numbers::pi_v<real> / 180;

// A bar of 1 m that hangs level from a ball joint at its end.
struct Pendulum {
  World world;
  BodyId bar;
  BallJoint* joint;
  SequentialImpulses solver;
  StepOptions stepping;
  explicit Pendulum(real beta, int projections) {
    const BodyId wall = world.add(static_body(vec3(0)));
    bar = world.add(box(2, vec3(1, real(0.1), real(0.2)), vec3(real(0.5), 0, 0)));
    joint = &world.add<BallJoint>(
        wall, bar, point_at(world.bodies[wall], world.bodies[bar], vec3(0)));
    joint->beta = beta;
    stepping.projections = projections;
  }
  double gap() const {
    return double(length(joint->part.error(world.bodies[joint->body1], world.bodies[bar])));
  }
  double largest_gap(double seconds) {
    double largest = 0;
    for (int n = 0; n < int(seconds * 60); ++n) {
      step(world, solver, h, stepping);
      largest = std::max(largest, gap());
    }
    return largest;
  }
};

}  // namespace

TEST_CASE("one iteration of projection a step keeps a pendulum together for ten seconds") {
  const double without = Pendulum(0, 0).largest_gap(10);
  const double fed_back = Pendulum(real(0.2), 0).largest_gap(10);
  const double projected = Pendulum(0, 1).largest_gap(10);
  CHECK(without > 0.1);
  CHECK(fed_back > 1e-3);
  CHECK(projected < tolerance(1e-8, 2e-5));
}

TEST_CASE("two iterations of projection close what one has left") {
  CHECK(Pendulum(0, 2).largest_gap(10) < tolerance(1e-14, 2e-6));
}

TEST_CASE("I20 projection closes a wide gap with the square of what is left") {
  Pendulum pendulum(0, 0);
  pendulum.world.bodies[pendulum.bar].x += vec3(real(0.1), real(0.05), real(-0.08));
  std::vector<double> gaps{pendulum.gap()};
  for (int n = 0; n < 4; ++n) {
    project_positions(pendulum.world);
    gaps.push_back(pendulum.gap());
  }
  for (std::size_t n = 1; n < gaps.size(); ++n)
    CHECK(gaps[n] < std::max(0.6 * gaps[n - 1] * gaps[n - 1], tolerance(1e-15, 1e-6)));
}

TEST_CASE("projection changes no velocity and turns no static body") {
  Pendulum pendulum(0, 0);
  Body& bar = pendulum.world.bodies[pendulum.bar];
  bar.x += vec3(real(0.1));
  bar.v = vec3(1, 2, 3);
  bar.w = vec3(3, 2, 1);
  project_positions(pendulum.world);
  CHECK(bar.v == vec3(1, 2, 3));
  CHECK(bar.w == vec3(3, 2, 1));
  CHECK(pendulum.world.bodies[pendulum.joint->body1].x == vec3(0));
  CHECK(pendulum.world.bodies[pendulum.joint->body1].q == quat(1, 0, 0, 0));
}

TEST_CASE("projection leaves the common centre of two free bodies where it is") {
  World world;
  const BodyId a = world.add(box(2, vec3(1), vec3(0)));
  const BodyId b = world.add(box(5, vec3(1), vec3(1, 0, 0)));
  world.add<FixedJoint>(a, b, vec3(real(0.5), 0, 0));
  world.bodies[b].x += vec3(real(0.02), real(-0.05), real(0.03));
  const vec3 before = real(2) * world.bodies[a].x + real(5) * world.bodies[b].x;
  for (int n = 0; n < 10; ++n) project_positions(world);
  const vec3 after = real(2) * world.bodies[a].x + real(5) * world.bodies[b].x;
  CHECK(double(length(after - before)) < tolerance(1e-13, 1e-5));
}

TEST_CASE("projection moves no body further than max_displacement in an iteration") {
  for (int n = 0; n < 4; ++n) {
    World world;
    const BodyId wall = world.add(static_body(vec3(0)));
    const real lever = n % 4 < 2 ? 1 : 30;  // of the displacement and of the rotation
    const BodyId bar = world.add(body_with(1, vec3(1, 2, 2), vec3(10, 3, -7)));
    const vec3 end(0, lever, 0);
    if (n % 2 == 0) world.add<BallJoint>(wall, bar, Point{vec3(0), end});
    else world.add<BallJoint>(bar, wall, Point{end, vec3(0)});
    const Body before = world.bodies[bar];
    project_positions(world);
    const Body& after = world.bodies[bar];
    CHECK(after.x != before.x);
    const quat turned = after.q * conjugate(before.q);
    CHECK(double(length(after.x - before.x)) < 0.2 * (1 + tolerance(1e-12, 1e-4)));
    const double sine = double(length(vec3(turned.x, turned.y, turned.z)));
    CHECK(2 * std::asin(std::min(1.0, sine)) < 0.2001);
  }
}

TEST_CASE("a torn chain closes at any size alike if max_displacement has the size of the links") {
  // powers of two, so that the same digits come out
  const auto torn = [](double size, double cap) {
    World world;
    BodyId before = world.add(static_body(vec3(0)));
    for (int k = 0; k < 4; ++k) {
      const vec3 x = real(size) * vec3(real(k + 1), real(0.3) * real(k), 0);
      const BodyId next = world.add(ball(1, real(size) / 4, x));
      world.add<CentreDistanceJoint>(before, next, CentreDistance{real(size)});
      before = next;
    }
    world.bodies[before].x.z = real(size) * 9;
    world.max_displacement = real(cap);
    std::vector<double> places;
    for (int n = 0; n < 60; ++n) {
      project_positions(world);
      const vec3 x = world.bodies[before].x / real(size);
      for (const real number : {x.x, x.y, x.z}) places.push_back(double(number));
    }
    return places;
  };
  const std::vector<double> metres = torn(1, double(World().max_displacement));
  CHECK(std::abs(metres[2] - 9) < 0.2 * (1 + tolerance(1e-12, 1e-5)));
  CHECK(metres.back() < 4);
  for (const double size : {1.0 / 1024, 1024.0}) {
    CHECK(torn(size, 0.2 * size) == metres);
    CHECK(torn(size, 0.2) != metres);
  }
  World world;
  SequentialImpulses solver;
  for (const real bad : {real(0), real(-1), std::numeric_limits<real>::quiet_NaN()}) {
    world.max_displacement = bad;
    CHECK_THROWS_AS(step(world, solver, h), std::invalid_argument);
  }
}

TEST_CASE("projection leaves a joint with a frequency to its spring") {
  for (const real frequency : {real(0), real(3)}) {
    Pendulum pendulum(0, 0);
    pendulum.joint->frequency = frequency;
    Body& bar = pendulum.world.bodies[pendulum.bar];
    bar.x.y = real(0.1);
    project_positions(pendulum.world);
    CHECK((double(bar.x.y) == Approx(0.1)) == (frequency > 0));
  }
}

TEST_CASE("projection brings a passed limit back and leaves a motor and a limit with a gap alone") {
  for (const double start : {70.0, 30.0}) {
    World world = weightless();
    const BodyId wall = world.add(static_body(vec3(0)));
    const BodyId door = world.add(box(2, vec3(1, 2, real(0.1)), vec3(real(0.5), 0, 0)));
    auto& hinge = world.add<HingeJoint>(wall, door, vec3(0), vec3(0, 1, 0));
    hinge.set_limits(-60 * degree, 60 * degree);
    hinge.set_motor(1, 5);
    const quat turn = rotation(vec3(0, real(start) * degree, 0));
    world.bodies[door].q = turn;
    world.bodies[door].x = turn * vec3(real(0.5), 0, 0);
    hinge.begin_step(world.bodies, h);
    for (int n = 0; n < 20; ++n) project_positions(world);
    CHECK(double(hinge.position(world.bodies) / degree) ==
          Approx(std::min(start, 60.0)).margin(tolerance(1e-9, 1e-3)));
  }
}

TEST_CASE("a joint that does not take part in projection keeps its gap") {
  Pendulum pendulum(0, 3);
  pendulum.joint->projected = false;
  Pendulum off(0, 0);
  CHECK(pendulum.largest_gap(1) == off.largest_gap(1));
}
