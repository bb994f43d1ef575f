// The benchmark's chains.
#include "bench/scenes.h"

#include "joints/ball_joint.h"

namespace joints::bench {

namespace {

// The cubes of S1 and S1b; `join` holds two of them together at a place.
template <class Join>
BenchScene cubes(const std::string& name, int chains, int length, Join join) {
  BenchScene scene;
  scene.name = name;
  scene.chains = chains;
  scene.energy_scale = 0;
  for (int c = 0; c < chains; ++c) {
    BodyId before;
    for (int i = 0; i < length; ++i) {
      const vec3 place(real(3 * c), 0, real(1.5) * real(i));
      const BodyId id = scene.box(i == 0 ? 0 : 100, vec3(1), place);
      if (i > 0) {
        join(scene, before, id, place - vec3(0, 0, real(1.5)));
        scene.energy_scale += 100 * 9.81 * 1.5 * i;
      }
      before = id;
    }
  }
  scene.tip = length - 1;  // of the first chain: they are all alike
  if (length == 100) scene.tip_reference = {0, -4.9050000000, 147.6685472730};
  else if (length == 4) scene.tip_reference = {0, -4.2987677781, 1.1499633763};
  else scene.tip_mask = glm::dvec3(0);
  return scene;
}

}  // namespace

void join_by_ball(Scene& scene, BodyId id1, BodyId id2, const vec3& anchor) {
  const Body &body1 = scene.world.bodies[id1], &body2 = scene.world.bodies[id2];
  scene.world.add<BallJoint>(id1, id2, point_at(body1, body2, anchor));
  scene.mark(id1, id2, anchor);
}

HingeJoint& join_by_hinge(Scene& scene, BodyId id1, BodyId id2, const vec3& anchor,
                          const vec3& axis) {
  scene.mark(id1, id2, anchor, axis);
  return scene.world.add<HingeJoint>(id1, id2, anchor, axis);
}

BenchScene cubes_on_balls(int chains, int length) {
  return cubes("S1b", chains, length, join_by_ball);
}

BenchScene cubes_on_hinges(int chains, int length) {
  BenchScene scene = cubes(length == 4 ? "S5" : "S1", chains, length,
                      [](Scene& s, BodyId id1, BodyId id2, const vec3& anchor) {
                        join_by_hinge(s, id1, id2, anchor, vec3(1, 0, 0));
                      });
  scene.forbidden = {1, 0, 0};
  return scene;
}

BenchScene loaded_axes() {
  BenchScene scene = cubes_on_hinges(1, 11);
  scene.name = "S6";
  scene.tip_mask = glm::dvec3(1);
  scene.tip_reference = {0, -4.8793420933, 13.0903044791};
  scene.world.gravity = vec3(1, real(-9.7587), 0);
  return scene;
}

BenchScene sideways_gravity() {
  BenchScene scene = cubes_on_hinges(10, 100);
  scene.name = "S7";
  scene.world.gravity = vec3(3, real(-9.81), 0);
  return scene;
}

BenchScene heavy_end_unreferenced(double ratio) {
  BenchScene scene;
  char number[32];
  std::snprintf(number, sizeof number, "%g", ratio);
  scene.name = std::string("S2 R=") + (ratio < 1e5 ? std::to_string(int(ratio)) : number);
  scene.energy_scale = 0;
  BodyId before;
  for (int i = 0; i <= 21; ++i) {
    const vec3 place(real(0.5) * real(i), 0, 0);
    const BodyId id = i < 21 ? scene.box(i == 0 ? 0 : 1, vec3(real(0.4)), place)
                             : scene.ball(real(ratio), real(0.25), place);
    if (i > 0) {
      join_by_ball(scene, before, id, place - vec3(real(0.25), 0, 0));
      scene.energy_scale += (i == 21 ? ratio : 1.0) * 9.81 * 0.5 * i;
    }
    before = id;
  }
  scene.tip = 21;
  scene.tip_mask = glm::dvec3(0);
  return scene;
}

BenchScene heavy_end(double ratio) {
  BenchScene scene = heavy_end_unreferenced(ratio);
  scene.tip_mask = {1, 1, 0};
  const struct {
    double ratio, x, y;
  } references[] = {{1, 8.0970414980, -4.9049921200},      {10, 8.4796476432, -4.9049640418},
                    {100, 9.2624792368, -4.8651145480},    {1000, 9.3528668559, -4.7013348291},
                    {10000, 9.3649385124, -4.6875070381}};
  for (const auto& reference : references)
    if (reference.ratio == ratio) {
      scene.tip_reference = {reference.x, reference.y, 0};
      return scene;
    }
  refuse("ratio: no reference is known for this mass; take 1, 10, 100, 1000 or 10000");
}

BenchScene chain_of_masses(const std::vector<double>& masses, const vec3& along) {
  BenchScene scene;
  scene.name = "chain of masses";
  scene.energy_scale = 0;
  BodyId before = scene.world.add(static_body(vec3(0)));
  for (std::size_t k = 1; k <= masses.size(); ++k) {
    const real mass = real(masses[k - 1]);
    const vec3 place = real(k) * along;
    const BodyId id = scene.world.add(box(mass, vec3(real(0.4)), place));
    join_by_ball(scene, before, id, place - real(0.5) * along);
    scene.energy_scale += masses[k - 1] * 9.81 * double(k);
    before = id;
  }
  scene.tip = int(masses.size());
  scene.tip_mask = glm::dvec3(0);
  return scene;
}

}  // namespace joints::bench
