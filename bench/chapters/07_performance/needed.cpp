// The iterations that an error takes, the error that an iteration leaves, and the effect of half a
// kick. One chain is enough.
#include <algorithm>
#include <cmath>

#include "bench/chapters/07_performance/experiments.h"

namespace joints::chapter7 {

namespace {

// Gap of a whole run, RMS [m].
double gap_with(const Choice& choice, const Chains& chains, const Order& order, double omega,
                int iterations) {
  HingeLoop<real> loop = loop_over<real>(chains, order.groups, iterations);
  loop.relaxation = real(omega);
  const Measures found = run(experiment_of(loop, chains, steps_in(choice.seconds, h)));
  return found.finite ? found.gap_rms : 1e9;
}

// The least number of iterations with at most this gap. It is searched for between a number that is
// too small and one that is enough, by linear interpolation of the logarithms. NaN above 500.
double iterations_to(double gap, const Choice& choice, const Chains& chains, const Order& order,
                     double omega) {
  const auto left = [&](int count) { return gap_with(choice, chains, order, omega, count); };
  int few = 4, many = 8;
  double with_few = left(few), with_many = left(many);
  while (with_many > gap) {
    if (many > 500) return std::nan("");
    few = many, with_few = with_many;
    with_many = left(many *= 2);
  }
  while (many - few > 1) {
    const double part = std::log(with_few / gap) / std::log(with_few / with_many);
    const double guess = few * std::pow(double(many) / few, part);
    const int next = std::clamp(int(std::ceil(guess)), few + 1, many - 1);
    const double with_next = left(next);
    if (with_next > gap)
      few = next, with_few = with_next;
    else
      many = next, with_many = with_next;
  }
  return many;
}

void to_an_error(const Choice& choice, const Chains& chains, const std::vector<Order>& list) {
  CsvFile table(choice.out + "/needed.csv", {"order", "omega", "gap_rms_m", "iterations"});
  for (const Order& order : list)
    for (const double omega : {1.0, 1.5, 1.7, 1.8, 1.9, 1.95})
      table.row({order.name},
                {omega, 0.01, iterations_to(0.01, choice, chains, order, omega)});
}

// All orders and omegas from one state: that of the chain after 1 s of plain iterations in chain
// order. The error is the root of the sum of the squares of all e.
void inside_one_step(const Choice& choice, const Chains& chains, const std::vector<Order>& list) {
  CsvFile table(choice.out + "/rate.csv", {"order", "omega", "iteration", "error"});
  HingeLoop<real> start = loop_over<real>(chains, list.front().groups, choice.iterations);
  for (int n = 0; n < steps_in(1, h); ++n) start.step(h);
  for (const Order& order : list)
    for (const double omega : {1.0, 1.9})
      for (const int iteration : {0, 1, 10, 30, 50, 200}) {
        HingeLoop<real> loop = start;
        loop.arrange(order.groups);
        loop.relaxation = real(omega);
        loop.iterations = iteration;
        loop.step(h);
        double sum = 0;
        for (const real e : loop.errors()) sum += double(e) * double(e);
        table.row({order.name}, {omega, double(iteration), std::sqrt(sum)});
      }
}

// The tip of a level chain falls freely at first: the error of its height after 1 s.
void half_a_kick(const Choice& choice, const Chains& chains, const Order& order) {
  CsvFile table(choice.out + "/kick.csv",
                {"omega", "iterations", "first_kick", "tip_height_error_m"});
  for (const double omega : {1.0, 1.9})
    for (const double kick : {1.0, 0.5}) {
      HingeLoop<real> loop = loop_over<real>(chains, order.groups, 4 * choice.iterations);
      loop.relaxation = real(omega);
      const vec3 gravity = loop.gravity;
      const real height = loop.bodies.back().x.y + real(0.5) * gravity.y;
      for (int n = 0; n < steps_in(1, h); ++n) {
        loop.gravity = n == 0 ? real(kick) * gravity : gravity;
        loop.step(h);
      }
      table.row({omega, double(loop.iterations), kick,
                 std::abs(double(loop.bodies.back().x.y - height))});
    }
}

}  // namespace

void needed(const Choice& choice) {
  const Chains chains = cube_chains(1, 100, choice.beta);
  const std::vector<Order> list{{"chain", chain_order(chains)},
                                {"colours", colour_order(chains, 1)}};
  to_an_error(choice, chains, list);
  inside_one_step(choice, chains, list);
  half_a_kick(choice, chains, list.front());
}

}  // namespace joints::chapter7
