// The ragdoll falls, with 10 and with 30 iterations.
#include <cstdio>

#include "bench/chapters/08_ground/experiments.h"
#include "bench/chapters/08_ground/ragdoll.h"

namespace joints::chapter8 {

void ragdoll(const Choice& choice, std::vector<Summary>& lines) {
  CsvFile table(choice.out + "/ragdoll.csv",
                {"time_s", "fastest_m_s", "fastest_rad_s", "gap_m", "penetration_m"});
  for (const int iterations : iterations_to_compare(choice)) {
    const bool chosen = iterations == choice.iterations;
    Choice here = choice;
    here.iterations = iterations;
    Ragdoll doll(here);
    if (chosen) doll.scene.print_plan();
    double deepest = 0, moved = 0;  // the last time at which it moved [s]
    Summary line = play(doll.scene, "", choice.seconds,
                        chosen ? choice.out + "/ragdoll.motion.json" : "", [&](double time) {
                          const double now = penetration(doll.scene.world);
                          deepest = std::max(deepest, now);
                          if (!doll.rests()) moved = time;
                          if (chosen)
                            table.row({time, doll.fastest(), doll.fastest_turn(),
                                       widest(doll.scene), now});
                        });
    machine_row(choice, "ragdoll", iterations, line, deepest);
    if (!chosen) continue;
    char setting[60];
    std::snprintf(setting, sizeof setting, "at rest after %.1f s", moved);
    line.setting = doll.rests() ? setting : "not at rest";
    lines.push_back(line);
  }
}

}  // namespace joints::chapter8
