// Chains, trees and islands of all kinds, drawn by a seed.
#include "bench/random_chains.h"

#include <algorithm>
#include <cmath>

#include "bench/chapters/08_ground/ragdoll.h"
#include "bench/draw.h"

namespace joints::bench {

namespace {

constexpr double standard_gravity = 9.81;  // [m/s^2]

BenchScene empty(const char* name) {
  BenchScene scene;
  scene.name = name;
  scene.energy_scale = 0;
  scene.tip_mask = glm::dvec3(0);
  return scene;
}

// \param root of its first, static cube [m]
void add_bodies(BenchScene& scene, Draw& draw, const vec3& root, double ratio, bool tree) {
  const real edge = real(0.4), step = real(0.5);
  std::vector<BodyId> ids{scene.box(0, vec3(edge), root)};
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
    scene.energy_scale += mass * standard_gravity * reach.back();
  }
  scene.tip = int(ids.back().slot);
}

BenchScene random_bodies(const char* name, unsigned seed, double ratio, bool tree) {
  Draw draw(seed);
  BenchScene scene = empty(name);
  add_bodies(scene, draw, vec3(0), ratio, tree);
  return scene;
}

void add_limited_chain(BenchScene& scene, Draw& draw, const vec3& root, int links) {
  const real edge = real(0.4), step = real(0.5), limit = real(draw.number(0.1, 0.6));
  BodyId last = scene.box(0, vec3(edge), root);
  for (int k = 1; k <= links; ++k) {
    const vec3 x = root + vec3(real(k) * step, 0, 0);
    const double mass = draw.number(1, 10);
    const BodyId next = scene.box(real(mass), vec3(edge), x);
    HingeJoint& hinge = join_by_hinge(scene, last, next, x - vec3(step / 2, 0, 0), vec3(0, 0, 1));
    hinge.set_limits(-limit, limit);
    scene.energy_scale += mass * standard_gravity * k * double(step);
    last = next;
  }
}

// \return how many bodies it has that can move
int add_island(BenchScene& scene, Draw& draw, BodyId ground, const vec3& place) {
  const vec3 above = place + vec3(0, real(draw.number(1.3, 2.5)), 0), root = place + vec3(0, 25, 0);
  const std::size_t before = scene.world.bodies.size();
  switch (draw.whole(0, 5)) {
    case 0:
      chapter8::add_doll(scene, ground, above, draw.rotation(), real(0.2));
      break;
    case 1: {
      const vec3 size(real(draw.number(0.2, 1)), real(draw.number(0.2, 1)), real(0.5));
      const double mass = draw.number(1, 100);
      const BodyId box = scene.box(real(mass), size, above, draw.rotation());
      chapter8::stand(scene, ground, box, size, real(0.5));
      scene.energy_scale += mass * standard_gravity * double(above.y);
      break;
    }
    case 2:
      add_limited_chain(scene, draw, root, draw.whole(2, 20));
      return int(scene.world.bodies.size() - before) - 1;
    case 3:
    case 4:
      add_bodies(scene, draw, root, 10, draw.chance(0.5));
      return int(scene.world.bodies.size() - before) - 1;
    default: {
      const BodyId stand = scene.box(0, vec3(real(0.4)), root),
                   cube = scene.box(10, vec3(real(0.4)), root + vec3(1, 0, 0));
      HingeJoint& hinge = join_by_hinge(scene, stand, cube, root, draw.direction());
      hinge.set_motor(real(draw.number(-3, 3)), real(draw.number(10, 200)));
      scene.energy_scale += 10 * standard_gravity;
      return 1;
    }
  }
  return int(scene.world.bodies.size() - before);
}

}  // namespace

BenchScene random_chain(unsigned seed, double ratio) {
  return random_bodies("random chain", seed, ratio, false);
}

BenchScene random_tree(unsigned seed, double ratio) {
  return random_bodies("random tree", seed, ratio, true);
}

BenchScene limited_chains(int chains, int links, unsigned seed) {
  Draw draw(seed);
  BenchScene scene = empty("chains with limits");
  for (int c = 0; c < chains; ++c)
    add_limited_chain(scene, draw, vec3(0, 0, real(1.5) * real(c)), links);
  scene.finding = {"farthest beyond a limit [mrad]", 0, [](const Scene& now) {
                     double most = 0;
                     for (const auto& joint : now.world.joints()) {
                       const auto& hinge = dynamic_cast<const HingeJoint&>(*joint);
                       const real angle = hinge.position(now.world.bodies);
                       most = std::max({most, double(angle - hinge.limits().upper),
                                        double(hinge.limits().lower - angle)});
                     }
                     return 1000 * most;
                   }};
  return scene;
}

BenchScene mixed_islands(int bodies, unsigned seed) {
  Draw draw(seed);
  BenchScene scene = empty("mixed islands");
  const real apart = 12;
  const int in_a_row = int(std::ceil(std::sqrt(double(bodies))));  // more than there will be
  const BodyId ground = chapter8::add_ground(scene, apart * real(in_a_row));
  for (int k = 0, moving = 0; moving < bodies; ++k)
    moving += add_island(scene, draw, ground,
                         apart * vec3(real(k % in_a_row), 0, real(k / in_a_row)));
  return scene;
}

}  // namespace joints::bench
