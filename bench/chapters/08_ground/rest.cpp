// A box at rest.
#include "bench/chapters/08_ground/experiments.h"
#include "chapters/08_ground/program/one_box.h"

namespace joints::chapter8 {

// A box that rests for a minute: the displacement and the greatest speed of a corner.
void rest(const Choice& choice, std::vector<Summary>& lines) {
  CsvFile table(choice.out + "/rest.csv", {"start", "iterations", "farthest_m", "fastest_m_s",
                                           "centre_m"});
  for (const bool warm : {false, true})
    for (const int iterations : {1, 4, 10, 30}) {
      OneBox one("rest", choice, vec3(1, real(0.6), real(0.8)));
      one.scene.solver.iterations = iterations;
      one.scene.stepping.warm_start = warm;
      if (warm && iterations == 1) one.scene.print_plan();
      std::array<vec3, 8> start;
      for (int k = 0; k < 8; ++k) start[std::size_t(k)] = one.corner(k);
      const vec3 centre = one.body().x;
      double farthest = 0, fastest = 0;
      const std::string name = warm ? "warm" : "cold";
      const Summary line = play(
          one.scene, name + " " + std::to_string(iterations) + " iterations", 60, "", [&](double) {
            for (int k = 0; k < 8; ++k) {
              const vec3 p = one.corner(k);
              farthest = std::max(farthest, double(length(p - start[std::size_t(k)])));
              fastest = std::max(
                  fastest, double(length(point_velocity(one.body(), p - one.body().x))));
            }
          });
      table.row({name}, {double(iterations), farthest, fastest,
                         double(length(one.body().x - centre))});
      if (iterations == 30) lines.push_back(line);
    }
}

}  // namespace joints::chapter8
