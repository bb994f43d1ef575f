// Runs every scene of the live page and prints where its bodies are: live_digits STEPS. The page's
// module has to print the same.
#include <cstdio>
#include <cstdlib>

#include "docs/live/run.h"

int main(int, char** arguments) {
  const int steps = std::atoi(arguments[1]);
  for (const joints::live::Entry& entry : joints::live::entries()) {
    joints::live::LiveRun run(entry);
    run.set(run.settings());
    for (int k = 0; k < steps; ++k) run.step();
    std::printf("%s", entry.name);
    for (std::size_t k = 0; k < run.scene().shapes.size(); ++k) {
      const joints::Body& b = run.scene().world.bodies.at(int(k));
      for (const joints::real x : {b.x.x, b.x.y, b.x.z, b.q.w, b.q.x, b.q.y, b.q.z})
        std::printf(" %.17g", double(x));
    }
    for (const double error : run.errors(10)) std::printf(" %.17g", error);
    std::printf(" %.17g\n", run.rate(1000));
  }
}
