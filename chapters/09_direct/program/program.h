// What the runs of chapter 9 share. Read it; there is nothing to edit here.
#pragma once

#include "direct/direct_solver.h"
#include "engine/instruments/scene.h"

/// Chapter 9's program.
namespace joints::chapter9 {

/// The name of a method in tables and figures. \param iterations per step; 0: the direct solver
inline std::string name_of(int iterations) {
  return iterations == 0 ? "direct" : std::to_string(iterations) + " iterations";
}
/// The direct solver, for positions too. \param kappa added inertia, Eq. 9-14
inline DirectSolver with_positions(real kappa = 0) {
  DirectSolver direct;
  direct.added_inertia = kappa;
  return direct;
}
/// A step of a scene: Sequential Impulses with `iterations`, or the direct solver with leapfrog.
inline std::function<void()> steps_of(Scene& scene, int iterations, DirectSolver& direct) {
  if (iterations > 0) scene.solver.iterations = iterations;
  if (iterations > 0) return [&scene] { scene.step(); };
  return [&scene, &direct] { step(scene.world, direct, scene.h, {.leapfrog = true}); };
}
/// The largest present gap of the scene's joints [m].
inline double widest(const Scene& scene) {
  GapMeter meter;
  meter.look(scene.marks, poses(scene.world.bodies));
  return meter.maximum();
}

/// One of several scenes that are recorded side by side.
struct Shown {
  Scene& scene;                ///< the scene
  std::function<void()> step;  ///< makes one step of it
  std::string name;            ///< label of its first body
};
/// Runs scenes side by side and records them. \param apart distance between neighbours [m]
inline void record(const std::string& title, const std::vector<Shown>& shown,
                   const vec3& apart, double seconds, const std::string& path) {
  Motion motion(title, double(shown[0].scene.h));
  int first = 0;
  for (const Shown& one : shown) {
    for (std::size_t k = 0; k < one.scene.shapes.size(); ++k) {
      Shape shape = one.scene.shapes[k];
      if (k == 0) shape.label = one.name;
      motion.body(shape);
    }
    draw(motion, one.scene.marks, first);
    first += one.scene.world.bodies.slots();
  }
  std::vector<Body> frame;
  std::vector<Reading> readings;
  for (int n = 0; n <= steps_in(seconds, shown[0].scene.h); ++n) {
    frame.clear();
    readings.clear();
    for (std::size_t k = 0; k < shown.size(); ++k) {
      if (n > 0) shown[k].step();
      for (Body body : all_of(shown[k].scene.world.bodies)) {
        body.x += real(k) * apart;
        frame.push_back(body);
      }
      readings.push_back(reading_of(experiment_of(shown[k].scene, 0), shown[k].name));
    }
    motion.frame(frame.data(), readings);
  }
  motion.write(path);
}

}  // namespace joints::chapter9
