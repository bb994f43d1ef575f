// A suspension with the spring and the damper of a data sheet, an arm on a servo, and a load on a
// winch. Exit status 1 if one of them rests elsewhere.
// Prints:
//   the suspension sags 98.1 mm under 1962 N
//   the servo holds the arm at 60.00 degrees with 7.36 N m
//   the rope is 2.01 m long and pulls with 49.05 N
//   the shoulder lifts the arm with 29.4 N
#include <cmath>
#include <cstdio>
#include <numbers>

#include <joints.h>

using namespace joints;

int main() {
  World world;
  const BodyId ground = world.add(static_body(vec3(0)));
  // a quarter of a car, which moves along the vertical
  const BodyId car = world.add(box(200, vec3(2, real(0.5), 1), vec3(0, 1, 0)));
  auto& rail = world.add<SliderJoint>(ground, car, vec3(0, 1, 0), vec3(0, 1, 0));
  rail.set_spring({.stiffness = 20000, .damping = 1500});  // N/m, N s/m
  // an arm of 1 m and 3 kg, level at first
  const BodyId arm = world.add(box(3, vec3(1, real(0.1), real(0.1)), vec3(real(5.5), 0, 0)));
  auto& shoulder = world.add<HingeJoint>(ground, arm, vec3(5, 0, 0), vec3(0, 0, 1));
  const real up = std::numbers::pi_v<real> / 3;
  shoulder.set_servo(up, 1, 50);  // to 60 degrees, at most 1 rad/s and 50 N m
  shoulder.set_friction(2);       // N m
  // a load on a rope of at most 4 m, which a winch pulls in by 0.5 m/s
  const BodyId load = world.add(box(5, vec3(real(0.4)), vec3(9, -4, 0)));
  auto& rope = world.add<StrutJoint>(ground, load, vec3(9, 0, 0), vec3(9, -4, 0));
  rope.length().set_limits(0, 4);
  rope.length().set_motor(real(-0.5), 100);  // m/s, N

  PackedImpulses solver;
  solver.iterations = 30;
  for (int n = 0; n < 240; ++n) step(world, solver, real(1) / 60, {.warm_start = true});

  const Bodies& bodies = world.bodies;
  const real sag = -1000 * rail.position(bodies), angle = shoulder.position(bodies);
  std::printf("the suspension sags %.1f mm under %.0f N\n", double(sag),
              double(rail.spring_force()));
  std::printf("the servo holds the arm at %.2f degrees with %.2f N m\n",
              double(angle * 60 / up), double(shoulder.motor_force() + shoulder.friction_force()));
  std::printf("the rope is %.2f m long and pulls with %.2f N\n",
              double(rope.length().position(bodies)), -double(rope.length().motor_force()));
  std::printf("the shoulder lifts the arm with %.1f N\n",
              double(reaction(shoulder, bodies).force.y));
  const bool good = std::abs(sag - real(98.1)) < real(0.1) && std::abs(angle - up) < real(0.001) &&
                    std::abs(rope.length().position(bodies) - 2) < real(0.01);
  return good ? 0 : 1;
}
