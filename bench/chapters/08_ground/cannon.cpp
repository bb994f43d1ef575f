// The cannon: it shoots, and the shot lands.
#include "bench/chapters/08_ground/cannon.h"
#include "bench/chapters/08_ground/experiments.h"

namespace joints::chapter8 {

namespace {

// One run from loading to rest. Only the run that is shown writes a table.
Summary shoot(const Choice& choice, int iterations, double& deepest, CsvFile* table) {
  Cannon cannon(iterations, choice.beta);
  if (table) cannon.scene.print_plan();
  cannon.scene.gaps = [&](GapMeter& meter) { meter.add(cannon.gap()); };
  return play(cannon.scene, std::to_string(iterations) + " iterations", choice.seconds,
              table ? choice.out + "/cannon.motion.json" : "", [&](double time) {
                const Body& shot = cannon.scene.world.bodies[cannon.shot];
                if (table)
                  table->row({time, double(shot.x.x), double(shot.x.y), double(length(shot.v)),
                              double(cannon.landing->touching())});
                deepest = std::max(deepest, penetration(cannon.scene.world));
                cannon.look();
              });
}

}  // namespace

void cannon(const Choice& choice, std::vector<Summary>& lines) {
  CsvFile table(choice.out + "/cannon.csv",
                {"time_s", "shot_x_m", "shot_y_m", "speed_m_s", "touching"});
  double deepest = 0;
  lines.push_back(shoot(choice, choice.iterations, deepest, &table));
  for (const int iterations : {10, 30}) {
    deepest = 0;
    const Summary line = shoot(choice, iterations, deepest, nullptr);
    machine_row(choice, "cannon", iterations, line, deepest);
  }
}

}  // namespace joints::chapter8
