// The experiments of chapter 6: one joint, chains, methods side by side, and the questions.
#include "bench/chapters/06_baumgarte/experiments.h"
#include "engine/instruments/options.h"

using namespace joints;
using namespace joints::chapter6;

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("Chapter 6: drift, energy, chains, methods side by side",
                    {{"iterations", "30", "iterations per step"},
                     {"beta", "0.15", "fraction of the error fed back per step [1]"},
                     {"seconds", "10", "how long a joint moves, chains half as long [s]"}});
    if (!options.read(argc, argv)) return;
    const Choice choice{options.count("iterations", 1), real(options.number("beta", 0)),
                        options.number("seconds", 0.1), options.text("out")};
    std::vector<Summary> lines;
    one_joint(choice, lines);
    in_a_chain(choice);
    many_joints(choice, lines);
    budget(choice);
    hubs(choice);
    between_walls(choice, lines);
    questions(choice);
    report(lines, choice.out + "/experiments");
  });
}
