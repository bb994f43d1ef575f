// The summary of a program.
#include "engine/instruments/summary.h"

#include <cstdio>

#include "engine/instruments/record.h"

namespace joints {

void report(const std::vector<Summary>& lines, const std::string& folder) {
  CsvFile file(folder + "/summary.csv", {"scene", "setting", "us_per_step", "gap_rms_m",
                                         "gap_max_m", "energy_drift"});
  std::printf("%-12s %-25s %8s %9s %9s %9s\n%46s %9s %9s %9s\n", "scene", "setting", "a step",
              "gap RMS", "gap max", "drift", "[us]", "[mm]", "[mm]", "[1]");
  for (const Summary& line : lines) {
    std::printf("%-12s %-25s %8.2f %9.4g %9.4g %9.3g\n", line.scene.c_str(),
                line.setting.c_str(), line.us_per_step, 1000 * line.gap_rms, 1000 * line.gap_max,
                line.energy_drift);
    file.row({line.scene, line.setting},
             {line.us_per_step, line.gap_rms, line.gap_max, line.energy_drift});
  }
  std::puts("drift: energy at the end less that at the start, by the scene's own scale");
}

}  // namespace joints
