// The direct solver against thirty iterations, in one run: time, gap, tip, energy, and how many
// scenes of a random family hold. `./wb bench --direct` calls it.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bench/random_chains.h"
#include "bench/settings.h"
#include "chapters/09_direct/program/linkages.h"
#include "engine/instruments/options.h"

using namespace joints;
using namespace joints::bench;

namespace {

// A scene, or several of a kind that are told in one line.
struct Entry {
  std::string name{};
  std::vector<MakeScene> makes{};
  Span span{.steps = 300, .timed = 80};
  double holds = 0;  // a run holds if its largest gap is below this [m]
  std::string methods = "velocity shake rk4 si30";
};

MakeScene of_chapter_9(const std::function<Scene()>& make) {
  return [make] {
    BenchScene scene;
    static_cast<Scene&>(scene) = make();
    scene.tip_mask = glm::dvec3(0);
    return scene;
  };
}

std::vector<Entry> scenes(bool quick) {
  const std::string stiff = "velocity shake stiff si30", plain = "velocity shake si30";
  std::vector<Entry> list = {
      {.name = "S1", .makes = {[] { return cubes_on_hinges(10, 100); }},
       .methods = "velocity shake stiff rk4 si30 chapter7"},
      {.name = "S1b", .makes = {[] { return cubes_on_balls(10, 100); }}},
      {.name = "S5", .makes = {[] { return cubes_on_hinges(1, 4); }}},
      {.name = "S6", .makes = {loaded_axes}},
      {.name = "S7", .makes = {sideways_gravity}, .span = {.steps = 600, .timed = 80},
       .methods = plain},
      {.name = "S3", .makes = {[] { return hanging_bridge(true); }}, .methods = stiff},
      {.name = "S3b", .makes = {[] { return hanging_bridge(false); }}, .methods = stiff},
      {.name = "chain of 1000", .makes = {[] { return cubes_on_hinges(1, 1001); }},
       .methods = plain},
      {.name = "beam of 20", .makes = {of_chapter_9([] { return chapter9::beam(20); })},
       .methods = plain},
      {.name = "net 6x6", .makes = {of_chapter_9([] { return chapter9::net(6); })},
       .methods = plain},
      {.name = "four-bars 10", .makes = {of_chapter_9([] { return chapter9::four_bars(10); })},
       .methods = plain},
      {.name = "four-bars 40", .makes = {of_chapter_9([] { return chapter9::four_bars(40); })},
       .methods = plain},
      {.name = "Bricard", .makes = {of_chapter_9(chapter9::bricard)},
       .span = {.h = real(1) / 240, .steps = 2400, .timed = 200}}};
  for (const int arms : {12, 40, 100})
    list.push_back({.name = "star of " + std::to_string(arms),
                    .makes = {of_chapter_9([=] { return chapter9::star(arms); })},
                    .methods = "velocity si30"});
  for (const int exponent : {2, 4, 5, 6})
    list.push_back({.name = "heavy end 1e" + std::to_string(exponent),
                    .makes = {[=] { return heavy_end_unreferenced(std::pow(10, exponent)); }},
                    .span = {.steps = 600, .timed = 80}, .methods = stiff});
  for (const int chains : {1, 10, 100, 1000})
    if (!quick || chains < 100)
      list.push_back({.name = std::to_string(99 * chains) + " hinges",
                      .makes = {[=] { return cubes_on_hinges(chains, 100); }},
                      .span = {.steps = chains < 100 ? 120 : 30, .timed = chains < 100 ? 120 : 30},
                      .methods = plain});
  for (const bool tree : {false, true})
    for (const int exponent : {0, 2, 4, 6}) {
      Entry entry{.name = std::string(tree ? "random trees" : "random chains") + " 1e" +
                          std::to_string(exponent),
                  .span = {.steps = 600}, .holds = tree ? 0.1 : 1e-3, .methods = stiff};
      for (unsigned seed = 1; seed <= (quick ? 4u : 24u); ++seed)
        entry.makes.push_back([=] {
          const double ratio = std::pow(10, exponent);
          return tree ? random_tree(seed, ratio) : random_chain(seed, ratio);
        });
      list.push_back(entry);
    }
  return list;
}

// A method by its word in the table.
Setting setting_of(const std::string& method) {
  const Way direct{.loop = Loop::direct, .beta = 1, .leapfrog = true};
  Way way = direct;
  if (method == "shake" || method == "stiff") way.newton = 8;
  if (method == "stiff") way.stiffness = 8;
  if (method == "rk4") way = {.loop = Loop::runge_kutta, .beta = 1};
  if (method == "si30") way = {};
  if (method == "chapter7") return Way{.loop = Loop::hinges, .relaxation = real(1.9)}.setting(20);
  return way.setting(30);
}

// The method's runs one after the other; the worst of each measure.
struct Outcome {
  std::vector<double> us{};
  Result worst{};
  int held = 0;
};

void add(Outcome& out, const Result& result, double holds) {
  const auto raise = [](double& most, double number) {
    most = std::isnan(most) || number <= most ? most : number;  // NaN stays
  };
  if (out.worst.status.empty()) out.worst = result;
  raise(out.worst.gap_max, result.gap_max);
  raise(out.worst.tip_error, result.tip_error);
  raise(out.worst.energy_peak, result.energy_peak);
  if (std::abs(result.energy_drift) > std::abs(out.worst.energy_drift) || !result.finite)
    out.worst.energy_drift = result.energy_drift;
  const bool ok = result.status == "ok";
  if (!ok && out.worst.status == "ok") out.worst.status = result.status;
  out.held += holds > 0 ? result.gap_max < holds : ok;
}

double median(std::vector<double> numbers) {
  if (numbers.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(numbers.begin(), numbers.end());
  return numbers[numbers.size() / 2];
}

std::vector<std::string> words(const std::string& text) {
  std::vector<std::string> out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    out.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return out;
}

void measure(FILE* file, const Entry& entry, int repetitions) {
  const std::vector<std::string> methods = words(entry.methods);
  std::vector<Outcome> outcomes(methods.size());
  for (std::size_t m = 0; m < methods.size(); ++m) {
    std::fprintf(stderr, "%s, %s\n", entry.name.c_str(), methods[m].c_str());
    for (const MakeScene& make : entry.makes)
      add(outcomes[m], run(make, setting_of(methods[m]), 1, entry.span), entry.holds);
  }
  Span timed = entry.span;  // the methods in turn, so that what else runs disturbs all alike
  timed.steps = std::min(timed.steps, timed.timed);
  for (int n = 0; n < repetitions; ++n)
    for (std::size_t m = 0; m < methods.size(); ++m)
      outcomes[m].us.push_back(time_of_step(entry.makes.front(), setting_of(methods[m]), timed));
  double si30 = 0;
  for (std::size_t m = 0; m < methods.size(); ++m)
    if (methods[m] == "si30") si30 = median(outcomes[m].us);
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const Result& worst = outcomes[m].worst;
    const double us = median(outcomes[m].us);
    std::fprintf(file, "%s,%s,%s,%.4f,%.4f,%.6g,", entry.name.c_str(),
                 sizeof(real) == 8 ? "double" : "float", methods[m].c_str(), us, us / si30,
                 worst.gap_max);
    const bool referenced = entry.makes.front()().tip_mask != glm::dvec3(0);
    if (referenced) std::fprintf(file, "%.6g", worst.tip_error);
    std::fprintf(file, ",%.6g,%d,%zu,%s\n", worst.energy_drift, outcomes[m].held,
                 entry.makes.size(), worst.status.c_str());
  }
}

}  // namespace

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("The direct solver against thirty iterations",
                    {{"csv", "out/direct.csv", "the table"},
                     {"append", "0", "1: add lines to the table that is there"},
                     {"quick", "0", "1: fewer random scenes, no large ones"},
                     {"scene", "", "one scene alone, by its name in the table"},
                     {"repetitions", "5", "how often each step is timed"}});
    if (!options.read(argc, argv)) return;
    const std::string path = options.text("csv"), only = options.text("scene");
    std::vector<Entry> list = scenes(options.flag("quick"));
    std::erase_if(list, [&](const Entry& one) { return !only.empty() && one.name != only; });
    if (list.empty()) refuse("--scene " + only + ": there is none of this name");
    FILE* file = std::fopen(path.c_str(), options.flag("append") ? "a" : "w");
    if (!file) refuse("--csv " + path + ": cannot be written");
    if (!options.flag("append"))
      std::fputs("scene,real,method,us_per_step,ratio_to_si30,gap_max_m,tip_error_m,energy_drift,"
                 "held,of,status\n", file);
    for (const Entry& entry : list) measure(file, entry, options.count("repetitions", 1));
    std::fclose(file);
  });
}
