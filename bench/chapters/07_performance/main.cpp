// The experiments of chapter 7: orders, over-relaxation, colours, and the numbers of the questions.
#include "bench/chapters/07_performance/experiments.h"
#include "engine/instruments/options.h"

using namespace joints;
using namespace joints::chapter7;

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("Chapter 7: the order of the joints, over-relaxation, colours",
                    {{"iterations", "30", "iterations per step"},
                     {"beta", "0.2", "fraction of the error fed back per step [1]"},
                     {"seconds", "5", "how long the scenes run [s]"}});
    if (!options.read(argc, argv)) return;
    Choice choice{.iterations = options.count("iterations", 1),
                  .beta = real(options.number("beta", 0)),
                  .seconds = options.number("seconds", 0.1), .out = options.text("out")};
    relaxation(choice);
    colours(choice);
    needed(choice);
    at_once(choice);
  });
}
