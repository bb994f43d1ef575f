// Chapter 1's program: pendulum, suspension bridge and lamp, moved by the step of exercise 1.4.
// It uses the engine's bodies, but not its solver. Read it; there is nothing to edit here.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "chapters/01_distance/program/scenes.h"
#include "engine/instruments/plan.h"
#include "engine/instruments/options.h"
#include "engine/instruments/run.h"

using namespace joints;
using namespace joints::chapter1;

namespace {

// Runs a scene: one line of the table per step, and a motion if its path is given.
Summary run(LinkScene scene, const StepSettings& settings, double seconds, CsvFile& table,
            const std::string& motion_path) {
  Motion motion(scene.name, settings.h);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) motion.body(scene.shape);
  for (const Link& link : scene.links) motion.line({link.body1, link.body2, {}, {}});
  const auto gaps = [&](GapMeter& meter) {
    for (const Link& link : scene.links)
      meter.add(gap(link, scene.bodies[link.body1], scene.bodies[link.body2]));
  };
  const Experiment experiment{.step = [&] { step(scene.bodies, scene.links, settings); },
                              .bodies = [&] { return std::span<const Body>(scene.bodies); },
                              .gaps = gaps,
                              .steps = steps_in(seconds, settings.h),
                              .gravity = settings.gravity,
                              .energy_scale = scene.energy_scale};
  const double start = energy(scene.bodies, settings.gravity);
  const Measures measures = joints::run(experiment, [&](int n) {
    GapMeter now;
    gaps(now);
    table.row({double(settings.iterations), n * double(settings.h), now.rms(), now.maximum(),
               energy(scene.bodies, settings.gravity) - start});
    motion.frame(scene.bodies.data(), {reading_of(experiment)});
  });
  if (!motion_path.empty()) motion.write(motion_path);
  return {measures, scene.name, std::to_string(settings.iterations) + " iterations"};
}

// How far the lamp rises after its ropes have stopped it [m]: 0 if they release what is too much.
double rise_of(LinkScene scene, const StepSettings& settings) {
  double lowest = double(scene.bodies[0].x.y), rise = 0;
  for (long n = 0; n < steps_in(2, settings.h); ++n) {
    step(scene.bodies, scene.links, settings);
    lowest = std::min(lowest, double(scene.bodies[0].x.y));
    rise = std::max(rise, double(scene.bodies[0].x.y) - lowest);
  }
  return rise;
}

void print_plan(const LinkScene& scene) {
  Plan plan;
  plan.bodies = int(scene.bodies.size());
  for (const Body& body : scene.bodies) plan.static_bodies += body.is_static();
  plan.blocks = plan.rows = int(scene.links.size());
  std::printf("%s: %s\n", scene.name.c_str(), plan.line().c_str());
}

}  // namespace

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("Chapter 1: a pendulum on a rod, a bridge and a lamp on ropes",
                    {{"iterations", "30", "iterations per step, of the recorded motion"},
                     {"beta", "0.2", "fraction of the error fed back per step [1]"},
                     {"seconds", "10", "how long to simulate [s]"}});
    if (!options.read(argc, argv)) return;
    StepSettings settings;
    settings.beta = real(options.number("beta", 0));
    const int chosen = options.count("iterations", 1);
    const double seconds = options.number("seconds", 0.1);
    const std::string out = options.text("out");

    print_plan(pendulum());
    print_plan(bridge());
    std::vector<Summary> lines;
    std::vector<int> counts{5, 10, 30, 100};
    if (std::find(counts.begin(), counts.end(), chosen) == counts.end()) counts.push_back(chosen);
    for (const auto& make : {pendulum, bridge}) {
      const LinkScene scene = make();
      CsvFile table(out + "/" + scene.name + ".csv",
                    {"iterations", "time_s", "gap_rms_m", "gap_max_m", "energy_change_j"});
      for (int iterations : counts) {
        settings.iterations = iterations;
        const std::string motion = out + "/" + scene.name + ".motion.json";
        lines.push_back(run(scene, settings, seconds, table, iterations == chosen ? motion : ""));
      }
    }
    report(lines, out);
    settings.iterations = chosen;
    const double rise = rise_of(lamp(), settings);
    CsvFile(out + "/lamp.csv", {"iterations", "rise_m"}).row({double(chosen), rise});
    std::printf("lamp: three ropes stop its fall of 1 m; then it rises %.1f mm\n", 1000 * rise);
  });
}
