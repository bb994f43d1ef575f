// What the runs of chapter 9 have in common: a method, a step of it, a recording. Read it; there is
// nothing to edit here.
#pragma once

#include "direct/direct_solver.h"
#include "engine/instruments/scene.h"

/// Chapter 9's program.
namespace joints::chapter9 {

/// The options of the command line.
struct Choice {
  int iterations = 30;  ///< of the runs that are compared
  double seconds = 5;   ///< duration of the scenes
  std::string out;      ///< folder of tables and recordings
};

/// Sequential Impulses with a number of iterations per step, or the direct solver.
struct Method {
  int iterations = 0;  ///< 0: direct
  /// Its name in tables and figures.
  std::string name() const {
    return iterations == 0 ? "direct" : std::to_string(iterations) + " iterations";
  }
};

/// A step of a scene with a solver, of second order.
inline std::function<void()> leaps(Scene& scene, Solver& solver) {
  return [&scene, &solver] { step(scene.world, solver, scene.h, {.leapfrog = true}); };
}
/// A step of a scene with a method. \param direct the solver for the direct method
inline std::function<void()> steps_of(Scene& scene, const Method& method, DirectSolver& direct) {
  if (method.iterations == 0) return leaps(scene, direct);
  scene.solver.iterations = method.iterations;
  return [&scene] { scene.step(); };
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
