// The experiments of chapter 8: a box at rest, a loop by hand, drift, the questions, the machines.
#include "bench/chapters/08_ground/experiments.h"
#include "engine/instruments/options.h"

using namespace joints;
using namespace joints::chapter8;

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("Chapter 8: a box at rest, and five machines on the ground",
                    {{"iterations", "30", "iterations per step"},
                     {"beta", "0.2", "fraction of the error fed back per step [1]"},
                     {"seconds", "10", "how long the machines run [s]"},
                     {"machine", "all", "all, none, ragdoll, wheels, cannon, bridge or curl"}});
    if (!options.read(argc, argv)) return;
    const Choice choice{options.count("iterations", 1), real(options.number("beta", 0)),
                        options.number("seconds", 0.1), options.text("out")};
    const std::string machine = options.text("machine");
    const std::vector<std::pair<std::string, void (*)(const Choice&, std::vector<Summary>&)>>
        machines{{"ragdoll", ragdoll}, {"wheels", wheels}, {"cannon", cannon}, {"bridge", bridge},
                 {"curl", curl}};
    bool known = machine == "all" || machine == "none";
    for (const auto& [name, run] : machines) known = known || machine == name;
    require(known, "machine: must be all, none, ragdoll, wheels, cannon, bridge or curl");

    std::vector<Summary> lines;
    if (machine == "all" || machine == "none") {
      rest(choice, lines);
      by_hand(choice);
      drift(choice, lines);
      questions(choice);
    }
    for (const auto& [name, run] : machines)
      if (machine == "all" || machine == name) run(choice, lines);
    report(lines, choice.out + "/experiments");
  });
}
