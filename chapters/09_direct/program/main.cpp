// Chapter 9's program: a chain pulled sideways and a beam, which iterations do not solve, and your
// direct solver does. Read it; there is nothing to edit here.
#include <algorithm>
#include <cstdio>

#include "chapters/09_direct/program/program.h"
#include "chapters/09_direct/program/scenes.h"
#include "engine/instruments/options.h"

namespace joints::chapter9 {

namespace {

std::vector<Method> methods(const Choice& choice) {
  return {{choice.iterations}, {4 * choice.iterations}, {0}};
}

// 100 hinges whose axes all have the direction of the sideways pull.
void sideways(const Choice& choice, std::vector<Summary>& lines) {
  CsvFile table(choice.out + "/sideways.csv", {"method", "time_s", "sideways_m", "gap_m"});
  sideways_chains(1, 101).print_plan();
  for (const Method& method : methods(choice)) {
    Scene scene = sideways_chains(1, 101);
    DirectSolver direct;
    direct.newton = 8;
    double furthest = 0;
    lines.push_back(play(
        scene, method.name(), choice.seconds, "",
        [&](double time) {
          for (const Body& body : all_of(scene.world.bodies))
            furthest = std::max(furthest, std::abs(double(body.x.x)));
          table.row({method.name()}, {time, furthest, widest(scene)});
        },
        steps_of(scene, method, direct)));
    std::printf("%-14s  a cube has gone %.3g m where no hinge lets it go\n",
                method.name().c_str(), furthest);
  }
}

// Twenty welded cubes; the first one is static.
void sagging(const Choice& choice, std::vector<Summary>& lines) {
  CsvFile table(choice.out + "/beam.csv", {"method", "time_s", "sag_m"});
  beam(20).print_plan();
  for (const Method& method : methods(choice)) {
    Scene scene = beam(20);
    DirectSolver direct;
    direct.newton = 8;
    const auto sag = [&] { return 0 - double(all_of(scene.world.bodies).back().x.y); };
    double most = 0;
    lines.push_back(play(
        scene, method.name(), 2 * choice.seconds, "",
        [&](double time) {
          table.row({method.name()}, {time, sag()});
          most = std::max(most, sag());
        },
        steps_of(scene, method, direct)));
    std::printf("%-14s  the tip of the beam sags by up to %.3g m\n", method.name().c_str(), most);
  }
}

void together(const Choice& choice, std::vector<Summary>& lines) {
  sideways(choice, lines);
  sagging(choice, lines);
  Scene left = sideways_chains(1, 31), right = sideways_chains(1, 31);  // for the recording
  DirectSolver direct;
  direct.newton = 8;
  const Method few{choice.iterations};
  record("pulled sideways",
         {{left, steps_of(left, few, direct), few.name()},
          {right, leaps(right, direct), "direct"}},
         vec3(-6, 0, 0), choice.seconds, choice.out + "/sideways.motion.json");
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
    const Choice choice{options.count("iterations", 1), options.number("seconds", 0.1),
                        options.text("out")};
    std::vector<Summary> lines;
    together(choice, lines);
    report(lines, choice.out);
  });
}
