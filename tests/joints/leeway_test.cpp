// The angle of a hinge is not measured while the gap to its limits cannot have been used up: what
// is left out must not be missed.
#include <random>

#include "tests/oracle/test.h"

namespace {

constexpr real h = real(1) / 60;

// A door on a post, without gravity; its hinge along z, limits 60 degrees either way.
struct Door {
  World world;
  BodyId post, door;
  HingeJoint* hinge;
  SequentialImpulses solver;
  StepOptions stepping{};

  Door() {
    world.gravity = vec3(0);
    post = world.add(static_body(vec3(0)));
    door = world.add(box(3, vec3(1, real(0.1), 2), vec3(real(0.5), 0, 0)));
    hinge = &world.add<HingeJoint>(post, door, vec3(0), vec3(0, 0, 1));
    hinge->set_limits(-60 * degree, 60 * degree);
  }
  Body& body() { return world.bodies[door]; }
  // Turned by hand about the hinge, with a speed.
  void put(real angle, real speed) {
    body().q = rotation(vec3(0, 0, angle));
    body().x = to_world(body(), vec3(real(0.5), 0, 0));
    body().w = vec3(0, 0, speed);
    body().v = cross(body().w, body().x);
  }
  void steps(int n) {
    for (int k = 0; k < n; ++k) step(world, solver, h, stepping);
  }
  double angle() const { return double(hinge->position(world.bodies) / degree); }
};

}  // namespace

TEST_CASE("a door that creeps from the middle to its limit stops there") {
  for (const real speed : {real(0.05), real(-0.3), real(1)}) {
    Door door;
    door.put(0, speed);
    double furthest = 0;
    for (int k = 0; k < int(real(1.5) / std::abs(speed) / h); ++k) {
      door.steps(1);
      furthest = std::max(furthest, std::abs(door.angle()));
    }
    INFO("speed " << speed);
    CHECK(furthest < 60.01);
    CHECK(door.angle() == Approx(speed > 0 ? 60 : -60).margin(0.01));
  }
}

TEST_CASE("a door that is put beyond its limit by hand is noticed in the next step") {
  Door door;
  door.put(0, 0);
  door.steps(10);
  CHECK(door.hinge->limit_force() == 0);
  door.put(70 * degree, 0);
  door.steps(1);
  CHECK(double(door.hinge->limit_force()) < 0);  // it pushes the angle down
  CHECK(door.angle() < 69.5);
}

TEST_CASE("a door that creeps is measured when a neighbour's blow would take it past its limit") {
  Door door;
  door.put(0, real(0.5));
  door.steps(20);
  const vec3 end = world_point(door.body(), vec3(real(0.5), 0, 0));
  const BodyId stone = door.world.add(ball(100, real(0.1), end));
  Body& thrown = door.world.bodies[stone];
  thrown.v = real(60) * to_world(door.body(), vec3(0, 1, 0));
  door.world.add<BallJoint>(door.door, stone, point_at(door.body(), thrown, thrown.x));
  door.solver.iterations = 500;
  door.steps(1);
  CHECK(std::abs(door.angle()) < 60.5);
  CHECK(door.hinge->limit_force() != 0);
  door.world.remove(stone);
  door.put(0, 0);
  door.steps(1);
  CHECK(door.hinge->limit_force() == 0);  // the late limit's is gone
}

TEST_CASE("limits drawn in, or a new zero, are noticed in the next step") {
  for (const bool new_zero : {false, true}) {
    Door door;
    door.put(20 * degree, 0);
    door.steps(10);
    if (new_zero) {
      HingeAngle angle = door.hinge->coordinate();
      angle.start = rotation(vec3(0, 0, -50 * degree));  // so it stands at 70
      door.hinge->set_coordinate(angle);
    } else {
      door.hinge->set_limits(-10 * degree, 10 * degree);
    }
    door.steps(1);
    INFO((new_zero ? "new zero" : "new limits"));
    CHECK(double(door.hinge->limit_force()) < 0);
  }
}

TEST_CASE("two wheels on one axle that spin as one keep their angle and count no turns") {
  World world = weightless();
  const BodyId one = world.add(box(1, vec3(1), vec3(0)));
  const BodyId other = world.add(box(2, vec3(1), vec3(0, 0, 2)));
  auto& hinge = world.add<HingeJoint>(one, other, vec3(0, 0, 1), vec3(0, 0, 1));
  hinge.set_limits(-60 * degree, 60 * degree);
  for (const BodyId id : {one, other}) world.bodies[id].w = vec3(0, 0, 20);
  SequentialImpulses solver;
  for (int k = 0; k < 600; ++k) step(world, solver, h);
  CHECK(double(std::abs(hinge.position(world.bodies))) < tolerance(1e-9, 1e-3));
  CHECK(hinge.limit_force() == 0);
}

TEST_CASE("while the angle need not be measured a step cannot reach the limit") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto any_vector = [&](double size) {
    vec3 a;
    do a = vec3(real(unit(random)), real(unit(random)), real(unit(random)));
    while (length(a) < real(0.1) || length(a) > 1);
    return real(size * std::abs(unit(random))) * normalize(a);
  };
  int left_out = 0, measured = 0;
  for (int k = 0; k < 20000; ++k) {
    Body a = box(1, vec3(1), vec3(0)), b = box(1, vec3(1), vec3(1, 0, 0));
    a.q = rotation(any_vector(3));
    b.q = rotation(any_vector(3));
    HingeAngle angle = angle_about(a, b, any_vector(1) + vec3(0, 0, real(0.01)));
    b.q = normalize(rotation(any_vector(1.2)) * b.q);  // torn open
    const real x = angle.error(a, b);
    angle.expected = x;
    const real gap = real(std::abs(unit(random)) * 2);
    Leeway leeway;
    leeway.measured(angle, a, b, gap);
    // The bodies turn for a while, each as it likes; then there is a step.
    // Every other time all of it is about the hinge.
    const vec3 along = to_world(a, angle.a1_local);
    const auto any = [&](double size) {
      return k % 2 == 0 ? any_vector(size) : real(size * unit(random)) * along;
    };
    a.q = normalize(rotation(any(0.7)) * a.q);
    b.q = normalize(rotation(any(0.7)) * b.q);
    a.w = any(30);
    b.w = any(30);
    if (!leeway.still_near(a, b) || !leeway.is_slow(a, b, h)) {
      ++measured;
      continue;
    }
    ++left_out;
    a.q = normalize(rotation(h * a.w) * a.q);
    b.q = normalize(rotation(h * b.w) * b.q);
    REQUIRE(double(std::abs(angle.error(a, b) - x)) <= double(gap) + 1e-5);
  }
  CHECK(left_out > 300);
  CHECK(measured > 500);
}
