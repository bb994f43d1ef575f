// The bridge: its sag and its load.
#include "bench/chapters/08_ground/bridge.h"
#include "bench/chapters/08_ground/experiments.h"

namespace joints::chapter8 {

namespace {

Summary hang(const Choice& choice, int iterations, bool loaded, double& deepest, CsvFile* table) {
  Bridge bridge(iterations, loaded, 20, choice.beta / 10);  // bridge.h says why
  if (table) bridge.scene.print_plan();
  const std::string words = std::to_string(iterations) + " iterations";
  return play(bridge.scene, loaded ? words : words + "; no load", choice.seconds,
              table ? choice.out + "/bridge.motion.json" : "", [&](double time) {
                deepest = std::max(deepest, penetration(bridge.scene.world));
                if (!table) return;
                const Bodies& bodies = bridge.scene.world.bodies;
                table->row({time, double(bodies[bridge.crate].x.y), bridge.sag(),
                            double(bridge.carried().y), widest(bridge.scene)});
              });
}

}  // namespace

void bridge(const Choice& choice, std::vector<Summary>& lines) {
  CsvFile table(choice.out + "/bridge.csv", {"time_s", "load_y_m", "sag_m", "force_n", "gap_m"});
  double deepest = 0;
  lines.push_back(hang(choice, choice.iterations, true, deepest, &table));
  lines.push_back(hang(choice, choice.iterations, false, deepest, nullptr));
  for (const int iterations : {10, 30}) {
    deepest = 0;
    const Summary line = hang(choice, iterations, true, deepest, nullptr);
    machine_row(choice, "bridge", iterations, line, deepest);
  }
}

}  // namespace joints::chapter8
