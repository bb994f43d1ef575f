// Chapter 9's program: a chain pulled sideways and a beam, which iterations do not solve, and your
// direct solver does. Read it; there is nothing to edit here.
#include <algorithm>
#include <cstdio>

#include "chapters/09_direct/program/program.h"
#include "chapters/09_direct/program/scenes.h"
#include "engine/instruments/options.h"

namespace joints::chapter9 {

namespace {

// 100 hinges whose axes all have the direction of the sideways pull.
void sideways(const std::string& out, double seconds, const std::vector<int>& methods,
              std::vector<Summary>& lines) {
  CsvFile table(out + "/sideways.csv", {"method", "time_s", "sideways_m", "gap_m"});
  sideways_chains(1, 101).print_plan();
  for (const int iterations : methods) {
    Scene scene = sideways_chains(1, 101);
    DirectSolver direct = with_positions();
    const std::string name = name_of(iterations);
    double furthest = 0;
    lines.push_back(play(scene, name, seconds, "", [&](double time) {
      for (const Body& body : all_of(scene.world.bodies))
        furthest = std::max(furthest, std::abs(double(body.x.x)));
      table.row({name}, {time, furthest, widest(scene)});
    }, steps_of(scene, iterations, direct)));
    std::printf("%-14s  a cube has gone %.3g m where no hinge lets it go\n", name.c_str(),
                furthest);
  }
}

// Twenty welded cubes; the first one is static.
void sagging(const std::string& out, double seconds, const std::vector<int>& methods,
             std::vector<Summary>& lines) {
  CsvFile table(out + "/beam.csv", {"method", "time_s", "sag_m"});
  beam(20).print_plan();
  for (const int iterations : methods) {
    Scene scene = beam(20);
    DirectSolver direct = with_positions();
    const std::string name = name_of(iterations);
    double most = 0;
    lines.push_back(play(scene, name, seconds, "", [&](double time) {
      const double sag = 0 - double(all_of(scene.world.bodies).back().x.y);
      table.row({name}, {time, sag});
      most = std::max(most, sag);
    }, steps_of(scene, iterations, direct)));
    std::printf("%-14s  the tip of the beam sags by up to %.3g m\n", name.c_str(), most);
  }
}

// Exercises 9.5, 9.8 and 9.7: half the step, a heavy end, and a motor against a limit.
void alone() {
  const auto end_after = [](real h) {
    Scene scene = sideways_chains(1, 4);
    scene.world.gravity.x = 0;
    DirectSolver direct = DirectSolver::velocities_only();
    for (int n = 0; n < steps_in(1, h); ++n) second_order_step(scene.world, direct, h);
    return all_of(scene.world.bodies).back().x;
  };
  const real h = real(1) / 60;
  const vec3 fine = end_after(h / 32);
  std::printf("second_order_step: with half the step the end is off by %.2f of what it was\n",
              double(length(end_after(h / 2) - fine) / length(end_after(h) - fine)));
  for (const real kappa : {real(0), real(8)}) {
    Scene scene = sideways_chains(1, 11);
    Body& end = scene.world.bodies.at(10);
    end.inverse_mass /= 10000, end.inverse_inertia_local /= real(10000);
    DirectSolver direct = with_positions(kappa);
    int halved = 0;
    for (int n = 0; n < 300; ++n) {
      step(scene.world, direct, h, {.leapfrog = true});
      halved += direct.report().halved;
    }
    std::printf("slowed: with kappa %g an end of 10,000 links on nine halves velocities %d times\n",
                double(kappa), halved);
  }
  Scene scene = sideways_chains(1, 2);
  scene.world.gravity = vec3(0);
  auto& hinge = static_cast<HingeJoint&>(*scene.world.joints().front());
  hinge.set_limits(real(-0.1), real(0.1)), hinge.set_motor(2, 50);
  DirectSolver direct = DirectSolver::velocities_only();
  for (int n = 0; n < 60; ++n) step(scene.world, direct, h);
  std::printf("next_side: a motor that pushes against a limit at 0.1 rad stops at %.4f rad\n",
              double(hinge.position(scene.world.bodies)));
}

// Iterations beside the direct solver, recorded.
void side_by_side(const std::string& out, double seconds, int iterations) {
  Scene left = sideways_chains(1, 31), right = sideways_chains(1, 31);
  DirectSolver direct = with_positions();
  record("pulled sideways",
         {{left, steps_of(left, iterations, direct), name_of(iterations)},
          {right, steps_of(right, 0, direct), name_of(0)}},
         vec3(-6, 0, 0), seconds, out + "/sideways.motion.json");
}

}  // namespace
}  // namespace joints::chapter9

using namespace joints;
using namespace joints::chapter9;

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("Chapter 9: the direct solver beside iterations",
                    {{"iterations", "30", "iterations per step, for the comparison"},
                     {"seconds", "5", "how long the chain is pulled, the beam twice as long [s]"}});
    if (!options.read(argc, argv)) return;
    const int iterations = options.count("iterations", 1);
    const double seconds = options.number("seconds", 0.1);
    const std::string out = options.text("out");
    const std::vector<int> methods = {iterations, 4 * iterations, 0};
    std::vector<Summary> lines;
    sideways(out, seconds, methods, lines);
    sagging(out, 2 * seconds, methods, lines);
    side_by_side(out, seconds, iterations);
    alone();
    report(lines, out);
  });
}
