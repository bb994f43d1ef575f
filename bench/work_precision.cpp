// Error against run time: every scene with every setting that means something on it, a line each.
// `./wb bench` calls it. A scene more is a line more below, a setting more one in settings.cpp.
#include <cstdio>

#include "bench/named.h"
#include "engine/instruments/options.h"

using namespace joints;
using namespace joints::bench;

namespace {

// ---- scenes -------------------------------------------------------------------------------------

// A scene, its key in the table of settings, and the measures of its fronts and figures: the first
// one, or both.
struct Entry {
  std::string key;
  MakeScene make;
  std::vector<std::string> measures;
  int repetitions = 2;
  bool quick = true;
  int steps = 300;
  int most = 200;  // iterations
};

std::vector<Entry> scenes(int repetitions) {
  const int most = sizeof(real) == 4 ? repetitions : 1;
  std::vector<Entry> list = {
      {"S1", [] { return cubes_on_hinges(10, 100); }, {"gap_rms_m", "tip_error_m"}, most},
      {"S1x", [] { return cubes_on_hinges(20, 100); }, {"gap_rms_m"}, 2, false, 300, 60},
      {"S1b", [] { return cubes_on_balls(10, 100); }, {"gap_rms_m"}, 1}};
  for (const double ratio : {1, 100, 1000})
    list.push_back({"S2", [=] { return heavy_end(ratio); }, {"gap_max_m"}, 2, ratio == 100});
  list.push_back({"S3", [] { return hanging_bridge(true); }, {"gap_rms_m"}});
  list.push_back({"S3b", [] { return hanging_bridge(false); }, {"gap_rms_m"}, 2, false});
  list.push_back({"S5", [] { return cubes_on_hinges(1, 4); }, {"tip_error_m"}});
  list.push_back({"S6", loaded_axes, {"gap_rms_m"}});
  list.push_back({"S7", sideways_gravity, {"sideways_m"}, 1, false, 600, 120});  // it swings back
  return list;
}

// ---- the table ----------------------------------------------------------------------------------

// A run, and in the fronts of which measures it stands.
struct Point {
  Way way;
  int iterations = 0;
  Result result;
  double ns = 0;
  std::string fronts{};
};

double value(const Result& r, const std::string& measure) {
  return measure == "gap_rms_m"     ? r.gap_rms
         : measure == "gap_max_m"   ? r.gap_max
         : measure == "tip_error_m" ? r.tip_error
                                    : r.sideways;
}

const char* const columns =
    "scene,chains,solver,setting,real,iterations,substeps,warm,us_per_step,ns_per_joint_iteration,"
    "gap_rms_m,gap_max_m,axis_error_rad,energy_drift,tip_error_m,status,sideways_m,measures,"
    "fronts";

void write(FILE* file, const BenchScene& scene, const std::string& measures, const Point& point) {
  const Result& r = point.result;
  std::fprintf(file, "%s,%d,%s,%s,%s,%d,%d,%d,%.4f,%.3f,%.8g,%.8g,%.8g,%.8g,%.8g,%s,%.8g,%s,%s\n",
               scene.name.c_str(), scene.chains, point.way.solver().c_str(),
               point.way.name.c_str(), sizeof(real) == 8 ? "double" : "float",
               point.way.iterations_of(point.iterations), point.way.substeps, int(point.way.warm),
               r.us_per_step, point.ns, r.gap_rms, r.gap_max, r.axis_error, r.energy_drift,
               r.tip_error, r.status.c_str(), r.sideways, measures.c_str(), point.fronts.c_str());
}

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : "+") + word;
  return out;
}

// What one more iteration costs a joint is the slope of the time between a count and its neighbour.
double slope(const Point& a, const Point& b, std::size_t joints) {
  const int iterations = b.way.iterations_of(b.iterations) - a.way.iterations_of(a.iterations);
  return 1000 * (b.result.us_per_step - a.result.us_per_step) /
         (double(joints) * iterations * a.way.substeps);
}

// One setting on one scene, over the counts of iterations.
std::vector<Point> series(const Entry& entry, const BenchScene& scene, const Way& way,
                          const std::vector<int>& counts, int repetitions) {
  std::vector<Point> points;
  for (const int count : counts) {
    if (count > std::min(way.most, entry.most)) continue;
    if (!points.empty() && way.iterations_of(count) == way.iterations_of(points.back().iterations))
      continue;
    std::fprintf(stderr, "%s, %d chains, %s, %s, %d iterations\n", scene.name.c_str(), scene.chains,
                 way.solver().c_str(), way.name.c_str(), count);
    Span span;
    span.steps = entry.steps;
    span.timed = 80;
    points.push_back({way, count, run(entry.make, way.setting(count), repetitions, span)});
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::size_t a = k == 0 ? 0 : k - 1;
    if (points.size() > 1) points[k].ns = slope(points[a], points[a + 1], scene.marks.size());
  }
  return points;
}

// What is nearer than this [m] is exact: nothing is gained by being nearer still.
constexpr double rounding = 1e-9;

// Energy that is gained is no good, however small the gap.
bool counts(const Result& r) {
  return r.status == "ok" || r.status == "soft" || r.status == "torn";
}

void measure(FILE* file, const Entry& entry, const std::vector<int>& counted, bool quick) {
  const BenchScene scene = entry.make();
  std::vector<Point> points;
  for (const Way& way : ways()) {
    if (!way.means_something_on(entry.key) || (quick && !way.quick)) continue;
    const auto more = series(entry, scene, way, counted, quick ? 1 : entry.repetitions);
    points.insert(points.end(), more.begin(), more.end());
  }
  for (const std::string& name : entry.measures) {
    std::vector<Cost> costs;
    for (const Point& point : points)
      costs.push_back({point.result.us_per_step,
                       counts(point.result) ? std::max(value(point.result, name), rounding)
                                            : std::numeric_limits<double>::quiet_NaN()});
    for (const int k : pareto_front(costs))
      points[k].fronts += (points[k].fronts.empty() ? "" : "+") + name;
  }
  for (const Point& point : points) write(file, scene, joined(entry.measures), point);
}

}  // namespace

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("Error against run time",
                    {{"csv", "out/work_precision.csv", "the table"},
                     {"append", "0", "1: add lines to the table that is there"},
                     {"quick", "0", "1: fewer scenes, settings and counts, one repetition"},
                     {"scene", "", "one scene alone, by its key: S1, S1x (20 chains), S2, ..."},
                     {"repetitions", "5", "how often each run is timed at the most"}});
    if (!options.read(argc, argv)) return;
    const bool quick = options.flag("quick");
    const std::vector<int> counts = quick ? std::vector<int>{10, 30, 120}
                                          : std::vector<int>{10, 20, 30, 60, 120, 200};
    std::vector<Entry> list = scenes(options.count("repetitions", 1));
    std::erase_if(list, [&](const Entry& one) { return quick && !one.quick; });
    keep_named(list, options.text("scene"), &Entry::key);
    FILE* file = open_table(options.text("csv"), options.flag("append"), columns);
    for (const Entry& entry : list) measure(file, entry, counts, quick);
    std::fclose(file);
  });
}
