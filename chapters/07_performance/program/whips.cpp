// Chapter 7's program, recorded: the same chain three times, solved in chain order, by colours, and
// over-relaxed. Read it; there is nothing to edit here.
#include <algorithm>

#include "chapters/07_performance/program/program.h"
#include "chapters/07_performance/program/scenes.h"

namespace joints::chapter7 {

void whips(const Choice& choice, std::vector<Summary>& lines) {
  // Twenty cubes each, let go level with the last three hanging over; a tenth of the iterations,
  // so that one sees what they leave.
  const Chains one = bent_chains(1, 20, 3, choice.beta);
  const int iterations = std::max(1, choice.iterations / 10), steps = steps_in(choice.seconds);
  struct Whip {
    std::string name;
    HingeLoop<real> loop;
    Watch watch;
    StepClock clock{};
  };
  std::vector<Whip> all{
      {"chain order", loop_over<real>(one, chain_order(one), iterations), Watch(one, steps)},
      {"colours", loop_over<real>(one, colour_order(one, 1), iterations), Watch(one, steps)},
      {"omega 1.7", loop_over<real>(one, chain_order(one), iterations), Watch(one, steps)}};
  all[2].loop.relaxation = real(1.7);
  print_plan("whips", one.bodies, one.links.size());

  Motion motion("whips, " + std::to_string(iterations) + " iterations a step", double(h));
  for (std::size_t k = 0; k < all.size(); ++k) {
    for (std::size_t i = 0; i < one.bodies.size(); ++i)
      motion.body({"box", {1, 1, 1}, i == 0 ? all[k].name : ""});
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
  for (int n = 0; n <= steps; ++n) {
    frame.clear();
    for (std::size_t k = 0; k < all.size(); ++k) {
      Whip& whip = all[k];
      if (n > 0) {
        whip.clock.start();
        whip.loop.step(h);
        whip.clock.stop();
        whip.watch.look(n, whip.loop.bodies);
      }
      for (Body body : whip.loop.bodies) {
        body.x.x += 8 * spacing * real(k);  // side by side
        frame.push_back(body);
      }
    }
    motion.frame(frame.data());
  }
  motion.write(choice.out + "/whips.motion.json");
  for (const Whip& whip : all)
    lines.push_back({"whips", whip.name, whip.clock.median_us(), whip.watch.gap_rms(),
                     whip.watch.gap_max(), whip.watch.energy_change()});
}

}  // namespace joints::chapter7
