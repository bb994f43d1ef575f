// The benchmark's bridge and its cranes.
#include <cmath>
#include <numbers>

#include "bench/scenes.h"

namespace joints::bench {

namespace {

const real sixty_degrees = std::numbers::pi_v<real> / 3;

}  // namespace

BenchScene hanging_bridge(bool hinges) {
  BenchScene scene;
  scene.name = hinges ? "S3" : "S3b";
  scene.energy_scale = 0;
  const double step = std::numbers::pi / 2 / 41, radius = 0.5 / std::sin(step / 2);
  BodyId before;
  vec3 last(0);
  for (int i = 0; i < 42; ++i) {
    const double angle = -std::numbers::pi / 4 + i * step;
    const vec3 place(real(radius * std::sin(angle)),
                     real(radius * (std::cos(std::numbers::pi / 4) - std::cos(angle))), 0);
    const double mass = i == 21 ? 100 : 1;
    const bool fixed = i == 0 || i == 41;
    const BodyId id = scene.world.add(fixed ? static_body(place)
                                            : box(real(mass), vec3(real(0.8)), place));
    if (!fixed) scene.energy_scale += mass * 9.81 * 5;
    const vec3 midway = real(0.5) * (last + place);
    if (i > 0 && hinges) join_by_hinge(scene, before, id, midway, vec3(0, 0, 1));
    if (i > 0 && !hinges) join_by_ball(scene, before, id, midway);
    before = id;
    last = place;
  }
  scene.tip_mask = glm::dvec3(0);
  if (hinges) scene.forbidden = {0, 0, 1};
  return scene;
}

BenchScene crane(const vec3& axis) {
  BenchScene scene;
  scene.name = "S4";
  scene.energy_scale = 100 * 9.81 * 1.5;
  const BodyId wall = scene.world.add(static_body(vec3(0)));
  const BodyId cube = scene.world.add(box(100, vec3(1), vec3(0, 0, real(1.5))));
  join_by_hinge(scene, wall, cube, vec3(0), axis);
  scene.tip_mask = glm::dvec3(0);
  scene.forbidden = glm::dvec3(axis);
  return scene;
}

HingeJoint& hinge_of(Scene& scene) {
  return static_cast<HingeJoint&>(*scene.world.joints().front());
}

BenchScene motor() {
  BenchScene scene = crane(vec3(0, 1, 0));
  scene.name = "S4m";
  hinge_of(scene).set_motor(3, 500);
  return scene;
}

BenchScene limit() {
  BenchScene scene = crane(vec3(1, 0, 0));
  scene.name = "S4l";
  hinge_of(scene).set_limits(-sixty_degrees, sixty_degrees);
  return scene;
}

BenchScene motor_into_limit() {
  BenchScene scene = motor();
  scene.name = "S4ml";
  hinge_of(scene).set_limits(-sixty_degrees, sixty_degrees);
  return scene;
}

}  // namespace joints::bench
