// Chapter 3's program: doors that are slammed, a motor by hand, a chain that curls up, the motor
// and limit scenes of the published engines, and a chain under sideways gravity.
// Read it; there is nothing to edit here.
#include <algorithm>

#include "chapters/03_hinge/program/door.h"
#include "engine/instruments/options.h"

using namespace joints;
using namespace joints::chapter3;

namespace {

std::string words(bool whole) { return whole ? "whole joint" : "blocks apart"; }

// ---- doors --------------------------------------------------------------------------------------

// Four doors that are pushed open with different speeds.
Summary doors(const Settings& settings, bool whole, CsvFile& table) {
  const std::array<real, 4> speeds{1, 5, 20, 80};
  Scene scene{.name = whole ? "doors" : "doors apart"};
  scene.solver.iterations = settings.iterations;
  std::vector<HingeJoint*> hinges;
  for (int k = 0; k < 4; ++k)
    hinges.push_back(&add_door(scene, vec3(real(2.5) * real(k), 0, 0), speeds[std::size_t(k)],
                               settings, whole));
  scene.print_plan();
  const std::string motion = whole == settings.whole ? settings.out + "/doors.motion.json" : "";
  return play(scene, words(whole), settings.seconds, motion, [&](double time) {
    for (std::size_t k = 0; k < 4; ++k)
      table.row({words(whole)}, {double(settings.iterations), double(speeds[k]), time,
                                 double(hinges[k]->position(scene.world.bodies) / degree)});
  });
}

// ---- a motor, by hand ---------------------------------------------------------------------------

// A rotor of 1 kg m^2 about its axis and a motor of 2 N m with the target 5 rad/s, by the impulse
// of exercise 3.5; and the same if every solve of a step had a separate bound.
void motor_by_hand(const std::string& out) {
  CsvFile table(out + "/motor.csv", {"clamped", "solves", "time_s", "speed_rad_s"});
  const Motor motor{5, 2};
  const real h = real(1) / 60, K = 1;
  for (const std::string clamped : {"sum", "solve"})
    for (int solves : {1, 10, 100}) {
      real speed = 0;
      for (int n = 0; n <= 240; ++n) {
        table.row({clamped}, {double(solves), n * double(h), double(speed)});
        real sum = 0;
        for (int solve = 0; solve < solves; ++solve) {
          if (clamped == "solve") sum = 0;
          speed += K * motor_impulse(speed, K, motor, h, sum);
        }
      }
    }
}

// ---- a chain that curls up ----------------------------------------------------------------------

// Eight cubes of 100 kg that hang one below the other, the first static, each hinged to the centre
// of the previous one. A motor in every hinge bends it, up to 40 degrees.
Summary curl(const Settings& settings) {
  Scene scene{.name = "curl"};
  scene.solver.iterations = settings.iterations;
  CsvFile table(settings.out + "/curl.csv", {"time_s", "joint", "angle_deg", "motor_nm"});
  std::vector<HingeJoint*> hinges;
  BodyId before;
  for (int k = 0; k < 8; ++k) {
    const vec3 place(0, real(-1.5) * real(k), 0);
    const BodyId cube = scene.box(k == 0 ? 0 : 100, vec3(1), place);
    if (k > 0) {
      HingeJoint& joint = hinge(scene, before, cube, place + vec3(0, real(1.5), 0),
                                vec3(0, 0, 1), settings, settings.whole);
      joint.set_limits(0, 40 * degree);
      joint.set_motor(real(0.4), 20000);
      scene.energy_scale += 100 * 9.81 * 1.5 * k;
      hinges.push_back(&joint);
    }
    before = cube;
  }
  scene.print_plan();
  return play(scene, words(settings.whole), settings.seconds, settings.out + "/curl.motion.json",
              [&](double time) {
                for (std::size_t k = 0; k < hinges.size(); ++k)
                  table.row({time, double(k + 1),
                             double(hinges[k]->position(scene.world.bodies) / degree),
                             double(hinges[k]->motor_force())});
              });
}

// ---- motor and limit as the published engines ran them ------------------------------------------

// A static cube and one of 100 kg beside it: S4m drives it round an upright axis with 500 N m to
// 3 rad/s, S4l lets it swing down to a limit of 60 degrees, S4ml drives it into that limit.
void driven(const Settings& settings, const std::string& name, bool whole, int iterations,
            CsvFile& table) {
  Scene scene{.name = name};
  scene.solver.iterations = iterations;
  const BodyId wall = scene.box(0, vec3(1), vec3(0));
  const BodyId cube = scene.box(100, vec3(1), vec3(0, 0, real(1.5)));
  const vec3 axis = name == "S4l" ? vec3(1, 0, 0) : vec3(0, 1, 0);
  HingeJoint& joint = hinge(scene, wall, cube, vec3(0), axis, settings, whole);
  if (name != "S4m") joint.set_limits(-60 * degree, 60 * degree);
  if (name != "S4l") joint.set_motor(3, 500);
  double before = 0, reached = 0, largest = 0, last = 0;
  play(scene, "", 10, "", [&](double time) {
    const double speed = double(joint.speed(scene.world.bodies));
    if (reached == 0 && speed >= 2.85)  // 95 % of the target, between two steps
      reached = time - double(scene.h) * (speed - 2.85) / (speed - before);
    before = speed;
    last = std::abs(double(joint.position(scene.world.bodies) / degree));
    largest = std::max(largest, last);
  });
  const bool limited = name != "S4m";
  table.row({name, words(whole)}, {double(iterations), name == "S4m" ? reached : 0.0,
                                    limited ? largest - 60 : 0.0, limited ? last - 60 : 0.0});
}

// ---- sideways gravity ---------------------------------------------------------------------------

// A chain of 100 cubes whose hinges let it swing in one plane only, under a gravity that pulls it
// out of that plane: how far do its bodies move in this forbidden direction?
Summary sideways(const Settings& settings, bool whole, int iterations, CsvFile& table) {
  Scene scene{.name = "sideways"};
  scene.solver.iterations = iterations;
  scene.world.gravity = vec3(3, real(-9.81), 0);
  BodyId before;
  for (int k = 0; k < 100; ++k) {
    const vec3 place(0, 0, real(1.5) * real(k));
    const BodyId cube = scene.box(k == 0 ? 0 : 100, vec3(1), place);
    if (k > 0) {
      hinge(scene, before, cube, place - vec3(0, 0, real(1.5)), vec3(1, 0, 0), settings, whole);
      scene.energy_scale += 100 * 9.81 * 1.5 * k;
    }
    before = cube;
  }
  double largest = 0;
  const std::string setting = words(whole) + ", " + std::to_string(iterations);
  const Summary line = play(scene, setting, settings.seconds, "", [&](double) {
    for (int slot = 0; slot < 100; ++slot)
      largest = std::max(largest, std::abs(double(scene.world.bodies.at(slot).x.x)));
  });
  table.row({words(whole)}, {double(iterations), largest, line.gap_rms});
  return line;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program([&] {
    Settings settings;
    if (!read(settings, "Chapter 3: doors, a motor by hand, a chain that curls up", "5",
              "how long doors and chains run", argc, argv))
      return;

    std::vector<Summary> lines;
    CsvFile door_table(settings.out + "/door.csv",
                       {"blocks", "iterations", "speed_rad_s", "time_s", "angle_deg"});
    for (bool whole : {false, true}) lines.push_back(doors(settings, whole, door_table));
    motor_by_hand(settings.out);
    lines.push_back(curl(settings));
    CsvFile driven_table(settings.out + "/driven.csv", {"scene", "blocks", "iterations",
                                                        "time_to_target_s", "overshoot_deg",
                                                        "rest_deg"});
    for (const std::string scene : {"S4m", "S4l", "S4ml"})
      for (bool whole : {false, true})
        for (int iterations : {1, 3, 10, 30, 100})
          driven(settings, scene, whole, iterations, driven_table);
    CsvFile sideways_table(settings.out + "/sideways.csv",
                           {"blocks", "iterations", "sideways_m", "gap_rms_m"});
    for (bool whole : {false, true})
      for (int iterations : {10, 30, 100, 300})
        lines.push_back(sideways(settings, whole, iterations, sideways_table));
    report(lines, settings.out);
  });
}
