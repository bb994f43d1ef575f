// Many joints: rods that contradict each other, the methods side by side.
#include <algorithm>
#include <cmath>

#include "bench/chapters/06_baumgarte/cube_chain.h"
#include "bench/chapters/06_baumgarte/experiments.h"
#include "joints/distance_joint.h"

namespace joints::chapter6 {

namespace {

// ---- rods that contradict each other -----------------------------------------------------------

// The bridge of chapter 1 with rods of 2.3 m in place of its ropes: ten cubes 2 m apart, the outer
// ones static, nine rods that are all too long for the straight line.
void rods(const Choice& choice) {
  CsvFile table(choice.out + "/rods.csv",
                {"method", "iterations", "peak_speed_m_s", "gap_max_m"});
  const struct {
    std::string name;
    real beta;
    int projections;
  } methods[] = {{"beta 0.05", real(0.05), 0}, {"beta 0.2", real(0.2), 0}, {"beta 1", 1, 0},
                 {"projection", 0, 1}, {"beta 0.2 + projection", real(0.2), 1}};
  for (const auto& method : methods)
    for (const int iterations : {3, 10, 30, 100, 300}) {
      Scene scene{.name = "bridge of rods"};
      scene.solver.iterations = iterations;
      scene.stepping.projections = method.projections;
      BodyId before;
      for (int i = 0; i < 10; ++i) {
        const BodyId id = scene.box(i == 0 || i == 9 ? 0 : 100, vec3(1),
                                    vec3(real(2 * i - 9), 0, 0));
        if (i > 0) {
          scene.world.add<CentreDistanceJoint>(before, id, CentreDistance{real(2.3)}).beta =
              method.beta;
          scene.segments.push_back({i - 1, i, {}, {}});
        }
        before = id;
      }
      double peak = 0, gap = 0;
      const bool seen = method.beta == real(0.2) && iterations == 100;
      const std::string motion = seen ? choice.out + "/bridge_of_rods.motion.json" : "";
      play(scene, "", choice.seconds / 2, motion, [&](double time) {
        for (int slot = 0; slot < scene.world.bodies.slots(); ++slot)
          peak = std::max(peak, double(length(scene.world.bodies.at(slot).v)));
        if (time < 0.4 * choice.seconds) return;
        for (const auto& joint : scene.world.joints())
          gap = std::max(gap, std::abs(double(CentreDistance{real(2.3)}.error(
                                  scene.world.bodies[joint->body1],
                                  scene.world.bodies[joint->body2]))));
      });
      table.row({method.name}, {double(iterations), peak, gap});
    }
}

// ---- side by side ------------------------------------------------------------------------------

// Twenty cubes of 100 kg released level: gaps, energy and cost of each method. The gaps count in
// the last two thirds of the run, as in chapter 7. With substeps a step is divided into parts with
// a few iterations each; the table counts the iterations of all parts.
void side_by_side(const Choice& choice, std::vector<Summary>& lines) {
  CsvFile table(choice.out + "/side_by_side.csv", {"method", "iterations", "gap_rms_m", "gap_max_m",
                                                   "energy_drift", "us_per_step"});
  const struct {
    std::string name;
    real beta;
    int projections, substeps;
    std::vector<int> counts;  // iterations per step
  } methods[] = {{"beta 0.2", real(0.2), 0, 1, {5, 10, 30, 100}},
                 {"beta 1", 1, 0, 1, {5, 10, 30, 100}},
                 {"projection", 0, 1, 1, {5, 10, 30, 100}},
                 {"beta 0.2 + projection", real(0.2), 1, 1, {5, 10, 30, 100}},
                 {"beta 1 + projection", 1, 1, 1, {5, 10, 30, 100}},
                 {"beta 0.2 + 16 substeps", real(0.2), 0, 16, {16, 32, 96}},
                 {"beta 1 + 16 substeps", 1, 0, 16, {16, 32, 96}},
                 {"beta 1 + 4 substeps", 1, 0, 4, {8, 16, 32, 100}}};
  for (const auto& method : methods)
    for (const int iterations : method.counts) {
      CubeChain chain("side by side", 20, 100, vec3(1, 0, 0), method.beta);
      chain.scene.h = h / real(method.substeps);
      chain.scene.solver.iterations = iterations / method.substeps;
      chain.scene.stepping.projections = method.projections;
      if (&method == methods && iterations == 5) chain.scene.print_plan();
      const int steps = steps_in(choice.seconds / 2, chain.scene.h);
      Experiment experiment = experiment_of(chain.scene, steps);
      experiment.settling = last_two_thirds(experiment.steps);
      Summary line{run(experiment), chain.scene.name,
                   method.name + ", " + std::to_string(iterations)};
      line.us_per_step *= method.substeps;
      table.row({method.name}, {double(iterations), line.gap_rms, line.gap_max, line.energy_drift,
                                line.us_per_step});
      if (iterations == 30 || iterations == 32) lines.push_back(line);
    }
}

}  // namespace

void many_joints(const Choice& choice, std::vector<Summary>& lines) {
  rods(choice);
  side_by_side(choice, lines);
}

}  // namespace joints::chapter6
