// What docs/library.md says of things that have no call of their own: each works as it is said
// there. Exit status 1, with a line, for the first that does not.
#include <cmath>
#include <cstdio>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <vector>

#include <joints.h>

using namespace joints;

namespace {

const real h = real(1) / 60;

void expect(bool good, const char* what) {
  if (good) return;
  std::printf("%s\n", what);
  std::exit(1);
}

// A ball of 1 kg hangs below a fixed point, 1 m long, from points in body space.
struct Pendulum {
  World world;
  BodyId frame = world.add(static_body(vec3(0)));
  BodyId bob = world.add(ball(1, real(0.2), vec3(0, -1, 0)));
  JointId<BallJoint> pin = world.add<BallJoint>(frame, bob, Point{vec3(0), vec3(0, 1, 0)});
  DirectSolver solver;
};

void local_points() {
  Pendulum one;
  step(one.world, one.solver, h);
  expect(std::abs(length(one.world.bodies[one.bob].x) - 1) < real(1e-5), "points in body space");
}

void force_at_a_point() {
  Pendulum one;
  Body& bob = one.world.bodies[one.bob];
  const vec3 force(0, 0, 3), point = bob.x + vec3(real(0.1), 0, 0);
  bob.force += force;
  bob.torque += cross(point - bob.x, force);
  step(one.world, one.solver, h);
  bob.force = bob.torque = vec3(0);
  const real spin = bob.w.y;
  expect(spin < 0, "a force at a point turns the body");
  step(one.world, one.solver, h);
  expect(std::abs(bob.w.y - spin) < real(1e-5), "a force that was cleared acts no more");
}

void breaks() {
  Pendulum one;
  for (int n = 0; n < 3; ++n) step(one.world, one.solver, h);
  expect(std::abs(length(reaction(one.world[one.pin], one.world.bodies).force) - real(9.81)) <
             real(0.01), "the joint bears the weight");
  one.world.bodies[one.bob].force = vec3(0, -100, 0);
  step(one.world, one.solver, h);
  if (length(reaction(one.world[one.pin], one.world.bodies).force) > 50)
    one.world.remove(one.pin);
  expect(!one.world.alive(one.pin), "a joint that bears too much is removed");
}

void damped() {
  Pendulum one;
  one.world.remove(one.pin);
  one.world.gravity = vec3(0);
  Body& bob = one.world.bodies[one.bob];
  bob.v = vec3(1, 0, 0);
  for (int n = 0; n < 60; ++n) {
    bob.v /= 1 + 2 * h;
    step(one.world, one.solver, h);
  }
  expect(std::abs(bob.v.x - std::exp(real(-2))) < real(0.01), "damping of 2/s for a second");
}

void copied_and_between() {
  Pendulum one, other;
  one.world.bodies[one.bob].v = vec3(2, 0, 0);
  step(one.world, one.solver, h);
  restore(other.world, save(one.world));
  const std::vector<Pose> before = poses(one.world.bodies);
  step(one.world, one.solver, h);
  step(other.world, other.solver, h);
  const std::vector<Pose> after = poses(one.world.bodies), same = poses(other.world.bodies);
  const std::size_t bob = one.bob.slot;
  expect(after[bob].x == same[bob].x && after[bob].q == same[bob].q, "a copy moves alike");
  const glm::dvec3 between = mix(before[bob].x, after[bob].x, 0.5);
  const glm::dquat turned = slerp(before[bob].q, after[bob].q, 0.5);
  expect(between.x > before[bob].x.x && between.x < after[bob].x.x &&
             std::abs(length(turned) - 1) < 1e-6, "a pose between two steps");
}

void limits_are_seen() {
  World world;
  const BodyId frame = world.add(static_body(vec3(0)));
  const BodyId door = world.add(box(1, vec3(1, 1, real(0.1)), vec3(real(0.5), 0, 0)));
  auto& hinge = world.add<HingeJoint>(frame, door, vec3(0), vec3(0, 1, 0));
  hinge.set_limits(0, real(0.1));
  world.bodies[door].w = vec3(0, 2, 0);
  world.bodies[door].v = vec3(0, 0, -1);
  DirectSolver solver;
  bool reached = false;
  for (int n = 0; n < 30 && !reached; ++n) {
    step(world, solver, h);
    reached = hinge.limit_force() != 0;
  }
  expect(reached && hinge.position(world.bodies) < real(0.11), "a limit that was reached is seen");
}

void off_and_on_again() {
  Pendulum one;
  const std::uint64_t number = one.world[one.pin].number();
  std::map<std::uint64_t, const char*> own{{number, "pin"}};
  one.world.remove(one.pin);
  step(one.world, one.solver, h);
  const real fallen = one.world.bodies[one.bob].x.y;
  one.pin = one.world.add<BallJoint>(one.frame, one.bob, Point{vec3(0), vec3(0, -fallen, 0)});
  for (int n = 0; n < 10; ++n) step(one.world, one.solver, h);
  expect(fallen < -1 && std::abs(one.world.bodies[one.bob].x.y - fallen) < real(1e-5),
         "a joint that is added again holds");
  expect(own.contains(number) && !own.contains(one.world[one.pin].number()),
         "data of one's own belong to one joint");
}

// A dumb-bell: two balls of 1 kg, a metre from their centre, on a rod along (0, 1, 1) / sqrt(2).
// About the rod it has the inertia of the balls alone.
void several_parts() {
  const real own = ball(1, real(0.2), vec3(0)).inverse_inertia_local.x, about = 2 / own;
  World world;
  world.gravity = vec3(0);
  const quat along = angleAxis(std::acos(real(-1)) / 4, vec3(1, 0, 0));  // y becomes the rod
  const BodyId id = world.add(body_with(2, vec3(about + 2, about, about + 2), vec3(0), along));
  Body& body = world.bodies[id];
  SequentialImpulses solver;
  body.torque = vec3(1, 0, 0);
  step(world, solver, h);
  expect(std::abs(body.w.x - h / (about + 2)) < real(1e-5), "the inertia across the rod");
  body.w = vec3(0);
  body.torque = along * vec3(0, 1, 0);
  step(world, solver, h);
  expect(std::abs(length(body.w) - h / about) < real(1e-3), "the inertia about the rod");
}

}  // namespace

int main() {
  local_points();
  force_at_a_point();
  breaks();
  damped();
  copied_and_between();
  limits_are_seen();
  off_and_on_again();
  several_parts();
}
