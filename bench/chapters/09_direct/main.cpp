// The experiments of chapter 9: orders, dependent rows, time, bounds, heavy ends, the questions.
#include "bench/chapters/09_direct/experiments.h"
#include "engine/instruments/options.h"

using namespace joints;
using namespace joints::chapter9;

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("Chapter 9: orders, dependent rows, time, bounds, heavy ends",
                    {{"iterations", "30", "iterations per step, for the comparison"},
                     {"seconds", "5", "how long the scenes run [s]"}});
    if (!options.read(argc, argv)) return;
    const Choice choice{options.count("iterations", 1), options.number("seconds", 0.1),
                        options.text("out")};
    std::vector<Summary> lines;
    order(choice);
    dependent(choice, lines);
    time_steps(choice);
    newton(choice);
    bounds(choice, lines);
    heavy(choice, lines);
    questions(choice);
    report(lines, choice.out + "/experiments");
  });
}
