// A swinging chain is saved and restored. It then repeats its motion bit by bit, and so does a
// second chain that was built in the same way. Exit status 1 if one of them moves differently.
// Prints:
//   after a second: 5 J lost, an iteration multiplies an error by 0.94
//   the next second, repeated and in the other world: the same
#include <cstdio>

#include <joints.h>

using namespace joints;

// Eight links of 1 kg, released level.
World chain() {
  World world;
  BodyId before = world.add(static_body(vec3(0)));
  for (int k = 0; k < 8; ++k) {
    const BodyId next = world.add(ball(1, real(0.2), vec3(real(k + 1), 0, 0)));
    const vec3 middle(real(k) + real(0.5), 0, 0);
    world.add<BallJoint>(before, next, middle);
    before = next;
  }
  world.set_beta(real(0.1));
  return world;
}

State after_a_second(World& world) {
  SequentialImpulses solver;
  for (int n = 0; n < 60; ++n) step(world, solver, real(1) / 60, {.warm_start = true});
  return save(world);
}

int main() {
  World world = chain(), other = chain();
  const State now = after_a_second(world);
  std::printf("after a second: %.0f J lost, an iteration multiplies an error by %.2f\n",
              -energy(all_of(world.bodies), world.gravity), contraction_rate(world, 1000));
  const State then = after_a_second(world);
  restore(world, now);
  restore(other, from_bytes(to_bytes(now)));  // as through a file
  const bool same = after_a_second(world) == then && after_a_second(other) == then;
  std::printf("the next second, repeated and in the other world: %s\n",
              same ? "the same" : "different");
  return same ? 0 : 1;
}
