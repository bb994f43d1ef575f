// The door, the arm, the crate and the chain of the library's page as version 0.9 wrote them: the
// program passes the world's bodies to every joint. Exit status 1 if one of them rests elsewhere.
#include <cmath>
#include <cstdio>
#include <numbers>

#include <joints.h>

using namespace joints;

const real degree = std::numbers::pi_v<real> / 180, h = real(1) / 60;

bool door() {
  World world;
  const BodyId frame = world.add(static_body(vec3(0)));
  const BodyId leaf = world.add(box(20, vec3(real(0.8), 2, real(0.04)), vec3(real(0.4), 0, 0)));
  auto& hinge = world.add<HingeJoint>(world.bodies, frame, leaf, vec3(0), vec3(0, 1, 0));
  hinge.set_limits(0, 110 * degree);
  hinge.set_motor(1, 30);
  PackedImpulses solver;
  solver.iterations = 30;
  for (int n = 0; n < 240; ++n) step(world, solver, h);
  const real angle = hinge.position(world.bodies) / degree;
  std::printf("the door rests at %.4f degrees, the limit bears %.2f N m\n", double(angle),
              double(hinge.limit_force()));
  return std::abs(angle - 110) < real(0.01);
}

bool arm() {
  World world;
  const vec3 axis(0, 0, 1), thin(1, real(0.1), real(0.1));
  const BodyId base = world.add(static_body(vec3(0)));
  const BodyId upper = world.add(box(4, thin, vec3(real(0.5), 0, 0)));
  const BodyId lower = world.add(box(2, thin, vec3(real(1.4), 0, 0)));
  auto& shoulder = world.add<HingeJoint>(world.bodies, base, upper, vec3(0), axis);
  auto& elbow = world.add<HingeJoint>(world.bodies, upper, lower, vec3(1, 0, 0), axis);
  shoulder.set_limits(-30 * degree, 60 * degree);
  shoulder.set_motor(real(0.5), 60);
  elbow.set_limits(-120 * degree, 0);
  elbow.set_friction(3);
  SequentialImpulses solver;
  solver.iterations = 50;
  for (int n = 0; n < 240; ++n) step(world, solver, h, {.warm_start = true});
  return std::abs(shoulder.position(world.bodies) - 60 * degree) < real(0.001) &&
         std::abs(elbow.position(world.bodies) + 120 * degree) < real(0.001);
}

bool crate() {
  World world;
  const vec3 size(1, real(0.6), real(0.8));
  const BodyId ground = world.add(static_body(vec3(0)));
  const BodyId box_ = world.add(box(10, size, vec3(0, size.y / 2, 0)));
  auto& contact = world.add<GroundContact>(ground, box_, Top{}, box_outline(size));
  contact.friction = real(0.5);
  world.bodies[box_].v = vec3(4, 0, 0);
  PackedImpulses solver;
  solver.iterations = 30;
  for (int n = 0; n < 120; ++n) step(world, solver, h, {.warm_start = true});
  return std::abs(world.bodies[box_].x.x - real(1.598)) < real(0.01) && contact.touching() == 4;
}

bool chain() {
  World world;
  BodyId before = world.add(static_body(vec3(0)));
  for (int k = 0; k < 8; ++k) {
    const BodyId next = world.add(ball(1, real(0.2), vec3(real(k + 1), 0, 0)));
    world.add<BallJoint>(before, next, point_at(world.bodies[before], world.bodies[next],
                                                vec3(real(k) + real(0.5), 0, 0)));
    before = next;
  }
  world.set_beta(real(0.1));
  const auto a_second_later = [&] {
    SequentialImpulses solver;
    for (int n = 0; n < 60; ++n) step(world, solver, h, {.warm_start = true});
    return save(world);
  };
  const State now = a_second_later(), then = a_second_later();
  restore(world, now);
  return a_second_later() == then;
}

int main() { return door() && arm() && crate() && chain() ? 0 : 1; }
