// Chapter 6's program.
#include "chapters/06_baumgarte/program.h"
#include "engine/program.h"

using namespace joints;

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("Chapter 6", {{"iterations", "30", "sweeps a step"}});
    if (!options.read(argc, argv)) return;
    std::vector<Summary> lines;
    chapter6::one_joint({}, lines);
    chapter6::many_joints({}, lines);
  });
}
