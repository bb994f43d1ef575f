// The inner loop in six variants on the thesis' performance scene: what a joint and sweep costs in
// each, all in one run. `./wb bench --loop` calls it.
#include <cstdio>

#include "bench/runner.h"
#include "bench/textbook.h"
#include "chapters/03_hinge/hinge_joint.h"
#include "engine/program.h"
#include "engine/sequential_impulses.h"
#include "engine/wide.h"

using namespace joints;
using namespace joints::bench;

namespace {

// A variant: its scene, its solver, and what it needs to be told of the joints.
struct Variant {
  std::string name;
  std::function<Scene(int chains)> scene;
  std::function<Step(int iterations)> solver;
  bool whole = true;  // the joints' rows in one block
};

Scene in_chain_order(int chains) { return cubes_on_hinges(chains, 100); }

// The same joints, but the first of every chain, then the second of every chain, and so on: then
// the processor need not wait for one joint before it begins with the next.
Scene interleaved(int chains) {
  Scene scene = cubes_on_hinges(chains, 100);
  World world;
  std::vector<BodyId> ids;
  for (int slot = 0; slot < scene.world.bodies.slots(); ++slot)
    ids.push_back(world.add(scene.world.bodies.at(slot)));
  for (int i = 1; i < 100; ++i)
    for (int c = 0; c < chains; ++c) {
      const BodyId a = ids[std::size_t(100 * c + i - 1)], b = ids[std::size_t(100 * c + i)];
      world.add<HingeJoint>(world.bodies, a, b, world.bodies[a].x, vec3(1, 0, 0));
    }
  scene.world = std::move(world);
  return scene;
}

Step textbook(int iterations, bool recompute) {
  auto solver = std::make_shared<TextbookSolver>();
  solver->iterations = iterations;
  solver->recompute = recompute;
  return [solver](World& world, real h) {
    if (solver->joints.empty())
      for (const auto& joint : world.joints()) {
        Body &a = world.bodies[joint->body1], &b = world.bodies[joint->body2];
        solver->joints.push_back(
            std::make_unique<TextbookHinge>(a, b, a.x, vec3(1, 0, 0), joint->beta));
      }
    solver->step(world, h);
  };
}

Step scalar(int iterations) {
  SequentialImpulses solver;
  solver.iterations = iterations;
  return [solver](World& world, real h) mutable { solver.step(world, h); };
}

Step lanes(int iterations, Packing packing) {
  WideImpulses solver;
  solver.iterations = iterations;
  solver.packing = packing;
  return [solver](World& world, real h) mutable { solver.step(world, h); };
}

std::vector<Variant> variants() {
  return {{"recomputed", in_chain_order, [](int n) { return textbook(n, true); }},
          {"textbook", in_chain_order, [](int n) { return textbook(n, false); }},
          {"flat", in_chain_order, scalar, false},
          {"whole-joint", in_chain_order, scalar},
          {"interleaved", interleaved, scalar},
          {"lanes", in_chain_order, [](int n) { return lanes(n, Packing::trees); }},
          {"lanes, coloured", in_chain_order, [](int n) { return lanes(n, Packing::colours); }}};
}

void measure(FILE* file, const Variant& variant, int chains, int repetitions) {
  const int counts[] = {10, 30};
  Result results[2];
  for (int k = 0; k < 2; ++k) {
    const int iterations = counts[k];
    Setting setting{"", variant.name, iterations, false, {}, {}};
    setting.make = [&] { return variant.solver(iterations); };
    setting.prepare = [&](World& world) {
      for (const auto& joint : world.joints())
        static_cast<HingeJoint&>(*joint).whole = variant.whole;
    };
    results[k] = run([&] { return variant.scene(chains); }, setting, repetitions);
  }
  const double ns = 1000 * (results[1].us_per_step - results[0].us_per_step) /
                    (99.0 * chains * (counts[1] - counts[0]));
  for (int k = 0; k < 2; ++k)
    std::fprintf(file, "\"%s\",%d,%d,%s,%.4f,%.3f,,%.8g\n", variant.name.c_str(), chains,
                 counts[k], sizeof(real) == 8 ? "double" : "float", results[k].us_per_step, ns,
                 results[k].gap_rms);
  std::fprintf(stderr, "%s, %d chains: %.2f ns a joint and sweep\n", variant.name.c_str(), chains,
               ns);
}

}  // namespace

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("The inner loop in its variants",
                    {{"csv", "out/loop.csv", "the table"},
                     {"append", "0", "1: add lines to the table that is there"},
                     {"repetitions", "5", "how often each run is timed"}});
    if (!options.read(argc, argv)) return;
    const bool append = options.count("append", 0) != 0;
    const std::string path = options.text("csv");
    FILE* file = std::fopen(path.c_str(), append ? "a" : "w");
    if (!file) refuse("--csv " + path + ": cannot be written");
    if (!append)
      std::fputs("variant,chains,iterations,real,us_per_step,ns_per_joint_iteration,"
                 "instructions_per_joint_iteration,gap_rms_m\n", file);
    for (const Variant& variant : variants())
      for (const int chains : {10, 20})
        measure(file, variant, chains, options.count("repetitions", 1));
    std::fclose(file);
  });
}
