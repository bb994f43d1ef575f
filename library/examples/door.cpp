// A motor opens a door on a hinge up to its limit. Exit status 1 if the door rests elsewhere.
// Prints:
//   the door rests at 110.0000 degrees, the limit bears -30.00 N m
#include <cmath>
#include <cstdio>
#include <numbers>

#include <joints.h>

int main() {
  using namespace joints;
  const real degree = std::numbers::pi_v<real> / 180;

  World world;  // metres, kilograms, seconds; gravity is 9.81 m/s^2 along -y
  const BodyId frame = world.add(static_body(vec3(0)));
  const BodyId door = world.add(box(20, vec3(real(0.8), 2, real(0.04)), vec3(real(0.4), 0, 0)));
  auto& hinge = world.add<HingeJoint>(frame, door, vec3(0), vec3(0, 1, 0));
  hinge.set_limits(0, 110 * degree);
  hinge.set_motor(1, 30);  // rad/s, at most 30 N m

  PackedImpulses solver;
  solver.iterations = 30;
  for (int n = 0; n < 240; ++n) step(world, solver, real(1) / 60);

  const real angle = hinge.position(world.bodies) / degree;
  std::printf("the door rests at %.4f degrees, the limit bears %.2f N m\n", double(angle),
              double(hinge.limit_force()));
  return std::abs(angle - 110) < real(0.01) ? 0 : 1;
}
