// The four maps of the stability suite: what each method makes of mass ratio, beta, step and length
// (X1, X2, X3, X4), and the step of one hinge down to rounding.
#include <cmath>

#include "bench/stability.h"

namespace joints::bench {

namespace {

Line run_of(const std::string& id, const std::string& parameter, double value,
            const MakeScene& make, const Method& method, const Rates& rates,
            const Span& span = {}) {
  Line line = of_run({.id = id, .method = method.name, .parameter = parameter, .value = value},
                     run(make, setting_of(method), 1, span));
  add_criterion(line, method, rates);
  return line;
}

std::vector<double> some(bool quick, const std::vector<double>& all,
                         const std::vector<double>& few) {
  return quick ? few : all;
}

constexpr int links = 21;  // bodies of the chain of X2 and X3, the static one included

}  // namespace

void mass_ratios(bool quick, const Tell& tell) {
  for (double ratio : some(quick, {1, 10, 30, 100, 300, 1000, 1e4, 1e5, 1e6}, {1, 1e6})) {
    const MakeScene make = [=] { return heavy_end_unreferenced(ratio); };
    const Rates rates = rates_of(make);
    for (const Method& method : methods())
      if (method.whole) tell(run_of("X1", "end mass / link mass", ratio, make, method, rates));
  }
}

void feedback_of_many(bool quick, const Tell& tell) {
  const MakeScene make = [] { return cubes_on_hinges(1, links); };
  const Rates rates = rates_of(make);
  for (double beta : some(quick, {.05, .1, .2, .5, .8, 1, 1.5, 1.9, 2, 2.2}, {.2, 2.2}))
    for (bool warm : {false, true})
      for (int iterations : {1, 3, 10, 30, 100}) {
        if (quick && iterations > 3) continue;
        const Method method{.name = (warm ? "warm " : "cold ") + std::to_string(iterations),
                            .iterations = iterations,
                            .warm = warm,
                            .beta = real(beta)};
        tell(run_of("X2", "beta, chain of 20 hinges", beta, make, method, rates));
      }
}

void steps(bool quick, const Tell& tell) {
  const MakeScene make = [] { return cubes_on_hinges(1, links); };
  const Rates rates = rates_of(make);
  const double seconds = quick ? 1 : 5;
  for (const Method& method : methods()) {
    for (int rate : {15, 30, 60, 120, 240, 480, 960}) {
      if (quick && rate > 30) continue;
      tell(run_of("X3", "step [s]", 1.0 / rate, make, method, rates,
                  {.h = real(1) / real(rate), .steps = int(seconds * rate)}));
    }
  }
  for (int iterations : {30, 100}) {  // S1 itself, one chain: how the gap falls with the step
    double before = none;
    for (int rate : {30, 60, 120, 240, 480, 960}) {
      if (quick && rate > 60) continue;
      const Method method{.name = "cold " + std::to_string(iterations), .iterations = iterations};
      const Line line = run_of("X3", "step [s], S1 with one chain", 1.0 / rate,
                               [&] { return cubes_on_hinges(1, quick ? 10 : 100); }, method, rates,
                               {.h = real(1) / real(rate), .steps = int(seconds * rate)});
      tell(line);
      if (rate > 30)
        tell(compared({.id = "X3", .method = method.name,
                       .parameter = "order of the gap RMS from 2h to h [s]", .value = 1.0 / rate},
                      2, std::log2(before / line.gap_rms), 0.25));
      before = line.gap_rms;
    }
  }
}

void truncation(bool quick, const Tell& tell) {
  // let go level it comes to w^2 = 2 m g r / (i + m r^2) at the bottom: e = w^2 r h^2 / (2 beta)
  const double r = 1.5, w2 = 2 * 9.81 * r / (1.0 / 6 + r * r);
  const MakeScene make = [] { return cubes_on_hinges(1, 2); };
  for (int rate = 60; rate <= (quick ? 240 : 15360); rate *= 2) {
    const double h = 1.0 / rate, expected = w2 * r * h * h / 0.4;
    const Result result = run(make, setting_of({.name = "cold 3", .iterations = 3}), 1,
                              {.h = real(1) / real(rate), .steps = 2 * rate});
    const Line line = of_run({.id = "X3", .method = "one hinge, cold 3",
                              .parameter = "step of one hinge [s]", .value = h}, result);
    tell(compared(line, expected, line.gap_max, 0.1 * expected));
  }
}

void lengths(bool quick, const Tell& tell) {
  std::vector<Method> all = methods();
  all.insert(all.begin() + 3, {.name = "cold 200", .iterations = 200});
  for (double length : some(quick, {10, 30, 100, 300, 1000}, {10})) {
    const MakeScene make = [=] { return cubes_on_hinges(1, int(length) + 1); };
    const Rates rates = rates_of(make);
    for (const Method& method : all)
      tell(run_of("X4", "links of the chain", length, make, method, rates));
  }
}

}  // namespace joints::bench
