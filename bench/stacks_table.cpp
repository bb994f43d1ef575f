// Which stacks stand with which solver and setting. `./wb bench --stacks` calls it.
#include <cstdio>

#include "bench/named.h"
#include "bench/stacks.h"
#include "engine/instruments/options.h"

using namespace joints;
using namespace joints::bench;

namespace {

// What is left out: settings that say no more of a stack than those of its neighbours.
bool runs(const std::string& kind, int count, const std::string& setting) {
  const bool equal = kind == "equal";
  if (kind == "heavy top") return count <= 5 && (setting == "guide" || setting == "finer");
  if (!equal && count > 20) return false;
  if (setting == "taller") return count >= 20 || kind == "overlapping";
  return setting == "guide" || (equal && (setting == "hard" || count >= 20));
}

}  // namespace

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("Which stacks stand for how long",
                    {{"csv", "out/stacks.csv", "the table"},
                     {"append", "0", "1: add lines to the table that is there"},
                     {"kind", "", "one kind alone; drawn: those of seeds"},
                     {"seed", "1", "the first of the drawn stacks"},
                     {"drawn", "100", "how many are drawn"},
                     {"seconds", "60", "duration of a run [s]"}});
    if (!options.read(argc, argv)) return;
    FILE* file = open_table(options.text("csv"), options.flag("append"),
                            "kind,boxes,real,solver,setting,drift_m,sag_m,fastest_m_s,stands,"
                            "us_per_step");
    const double seconds = options.number("seconds", 1);
    std::printf("%-12s %5s %-11s %-7s %11s %9s %9s %7s %8s\n", "kind", "boxes", "solver", "setting",
                "drift [mm]", "sag [mm]", "[m/s]", "stands", "us/step");
    const auto write = [&](const Stack& stack, const char* solver, const char* setting,
                           const Standing& out, int stands) {
      const double us = 1e6 * out.seconds / (60 * seconds);
      std::printf("%-12s %5d %-11s %-7s %11.3g %9.3g %9.3g %7d %8.1f\n", stack.kind.c_str(),
                  stack.count, solver, setting, 1000 * out.drift, 1000 * out.sag, out.fastest,
                  stands, us);
      std::fflush(stdout);
      std::fprintf(file, "%s,%d,%s,%s,%s%s%s%s,%d%s\n", stack.kind.c_str(), stack.count,
                   sizeof(real) == 8 ? "double" : "float", solver, setting, cell(out.drift).c_str(),
                   cell(out.sag).c_str(), cell(out.fastest).c_str(), stands, cell(us).c_str());
    };
    const std::string only = options.text("kind");
    for (const std::string& kind : stack_kinds())
      for (const int count : {2, 3, 5, 10, 20, 30})
        for (const char* solver : {"sequential", "lanes", "direct"})
          for (const char* setting : {"guide", "taller", "finer", "hard"}) {
            if (!runs(kind, count, setting) || (!only.empty() && only != kind)) continue;
            const Standing out = run_stack({kind, count}, solver, setting, seconds);
            write({kind, count}, solver, setting, out, int(out.stands));
          }
    if (!only.empty() && only != "drawn") return void(std::fclose(file));
    const int drawn = options.count("drawn", 0);
    for (const char* solver : {"sequential", "lanes", "direct"})
      for (const char* setting : {"guide", "taller"}) {
        Standing worst;  // of those that stand
        int stand = 0;
        for (int k = 0; k < drawn; ++k) {
          const unsigned seed = unsigned(options.count("seed", 0) + k);
          const Standing out = run_stack(drawn_stack(seed), solver, setting, seconds);
          worst.seconds += out.seconds / drawn;
          if (!out.stands) continue;
          ++stand;
          worst.drift = std::max(worst.drift, out.drift);
          worst.sag = std::max(worst.sag, out.sag);
          worst.fastest = std::max(worst.fastest, out.fastest);
        }
        write({"drawn", drawn}, solver, setting, worst, stand);
      }
    std::fclose(file);
  });
}
