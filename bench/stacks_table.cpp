// Which stacks stand with which solver and setting. `./wb bench --stacks` calls it.
#include <cstdio>

#include "bench/named.h"
#include "bench/stacks.h"
#include "engine/instruments/options.h"

using namespace joints;
using namespace joints::bench;

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("Which stacks stand for how long",
                    {{"csv", "out/stacks.csv", "the table"},
                     {"append", "0", "1: add lines to the table that is there"},
                     {"seconds", "60", "duration of a run [s]"}});
    if (!options.read(argc, argv)) return;
    FILE* file = open_table(options.text("csv"), options.flag("append"),
                            "kind,boxes,real,solver,setting,drift_m,sag_m,fastest_m_s,stands,"
                            "us_per_step");
    const double seconds = options.number("seconds", 1);
    std::printf("%-12s %5s %-11s %-7s %11s %9s %9s %7s %8s\n", "kind", "boxes", "solver", "setting",
                "drift [mm]", "sag [mm]", "[m/s]", "stands", "us/step");
    for (const std::string& kind : stack_kinds())
      for (const int count : {2, 3, 5, 10, 20, 30})
        for (const char* solver : {"sequential", "lanes", "direct"})
          for (const char* setting : {"guide", "finer", "hard"}) {
            const std::string name = setting;
            const bool hard = name == "hard", fine = name == "finer";
            if (kind == "heavy top" && count > 5) continue;
            if (kind != "equal" && (count > 20 || hard)) continue;
            if (kind != "equal" && kind != "heavy top" && fine) continue;
            if (fine && count < 30 && kind == "equal" && count != 20) continue;
            const Standing out = run_stack({kind, count}, solver, setting, seconds);
            const double us = 1e6 * out.seconds / (60 * seconds);
            std::printf("%-12s %5d %-11s %-7s %11.3g %9.3g %9.3g %7d %8.1f\n", kind.c_str(), count,
                        solver, setting, 1000 * out.drift, 1000 * out.sag, out.fastest, out.stands,
                        us);
            std::fflush(stdout);
            std::fprintf(file, "%s,%d,%s,%s,%s%s%s%s,%d%s\n", kind.c_str(), count,
                         sizeof(real) == 8 ? "double" : "float", solver, setting,
                         cell(out.drift).c_str(), cell(out.sag).c_str(), cell(out.fastest).c_str(),
                         int(out.stands), cell(us).c_str());
          }
    std::fclose(file);
  });
}
