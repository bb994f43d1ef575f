// Chapter 7's program. Read it; there is nothing to edit here.
#include "chapters/07_performance/program/program.h"
#include "engine/instruments/options.h"

using namespace joints;
using namespace joints::chapter7;

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("Chapter 7: the performance loop, step by step",
                    {{"iterations", "30", "iterations per step"},
                     {"beta", "0.2", "fraction of the error fed back per step [1]"},
                     {"seconds", "5", "how long the scenes run [s]"},
                     {"chains", "10", "chains of 100 cubes"}});
    if (!options.read(argc, argv)) return;
    const Choice choice{options.count("iterations", 1), real(options.number("beta", 0)),
                        options.number("seconds", 0.1), options.count("chains", 1),
                        options.text("out")};
    std::vector<Summary> lines;
    steps(choice, lines);
    relaxation(choice);
    colours(choice);
    needed(choice);
    at_once(choice);
    whips(choice, lines);
    report(lines, choice.out);
  });
}
