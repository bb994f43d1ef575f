// A rope of nine links of 1 kg swings with 1,000 kg at its end, moved in three ways: by iterations,
// by the direct solver with the settings that docs/which_method.md recommends, and in reduced
// coordinates. Exit status 1 unless the last two hold it.
// Prints:
//   30 iterations       comes apart
//   direct              holds
//   reduced coordinates holds
#include <algorithm>
#include <cstdio>
#include <vector>

#include <joints.h>

using namespace joints;

const real h = real(1) / 60;

struct Hoist {
  World world;
  std::vector<BallJoint*> links;
  Hoist() {
    BodyId before = world.add(static_body(vec3(0)));
    for (int k = 0; k < 10; ++k) {
      const vec3 top(real(0.6) * real(k), real(-0.8) * real(k), 0);
      const vec3 middle = top + vec3(real(0.3), real(-0.4), 0);
      const BodyId link = world.add(ball(k < 9 ? 1 : 1000, real(0.2), middle));
      links.push_back(&world.add<BallJoint>(before, link, top));
      before = link;
    }
  }
  // The widest gap of a joint now [m].
  real gap() const {
    real widest = 0;
    for (const BallJoint* joint : links) {
      const Body &a = world.bodies[joint->body1], &b = world.bodies[joint->body2];
      widest = std::max(widest, length(joint->part.error(a, b)));
    }
    return widest;
  }
};

// Plays five seconds and says what became of the hoist. True if it holds.
template <class Step>
bool play(const char* name, Hoist& hoist, const Step& one_step) {
  real widest = 0;
  for (int n = 0; n < 300; ++n) {
    one_step();
    widest = std::max(widest, hoist.gap());
  }
  const char* verdict = widest < real(0.001) ? "holds" : widest > 1 ? "comes apart" : "opens";
  std::printf("%-19s %s\n", name, verdict);
  return widest < real(0.001);
}

int main() {
  Hoist first, second, third;

  SequentialImpulses iterations;
  iterations.iterations = 30;
  play("30 iterations", first, [&] { step(first.world, iterations, h); });

  DirectSolver direct;
  const bool held = play("direct", second,
                         [&] { step(second.world, direct, h, {.leapfrog = true}); });

  Reduced tree(third.world);
  return play("reduced coordinates", third, [&] { tree.step(third.world, h); }) && held ? 0 : 1;
}
