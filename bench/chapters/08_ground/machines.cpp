// The table of all machines.
#include "bench/chapters/08_ground/experiments.h"

namespace joints::chapter8 {

// The file is written anew for each row, so it is complete for any choice of machines.
void machine_row(const Choice& choice, const std::string& machine, int iterations,
                 const Summary& line, double penetration) {
  struct MachineRow {
    std::string machine;
    int iterations;
    Summary line;
    double penetration;
  };
  static std::vector<MachineRow> rows;
  rows.push_back({machine, iterations, line, penetration});
  CsvFile table(choice.out + "/machines.csv",
                {"machine", "iterations", "gap_rms_m", "gap_max_m", "penetration_max_m",
                 "energy_drift"});
  for (const MachineRow& row : rows)
    table.row({row.machine}, {double(row.iterations), row.line.gap_rms, row.line.gap_max,
                              row.penetration, row.line.energy_drift});
}

}  // namespace joints::chapter8
