// The benchmark scenes.
#include "bench/scenes.h"

#include "chapters/02_ball/ball_joint.h"

namespace joints::bench {

namespace {

// A ball joint at a point of the world, and the mark that measures it.
void join(Scene& scene, BodyId id1, BodyId id2, const vec3& anchor) {
  const Body &body1 = scene.world.bodies[id1], &body2 = scene.world.bodies[id2];
  scene.world.add<BallJoint>(id1, id2, point_at(body1, body2, anchor));
  scene.marks.push_back({int(id1.slot), int(id2.slot), glm::dvec3(anchor - body1.x),
                         glm::dvec3(anchor - body2.x), glm::dvec3(0), glm::dvec3(0)});
}

}  // namespace

Scene cubes_on_balls(int chains, int length) {
  Scene scene;
  scene.name = "S1b";
  scene.chains = chains;
  scene.energy_scale = 0;
  for (int c = 0; c < chains; ++c) {
    BodyId before;
    for (int i = 0; i < length; ++i) {
      const vec3 place(real(3 * c), 0, real(1.5) * real(i));
      const BodyId id = scene.world.add(i == 0 ? static_body(place) : box(100, vec3(1), place));
      if (i > 0) {
        join(scene, before, id, place - vec3(0, 0, real(1.5)));
        scene.energy_scale += 100 * 9.81 * 1.5 * i;
      }
      before = id;
    }
  }
  scene.tip = length - 1;  // of the first chain: they are all alike
  if (length == 100) scene.tip_reference = {0, -4.9050000000, 147.6685472730};
  if (length == 4) scene.tip_reference = {0, -4.2987677781, 1.1499633763};
  return scene;
}

Scene heavy_end(double ratio) {
  Scene scene;
  scene.name = "S2 R=" + std::to_string(int(ratio));
  scene.energy_scale = 0;
  BodyId before;
  for (int i = 0; i <= 21; ++i) {
    const vec3 place(real(0.5) * real(i), 0, 0);
    const Body body = i == 0    ? static_body(place)
                      : i == 21 ? ball(real(ratio), real(0.25), place)
                                : box(1, vec3(real(0.4)), place);
    const BodyId id = scene.world.add(body);
    if (i > 0) {
      join(scene, before, id, place - vec3(real(0.25), 0, 0));
      scene.energy_scale += (i == 21 ? ratio : 1.0) * 9.81 * 0.5 * i;
    }
    before = id;
  }
  scene.tip = 21;
  scene.tip_mask = {1, 1, 0};
  const struct {
    double ratio, x, y;
  } references[] = {{1, 8.0970414980, -4.9049921200},      {10, 8.4796476432, -4.9049640418},
                    {100, 9.2624792368, -4.8651145480},    {1000, 9.3528668559, -4.7013348291},
                    {10000, 9.3649385124, -4.6875070381}};
  bool known = false;
  for (const auto& reference : references)
    if (reference.ratio == ratio) {
      scene.tip_reference = {reference.x, reference.y, 0};
      known = true;
    }
  require(known, "ratio: no reference is known for this mass; take 1, 10, 100, 1000 or 10000");
  return scene;
}

}  // namespace joints::bench
