// A lift whose motion the program prescribes: a kinematic body carries a crate two metres up. Exit
// status 1 if the crate does not arrive.
// Prints:
//   the lift is at 2.000 m, the crate 0.300 m above it
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include <joints.h>

int main() {
  using namespace joints;
  const real h = real(1) / 60;
  const vec3 size(1, real(0.6), real(0.8));
  World world;
  Body platform = static_body(vec3(0));
  platform.kinematic = true;  // no force moves it; steps move it by its v and w
  const BodyId lift = world.add(platform);
  const BodyId crate = world.add(box(10, size, vec3(0, size.y / 2, 0)));
  world.add<GroundContact>(lift, crate, Top{}, box_outline(size));

  PackedImpulses solver;
  solver.iterations = 30;
  for (int n = 1; n <= 180; ++n) {  // up in two seconds, gently at both ends
    const real part = std::min(real(1), n * h / 2);
    const real height = 1 - std::cos(std::numbers::pi_v<real> * part);
    move_to(world.bodies[lift], vec3(0, height, 0), quat(1, 0, 0, 0), h);
    step(world, solver, h, {.warm_start = true});
  }

  const real top = world.bodies[lift].x.y, above = world.bodies[crate].x.y - top;
  std::printf("the lift is at %.3f m, the crate %.3f m above it\n", double(top), double(above));
  return std::abs(top - 2) < real(1e-4) && std::abs(above - size.y / 2) < real(0.001) ? 0 : 1;
}
