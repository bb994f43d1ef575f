// Experiments that the text of chapter 9 and its answers quote, beyond the chapter's program. They
// run on the solution.
#pragma once

#include "bench/chapters/09_direct/linkages.h"
#include "chapters/09_direct/program/program.h"

namespace joints::chapter9 {

/// The options of the command line.
struct Choice {
  int iterations = 30;  ///< of the runs that are compared
  double seconds = 5;   ///< duration of the scenes
  std::string out;      ///< folder of tables and recordings
};

/// A step of a scene with the direct solver, of second order.
inline std::function<void()> leaps(Scene& scene, DirectSolver& solver) {
  return steps_of(scene, 0, solver);
}

/// The present energy of the bodies [J].
inline double energy_of(const Scene& scene) {
  return energy(all_of(scene.world.bodies), scene.world.gravity);
}

/// Fill and multiplications by the order of elimination: order.csv, pattern.csv, hub.csv.
void order(const Choice& choice);
/// Linkages with rows that depend on others: bricard.csv, four_bars.csv.
void dependent(const Choice& choice, std::vector<Summary>& lines);
/// The error over the step: convergence.csv.
void time_steps(const Choice& choice);
/// Newton's method on the positions: newton.csv.
void newton(const Choice& choice);
/// Motors and limits: motor.csv, limits.csv.
void bounds(const Choice& choice, std::vector<Summary>& lines);
/// A chain with a heavy end: heavy.csv.
void heavy(const Choice& choice, std::vector<Summary>& lines);
/// The tables of the answers to the chapter's questions: needed.csv, rings.csv, kept.csv.
void questions(const Choice& choice);

}  // namespace joints::chapter9
