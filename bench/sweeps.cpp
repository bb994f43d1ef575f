// Error against run time on the scenes of accuracy.h: every method, and the published engines where
// they are installed, at steps from 1/30 to 1/1920 s. `./wb bench --sweeps` calls it.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bench/accuracy.h"
#include "bench/named.h"
#include "bench/start.h"
#include "engine/instruments/options.h"
#ifdef WITH_PEERS
#include "bench/peers/peer.h"
#endif

using namespace joints;
using namespace joints::bench;

namespace {

const std::vector<int> rates = {30, 60, 120, 240, 480, 960, 1920};  // steps per second
constexpr int untimed = 20;  // steps of a run, at most half of them

// A curve of the figures.
struct Curve {
  std::string engine, version, name;
  Setting setting;
};

std::vector<Curve> curves(const AccuracyScene& scene) {
  std::vector<Curve> out;
  const std::string ours = "beta1:10 beta1:30 beta1:120 velocity shake inertia rk4";
  for (const std::string& word : words(ours + tree_methods(scene.make)))
    out.push_back({"ours", "", word, setting_named(word)});
#ifdef WITH_PEERS
  const PeerScene theirs = peer_scene(scene.make().world);
  for (const PeerSetting& peer : peer_settings())
    if (peer.takes(theirs) && peer.name.find("substeps") == std::string::npos)  // as other points
      out.push_back({peer.engine, peer.version, peer.name, peer.setting()});
#endif
  for (Curve& curve : out) curve.setting = with_same_start(curve.setting);
  return out;
}

double quantile(std::vector<double> numbers, double share) {
  std::sort(numbers.begin(), numbers.end());
  return numbers[std::size_t(share * double(numbers.size() - 1) + 0.5)];
}

// A curve at one length of the step.
struct Point {
  const Curve& curve;
  int rate;
  Result result{};
  std::vector<double> us{};
};

void measure(FILE* file, const AccuracyScene& scene, int rounds, const std::string& machine) {
  const BenchScene compared = scene.make();
  const std::vector<Curve> all = curves(scene);
  std::vector<Point> points;
  for (const Curve& curve : all)
    for (const int rate : rates) {
      std::fprintf(stderr, "%s, %s, %s, %d steps per second\n", scene.key.c_str(),
                   curve.engine.c_str(), curve.name.c_str(), rate);
      const int steps = int(std::lround(compared.tip_time * rate));
      points.push_back({curve, rate, {}, {}});
      points.back().result =
          run(scene.make, curve.setting, 1, {.h = real(1) / real(rate), .steps = steps});
    }
  for (int n = 1; n <= rounds; ++n) {
    std::fprintf(stderr, "%s, round %d of %d\n", scene.key.c_str(), n, rounds);
    for (Point& point : points) {
      if (!point.result.finite) continue;
      const int steps = int(std::lround(compared.tip_time * point.rate));
      const int first = std::min(untimed, steps / 2);
      point.us.push_back(time_of_run(scene.make, point.curve.setting, real(1) / real(point.rate),
                                     first, steps - first));
    }
  }
  for (const Point& point : points) {
    const bool lost = point.us.empty();
    const double us = lost ? 0 : quantile(point.us, 0.5);
    const double apart = lost ? 0 : quantile(point.us, 0.75) - quantile(point.us, 0.25);
    std::fprintf(file, "%s,%s,%s,%s,%s,%d", sizeof(real) == 8 ? "double" : "float",
                 scene.key.c_str(), point.curve.engine.c_str(), point.curve.version.c_str(),
                 point.curve.name.c_str(), point.rate);
    std::fprintf(file, "%s%s%s%s%s,%s,%s\n", cell(us, !lost).c_str(),
                 cell(apart / us, !lost).c_str(), cell(point.result.tip_error, !lost).c_str(),
                 cell(point.result.gap_max, !lost).c_str(),
                 cell(point.result.energy_drift, !lost).c_str(), point.result.status.c_str(),
                 machine.c_str());
  }
  std::fflush(file);
}

}  // namespace

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("Error against run time, over the length of the step",
                    {{"csv", "out/sweeps.csv", "the table"},
                     {"append", "0", "1: add lines to the table that is there"},
                     {"scene", "", "one scene alone, by its name in the table"},
                     {"machine", "", "what stands in the last column"},
                     {"rounds", "9", "how often each is timed, in turn"}});
    if (!options.read(argc, argv)) return;
    std::vector<AccuracyScene> list = accuracy_scenes();
    keep_named(list, options.text("scene"), &AccuracyScene::key);
    FILE* file = open_table(options.text("csv"), options.flag("append"),
                            "real,scene,engine,version,setting,steps_per_s,us_per_step,spread,"
                            "tip_error_m,gap_max_m,energy_drift,status,machine");
    for (const AccuracyScene& scene : list)
      measure(file, scene, options.count("rounds", 1), options.text("machine"));
    std::fclose(file);
  });
}
