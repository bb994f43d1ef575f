// Chapter 7's program, the steps of the loop on the performance scene: each takes over what the one
// before has gained. Read it; there is nothing to edit here.
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

// All that the variants have in common.
struct Race {
  const Choice& choice;
  Chains chains;
  int steps;
  int counts[2];  // iterations: those of the choice, and a third of them
  CsvFile table;
  std::vector<Summary>& lines;

  // Where the bodies are after every step, solved one at a time in this order.
  std::vector<Places> run(const Groups& order, int iterations) const {
    HingeLoop<real> loop = loop_over<real>(chains, order, iterations);
    std::vector<Places> places;
    for (int n = 1; n <= steps; ++n) {
      loop.step(h);
      places.push_back(places_of(loop.bodies));
    }
    return places;
  }

  // One variant with both counts, a step of the one and a step of the other: whatever else the
  // machine does meets both alike. `same` are the runs in the same order with one lane.
  template <class Number>
  void measure(const std::string& name, const Groups& groups,
               const std::vector<Places> (&same)[2], bool once_a_step = true) {
    struct Run {
      HingeLoop<Number> loop;
      Watch watch;
      StepClock clock{};
      double off = 0;
    };
    std::vector<Run> runs;
    for (const int count : counts) {
      runs.push_back({loop_over<Number>(chains, groups, count), Watch(chains, steps)});
      runs.back().loop.once_a_step = once_a_step;
    }
    for (int n = 1; n <= steps; ++n)
      for (int k = 0; k < 2; ++k) {
        Run& run = runs[k];
        run.clock.start();
        run.loop.step(h);
        run.clock.stop();
        run.watch.look(n, run.loop.bodies);
        run.off = std::max(run.off, furthest(run.loop.bodies, same[k][n - 1]));
      }
    const double ns = 1000 * (runs[0].clock.median_us() - runs[1].clock.median_us()) /
                      (double(chains.links.size()) * (counts[0] - counts[1]));  // Eq. 7-2
    std::printf("              %-24s %6.1f ns a hinge and iteration\n", name.c_str(), ns);
    if (const double off = std::max(runs[0].off, runs[1].off); off > 1e-3)
      std::printf("              off by %.3g m from one lane in the same order: two neighbours of "
                  "one colour? ./wb test 7.3\n", off);
    for (int k = 0; k < 2; ++k) {
      const Run& run = runs[k];
      table.row({name}, {double(run.loop.width), double(counts[k]), run.clock.median_us(), ns,
                         run.watch.gap_rms(), run.watch.gap_max(), run.off});
    }
    lines.push_back({"steps", name, runs[0].clock.median_us(), runs[0].watch.gap_rms(),
                     runs[0].watch.gap_max(), runs[0].watch.energy_change()});
  }
};

}  // namespace

void steps(const Choice& choice, std::vector<Summary>& lines) {
  Race race{choice, cube_chains(choice.chains, 100, choice.beta), steps_in(choice.seconds),
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
  const Islands islands = islands_of(chains.links, moving(chains.bodies));
  race.measure<real>("prepared in every visit", chain, along, false);
  race.measure<real>("prepared once a step", chain, along);
  race.measure<real>("interleaved", interleaved(islands, 1), along);
  race.measure<Lanes>("lanes and colours", colour_order(chains, width), by_colours);
  race.measure<Lanes>("lanes a chain each", interleaved(islands, width),
                      along);
}

}  // namespace joints::chapter7
