// Convergence: the order of the joints, over-relaxation, and the rows inside one step. One chain is
// enough, since all chains move alike.
#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>

#include "bench/chapters/07_performance/experiments.h"

namespace joints::chapter7 {

namespace {

// One chain in an order that is drawn anew before every step (Fisher and Yates).
Measures in_random_order(const Choice& choice, const Chains& chains, int iterations,
                         unsigned seed) {
  Groups order = chain_order(chains);
  HingeLoop<real> loop = loop_over<real>(chains, order, iterations);
  Experiment experiment = experiment_of(loop, chains, steps_in(choice.seconds, h));
  std::mt19937 random(seed);
  experiment.step = [&] {
    for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[random() % k]);
    loop.arrange(order);
    loop.step(h);
  };
  return run(experiment);
}

void orders(const Choice& choice, const Chains& chains) {
  CsvFile table(choice.out + "/order.csv",
                {"order", "iterations", "seed", "gap_rms_m", "gap_max_m"});
  std::set<int> counts{5, 10, 20, 30, 60, 120};
  counts.insert(choice.iterations);
  for (const Order& order : {Order{"chain", chain_order(chains)},
                             {"from the end", from_the_end(chains)},
                             {"colours", colour_order(chains, 1)}})
    for (const int count : counts) {
      HingeLoop<real> loop = loop_over<real>(chains, order.groups, count);
      const Measures found =
          run(experiment_of(loop, chains, steps_in(choice.seconds, h)));
      table.row({order.name}, {double(count), 0, found.gap_rms, found.gap_max});
    }
  for (const int count : counts)
    for (unsigned seed = 1; seed <= 10; ++seed) {
      const Measures found = in_random_order(choice, chains, count, seed);
      table.row({"random"}, {double(count), double(seed), found.gap_rms, found.gap_max});
    }
}

void omegas(const Choice& choice, const Chains& chains, const std::vector<Order>& list) {
  CsvFile table(choice.out + "/relaxation.csv", {"order", "status", "omega", "iterations",
                                                 "gap_rms_m", "gap_max_m", "energy_change"});
  const std::set<int> counts{std::max(1, choice.iterations / 3), choice.iterations};
  for (const Order& order : list)
    for (const int count : counts)
      for (int tenths = 6; tenths <= 21; ++tenths) {
        HingeLoop<real> loop = loop_over<real>(chains, order.groups, count);
        loop.relaxation = real(tenths) / 10;
        const Measures found =
          run(experiment_of(loop, chains, steps_in(choice.seconds, h)));
        table.row({order.name, status(found, double(spacing))},
                  {tenths / 10.0, double(count), found.gap_rms, found.gap_max,
                   found.energy_drift});
      }
}

// Each order and omega begins with the state to which it has brought the chain in 1 s. A step with
// n iterations shows the remaining error after iteration n.
void inside_a_step(const Choice& choice, const Chains& chains, const std::vector<Order>& list) {
  CsvFile table(choice.out + "/inside_a_step.csv", {"order", "omega", "iteration", "largest_e"});
  for (const Order& order : list)
    for (const real omega : {real(1), real(1.5), real(1.9)}) {
      HingeLoop<real> before = loop_over<real>(chains, order.groups, choice.iterations);
      before.relaxation = omega;
      for (int n = 0; n < steps_in(1, h); ++n) before.step(h);
      for (int iteration = 0; iteration <= 60; ++iteration) {
        HingeLoop<real> loop = before;
        loop.iterations = iteration;
        loop.step(h);
        double largest = 0;
        for (const real e : loop.errors()) largest = std::max(largest, std::abs(double(e)));
        table.row({order.name}, {double(omega), double(iteration), largest});
      }
    }
}

}  // namespace

void relaxation(const Choice& choice) {
  const Chains chains = cube_chains(1, 100, choice.beta);
  print_plan("relaxation", chains.bodies, chains.links.size());
  const std::vector<Order> list{{"chain", chain_order(chains)},
                                {"colours", colour_order(chains, 1)}};
  orders(choice, chains);
  omegas(choice, chains, list);
  inside_a_step(choice, chains, list);
}

}  // namespace joints::chapter7
