// Error against run time: every scene with every setting, a line each. `./wb bench` calls it.
// A scene, a solver or a setting more is one line more, below.
#include <cstdio>

#include "bench/runner.h"
#include "engine/program.h"
#include "engine/wide.h"
#include "engine/sequential_impulses.h"

using namespace joints;
using namespace joints::bench;

namespace {

// ---- solvers and settings -----------------------------------------------------------------------

// A solver with everything but its sweeps.
using Solver = std::function<Setting(int iterations)>;

Setting sequential_impulses(int iterations, bool warm) {
  return {"sequential impulses", "whole blocks", iterations, warm, [=] {
            SequentialImpulses solver;
            solver.iterations = iterations;
            solver.warm_start = warm;
            return [solver](World& world, real h) mutable { solver.step(world, h); };
          }, {}};
}
Setting cold(int iterations) { return sequential_impulses(iterations, false); }
Setting warm(int iterations) { return sequential_impulses(iterations, true); }

Setting on_lanes(int iterations, Packing packing, real beta) {
  Setting setting{"on lanes", packing == Packing::trees ? "a tree a lane" : "coloured", iterations,
                  false, [=] {
                    WideImpulses solver;
                    solver.iterations = iterations;
                    solver.packing = packing;
                    return [solver](World& world, real h) mutable { solver.step(world, h); };
                  }, {}};
  if (beta == real(0.2)) return setting;
  setting.name += " with beta 1";
  setting.prepare = [=](World& world) {
    for (const auto& joint : world.joints()) joint->beta = beta;
  };
  return setting;
}
Setting trees(int iterations) { return on_lanes(iterations, Packing::trees, real(0.2)); }
Setting coloured(int iterations) { return on_lanes(iterations, Packing::colours, real(0.2)); }
Setting trees_beta_1(int iterations) { return on_lanes(iterations, Packing::trees, 1); }

// ---- scenes -------------------------------------------------------------------------------------

// A scene and the solvers that run it.
struct Entry {
  MakeScene make;
  std::vector<Solver> solvers;
};

std::vector<Entry> scenes(bool quick) {
  std::vector<Entry> list;
  list.push_back({[] { return cubes_on_balls(10, 100); }, {cold, warm}});
  list.push_back({[] { return cubes_on_hinges(10, 100); }, {cold, trees, coloured, trees_beta_1}});
  for (double ratio : {1, 10, 100, 1000, 10000})
    if (!quick || ratio == 1 || ratio == 100)
      list.push_back({[=] { return heavy_end(ratio); }, {cold, warm}});
  return list;
}

// ---- the table ----------------------------------------------------------------------------------

const char* const columns =
    "scene,chains,solver,setting,real,iterations,substeps,warm,us_per_step,ns_per_joint_iteration,"
    "gap_rms_m,gap_max_m,axis_error_rad,energy_drift,tip_error_m,status\n";

void write(FILE* file, const Scene& scene, const Setting& setting, const Result& r, double ns) {
  std::fprintf(file, "%s,%d,%s,%s,%s,%d,1,%d,%.4f,%.3f,%.8g,%.8g,%.8g,%.8g,%.8g,%s\n",
               scene.name.c_str(), scene.chains, setting.solver.c_str(), setting.name.c_str(),
               sizeof(real) == 8 ? "double" : "float", setting.iterations, int(setting.warm),
               r.us_per_step, ns, r.gap_rms, r.gap_max, r.axis_error, r.energy_drift, r.tip_error,
               r.status.c_str());
}

// One scene with one kind of setting, over the iteration counts. What one more iteration costs a
// joint is the slope of the time between a count and its neighbour.
void series(FILE* file, const MakeScene& make, const Solver& solver,
            const std::vector<int>& counts, int repetitions) {
  const Scene scene = make();
  std::vector<Result> results;
  for (int count : counts) {
    const Setting setting = solver(count);
    std::fprintf(stderr, "%s, %s, %s %d\n", scene.name.c_str(), setting.name.c_str(),
                 setting.warm ? "warm" : "cold", count);
    results.push_back(run(make, setting, repetitions));
  }
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const std::size_t a = k == 0 ? 0 : k - 1, b = a + 1;
    const double ns = 1000 * (results[b].us_per_step - results[a].us_per_step) /
                      (double(scene.marks.size()) * (counts[b] - counts[a]));
    write(file, scene, solver(counts[k]), results[k], ns);
  }
}

// Nothing but steps, for counting instructions: the difference of two calls is what is sought.
void only_steps(int iterations, int steps) {
  Scene scene = cubes_on_balls(1, 100);
  const Step step = cold(iterations).make();
  for (int n = 0; n < steps; ++n) step(scene.world, real(1) / 60);
}

}  // namespace

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("Error against run time",
                    {{"csv", "out/work_precision.csv", "the table"},
                     {"append", "0", "1: add lines to the table that is there"},
                     {"quick", "0", "1: fewer scenes, one repetition"},
                     {"repetitions", "5", "how often each run is timed"},
                     {"only-steps", "0", "do so many steps of one chain and measure nothing"},
                     {"iterations", "30", "with --only-steps: sweeps a step"}});
    if (!options.read(argc, argv)) return;
    if (const int steps = options.count("only-steps", 0); steps > 0)
      return only_steps(options.count("iterations", 1), steps);
    const bool append = options.count("append", 0) != 0, quick = options.count("quick", 0) != 0;
    const int repetitions = quick ? 1 : options.count("repetitions", 1);
    const std::vector<int> counts = quick ? std::vector<int>{10, 30, 100, 200}
                                          : std::vector<int>{10, 20, 30, 60, 120, 200};
    const std::string path = options.text("csv");
    FILE* file = std::fopen(path.c_str(), append ? "a" : "w");
    if (!file) refuse("--csv " + path + ": cannot be written");
    if (!append) std::fputs(columns, file);
    for (const Entry& entry : scenes(quick))
      for (const Solver& solver : entry.solvers)
        series(file, entry.make, solver, counts, repetitions);
    std::fclose(file);
  });
}
