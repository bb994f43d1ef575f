// Chapter 5's program: a welded beam, a weld whose anchor is far away, a beam and a sleeve that
// break, and a ragdoll hung by one hand. Read it; there is nothing to edit here.
#include <algorithm>
#include <cstdio>

#include "chapters/05_fixed/program/hung_ragdoll.h"
#include "engine/instruments/options.h"
#include "engine/instruments/rate.h"

using namespace joints;
using namespace joints::chapter5;

namespace {

std::string words(bool whole) { return whole ? "6x6" : "3+3"; }

// ---- a beam of cubes ----------------------------------------------------------------------------

// `n` cubes of 1 kg and 1 m in a row, the first welded to a wall at the origin. Its tip is the
// centre of the last cube.
struct Beam {
  Scene scene{.name = "beam"};
  std::vector<FixedJoint*> welds;
  BodyId tip;

  Beam(int n, const Settings& settings, int iterations, bool whole, bool warm) {
    scene.solver.iterations = iterations;
    scene.stepping.warm_start = warm;
    BodyId before = scene.box(0, vec3(1), vec3(real(-0.5), 0, 0));
    for (int k = 0; k < n; ++k) {
      const vec3 anchor(real(k), 0, 0);
      tip = scene.box(1, vec3(1), anchor + vec3(real(0.5), 0, 0));
      auto& weld = scene.world.add<FixedJoint>(before, tip, anchor);
      weld.beta = settings.beta;
      weld.whole = whole;
      scene.mark(before, tip, anchor);
      scene.energy_scale += 9.81 * (k + 0.5);
      welds.push_back(&weld);
      before = tip;
    }
  }
  double sag() const { return -double(scene.world.bodies[tip].x.y); }
};

// The beam under its own weight: the sag of its tip and the load of the weld at the wall, compared
// with statics. The last two seconds are averaged.
Summary cantilever(const Settings& settings, int iterations, bool whole, bool warm, double rho,
                   CsvFile& table, CsvFile& curves) {
  Beam beam(10, settings, iterations, whole, warm);
  const std::string motion = iterations == settings.iterations && whole == settings.whole && !warm
                                 ? settings.out + "/beam.motion.json"
                                 : "";
  double sag = 0, force = 0, torque = 0;
  int count = 0;
  Summary line =
      play(beam.scene, "", 2 * settings.seconds, motion, [&](double time) {
             if (!warm) curves.row({words(whole)}, {double(iterations), time, beam.sag()});
             if (time < 2 * settings.seconds - 2) return;
             const Reaction wall = beam.welds[0]->load();
             sag += beam.sag();
             force += double(wall.force.y);
             torque += double(wall.torque.z);
             ++count;
           });
  char setting[60];
  std::snprintf(setting, sizeof setting, "%s, %d: sag %.2f m", words(whole).c_str(), iterations,
                sag / count);
  line.setting = setting;
  const double kept = std::pow(rho, iterations);
  table.row({words(whole), warm ? "warm" : "cold"},
            {double(iterations), rho, kept * (1 + double(settings.beta)) < 1 ? 1.0 : 0.0,
             sag / count, force / count, torque / count, 10 * 9.81, 100 * 9.81 / 2});
  return line;
}

// The factor by which an iteration multiplies the error in the long run, by the number of cubes.
void beam_rates(const Settings& settings) {
  CsvFile table(settings.out + "/rates.csv", {"cubes", "rho"});
  for (const int n : {5, 10, 20}) {
    Beam beam(n, settings, 1, true, false);
    table.row({double(n), contraction_rate(beam.scene.world, 100 * n * n)});
  }
}

// ---- a far anchor -------------------------------------------------------------------------------

// A cube of 1 kg welded to a wall at an anchor r metres beside it, hit once: the fraction of the
// error that remains after one more iteration, by formula and measured, and after 30 more.
void far_anchor(const std::string& out) {
  CsvFile table(out + "/anchor.csv",
                {"blocks", "lever_m", "predicted", "measured", "left_after_30"});
  const real h = real(1) / 60;
  for (const bool whole : {false, true})
    for (real r : {real(0.25), real(0.5), real(1), real(2), real(3), real(5), real(10)}) {
      World world;
      world.gravity = vec3(0);
      const BodyId wall = world.add(static_body(vec3(0)));
      const BodyId cube = world.add(box(1, vec3(1), vec3(r, 0, 0)));
      auto& weld = world.add<FixedJoint>(wall, cube, vec3(0));
      weld.whole = whole;
      world.bodies[cube].w = vec3(0, 0, 1);
      SequentialImpulses solver;
      begin_step(world, solver, h);
      std::vector<double> left;
      for (int n = 0; n <= 30; ++n) {
        solver.iterate(world.bodies);
        left.push_back(double(length(world.bodies[cube].v)));
      }
      const double i = 1.0 / 6, lever = double(r);
      table.row({words(whole)}, {lever, lever * lever / (i + lever * lever),
                                 left[9] > 1e-12 ? left[10] / left[9] : 0.0,
                                 left[0] > 1e-12 ? left[30] / left[0] : 0.0});
    }
}

// ---- a beam that breaks -------------------------------------------------------------------------

// Three welded cubes; a force at the tip grows by 20 N per second. A weld bears 150 N m.
Summary breaking(const Settings& settings, CsvFile& table) {
  Beam beam(3, settings, std::max(settings.iterations, 100), settings.whole, false);
  beam.scene.name = "breaking";
  beam.scene.print_plan();
  const Strength strength{.torque = 150};
  Bodies& bodies = beam.scene.world.bodies;
  bool broken = false;
  return play(beam.scene, words(settings.whole), std::min(settings.seconds, 2.8),
              settings.out + "/breaking.motion.json", [&](double time) {
                const double pull = -double(bodies[beam.tip].force.y);
                const Reaction wall = broken ? Reaction{} : beam.welds[0]->load();
                table.row({time, pull, double(wall.force.y), double(wall.torque.z),
                           9 * 9.81 / 2 + 2.5 * pull, double(strength.torque),
                           broken ? 1.0 : 0.0});
                if (!broken && breaks(wall, strength)) {
                  beam.scene.world.remove(*beam.welds[0]);
                  beam.scene.marks.erase(beam.scene.marks.begin());
                  broken = true;
                }
                bodies[beam.tip].force = broken ? vec3(0) : vec3(0, real(-20 * time), 0);
              });
}

// ---- a sleeve that breaks -----------------------------------------------------------------------

// Your sleeve on a slanted shaft carries a cube of 1 kg, half a metre from the seam. It is pulled
// across the shaft, by 20 N more per second, without gravity. The sleeve bears 30 N m.
void breaking_sleeve(const std::string& out) {
  CsvFile table(out + "/sleeve.csv", {"time_s", "pull_n", "sleeve_n", "sleeve_nm", "broken"});
  const vec3 along(real(0.8), real(0.6), 0), across(real(0.6), real(-0.8), 0), seam(0);
  const real h = real(1) / 60;
  Body wall = static_body(seam), cube = box(1, vec3(1), along / real(2));
  const Kit kit{point_at(wall, cube, seam), line_along(wall, cube, seam, along),
                axis_along(wall, cube, along), lock_of(wall, cube)};
  const Strength strength{.torque = 30};
  bool broken = false;
  for (int n = 1; n <= 600 && !broken; ++n) {
    const real pull = 20 * h * real(n);
    cube.force = pull * across;
    integrate_forces(cube, vec3(0), h);
    FourRows rows = sleeve(kit, wall, cube);
    invert_symmetric(rows.K[0].data(), 4);
    Vector<4> rate{}, impulse{};
    for (int i = 0; i < 4; ++i) rate[i] = row_velocity(rows.J[i], wall, cube) + rows.C[i] / h;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) impulse[i] -= rows.K[i][j] * rate[j];
    for (int i = 0; i < 4; ++i) {
      cube.v += cube.inverse_mass * impulse[i] * rows.J[i].v2;
      cube.w += inverse_inertia(cube) * (impulse[i] * rows.J[i].w2);
    }
    const Reaction load = transmitted(rows.J, impulse, h, cube, seam);
    broken = breaks(load, strength);
    table.row({double(h) * n, double(pull), double(length(load.force)),
               double(length(load.torque)), broken ? 1.0 : 0.0});
    integrate_pose(cube, h);
  }
}

// ---- a ragdoll hung by one hand -----------------------------------------------------------------

Summary ragdoll(const Settings& settings) {
  HungRagdoll doll(settings);
  Scene& scene = doll.scene;
  scene.print_plan();
  CsvFile table(settings.out + "/ragdoll.csv", {"time_s", "hand_n", "weight_n"});
  const double weight = doll.mass * 9.81;
  double sum = 0;
  int count = 0;
  Summary line = play(scene, "", settings.seconds, settings.out + "/ragdoll.motion.json",
                      [&](double time) {  // the force of the grip on the arm, upwards
                        const double carried = double(doll.grip->forces()[1]);
                        table.row({time, carried, weight});
                        sum += carried;
                        ++count;
                      });
  char setting[60];
  std::snprintf(setting, sizeof setting, "hand: %.0f N of %.0f N", sum / count, weight);
  line.setting = setting;
  return line;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program([&] {
    Settings settings;
    if (!read(settings, "Chapter 5: a beam, a far anchor, a weld that breaks, a ragdoll", "10",
              "how long the ragdoll hangs; the beam takes twice as long", argc, argv))
      return;

    std::vector<Summary> lines;
    CsvFile table(settings.out + "/cantilever.csv",
                  {"blocks", "start", "iterations", "rho", "warm_safe", "sag_m", "wall_n",
                   "wall_nm", "statics_n", "statics_nm"});
    CsvFile curves(settings.out + "/beam.csv", {"blocks", "iterations", "time_s", "sag_m"});
    std::vector<int> counts{10, 30, 100, 300, 1200};
    if (std::find(counts.begin(), counts.end(), settings.iterations) == counts.end())
      counts.push_back(settings.iterations);
    Beam(10, settings, 1, settings.whole, false).scene.print_plan();
    for (const bool whole : {false, true}) {
      Beam beam(10, settings, 1, whole, false);
      const double rho = contraction_rate(beam.scene.world, 7000);
      for (const bool warm : {false, true})
        for (const int iterations : counts) {
          const Summary line = cantilever(settings, iterations, whole, warm, rho, table, curves);
          if (!warm && iterations <= 100) lines.push_back(line);
        }
    }
    beam_rates(settings);
    far_anchor(settings.out);
    CsvFile breaking_table(settings.out + "/breaking.csv",
                           {"time_s", "pull_n", "wall_n", "wall_nm", "statics_nm", "strength_nm",
                            "broken"});
    lines.push_back(breaking(settings, breaking_table));
    breaking_sleeve(settings.out);
    lines.push_back(ragdoll(settings));
    report(lines, settings.out);
  });
}
