// Bounds: a motor against a limit, and chains of limits.
#include <algorithm>
#include <cstdio>

#include "bench/chapters/09_direct/experiments.h"

namespace joints::chapter9 {

namespace {

// A bar on an upright hinge: its motor turns it to a limit and then pushes against it.
void motor_and_limit(const Choice& choice) {
  CsvFile table(choice.out + "/motor.csv", {"time_s", "angle_rad", "rate_rad_s", "motor_nm",
                                            "limit_nm", "passes"});
  Scene scene{.name = "motor"};
  const BodyId wall = scene.box(0, vec3(real(0.2)), vec3(0));
  const BodyId bar = scene.box(10, vec3(1, real(0.1), real(0.1)), vec3(real(0.5), 0, 0));
  HingeJoint& hinge = on_hinge(scene, wall, bar, vec3(0), vec3(0, 1, 0));
  hinge.set_limits(-1, 1);
  hinge.set_motor(2, 20);
  scene.print_plan();
  DirectSolver direct = with_positions();
  int most = 0;
  play(
      scene, "", 1, "",
      [&](double time) {
        most = std::max(most, direct.report().passes);
        table.row({time, double(hinge.position(scene.world.bodies)),
                   double(hinge.speed(scene.world.bodies)), double(hinge.motor_force()),
                   double(hinge.limit_force()), double(direct.report().passes)});
      },
      leaps(scene, direct));
  std::printf("motor: rests at %.9f rad; motor %+.4f, limit %+.4f N m; %d passes at most\n",
              double(hinge.position(scene.world.bodies)), double(hinge.motor_force()),
              double(hinge.limit_force()), most);
}

// A falling chain whose hinges bend by at most 5 degrees.
void many_limits(const Choice& choice, std::vector<Summary>& lines) {
  CsvFile table(choice.out + "/limits.csv", {"hinges", "passes_mean", "passes_max", "steps",
                                             "steps_with_wrong", "gap_max_m"});
  for (const int hinges : {5, 10, 20, 40, 80}) {
    Scene scene = sideways_chains(1, hinges + 1);
    scene.name = "limits";
    scene.world.gravity = vec3(0, real(-9.81), 0);
    for (const auto& joint : scene.world.joints())
      static_cast<HingeJoint&>(*joint).set_limits(real(-0.0873), real(0.0873));
    DirectSolver direct = with_positions();
    int passes = 0, most = 0, wrong = 0, steps = -1;
    const Summary line = play(
        scene, std::to_string(hinges) + " hinges", choice.seconds, "",
        [&](double) {
          if (++steps == 0) return;
          passes += direct.report().passes;
          most = std::max(most, direct.report().passes);
          wrong += direct.report().wrong > 0;
        },
        leaps(scene, direct));
    lines.push_back(line);
    table.row({double(hinges), double(passes) / steps, double(most), double(steps), double(wrong),
               line.gap_max});
    std::printf("limits in %2d hinges: %.2f passes per step, %d at most; a row on the wrong side "
                "in %d of %d steps\n", hinges, double(passes) / steps, most, wrong, steps);
  }
}

}  // namespace

void bounds(const Choice& choice, std::vector<Summary>& lines) {
  motor_and_limit(choice);
  many_limits(choice, lines);
}

}  // namespace joints::chapter9
