// Trees in reduced coordinates beside the methods on rows: time of a step, in processor time, and
// the error of the tip after a second. All methods take turns in one run, so the ratios hold on a
// busy machine, too. Usage: trees [repetitions]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "bench/named.h"
#include "reduced/reduced.h"

using namespace joints;
using namespace joints::bench;

namespace {

// A setting of the runner that steps in reduced coordinates.
Setting reduced(Reduced::Method method) {
  Setting setting;
  setting.make = [method]() -> Step {
    const auto tree = std::make_shared<std::unique_ptr<Reduced>>();
    return [method, tree](World& world, real h) {
      if (!*tree) *tree = std::make_unique<Reduced>(world);
      (*tree)->method = method;
      (*tree)->step(world, h);
    };
  };
  return setting;
}

struct Method {
  const char* name;
  Setting setting;
};

}  // namespace

int main(int argc, char** argv) {
  const int repetitions = argc > 1 ? std::max(1, std::atoi(argv[1])) : 7;
  const std::vector<Method> methods = {
      {"reduced, leapfrog", reduced(Reduced::Method::leapfrog)},
      {"reduced, Runge-Kutta", reduced(Reduced::Method::runge_kutta)},
      {"direct", setting_named("velocity")},
      {"direct, newton 8", setting_named("shake")},
      {"rows, Runge-Kutta", setting_named("rk4")}};
  const struct {
    const char* name;
    MakeScene make;
  } scenes[] = {{"S1", [] { return cubes_on_hinges(10, 100); }},
                {"S5", [] { return cubes_on_hinges(1, 4); }},
                {"S6", loaded_axes},
                {"S7", sideways_gravity}};
  std::printf("%-6s %-22s %12s %9s %12s %12s\n", "scene", "method", "us per step", "ratio",
              "tip error m", "energy");
  for (const auto& scene : scenes) {
    std::vector<Result> results;
    std::vector<std::vector<double>> times(methods.size());
    for (const Method& method : methods) results.push_back(run(scene.make, method.setting, 1));
    for (int n = 0; n < repetitions; ++n)
      for (std::size_t m = 0; m < methods.size(); ++m)
        times[m].push_back(time_of_step(scene.make, methods[m].setting, {.steps = 120}));
    std::vector<double> middle;
    for (auto& list : times) {
      std::ranges::nth_element(list, list.begin() + long(list.size() / 2));
      middle.push_back(list[list.size() / 2]);
    }
    for (std::size_t m = 0; m < methods.size(); ++m)
      std::printf("%-6s %-22s %12.2f %9.3f %12.2g %12.2g\n", scene.name, methods[m].name, middle[m],
                  middle[m] / middle[2], results[m].tip_error, results[m].energy_drift);
  }
}
