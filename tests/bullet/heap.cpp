// Ten cubes stand on each other for a minute, on contacts that Bullet's collision part finds. Exit
// status 1 if one of them has moved by more than 1 mm in the last 50 s.
#include <cstdio>
#include <vector>

#include <bullet_contacts.h>
#include <joints.h>

using namespace joints;

int main() {
  World world;
  const real h = real(1) / 60;
  BulletContacts shapes(world, h, 4);  // 4 substeps
  const BodyId ground = world.add(static_body(vec3(0, -1, 0)));
  shapes.add_box(ground, vec3(100, 2, 100));
  std::vector<BodyId> cubes;
  for (int k = 0; k < 10; ++k) {
    cubes.push_back(world.add(box(10, vec3(1), vec3(0, real(k) + real(0.5), 0))));
    shapes.add_box(cubes.back(), vec3(1));  // or add_ball, add_capsule, or add: any convex shape
  }
  shapes.contacts.skip_joined();  // no contacts between bodies that a joint connects

  SequentialImpulses solver;
  solver.iterations = 4;
  std::vector<vec3> settled;
  for (int n = 0; n < 3600; ++n) {
    if (n == 600)
      for (const BodyId id : cubes) settled.push_back(world.bodies[id].x);
    shapes.update();
    step(world, solver, h, {.warm_start = true, .substeps = 4});
  }
  real drift = 0;
  for (std::size_t k = 0; k < cubes.size(); ++k)
    drift = std::max(drift, length(world.bodies[cubes[k]].x - settled[k]));
  std::printf("%d pairs touch, drift %.2f mm\n", shapes.contacts.count(), 1000 * double(drift));
  return drift < real(1e-3) ? 0 : 1;
}
