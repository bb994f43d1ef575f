// Chapter 8's program: joints and contacts in one loop, or in one loop after the other. Read it;
// there is nothing to edit here.
#include "chapters/08_ground/program/order.h"

namespace joints::chapter8 {

void order(const Choice& choice, std::vector<Summary>& lines) {
  CsvFile table(choice.out + "/order.csv",
                {"order", "iterations", "time_s", "gap_m", "penetration_m"});
  CsvFile ends(choice.out + "/order_summary.csv",
               {"order", "iterations", "gap_rms_m", "gap_max_m", "penetration_max_m"});
  const struct {
    std::string name;
    Turns turns;
  } orders[] = {{"interleaved", Turns::interleaved}, {"joints first", Turns::joints_first},
                {"contacts first", Turns::contacts_first}, {"no ground", Turns::no_ground}};
  for (const auto& order : orders)
    for (const int iterations : {5, 10, 30, 100}) {
      const std::string& name = order.name;
      const Turns turns = order.turns;
      LandingChain chain(turns, 8, iterations, choice.beta);
      Scene& scene = chain.scene;
      const bool seen = turns == Turns::interleaved && iterations == 30;
      if (seen) scene.print_plan();
      double deepest = 0;
      const Summary line = play(
          scene, name, 6, seen ? choice.out + "/order.motion.json" : "",
          [&](double time) {
            const double deep = penetration(scene.world);
            deepest = std::max(deepest, deep);
            table.row({name}, {double(iterations), time, widest(scene), deep});
          },
          [&] { chain.step(turns); });
      ends.row({name}, {double(iterations), line.gap_rms, line.gap_max, deepest});
      if (iterations == 30) lines.push_back(line);
    }
}

}  // namespace joints::chapter8
