// Chapter 9's program, a chain of light cubes with a heavy end: what more inertia holds, and what it
// costs. Read it; there is nothing to edit here.
#include <cmath>
#include <cstdio>

#include "chapters/09_direct/program/program.h"

namespace joints::chapter9 {

namespace {

constexpr int links = 10;
constexpr real factor_of_inertia = 16;
constexpr double seconds = 2;

struct End {
  Summary line;
  vec3 tip{0};  // after a second
};

// \param parts into how many steps each step of 1/60 s is cut
// \param look called with the time [s] and what the energy has changed by
End swing(real ratio, real stiffness, int parts, const std::string& setting,
          const std::function<void(double, double)>& look = [](double, double) {}) {
  Scene scene = heavy_chain(links, ratio);
  scene.h /= real(parts);
  DirectSolver direct;
  direct.newton = 8;
  direct.stiffness = stiffness;
  End end;
  const double start = energy_of(scene);
  end.line = play(
      scene, setting, seconds, "",
      [&](double time) {
        if (time < 1 + double(scene.h) / 2) end.tip = all_of(scene.world.bodies).back().x;
        look(time, (energy_of(scene) - start) / scene.energy_scale);
      },
      leaps(scene, direct));
  return end;
}

}  // namespace

void heavy(const Choice& choice, std::vector<Summary>& lines) {
  CsvFile table(choice.out + "/heavy.csv",
                {"inertia", "ratio", "gap_m", "energy_change", "tip_error_m"});
  heavy_chain(links, 1).print_plan();
  std::printf("heavy end: how far off after 1 s; the largest gap and the energy after 2 s\n");
  for (const double ratio : {1., 10., 100., 1e3, 1e4, 1e5, 1e6}) {
    // The stiffer, the smaller steps must be without more inertia: 2 / omega falls as ratio^-1/2.
    const int parts = std::max(64, int(6.4 * std::sqrt(ratio)));
    const vec3 truth = swing(real(ratio), 0, parts, "").tip;
    for (const real stiffness : {real(0), factor_of_inertia}) {
      char setting[40];
      std::snprintf(setting, sizeof setting, "%g kg, %s", ratio,
                    stiffness > 0 ? "more inertia" : "plain");
      const End end = swing(real(ratio), stiffness, 1, setting);
      const double off = double(length(end.tip - truth));
      table.row({stiffness > 0 ? "more" : "plain"},
                {ratio, end.line.gap_max, end.line.energy_drift, off});
      std::printf("%8g kg, %-12s  off by %8.3g m, gap %8.2g m, energy %+.3g\n", ratio,
                  stiffness > 0 ? "more inertia" : "plain", off, end.line.gap_max,
                  end.line.energy_drift);
      lines.push_back(end.line);
    }
  }
  CsvFile path(choice.out + "/heavy_energy.csv", {"h_s", "time_s", "energy_change"});
  for (const int parts : {1, 4, 16})
    swing(100, factor_of_inertia, parts, "", [&](double time, double change) {
      path.row({1.0 / (60 * parts), time, change});
    });
  Scene left = heavy_chain(links, 100), right = heavy_chain(links, 100);
  DirectSolver plain, more;
  plain.newton = more.newton = 8;
  more.stiffness = factor_of_inertia;
  record("a heavy end", {{left, leaps(left, plain), "plain"},
                         {right, leaps(right, more), "more inertia"}},
         vec3(0, 0, 3), seconds, choice.out + "/heavy.motion.json");
}

}  // namespace joints::chapter9
