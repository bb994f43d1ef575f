// Every method on every kind of scene, in one run: time, gap, tip, energy, what the scene is for,
// and how many scenes of a random family hold. `./wb bench --methods` calls it.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bench/chapters/09_direct/linkages.h"
#include "bench/named.h"
#include "bench/random_chains.h"
#include "bench/tasks.h"
#include "bench/trajectory.h"
#include "engine/instruments/options.h"

using namespace joints;
using namespace joints::bench;

namespace {

const std::string iterated = "si30 beta1 4x8 16x2 warm projection split relax omega";

// A scene, or several of a kind that are told in one line. Scenes whose names end in ": " and a
// value are the columns of a map: one number changes, all else stays.
struct Entry {
  std::string name{};
  std::vector<MakeScene> makes{};
  Span span{.steps = 300, .timed = 80};
  double holds = 0;  // a run holds if its largest gap is below this [m]; 0: if its status is ok
  std::string methods = iterated + " velocity shake rk4";
  bool large = false;  // each step is timed at most three times
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
  const std::string both = iterated + " velocity shake inertia velocity/8 shake/8 inertia/8",
                    few = "si30 velocity shake",
                    many = "si30 rows10 lanes10 velocity shake inertia",
                    next_door = " xpbd nncg cg cg-exact";
  const Span ten_seconds{.steps = 600, .timed = 80}, one_second{.steps = 60, .timed = 60};
  std::vector<Entry> list = {
      {.name = "S1", .makes = {[] { return cubes_on_hinges(10, 100); }},
       .methods = both + " rk4 lanes10 lanes chapter7 textbook" + next_door},
      {.name = "S1b", .makes = {[] { return cubes_on_balls(10, 100); }}},
      {.name = "S5", .makes = {[] { return cubes_on_hinges(1, 4); }},
       .methods = iterated + " velocity shake rk4" + next_door},
      {.name = "chain of 20", .makes = {[] { return cubes_on_hinges(1, 20); }},
       .methods = both + next_door},
      {.name = "S6", .makes = {loaded_axes}},
      {.name = "S7", .makes = {sideways_gravity}, .span = ten_seconds, .methods = both},
      {.name = "S3", .makes = {[] { return hanging_bridge(true); }}, .methods = both},
      {.name = "S3b", .makes = {rope_bridge}, .span = ten_seconds, .methods = both},
      {.name = "hung 10", .makes = {[] { return hung_chain(10, 100); }}, .span = ten_seconds,
       .methods = both},
      {.name = "hung 10 with 1 t", .makes = {[] { return hung_chain(10, 1000); }},
       .span = ten_seconds, .methods = both},
      {.name = "arm", .makes = {arm}, .span = one_second, .methods = both + " plain placed"},
      {.name = "motor", .makes = {driven_crane}, .span = one_second,
       .methods = both + " plain placed"},
      {.name = "limit", .makes = {stopped_crane}, .span = ten_seconds, .methods = both},
      {.name = "planks", .makes = {loaded_planks}, .span = ten_seconds, .methods = both},
      {.name = "ragdoll", .makes = {[] { return ragdolls(1); }}, .span = ten_seconds,
       .methods = both},
      {.name = "chains with limits", .makes = {[] { return limited_chains(10, 10, 1); }},
       .methods = many},
      {.name = "chain of 1000", .makes = {[] { return cubes_on_hinges(1, 1001); }},
       .methods = few},
      {.name = "beam of 10", .makes = {[] { return welded_beam(10); }}, .methods = both},
      {.name = "beam of 20", .makes = {[] { return welded_beam(20); }}, .methods = both},
      {.name = "net 6x6", .makes = {of_chapter_9([] { return chapter9::net(6); })},
       .methods = both},
      {.name = "four-bars 10", .makes = {of_chapter_9([] { return chapter9::four_bars(10); })},
       .methods = few},
      {.name = "four-bars 40", .makes = {of_chapter_9([] { return chapter9::four_bars(40); })},
       .methods = few},
      {.name = "Bricard", .makes = {of_chapter_9(chapter9::bricard)},
       .span = {.h = real(1) / 240, .steps = 2400, .timed = 200}, .methods = few}};
  for (const int count : {50, 500, 5000})
    if (!quick || count < 5000)
      list.push_back({.name = "ragdolls " + std::to_string(count),
                      .makes = {[=] { return random_ragdolls(count, 1); }},
                      .span = {.steps = count < 5000 ? 180 : 90, .timed = count < 5000 ? 120 : 60},
                      .methods = count < 5000 ? many : "si30 rows10 lanes10 velocity",
                      .large = count == 5000});
  for (const int bodies : {100, 1000, 20000})
    if (!quick || bodies < 20000)
      list.push_back({.name = "mixed islands " + std::to_string(bodies),
                      .makes = {[=] { return mixed_islands(bodies, 1); }},
                      .span = {.steps = bodies < 20000 ? 120 : 60,
                               .timed = bodies < 20000 ? 120 : 30},
                      .methods = many, .large = bodies == 20000});
  for (const int arms : {12, 40, 100})
    list.push_back({.name = "star of " + std::to_string(arms),
                    .makes = {of_chapter_9([=] { return chapter9::star(arms); })},
                    .methods = "si30 velocity"});
  for (const int exponent : {1, 2, 3, 4, 5, 6})
    list.push_back({.name = "heavy end: 1e" + std::to_string(exponent),
                    .makes = {[=] { return heavy_end_unreferenced(std::pow(10, exponent)); }},
                    .span = ten_seconds, .methods = both + next_door});
  for (const double inertia : {0.5, 5.0, 50.0, 500.0, 5000.0}) {
    char number[32];
    std::snprintf(number, sizeof number, "%g", inertia);
    list.push_back({.name = std::string("m r^2/I: ") + number,
                    .makes = {[=] { return beads(inertia); }}, .span = ten_seconds,
                    .methods = both});
  }
  for (const int cubes : {5, 10, 20, 50, 100})
    list.push_back({.name = "links: " + std::to_string(cubes),
                    .makes = {[=] { return cubes_on_hinges(1, cubes + 1); }}, .methods = both});
  for (const int hertz : {30, 60, 120, 240, 480})
    list.push_back({.name = "steps per s: " + std::to_string(hertz),
                    .makes = {[] { return heavy_end_unreferenced(100); }},
                    .span = {.h = real(1) / real(hertz), .steps = 10 * hertz, .timed = 80},
                    .methods = both});
  for (const int hertz : {20, 60, 200, 1000})
    list.push_back({.name = "springs in Hz: " + std::to_string(hertz),
                    .makes = {[=] { return sprung_chain(10, hertz); }}, .span = ten_seconds,
                    .methods = both});
  for (const int chains : {1, 10, 100, 1000})
    if (!quick || chains < 100)
      list.push_back({.name = std::to_string(99 * chains) + " hinges",
                      .makes = {[=] { return cubes_on_hinges(chains, 100); }},
                      .span = {.steps = chains < 100 ? 120 : 30, .timed = chains < 100 ? 120 : 30},
                      .methods = few});
  for (const bool tree : {false, true})
    for (const int exponent : {0, 2, 4, 6}) {
      Entry entry{.name = std::string(tree ? "random trees" : "random chains") + " 1e" +
                          std::to_string(exponent),
                  .span = {.steps = 600}, .holds = tree ? 0.1 : 1e-3, .methods = both};
      for (unsigned seed = 1; seed <= (quick ? 4u : 24u); ++seed)
        entry.makes.push_back([=] {
          const double ratio = std::pow(10, exponent);
          return tree ? random_tree(seed, ratio) : random_chain(seed, ratio);
        });
      list.push_back(entry);
    }
  return list;
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
  raise(out.worst.gap_rms, result.gap_rms);
  raise(out.worst.gap_max, result.gap_max);
  raise(out.worst.axis_error, result.axis_error);
  raise(out.worst.sideways, result.sideways);
  raise(out.worst.tip_error, result.tip_error);
  raise(out.worst.energy_peak, result.energy_peak);
  if (std::abs(result.energy_drift) > std::abs(out.worst.energy_drift) || !result.finite)
    out.worst.energy_drift = result.energy_drift;
  const bool ok = result.status == "ok";
  if (!ok && out.worst.status == "ok") out.worst.status = result.status;
  out.held += holds > 0 ? result.gap_max < holds : ok;
}

// The number below which this fraction of them lies.
double quantile(std::vector<double> numbers, double share) {
  if (numbers.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(numbers.begin(), numbers.end());
  return numbers[std::size_t(share * double(numbers.size() - 1) + 0.5)];
}
double median(const std::vector<double>& numbers) { return quantile(numbers, 0.5); }

// One joint and iteration of the textbook's loop [us]: the unit in which times can be carried from
// machine to machine.
double textbook_iteration() {
  const MakeScene make = [] { return cubes_on_hinges(10, 100); };
  return time_of_step(make, setting_named("textbook"), {.steps = 120}) / 30 /
         double(make().world.joints().size());
}

void measure(FILE* file, const Entry& entry, int repetitions, double unit) {
  const std::vector<std::string> methods = words(entry.methods);
  std::vector<Outcome> outcomes(methods.size());
  for (std::size_t m = 0; m < methods.size(); ++m) {
    std::fprintf(stderr, "%s, %s\n", entry.name.c_str(), methods[m].c_str());
    for (const MakeScene& make : entry.makes)
      add(outcomes[m], run(make, setting_named(methods[m]), 1, entry.span), entry.holds);
  }
  Span timed = entry.span;  // the methods in turn, so that what else runs disturbs all alike
  timed.steps = std::min(timed.steps, timed.timed);
  for (int n = 0; n < (entry.large ? std::min(repetitions, 3) : repetitions); ++n)
    for (std::size_t m = 0; m < methods.size(); ++m)
      outcomes[m].us.push_back(time_of_step(entry.makes.front(), setting_named(methods[m]), timed));
  double si30 = 0;
  for (std::size_t m = 0; m < methods.size(); ++m)
    if (methods[m] == "si30") si30 = median(outcomes[m].us);
  const BenchScene scene = entry.makes.front()();
  const double joints = double(scene.world.joints().size());
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const Result& worst = outcomes[m].worst;
    const double us = median(outcomes[m].us);
    const double spread = (quantile(outcomes[m].us, 0.75) - quantile(outcomes[m].us, 0.25)) / us;
    std::fprintf(file, "%s,%s,%s,%.0f,%.4f,%.3f,%.4f,%.4f", entry.name.c_str(),
                 sizeof(real) == 8 ? "double" : "float", methods[m].c_str(), joints, us, spread,
                 us / si30, us / joints / unit);
    std::fprintf(file, "%s,%d,%zu,%s\n", measure_cells(scene, worst).c_str(), outcomes[m].held,
                 entry.makes.size(), worst.status.c_str());
    std::fflush(file);
  }
}

const std::string followed_methods = "si30 4x8 16x2 velocity shake inertia velocity/8";

// Every method's distance from a reference of the scene, and the range of what it finds. Of several
// scenes of a kind, of which the first three are followed: the times and errors are medians.
void follow(FILE* file, const Entry& entry, double patience) {
  const double seconds = entry.span.steps * double(entry.span.h);
  const std::size_t draws = std::min<std::size_t>(entry.makes.size(), 3);
  std::vector<KnownMotion> motions;
  std::vector<double> until, agree, grown;
  const char* const kinds[] = {"followed", "chaotic", "given up", "hurried"};
  int count[4] = {};
  for (std::size_t k = 0; k < draws; ++k) {
    std::fprintf(stderr, "%s, reference %zu\n", entry.name.c_str(), k + 1);
    motions.push_back(motion_of(entry.makes[k], entry.span, patience));
    until.push_back(motions[k].until), grown.push_back(motions[k].grown);
    agree.push_back(motions[k].agree_first);
    for (int n = 0; n < 4; ++n) count[n] += motions[k].kind(seconds) == kinds[n];
  }
  const BenchScene scene = entry.makes.front()();
  for (const std::string& method : words(entry.methods)) {
    std::fprintf(stderr, "%s, %s\n", entry.name.c_str(), method.c_str());
    std::vector<double> first, all;
    Astray last;
    for (std::size_t k = 0; k < draws; ++k) {
      last = astray(entry.makes[k], setting_named(method), entry.span, motions[k], !entry.large);
      first.push_back(last.first), all.push_back(last.all);
    }
    if (last.refused) continue;
    std::fprintf(file, "%s,%s,%s,%s,%.6g,%zu,%d,%d,%d,%d", entry.name.c_str(),
                 sizeof(real) == 8 ? "double" : "float", method.c_str(),
                 motions.front().roads.c_str(), seconds, draws, count[0], count[1], count[2],
                 count[3]);
    std::fprintf(file, "%s%s%s", cell(median(until)).c_str(), cell(median(agree)).c_str(),
                 cell(median(grown)).c_str());
    std::fprintf(file, "%s%s,%s%s%s%s\n", cell(median(first)).c_str(), cell(median(all)).c_str(),
                 scene.finding.what.c_str(),
                 cell(scene.finding.expected, !scene.finding.what.empty()).c_str(),
                 cell(last.found).c_str(), cell(last.range).c_str());
    std::fflush(file);
  }
}

}  // namespace

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("Every method on every kind of scene",
                    {{"csv", "out/methods.csv", "the table"},
                     {"followed", "0", "1: no times, but distances from references of the motion"},
                     {"patience", "300", "processor time of a reference, about [s]"},
                     {"append", "0", "1: add lines to the table that is there"},
                     {"quick", "0", "1: fewer random scenes, no large ones"},
                     {"scene", "", "one scene alone, by its name in the table"},
                     {"methods", "", "these alone, by their words; ratios need si30"},
                     {"repetitions", "5", "how often each step is timed"}});
    if (!options.read(argc, argv)) return;
    std::vector<Entry> list = scenes(options.flag("quick"));
    keep_named(list, options.text("scene"), &Entry::name);
    const bool followed = options.flag("followed");
    FILE* file = open_table(
        options.text("csv"), options.flag("append"),
        followed ? "scene,real,method,roads,seconds,draws,followed,chaotic,given_up,hurried,"
                   "until_s,agree_m,grown_m,first_second_m,distance_m,finding,expected,found,range"
                 : "scene,real,method,joints,us_per_step,spread,ratio_to_si30,"
                   "textbook_iterations," + measure_columns + ",held,of,status");
    if (!options.text("methods").empty())
      for (Entry& entry : list) entry.methods = options.text("methods");
    else
      for (Entry& entry : list)
        entry.methods = (followed ? followed_methods : entry.methods) +
                        tree_methods(entry.makes.front());
    const double unit = followed ? 0 : textbook_iteration();
    for (const Entry& entry : list)
      if (followed) follow(file, entry, options.number("patience", 0));
      else measure(file, entry, options.count("repetitions", 1), unit);
    std::fclose(file);
  });
}
