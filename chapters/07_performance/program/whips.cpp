// Chapter 7's program, recorded: the same chain three times, solved in chain order, by colours, and
// over-relaxed. Read it; there is nothing to edit here.
#include <algorithm>

#include "chapters/07_performance/program/program.h"
#include "chapters/07_performance/program/scenes.h"

namespace joints::chapter7 {

void whips(const Choice& choice, std::vector<Summary>& lines) {
  // Twenty cubes each, released level with the last three hanging down; a tenth of the iterations,
  // so that the remaining errors are visible.
  const Chains one = bent_chains(1, 20, 3, choice.beta);
  const int iterations = std::max(1, choice.iterations / 10), steps = steps_in(choice.seconds, h);
  const std::string names[] = {"chain order", "colours", "omega 1.7"};
  std::vector<HingeLoop<real>> all{loop_over<real>(one, chain_order(one), iterations),
                                   loop_over<real>(one, colour_order(one, 1), iterations),
                                   loop_over<real>(one, chain_order(one), iterations)};
  all[2].relaxation = real(1.7);
  std::vector<Run> runs;
  for (HingeLoop<real>& loop : all) runs.emplace_back(experiment_of(loop, one, steps));
  print_plan("whips", one.bodies, one.links.size());

  Motion motion("whips, " + std::to_string(iterations) + " iterations per step", double(h));
  for (std::size_t k = 0; k < all.size(); ++k) {
    for (std::size_t i = 0; i < one.bodies.size(); ++i)
      motion.body({"box", {1, 1, 1}, i == 0 ? names[k] : ""});
    const int first = int(k * one.bodies.size());
    for (std::size_t j = 0; j < one.links.size(); ++j) {
      const Point& point = one.hinges[j].point;
      const int body1 = first + one.links[j].body1, body2 = first + one.links[j].body2;
      const glm::dvec3 a(point.anchor1_local), b(point.anchor2_local);
      motion.line({body1, body1, {0, 0, 0}, {a.x, a.y, a.z}});
      motion.line({body2, body2, {0, 0, 0}, {b.x, b.y, b.z}});
    }
  }
  std::vector<Body> frame;
  std::vector<Reading> readings;
  for (int n = 0; n <= steps; ++n) {
    frame.clear();
    readings.clear();
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (n > 0) runs[k].step();
      for (Body body : all[k].bodies) {
        body.x.x += 8 * spacing * real(k);  // side by side
        frame.push_back(body);
      }
      readings.push_back(reading_of(experiment_of(all[k], one, steps), names[k]));
    }
    motion.frame(frame.data(), readings);
  }
  motion.write(choice.out + "/whips.motion.json");
  for (std::size_t k = 0; k < all.size(); ++k)
    lines.push_back({runs[k].measures(), "whips", names[k]});
}

}  // namespace joints::chapter7
