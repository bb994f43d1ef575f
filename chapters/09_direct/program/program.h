// Declarations common to the parts of chapter 9's program. Read it; there is nothing to edit here.
#pragma once

#include "direct/direct_solver.h"
#include "chapters/09_direct/program/linkages.h"
#include "engine/instruments/scene.h"

/// \addtogroup chapter9
/// @{

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
/// The present energy of the bodies [J].
inline double energy_of(const Scene& scene) {
  return energy(all_of(scene.world.bodies), scene.world.gravity);
}

/// One of several scenes that are recorded side by side.
struct Shown {
  Scene& scene;                ///< the scene
  std::function<void()> step;  ///< makes one step of it
  std::string name;            ///< label of its first body
};
/// Runs scenes side by side and records them. \param apart distance between neighbours [m]
void record(const std::string& title, const std::vector<Shown>& shown, const vec3& apart,
            double seconds, const std::string& path);

/// A chain pulled sideways, a beam: sideways.csv, beam.csv. (together.cpp)
void together(const Choice& choice, std::vector<Summary>& lines);
/// Fill and multiplications by the order of elimination: order.csv, pattern.csv, hub.csv.
/// (order.cpp)
void order(const Choice& choice);
/// Linkages with rows that depend on others: bricard.csv, four_bars.csv. (dependent.cpp)
void dependent(const Choice& choice, std::vector<Summary>& lines);
/// The error over the step: convergence.csv. (time.cpp)
void time_steps(const Choice& choice);
/// Newton's method on the positions: newton.csv. (time.cpp)
void newton(const Choice& choice);
/// Motors and limits: motor.csv, limits.csv. (bounds.cpp)
void bounds(const Choice& choice, std::vector<Summary>& lines);
/// A chain with a heavy end: heavy.csv. (heavy.cpp)
void heavy(const Choice& choice, std::vector<Summary>& lines);
/// The tables of the answers to the chapter's questions: needed.csv, rings.csv, kept.csv.
/// (questions.cpp)
void questions(const Choice& choice);

}  // namespace joints::chapter9
/// @}
