// An arm of two links on a fixed base. A motor lifts it up to a limit, and friction keeps the elbow
// straight. With less friction the elbow sinks to its own limit. Exit status 1 if the arm rests
// elsewhere.
// Prints:
//   friction of 30 N m: shoulder at 60.00, elbow at 0.00 degrees, the limit bears -36.46 N m
//   friction of  3 N m: shoulder at 60.00, elbow at -120.00 degrees, the limit bears -36.46 N m
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

#include <joints.h>

using namespace joints;

int main() {
  const real degree = std::numbers::pi_v<real> / 180;
  World world;
  const vec3 axis(0, 0, 1);
  const BodyId base = world.add(static_body(vec3(0)));
  const BodyId upper = world.add(box(4, vec3(1, real(0.1), real(0.1)), vec3(real(0.5), 0, 0)));
  const BodyId lower = world.add(box(2, vec3(real(0.8), real(0.1), real(0.1)),
                                     vec3(real(1.4), 0, 0)));
  auto& shoulder = world.add<HingeJoint>(base, upper, vec3(0), axis);
  auto& elbow = world.add<HingeJoint>(upper, lower, vec3(1, 0, 0), axis);
  shoulder.set_limits(-30 * degree, 60 * degree);
  shoulder.set_motor(real(0.5), 60);  // rad/s, at most 60 N m
  elbow.set_limits(-120 * degree, 0);

  PackedImpulses solver;
  solver.iterations = 50;
  bool good = true;
  for (const auto& [friction, expected] : {std::pair{30, 0}, std::pair{3, -120}}) {
    elbow.set_friction(real(friction));  // at most this torque [N m]
    for (int n = 0; n < 240; ++n) step(world, solver, real(1) / 60, {.warm_start = true});
    const real at = shoulder.position(world.bodies) / degree;
    const real bent = elbow.position(world.bodies) / degree;
    std::printf("friction of %2d N m: shoulder at %.2f, elbow at %.2f degrees, "
                "the limit bears %.2f N m\n",
                friction, double(at), double(bent), double(shoulder.limit_force()));
    good = good && std::abs(at - 60) < real(0.05) && std::abs(bent - expected) < real(0.05);
  }
  return good ? 0 : 1;
}
