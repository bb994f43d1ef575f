// Chapter 7's program: your loop step by step on the performance scene, each step with the
// improvements of the earlier ones, and three chains that whip down. Read it; there is nothing to
// edit here.
#include <algorithm>

#include "chapters/07_performance/program/scenes.h"
#include "engine/instruments/options.h"

namespace joints::chapter7 {

namespace {

// ---- the steps of the loop ---------------------------------------------------------------------

using Places = std::vector<vec3>;

Places places_of(const std::vector<Body>& bodies) {
  Places places;
  for (const Body& body : bodies) places.push_back(body.x);
  return places;
}

double furthest(const std::vector<Body>& bodies, const Places& places) {
  double most = 0;
  for (std::size_t k = 0; k < bodies.size(); ++k)
    most = std::max(most, double(length(bodies[k].x - places[k])));
  return most;
}

// The common data of all variants.
struct Race {
  const Choice& choice;
  Chains chains;
  int steps;
  int counts[2];  // iterations: those of the choice, and a third of them
  CsvFile table;
  std::vector<Summary>& lines;

  // The positions of the bodies after every step, if solved one at a time in this order.
  std::vector<Places> run(const Groups& order, int iterations) const {
    HingeLoop<real> loop = loop_over<real>(chains, order, iterations);
    std::vector<Places> places;
    for (int n = 1; n <= steps; ++n) {
      loop.step(h);
      places.push_back(places_of(loop.bodies));
    }
    return places;
  }

  // One variant with both counts, a step of each in turn, so that other programs on the machine
  // affect both alike. `same` are the runs in the same order with one lane.
  template <class Number>
  void measure(const std::string& name, const Groups& groups,
               const std::vector<Places> (&same)[2], bool once_a_step = true) {
    std::vector<HingeLoop<Number>> loops;
    for (const int count : counts) {
      loops.push_back(loop_over<Number>(chains, groups, count));
      loops.back().once_a_step = once_a_step;
    }
    Run runs[] = {Run(experiment_of(loops[0], chains, steps)),
                  Run(experiment_of(loops[1], chains, steps))};
    double off[2] = {};
    for (int n = 1; n <= steps; ++n)
      for (int k = 0; k < 2; ++k) {
        runs[k].step();
        off[k] = std::max(off[k], furthest(loops[k].bodies, same[k][n - 1]));
      }
    const Measures found[] = {runs[0].measures(), runs[1].measures()};
    const double ns = 1000 * (found[0].us_per_step - found[1].us_per_step) /
                      (double(chains.links.size()) * (counts[0] - counts[1]));  // Eq. 7-2
    std::printf("              %-24s %6.1f ns per hinge and iteration\n", name.c_str(), ns);
    if (const double most = std::max(off[0], off[1]); most > 1e-3)
      std::printf("              off by %.3g m from one lane in the same order: two neighbours of "
                  "one colour? ./wb test 7.3\n", most);
    for (int k = 0; k < 2; ++k)
      table.row({name}, {double(loops[k].width), double(counts[k]), found[k].us_per_step, ns,
                         found[k].gap_rms, found[k].gap_max, off[k]});
    lines.push_back({found[0], "steps", name});
  }
};

void steps(const Choice& choice, std::vector<Summary>& lines) {
  Race race{choice, cube_chains(choice.chains, 100, choice.beta), steps_in(choice.seconds, h),
            {choice.iterations, choice.iterations / 3},
            CsvFile(choice.out + "/steps.csv",
                    {"step", "lanes", "iterations", "us_per_step", "ns_per_hinge_and_iteration",
                     "gap_rms_m", "gap_max_m", "off_m"}),
            lines};
  const Chains& chains = race.chains;
  print_plan("steps", chains.bodies, chains.links.size());
  const Groups chain = chain_order(chains), colours = colour_order(chains, 1);
  const std::vector<Places> along[] = {race.run(chain, race.counts[0]),
                                       race.run(chain, race.counts[1])};
  const std::vector<Places> by_colours[] = {race.run(colours, race.counts[0]),
                                            race.run(colours, race.counts[1])};
  constexpr int width = HingeLoop<Lanes>::width;
  race.measure<real>("prepared in every solve", chain, along, false);
  race.measure<real>("prepared once a step", chain, along);
  race.measure<real>("interleaved", by_islands, along);
  race.measure<Lanes>("lanes and colours", colour_order(chains, width), by_colours);
  race.measure<Lanes>("lanes a chain each", by_islands, along);
}

// ---- three whips, recorded ---------------------------------------------------------------------

// The same chain, solved in chain order, by colours, and over-relaxed. Twenty cubes each, released
// level with the last three hanging down; a tenth of the iterations, so that the remaining errors
// are visible.
void whips(const Choice& choice, std::vector<Summary>& lines) {
  const Chains one = cube_chains(1, 20, choice.beta, 3);
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

}  // namespace
}  // namespace joints::chapter7

using namespace joints;
using namespace joints::chapter7;

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("Chapter 7: the performance loop, step by step",
                    {{"iterations", "30", "iterations per step"},
                     {"beta", "0.2", "fraction of the error fed back per step [1]"},
                     {"seconds", "5", "how long the scenes run [s]"},
                     {"chains", "10", "chains of 100 cubes"}});
    if (!options.read(argc, argv)) return;
    const Choice choice{options.count("iterations", 1), real(options.number("beta", 0)),
                        options.number("seconds", 0.1), options.count("chains", 1),
                        options.text("out")};
    std::vector<Summary> lines;
    steps(choice, lines);
    whips(choice, lines);
    report(lines, choice.out);
  });
}
