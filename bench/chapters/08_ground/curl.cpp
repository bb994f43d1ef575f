// The chain that curls up on the ground.
#include "bench/chapters/08_ground/curl.h"
#include "bench/chapters/08_ground/experiments.h"

namespace joints::chapter8 {

namespace {

Summary bend(const Choice& choice, int iterations, double& deepest, CsvFile* table) {
  Curl curl(iterations, 8000, choice.beta / 10);  // curl.h says why
  if (table) curl.scene.print_plan();
  return play(curl.scene, std::to_string(iterations) + " iterations", choice.seconds,
              table ? choice.out + "/curl.motion.json" : "", [&](double time) {
                deepest = std::max(deepest, penetration(curl.scene.world));
                if (!table) return;
                const vec3 tip = curl.tip();
                table->row({time, double(tip.x), double(tip.y), double(curl.touching()),
                            widest(curl.scene)});
              });
}

}  // namespace

void curl(const Choice& choice, std::vector<Summary>& lines) {
  CsvFile table(choice.out + "/curl.csv", {"time_s", "tip_x_m", "tip_y_m", "touching", "gap_m"});
  double deepest = 0;
  lines.push_back(bend(choice, choice.iterations, deepest, &table));
  for (const int iterations : {10, 30}) {
    deepest = 0;
    const Summary line = bend(choice, iterations, deepest, nullptr);
    machine_row(choice, "curl", iterations, line, deepest);
  }
}

}  // namespace joints::chapter8
