// A fixed budget: 32 iterations for every 1/60 s, in one step or in many.
#include "bench/chapters/06_baumgarte/cube_chain.h"
#include "bench/chapters/06_baumgarte/experiments.h"
#include "engine/steps/two_pass_impulses.h"

namespace joints::chapter6 {

namespace {

constexpr int total = 32;  // iterations in 1/60 s, both kinds together

// The purpose of the second half of the iterations, for methods with two kinds.
enum class Second { none, projection, split, relax };

struct Method {
  std::string name;
  Second second;
  real beta;
  real frequency = 0;  // [Hz]
};

// Cubes of 100 kg released level, the last one heavier by a factor; measured as in side by side.
void measure(const std::string& path, int links, real end, double seconds) {
  CsvFile table(path, {"method", "substeps", "iterations", "gap_rms_m", "gap_max_m",
                       "energy_drift"});
  const Method methods[] = {{"beta 0.2", Second::none, real(0.2)},
                            {"beta 1", Second::none, 1},
                            {"projection", Second::projection, 0},
                            {"split impulse", Second::split, 1},
                            {"relax", Second::relax, 1},
                            {"soft + relax", Second::relax, 0, 60}};
  for (const Method& method : methods)
    for (const bool warm : {false, true})
      for (int substeps = 1; substeps <= total; substeps *= 2) {
        const int all = total / substeps;
        const int second = method.second == Second::none ? 0 : all / 2;
        if (method.second != Second::none && second == 0) continue;  // one iteration, two kinds
        CubeChain chain("budget", links, 100, vec3(1, 0, 0), method.beta);
        Body& last = chain.scene.world.bodies[chain.ids.back()];
        last.inverse_mass /= end;
        last.inverse_inertia_local /= end;
        chain.scene.energy_scale += double(100 * (end - 1)) * 9.81 * links;
        chain.scene.h = h / real(substeps);
        StepOptions& stepping = chain.scene.stepping;
        TwoPassImpulses solver;
        stepping.warm_start = warm;
        stepping.frequency = method.frequency;
        stepping.damping = 2;  // the numbers of Box2D 3
        solver.iterations = all - second;
        if (method.second == Second::projection) stepping.projections = second;
        if (method.second == Second::split) solver.split_iterations = second;
        if (method.second == Second::relax) solver.relax_iterations = second;
        Experiment experiment = experiment_of(chain.scene, steps_in(seconds, chain.scene.h));
        experiment.step = [&] { step(chain.scene.world, solver, chain.scene.h, stepping); };
        experiment.settling = last_two_thirds(experiment.steps);
        const Measures line = run(experiment);
        table.row({method.name + (warm ? " warm" : "")},
                  {double(substeps), double(total), line.gap_rms, line.gap_max,
                   line.energy_drift});
      }
}

}  // namespace

void budget(const Choice& choice) {
  measure(choice.out + "/budget.csv", 20, 1, choice.seconds / 2);
  measure(choice.out + "/budget_heavy.csv", 10, 100, choice.seconds / 2);
}

}  // namespace joints::chapter6
