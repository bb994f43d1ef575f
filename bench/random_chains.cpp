// Chains and trees, drawn at random.
#include "bench/random_chains.h"

#include <cmath>

#include "bench/draw.h"

namespace joints::bench {

namespace {

BenchScene random_bodies(const char* name, unsigned seed, double ratio, bool tree) {
  Draw draw(seed);
  BenchScene scene;
  scene.name = name;
  scene.energy_scale = 0;
  scene.tip_mask = glm::dvec3(0);
  const real edge = real(0.4), step = real(0.5);
  std::vector<BodyId> ids{scene.box(0, vec3(edge), vec3(0))};
  std::vector<double> reach{0};
  vec3 along(1, 0, 0);
  const int count = draw.whole(5, 40);
  for (int k = 1; k <= count; ++k) {
    const int before = tree ? draw.whole(0, k - 1) : k - 1;
    along = normalize(along + real(tree ? 2 : 0.5) * draw.direction());
    const vec3 from = scene.world.bodies[ids[before]].x, x = from + step * along;
    const double mass = std::exp(draw.number(0, std::log(ratio)));
    ids.push_back(scene.box(real(mass), vec3(edge), x));
    const vec3 anchor = (from + x) / real(2);
    if (draw.number(0, 1) < 0.5) join_by_ball(scene, ids[before], ids.back(), anchor);
    else join_by_hinge(scene, ids[before], ids.back(), anchor, draw.direction());
    reach.push_back(reach[before] + double(step));
    scene.energy_scale += mass * 9.81 * reach.back();
  }
  scene.tip = count;
  return scene;
}

}  // namespace

BenchScene random_chain(unsigned seed, double ratio) {
  return random_bodies("random chain", seed, ratio, false);
}

BenchScene random_tree(unsigned seed, double ratio) {
  return random_bodies("random tree", seed, ratio, true);
}

}  // namespace joints::bench
