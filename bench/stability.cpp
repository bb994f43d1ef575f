// The stability suite: every case, a line for every method and value. `./wb bench --stability`
// calls it.
#include "bench/stability.h"

#include <cmath>
#include <cstdio>

#include "bench/named.h"
#include "engine/instruments/options.h"

using namespace joints;
using namespace joints::bench;

namespace {

const char* const columns =
    "case,method,real,parameter,value,expected,measured,status,gap_rms_m,gap_max_m,energy_drift,"
    "energy_peak,rho,criterion,rho_any";

// A number, or nothing where there is none.
std::string field(double number) {
  char text[40] = "";
  if (std::isfinite(number)) std::snprintf(text, sizeof text, "%.8g", number);
  return text;
}

std::string quoted(const std::string& words) {
  return words.find(',') == std::string::npos ? words : '"' + words + '"';
}

void write(FILE* file, const Line& line) {
  std::fprintf(file, "%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s\n", line.id.c_str(),
               quoted(line.method).c_str(), sizeof(real) == 8 ? "double" : "float",
               quoted(line.parameter).c_str(), field(line.value).c_str(),
               field(line.expected).c_str(), field(line.measured).c_str(), line.status.c_str(),
               field(line.gap_rms).c_str(), field(line.gap_max).c_str(),
               field(line.energy_drift).c_str(), field(line.energy_peak).c_str(),
               field(line.rho).c_str(), field(line.criterion).c_str(),
               field(line.rho_any).c_str());
}

// Every case, and once more by the direct solver where small worlds are watched: the maps (X1 to
// X4) have it among their methods, and X8's box, X15 and X16 are about what is not solved by it.
std::vector<std::pair<Case, bool>> runs() {
  std::vector<std::pair<Case, bool>> out;
  for (const Case& one : cases()) out.push_back({one, false});
  for (const Case& one : cases())
    if (one.watched) out.push_back({one, true});
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("The stability suite",
                    {{"csv", "out/stability.csv", "the table"},
                     {"append", "0", "1: add lines to the table that is there"},
                     {"quick", "0", "1: few values"},
                     {"case", "", "one case only, such as X4"},
                     {"list", "0", "1: only say what the cases are"}});
    if (!options.read(argc, argv)) return;
    if (options.flag("list")) {
      for (const Case& one : cases()) std::printf("%s %s\n", one.id.c_str(), one.what.c_str());
      return;
    }
    const bool quick = options.flag("quick");
    const std::string only = options.text("case");
    bool known = only.empty();
    for (const Case& one : cases()) known = known || one.id == only;
    if (!known) refuse("--case " + only + ": no such case; there are X1 to X17");
    FILE* file = open_table(options.text("csv"), options.flag("append"), columns);
    for (const auto& [one, directly] : runs()) {
      if (!only.empty() && one.id != only) continue;
      Watch::directly = directly;
      one.run(quick, [&, directly = directly](Line line) {
        if (directly) line.method = "direct: " + line.method;
        std::fprintf(stderr, "%s %s, %s %g: %s\n", line.id.c_str(), line.method.c_str(),
                     line.parameter.c_str(), line.value, line.status.c_str());
        write(file, line);
      });
    }
    std::fclose(file);
  });
}
