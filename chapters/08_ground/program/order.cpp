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
  for (const auto& [name, turns] : orders)
    for (const int iterations : {5, 10, 30, 100}) {
      LandingChain chain(turns, 8, iterations, choice.beta);
      Scene& scene = chain.scene;
      const bool seen = turns == Turns::interleaved && iterations == 30;
      if (seen) scene.print_plan();
      Motion motion(scene.name, double(scene.h));
      for (const Shape& shape : scene.shapes) motion.body(shape);
      StepClock clock;
      GapMeter gaps;
      std::vector<Pose> now;
      double deepest = 0;
      const double start = energy(scene.world);
      for (int n = 0; n <= 360; ++n) {
        if (n > 0) {
          clock.start();
          chain.step(turns);
          clock.stop();
        }
        poses(scene.world.bodies, now);
        gaps.look(scene.marks, now);
        double widest = 0;
        for (const Mark& mark : scene.marks) widest = std::max(widest, gap(mark, now));
        const double deep = penetration(scene.world);
        deepest = std::max(deepest, deep);
        table.row({name}, {double(iterations), n * double(h), widest, deep});
        motion.frame(scene.world.bodies.data());
      }
      ends.row({name}, {double(iterations), gaps.rms(), gaps.maximum(), deepest});
      if (seen) motion.write(choice.out + "/order.motion.json");
      if (iterations == 30)
        lines.push_back({scene.name, name, clock.median_us(), gaps.rms(), gaps.maximum(),
                         (energy(scene.world) - start) / scene.energy_scale});
    }
}

}  // namespace joints::chapter8
