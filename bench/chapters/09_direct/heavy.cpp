// A chain of light cubes with a heavy end: which ends added inertia holds, and its errors.
#include <cmath>
#include <cstdio>

#include "bench/chapters/09_direct/experiments.h"

namespace joints::chapter9 {

namespace {

constexpr int links = 10;

struct End {
  Summary line;
  vec3 tip{0};        // position after a second
  double energy = 0;  // change of the energy after two seconds
  int kept = 0;       // steps that kept the velocities without a correction
};

// \param inertia factor of Eq. 9-14 \param parts number of steps per 1/60 s
// \param look called with the time [s] and the change of the energy
End swing(real ratio, real inertia, int parts, double seconds,
          const std::function<void(double, double)>& look = [](double, double) {}) {
  char setting[40];
  std::snprintf(setting, sizeof setting, "%g kg, kappa %g", double(ratio), double(inertia));
  Scene scene = heavy_chain(links, ratio);
  scene.h /= real(parts);
  DirectSolver direct = with_positions();
  direct.added_inertia = inertia;
  End end;
  const double start = energy_of(scene);
  end.line = play(
      scene, setting, seconds, "",
      [&](double time) {
        const double change = (energy_of(scene) - start) / scene.energy_scale;
        if (time < 1 + double(scene.h) / 2) end.tip = all_of(scene.world.bodies).back().x;
        if (time < 2 + double(scene.h) / 2) end.energy = change;
        end.kept += time > 0 && !direct.report().moved_exactly;
        look(time, change);
      },
      leaps(scene, direct));
  return end;
}

}  // namespace

void heavy(const Choice& choice, std::vector<Summary>& lines) {
  CsvFile table(choice.out + "/heavy.csv", {"factor", "ratio", "gap_m", "energy_change_2s",
                                            "tip_error_1s_m", "steps_without_correction"});
  CsvFile path(choice.out + "/heavy_energy.csv", {"factor", "h_s", "time_s", "energy_change"});
  heavy_chain(links, 1).print_plan();
  const double ratios[] = {1, 10, 100, 1e3, 1e4, 1e5, 1e6};
  std::vector<vec3> truth;  // position of the end after a second
  for (const double ratio : ratios)  // 2 / omega falls as ratio^-1/2, and the step with it
    truth.push_back(swing(real(ratio), 0, std::max(64, int(2.1 * std::sqrt(ratio))),
                          std::min(1.0, 2 * choice.seconds)).tip);
  for (const real factor : {real(0), real(1), real(2), real(4), real(8)}) {
    double holds = 0;
    for (std::size_t k = 0; k < truth.size(); ++k) {
      const End end = swing(real(ratios[k]), factor, 1, 2 * choice.seconds);
      const double off = double(length(end.tip - truth[k]));
      table.row({double(factor), ratios[k], end.line.gap_max, end.energy, off, double(end.kept)});
      if (end.line.gap_max < 0.25) holds = ratios[k];  // half a link; beyond it is torn
      if (ratios[k] != 100) continue;
      std::printf("kappa %g: with 100 kg off by %5.2f m after 1 s, energy %+4.0f %% in 2 s;",
                  double(factor), off, 100 * end.energy);
      if (factor > 0) lines.push_back(end.line);
    }
    std::printf(" not torn up to %g kg\n", holds);
  }
  for (const auto& [factor, parts] : {std::pair{1, 1}, {2, 1}, {4, 1}, {8, 1}, {8, 4}})
    swing(100, real(factor), parts, std::min(2.0, 2 * choice.seconds),
          [&, factor = factor, parts = parts](double time, double change) {
            path.row({double(factor), 1.0 / (60 * parts), time, change});
          });
  Scene left = heavy_chain(links, 100), right = heavy_chain(links, 100);
  DirectSolver plain = with_positions(), more = with_positions(8);
  record("a heavy end", {{left, leaps(left, plain), "plain"},
                         {right, leaps(right, more), "more inertia"}},
         vec3(0, 0, 3), 2, choice.out + "/heavy.motion.json");
}

}  // namespace joints::chapter9
