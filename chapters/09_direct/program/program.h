// What the parts of chapter 9's program share. Read it; there is nothing to edit here.
#pragma once

#include "chapters/09_direct/direct_solver.h"
#include "chapters/09_direct/program/linkages.h"
#include "engine/instruments/scene.h"

/// \addtogroup chapter9
/// @{

/// Chapter 9's program.
namespace joints::chapter9 {

/// What the command line says.
struct Choice {
  int iterations = 30;  ///< of the runs to compare with
  double seconds = 5;   ///< how long the scenes run
  std::string out;      ///< folder of tables and recordings
};

/// Sequential Impulses with so many iterations per step, or the direct solver.
struct Method {
  int iterations = 0;  ///< 0: direct
  /// As tables and figures call it.
  std::string name() const {
    return iterations == 0 ? "direct" : std::to_string(iterations) + " iterations";
  }
};

/// A step of a scene with a solver, of second order.
inline std::function<void()> leaps(Scene& scene, Solver& solver) {
  return [&scene, &solver] { step(scene.world, solver, scene.h, {.leapfrog = true}); };
}
/// A step of a scene with a method. \param direct solves if the method is the direct one
inline std::function<void()> steps_of(Scene& scene, const Method& method, DirectSolver& direct) {
  if (method.iterations == 0) return leaps(scene, direct);
  scene.solver.iterations = method.iterations;
  return [&scene] { scene.step(); };
}
/// The greatest gap of the scene's joints now [m].
inline double widest(const Scene& scene) {
  GapMeter meter;
  meter.look(scene.marks, poses(scene.world.bodies));
  return meter.maximum();
}
/// What the bodies have of energy now [J].
inline double energy_of(const Scene& scene) {
  return energy(all_of(scene.world.bodies), scene.world.gravity);
}

/// A scene of a recording of several, side by side.
struct Shown {
  Scene& scene;                ///< what is shown
  std::function<void()> step;  ///< does a step of it
  std::string name;            ///< written at its first body
};
/// Runs scenes side by side and records them. \param apart from one to the next [m]
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
/// What the answers to the chapter's questions count on: needed.csv, rings.csv, kept.csv.
/// (questions.cpp)
void questions(const Choice& choice);

}  // namespace joints::chapter9
/// @}
