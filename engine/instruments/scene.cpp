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

BodyId Scene::ball(real mass, real radius, const vec3& x) {
  const double edge = 2 * double(radius);
  shapes.push_back({"ball", {edge, edge, edge}});
  return world.add(joints::ball(mass, radius, x));
}

void Scene::mark(BodyId id1, BodyId id2, const vec3& anchor, const vec3& axis) {
  const Body &body1 = world.bodies[id1], &body2 = world.bodies[id2];
  marks.push_back({int(id1.slot), int(id2.slot), glm::dvec3(to_local(body1, anchor - body1.x)),
                   glm::dvec3(to_local(body2, anchor - body2.x)),
                   glm::dvec3(to_local(body1, axis)), glm::dvec3(to_local(body2, axis))});
}

void Scene::print_plan() {
  for (const auto& joint : world.joints()) joint->begin_step(world.bodies, h);
  std::printf("%s: %s\n", name.c_str(), plan(world, stepping.warm_start, &solver).line().c_str());
}

bool read(Settings& settings, const std::string& program, const std::string& seconds,
          const std::string& what_runs, int argc, const char* const* argv) {
  Options options(program, {{"iterations", "30", "iterations a step"},
                            {"beta", "0.2", "fraction of the error fed back per step [1]"},
                            {"seconds", seconds, what_runs + " [s]"},
                            {"whole", "1", "recorded with 1: whole joints, 0: blocks apart"}});
  if (!options.read(argc, argv)) return false;
  settings = {options.count("iterations", 1), real(options.number("beta", 0)),
              options.flag("whole"), options.number("seconds", 0.1),
              options.text("out")};
  return true;
}

Experiment experiment_of(Scene& scene, int steps) {
  return {.step = [&scene] { scene.step(); },
          .bodies = [&scene] { return all_of(scene.world.bodies); },
          .gaps =
              [&scene, now = std::vector<Pose>()](GapMeter& meter) mutable {
                if (scene.gaps) return scene.gaps(meter);
                poses(all_of(scene.world.bodies), now);
                meter.look(scene.marks, now);
              },
          .steps = steps,
          .gravity = scene.world.gravity,
          .energy_scale = scene.energy_scale};
}

void draw(Motion& motion, const std::vector<Mark>& marks, int first) {
  for (const Mark& mark : marks) {
    const glm::dvec3 &a = mark.anchor1_local, &b = mark.anchor2_local;
    const int body1 = first + mark.body1, body2 = first + mark.body2;
    motion.line({body1, body1, {0, 0, 0}, {a.x, a.y, a.z}});
    motion.line({body2, body2, {0, 0, 0}, {b.x, b.y, b.z}});
  }
}

Summary play(Scene& scene, const std::string& setting, double seconds,
             const std::string& motion_path, const std::function<void(double)>& look,
             const std::function<void()>& step) {
  Motion motion(scene.name, double(scene.h));
  for (const Shape& shape : scene.shapes) motion.body(shape);
  draw(motion, scene.marks);
  for (const Segment& segment : scene.segments) motion.line(segment);
  Experiment experiment = experiment_of(scene, steps_in(seconds, scene.h));
  if (step) experiment.step = step;
  const Measures measures = run(experiment, [&](int n) {
    if (!motion_path.empty())
      motion.frame(scene.world.bodies.data(), {reading_of(experiment)});
    look(n * double(scene.h));
  });
  if (!motion_path.empty()) motion.write(motion_path);
  return {measures, scene.name, setting};
}

}  // namespace joints
