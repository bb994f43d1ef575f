// Linkages in which a row depends on the others: Bricard's, and four-bars side by side.
#include <algorithm>
#include <cstdio>

#include "bench/chapters/09_direct/experiments.h"

namespace joints::chapter9 {

namespace {

// Divides by every pivot, even if it is only a rounding error.
double plain_inverse(double pivot, double) { return 1 / pivot; }

// How far the rods of Bricard's linkage are from their places after a second.
void errors_after_a_second(const Choice& choice) {
  CsvFile table(choice.out + "/bricard_after.csv", {"newton", "steps_per_s", "off_m"});
  const auto after = [](int newton, int rate) {
    Scene scene = bricard();
    DirectSolver direct = DirectSolver::velocities_only();
    direct.newton = newton;
    scene.h = real(1) / real(rate);
    const auto leap = leaps(scene, direct);
    for (int n = 0; n < rate; ++n) leap();
    const auto all = all_of(scene.world.bodies);
    return std::vector<Body>(all.begin(), all.end());
  };
  const std::vector<Body> exact = after(8, 3840);
  for (const int newton : {0, 8})
    for (const int rate : {60, 120, 240}) {
      const std::vector<Body> bodies = after(newton, rate);
      double most = 0;
      for (std::size_t k = 0; k < exact.size(); ++k)
        most = std::max(most, double(length(bodies[k].x - exact[k].x)));
      table.row({double(newton), double(rate), most});
    }
}

void bricards(const Choice& choice, std::vector<Summary>& lines) {
  CsvFile table(choice.out + "/bricard.csv", {"method", "time_s", "gap_m", "energy"});
  bricard().print_plan();
  const auto rows_of = [&](const std::string& name, Scene& scene) {
    const double start = energy_of(scene);
    return [&, name, start](double time) {
      table.row({name}, {time, widest(scene), (energy_of(scene) - start) / scene.energy_scale});
    };
  };
  errors_after_a_second(choice);
  const double seconds = 2 * choice.seconds;
  {
    Scene scene = bricard();
    DirectSolver direct = with_positions();
    lines.push_back(play(scene, "direct", seconds, choice.out + "/bricard.motion.json",
                         rows_of("softened", scene), leaps(scene, direct)));
    std::printf("Bricard: of %zu rows %d depends on the others\n", scene.world.blocks.C.size(),
                direct.dependent());
  }
  {
    Scene scene = bricard();
    DirectSolver plain = with_positions();
    plain.softening = 0;
    plain.inverse = plain_inverse;
    lines.push_back(play(scene, "neither", seconds, "", rows_of("neither", scene),
                         leaps(scene, plain)));
  }
  {
    Scene scene = bricard();
    DirectSolver unused = DirectSolver::velocities_only();
    const std::string few = name_of(choice.iterations);
    lines.push_back(play(scene, few, seconds, "", rows_of(few, scene),
                         steps_of(scene, choice.iterations, unused)));
  }
}

// Largest distance between the upper end of an upright and its place in a parallel motion [m]. The
// uprights have the odd slots.
double off_parallel(const Scene& scene) {
  const auto along = [&](int slot) { return scene.world.bodies.at(slot).q * vec3(1, 0, 0); };
  double most = 0;
  for (int slot = 3; slot < scene.world.bodies.slots(); slot += 2)
    most = std::max(most, double(length(along(slot) - along(1))));
  return most;
}

void bars(const Choice& choice, std::vector<Summary>& lines) {
  CsvFile table(choice.out + "/four_bars.csv",
                {"method", "time_s", "height_m", "off_parallel_m", "gap_m", "energy"});
  four_bars(6).print_plan();
  for (const int iterations : {0, choice.iterations}) {
    const std::string name = name_of(iterations);
    Scene scene = four_bars(6);
    DirectSolver direct = with_positions();
    const double start = energy_of(scene);
    double least = 0, most = 0, off = 0;
    lines.push_back(play(
        scene, name, 2 * choice.seconds,
        iterations == 0 ? choice.out + "/four_bars.motion.json" : "",
        [&](double time) {
          const double change = (energy_of(scene) - start) / scene.energy_scale;
          least = std::min(least, change), most = std::max(most, change);
          off = std::max(off, off_parallel(scene));
          table.row({name}, {time, 2 * double(scene.world.bodies.at(1).x.y), off_parallel(scene),
                             widest(scene), change});
        },
        steps_of(scene, iterations, direct)));
    std::printf("four-bars, %s: energy between %+.2g %% and %+.2g %%, off parallel by %.2g m",
                name.c_str(), 100 * least, 100 * most, off);
    if (iterations == 0)
      std::printf("; of %zu rows %d depend on the others", scene.world.blocks.C.size(),
                  direct.dependent());
    std::printf("\n");
  }
}

}  // namespace

void dependent(const Choice& choice, std::vector<Summary>& lines) {
  bricards(choice, lines);
  bars(choice, lines);
}

}  // namespace joints::chapter9
