// What a joint costs as a scene grows: chains of a hundred cubes, from one to a thousand of them,
// time and memory. `./wb bench` calls it.
#include <algorithm>
#include <cstdio>

#include "bench/named.h"
#include "engine/instruments/options.h"

using namespace joints;
using namespace joints::bench;

namespace {

constexpr int length = 100;  // bodies of a chain

// A solver; `least` is how many chains it needs to be what its name says.
struct Candidate {
  std::string name, setting;
  Way way;
  int least = 1;
};

std::vector<Candidate> candidates() {
  return {
      {"textbook", "one at a time", {.loop = Loop::textbook}},
      {"engine rows", "one at a time", {.loop = Loop::rows}},
      {"packed", "one at a time", {.loop = Loop::packed}},
      {"lanes", "islands", {.loop = Loop::lanes}, 10},  // of one island seven lanes would be idle
      {"lanes", "colours", {.loop = Loop::lanes, .packing = Packing::colours}}};
}

// What one size and number of iterations takes.
struct Seen {
  double us = 0, bytes = 0;
};

// Bodies, joints and the memory of the solver: made, run, and counted.
Seen look(const Candidate& candidate, int chains, int iterations, int repetitions) {
  const double before = bytes_in_use();
  Seen seen;
  BenchScene scene = cubes_on_hinges(chains, length);
  scene.marks = {};  // they are the measure's
  const Setting setting = candidate.way.setting(iterations);
  setting.prepare(scene.world);
  const Step step = setting.make();
  const real h = real(1) / 60;
  const double joints = double(chains) * (length - 1);
  const int steps = std::clamp(int(3e6 / (joints * iterations)), 7, 200) * repetitions;
  for (int k = 0; k < 3; ++k) step(scene.world, h);
  seen.bytes = std::max(0.0, bytes_in_use() - before);
  StepClock clock;
  for (int k = 0; k < steps; ++k) clock.time([&] { step(scene.world, h); });
  seen.us = clock.median_us();
  return seen;
}

void measure(FILE* file, const Candidate& candidate, int chains, int repetitions) {
  const double joints = double(chains) * (length - 1);
  std::fprintf(stderr, "%.0f joints, %s, %s\n", joints, candidate.name.c_str(),
               candidate.setting.c_str());
  const Seen few = look(candidate, chains, 10, repetitions),
             many = look(candidate, chains, 30, repetitions);
  const double slope = 1000 * (many.us - few.us) / (joints * 20);
  for (const auto& [iterations, seen] : {std::pair{10, few}, std::pair{30, many}}) {
    std::fprintf(file, "%.0f,%s,%s,%s,%.4f,%.3f,%.3f,", joints, candidate.name.c_str(),
                 candidate.setting.c_str(), sizeof(real) == 8 ? "double" : "float", seen.us, slope,
                 1000 * seen.us / joints);
    if (seen.bytes > 0) std::fprintf(file, "%.1f", seen.bytes / joints);
    std::fprintf(file, ",%d,%d\n", iterations, chains);
  }
}

}  // namespace

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("What a joint costs as a scene grows",
                    {{"csv", "out/scaling.csv", "the table"},
                     {"repetitions", "1", "as many times the steps that each run is timed over"}});
    if (!options.read(argc, argv)) return;
    FILE* file = open_table(options.text("csv"), false,
                            "joints,solver,setting,real,us_per_step,ns_per_joint_iteration,"
                            "ns_per_joint_step,bytes_per_joint,iterations,chains");
    for (const int chains : {1, 10, 101, 1010})
      for (const Candidate& candidate : candidates())
        if (chains >= candidate.least)
          measure(file, candidate, chains, options.count("repetitions", 1));
    std::fclose(file);
  });
}
