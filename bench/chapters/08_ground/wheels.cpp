// The wheels drive out and back, slowly and fast.
#include <cstdio>
#include <optional>

#include "bench/chapters/08_ground/experiments.h"
#include "bench/chapters/08_ground/wheels.h"

namespace joints::chapter8 {

namespace {

struct Drive {
  int iterations;   // iterations per step
  real speed;       // of the motors [rad/s]
  real strength;    // of each [N m]
  bool recorded = false, compared = false;  // motion and table; a row of machines.csv
};

// Out for choice.seconds, and as long back.
Summary drive(const Choice& choice, const Drive& how) {
  Choice here = choice;
  here.iterations = how.iterations;
  Wheels wheels(here);
  wheels.drive(how.speed, how.strength);
  if (how.recorded) wheels.scene.print_plan();
  std::optional<CsvFile> table;
  if (how.recorded)
    table.emplace(choice.out + "/wheels.csv",
                  std::initializer_list<const char*>{"time_s", "place_m", "turned_rad", "rolled_m",
                                                     "motor_nm", "gap_m"});
  double deepest = 0, place = 0, rolled = 0;
  int steps = 0, flying = 0;
  Summary line = play(wheels.scene, "", 2 * choice.seconds,
                      how.recorded ? choice.out + "/wheels.motion.json" : "", [&](double time) {
                        const double way = wheels.turned() * Wheels::rolling_radius();
                        deepest = std::max(deepest, penetration(wheels.scene.world));
                        ++steps;
                        flying += wheels.flying();
                        if (time < choice.seconds + double(h) / 2) {
                          place = wheels.place();
                          rolled = way;
                        } else {
                          wheels.drive(-how.speed, how.strength);
                        }
                        if (table)
                          table->row({time, wheels.place(), wheels.turned(), way,
                                      wheels.torque(), widest(wheels.scene)});
                      });
  char setting[40];
  std::snprintf(setting, sizeof setting, "%g rad/s: %.1f m of %.1f", double(how.speed), place,
                rolled);
  line.setting = setting;
  if (!how.compared || how.recorded)
    std::printf("%s: %s rolled; back at %.1f m; %.0f %% in the air\n",
                "wheels", setting, wheels.place(), 100.0 * flying / steps);
  if (how.compared) machine_row(choice, "wheels", how.iterations, line, deepest);
  return line;
}

}  // namespace

void wheels(const Choice& choice, std::vector<Summary>& lines) {
  for (const int iterations : iterations_to_compare(choice))
    drive(choice, {iterations, Wheels::speed, Wheels::strength, false, true});
  const int enough = std::max(choice.iterations, Wheels::iterations);
  lines.push_back(drive(choice, {enough, Wheels::speed, Wheels::strength, true, true}));
  lines.push_back(drive(choice, {enough, 3, 25000}));  // the thesis' speed
}

}  // namespace joints::chapter8
