// A crate slides over the ground until friction stops it. Exit status 1 if it stops elsewhere.
// Prints:
//   the crate stops after 1.598 m, on 4 corners
#include <cmath>
#include <cstdio>

#include <joints.h>

int main() {
  using namespace joints;
  World world;
  const vec3 size(1, real(0.6), real(0.8));
  const BodyId ground = world.add(static_body(vec3(0)));
  const BodyId crate = world.add(box(10, size, vec3(0, size.y / 2, 0)));
  auto& contact = world.add<GroundContact>(ground, crate, Top{}, box_outline(size));
  contact.friction = real(0.5);
  world.bodies[crate].v = vec3(4, 0, 0);

  PackedImpulses solver;
  solver.iterations = 30;
  for (int n = 0; n < 120; ++n) step(world, solver, real(1) / 60, {.warm_start = true});

  const real path = world.bodies[crate].x.x, expected = real(4 * 4 / (2 * 0.5 * 9.81));
  std::printf("the crate stops after %.3f m, on %d corners\n", double(path), contact.touching());
  return std::abs(path - expected) < real(0.05) ? 0 : 1;
}
