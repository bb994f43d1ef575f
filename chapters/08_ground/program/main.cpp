// Chapter 8's program: bodies that rest, slide and bounce, and the five machines.
// Read it; there is nothing to edit here.
#include "chapters/08_ground/program/program.h"
#include "engine/instruments/options.h"

using namespace joints;
using namespace joints::chapter8;

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("Chapter 8: the ground, and five machines on it",
                    {{"iterations", "30", "iterations per step"},
                     {"beta", "0.2", "fraction of the error fed back per step [1]"},
                     {"seconds", "10", "how long the machines run [s]"},
                     {"machine", "all", "all, none, ragdoll, wheels, cannon, bridge or curl"}});
    if (!options.read(argc, argv)) return;
    const Choice choice{options.count("iterations", 1), real(options.number("beta", 0)),
                        options.number("seconds", 0.1), options.text("machine"),
                        options.text("out")};
    const std::vector<std::pair<std::string, void (*)(const Choice&, std::vector<Summary>&)>>
        machines{{"ragdoll", ragdoll}, {"wheels", wheels}, {"cannon", cannon}, {"bridge", bridge},
                 {"curl", curl}};
    bool known = choice.machine == "all" || choice.machine == "none";
    for (const auto& [name, run] : machines) known = known || choice.machine == name;
    require(known, "machine: must be all, none, ragdoll, wheels, cannon, bridge or curl");

    std::vector<Summary> lines;
    if (choice.machine == "all" || choice.machine == "none") {
      basics(choice, lines);
      by_hand(choice);
      order(choice, lines);
      drift(choice, lines);
      questions(choice);
    }
    for (const auto& [name, run] : machines)
      if (choice.machine == "all" || choice.machine == name) run(choice, lines);
    report(lines, choice.out);
  });
}
