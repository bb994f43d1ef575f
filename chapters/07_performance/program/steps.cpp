// Chapter 7's program, the steps of the loop on the performance scene: each one contains the
// improvements of the earlier ones. Read it; there is nothing to edit here.
#include <algorithm>
#include <cstdio>

#include "chapters/07_performance/program/program.h"
#include "chapters/07_performance/program/scenes.h"

namespace joints::chapter7 {

namespace {

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

}  // namespace

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

}  // namespace joints::chapter7
