// Running, watching and recording a scene.
#include "engine/instruments/scene.h"

#include <cstdio>

#include "engine/instruments/plan.h"
#include "engine/instruments/options.h"

namespace joints {

BodyId Scene::box(real mass, const vec3& size, const vec3& x, const quat& q) {
  shapes.push_back({"box", {double(size.x), double(size.y), double(size.z)}});
  return world.add(mass > 0 ? joints::box(mass, size, x, q) : static_body(x, q));
}

void Scene::mark(BodyId id1, BodyId id2, const vec3& anchor, const vec3& axis) {
  const Body &body1 = world.bodies[id1], &body2 = world.bodies[id2];
  marks.push_back({int(id1.slot), int(id2.slot), glm::dvec3(to_local(body1, anchor - body1.x)),
                   glm::dvec3(to_local(body2, anchor - body2.x)),
                   glm::dvec3(to_local(body1, axis)), glm::dvec3(to_local(body2, axis))});
}

void Scene::print_plan() {
  for (const auto& joint : world.joints()) joint->begin_step(world.bodies, h);
  std::printf("%s: %s\n", name.c_str(), plan(world, stepping.warm_start).line().c_str());
}

bool read(Settings& settings, const std::string& program, const std::string& seconds,
          const std::string& what_runs, int argc, const char* const* argv) {
  Options options(program, {{"iterations", "30", "iterations a step"},
                            {"beta", "0.2", "share of the error fed back in a step"},
                            {"seconds", seconds, what_runs},
                            {"whole", "1", "recorded with 1: whole joints, 0: blocks apart"}});
  if (!options.read(argc, argv)) return false;
  settings = {options.count("iterations", 1), real(options.number("beta", 0)),
              options.flag("whole"), options.number("seconds", 0.1),
              options.text("out")};
  return true;
}

double energy(const World& world) {
  double sum = potential_energy(poses(world.bodies), masses(world.bodies),
                                glm::dvec3(world.gravity));
  for (int slot = 0; slot < world.bodies.slots(); ++slot)
    sum += kinetic_energy(world.bodies.at(slot));
  return sum;
}

Summary play(Scene& scene, const std::string& setting, double seconds,
             const std::string& motion_path, const std::function<void(double)>& look) {
  Motion motion(scene.name, double(scene.h));
  for (const Shape& shape : scene.shapes) motion.body(shape);
  for (const Mark& mark : scene.marks) {
    const glm::dvec3 &a = mark.anchor1_local, &b = mark.anchor2_local;
    motion.line({mark.body1, mark.body1, {0, 0, 0}, {a.x, a.y, a.z}});
    motion.line({mark.body2, mark.body2, {0, 0, 0}, {b.x, b.y, b.z}});
  }
  for (const Segment& segment : scene.segments) motion.line(segment);
  StepClock clock;
  GapMeter gaps;
  std::vector<Pose> now;
  const double start = energy(scene.world);
  const int steps = int(std::lround(seconds / double(scene.h)));
  for (int n = 0; n <= steps; ++n) {
    if (n > 0) {
      clock.start();
      scene.step();
      clock.stop();
    }
    poses(scene.world.bodies, now);
    gaps.look(scene.marks, now);
    motion.frame(scene.world.bodies.data());
    look(n * double(scene.h));
  }
  if (!motion_path.empty()) motion.write(motion_path);
  return {scene.name, setting, clock.median_us(), gaps.rms(), gaps.maximum(),
          (energy(scene.world) - start) / scene.energy_scale};
}

}  // namespace joints
