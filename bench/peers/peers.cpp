// The published engines and our own solvers on the same scenes, in one run: `./wb bench --peers`.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "bench/named.h"
#include "bench/peers/entries.h"
#include "bench/peers/peer.h"
#include "bench/start.h"
#include "engine/instruments/options.h"

using namespace joints;
using namespace joints::bench;

namespace {

// ---- who runs -----------------------------------------------------------------------------------

// One line of the table to be.
struct Contender {
  PeerSetting who;
  Setting setting;
  bool ours = false;
  Result result{};
  double own_start = std::numeric_limits<double>::quiet_NaN();  // error of the tip [m]
  StepClock clock{StepClock::Time::thread};
  double bytes = 0;
};

std::vector<Contender> contenders(const PeerEntry& entry, bool quick, bool search) {
  std::vector<Contender> out;
  const PeerScene scene = peer_scene(entry.make().world);
  std::string ours = entry.ours + tree_methods(entry.make);
  if (ours.ends_with("tree-rk4")) ours += " tree-rk4/4";  // as one of MuJoCo's has 4 substeps
  for (const std::string& word : words(ours))
    out.push_back({{.engine = "ours", .version = "",
                    .number = sizeof(real) == 8 ? "double" : "float", .name = word},
                   setting_named(word), true});
  for (const PeerSetting& peer : peer_settings(search))
    if (peer.takes(scene) && !peer.swept && (!quick || peer.quick) &&
        (!peer.slow || entry.slow || scene.joints.size() < 200) && (!entry.basic || peer.basic))
      out.push_back({peer, peer.setting()});
  for (Contender& one : out) one.setting.differences = true;
  return out;
}

// What a world takes of the heap, with all that its solver keeps, after a few steps. Of ours the
// bodies and joints count; a peer has its own.
double bytes_of(const PeerEntry& entry, const Contender& one) {
  one.setting.make();  // the world of the last run goes
  const double empty = bytes_in_use();
  BenchScene scene = entry.make();
  scene.marks = {};
  const double made = bytes_in_use();
  if (one.setting.prepare) one.setting.prepare(scene.world);
  const Step step = one.setting.make();
  for (int k = 0; k < 3; ++k) step(scene.world, entry.span.h);
  return std::max(0.0, bytes_in_use() - (one.ours ? empty : made));
}

constexpr double most_us = 2.5e5;  // of a round of one contender
constexpr int untimed = 20;        // steps of a run

// A round: each in turn, so that what else runs meanwhile disturbs all alike.
void time_round(const PeerEntry& entry, std::vector<Contender>& all) {
  for (Contender& one : all) {
    const double us = std::max(1.0, one.result.us_per_step);
    Span span = entry.span;
    if (!entry.falls)
      span.steps = std::min(span.steps, untimed + std::clamp(int(most_us / us) - untimed, 5,
                                                             span.timed));
    time_steps(one.clock, entry.make, one.setting, span);
  }
}

// ---- the table ----------------------------------------------------------------------------------

void write(FILE* file, const PeerEntry& entry, const Contender& one, const std::string& machine) {
  const BenchScene scene = entry.make();
  const Result& is = one.result;
  const double us = one.clock.median_us();
  const double spread = (one.clock.quantile_us(0.75) - one.clock.quantile_us(0.25)) / us;
  std::fprintf(file, "%s,%s,%s,%s,%s,%.4g,%.3f", one.who.engine.c_str(), one.who.version.c_str(),
               one.who.number.c_str(), entry.name.c_str(), one.who.name.c_str(), us, spread);
  std::fprintf(file, "%s%s,%s,%s,%zu%s\n", measure_cells(scene, is).c_str(),
               cell(one.bytes).c_str(), is.status.c_str(), machine.c_str(), scene.marks.size(),
               cell(one.own_start, is.status != "nan").c_str());
}

void measure(FILE* file, const PeerEntry& entry, const Options& options) {
  const bool search = options.flag("search");
  std::vector<Contender> all = contenders(entry, options.flag("quick"), search);
  const std::string only = options.text("engine");
  std::erase_if(all, [&](const Contender& one) { return !only.empty() && one.who.engine != only; });
  for (Contender& one : all) {
    std::fprintf(stderr, "%s, %s, %s\n", entry.name.c_str(), one.who.engine.c_str(),
                 one.who.name.c_str());
    if (const BenchScene scene = entry.make(); scene.tip_mask != glm::dvec3(0)) {
      const int steps = int(std::lround(scene.tip_time / double(entry.span.h)));
      one.own_start =
          run(entry.make, one.setting, 1, {.h = entry.span.h, .steps = steps}).tip_error;
    }
    one.setting = with_same_start(one.setting);
    one.result = run(entry.make, one.setting, 1, entry.span);
    one.bytes = bytes_of(entry, one);
  }
  const bool large = all.front().result.us_per_step > most_us / 10;
  const int rounds = large || entry.falls ? 1 : options.count("rounds", 1);
  for (int n = 1; n <= rounds; ++n) {
    std::fprintf(stderr, "%s, round %d of %d\n", entry.name.c_str(), n, rounds);
    time_round(entry, all);
  }
  for (const Contender& one : all) write(file, entry, one, options.text("machine"));
  std::fflush(file);
}

}  // namespace

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("The published engines and our solvers on the same scenes",
                    {{"csv", "out/peers.csv", "the table"},
                     {"append", "0", "1: add lines to the table that is there"},
                     {"quick", "0", "1: fewer scenes and settings"},
                     {"search", "0", "1: many settings of the engines, to find their best"},
                     {"scene", "", "one scene alone, by its name in the table"},
                     {"engine", "", "one engine alone, by its name in the table"},
                     {"machine", "", "what stands in the last column"},
                     {"rounds", "3", "how often each is timed"}});
    if (!options.read(argc, argv)) return;
    std::vector<PeerEntry> list = peer_entries(options.flag("quick"));
    keep_named(list, options.text("scene"), &PeerEntry::name);
    FILE* file = open_table(options.text("csv"), options.flag("append"),
                            "engine,version,real,scene,setting,us_per_step,spread," +
                                measure_columns + ",bytes,status,machine,joints,tip_own_start_m");
    for (const PeerEntry& entry : list) measure(file, entry, options);
    std::fclose(file);
  });
}
