// Chapter 6's program: four pendulums and a hanging chain, moved by your own bias, warm start,
// projection and soft step. Read it; there is nothing to edit here.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <deque>
#include <numbers>

#include "chapters/06_baumgarte/program/chain_loop.h"
#include "chapters/06_baumgarte/program/program.h"
#include "engine/instruments/options.h"
#include "engine/instruments/plan.h"
#include "engine/instruments/scene.h"
#include "joints/ball_joint.h"

using namespace joints;
using namespace joints::chapter6;

namespace {

void print_plan(const std::string& name, int chains, int links, bool warm) {
  Plan plan;
  plan.warm_start = warm;
  plan.bodies = chains * (links + 1);
  plan.static_bodies = chains;
  plan.blocks = chains * links;
  plan.rows = 3 * plan.blocks;
  std::printf("%s: %s\n", name.c_str(), plan.line().c_str());
}

// ---- four pendulums ----------------------------------------------------------------------------

struct Method {
  std::string name;
  real beta;
  int projections;
};

const vec3 bar_size(1, real(0.1), real(0.1));

// A bar of 1 m and 1 kg, released level, its end on a ball joint; and the same in the engine, which
// must move in the same way.
struct Pendulum {
  ChainLoop own;
  World world;
  SequentialImpulses solver;
  StepOptions stepping{};
  BodyId bar;

  Pendulum(const Method& method, const vec3& place, int iterations) {
    const Body wall = static_body(place), body = box(1, bar_size, place + vec3(real(0.5), 0, 0));
    const Point joint = point_at(wall, body, place);
    own.chain = {{wall, body}, {joint}};
    own.settings = {.beta = method.beta, .projections = method.projections,
                    .iterations = iterations};
    const BodyId hook = world.add(wall);
    bar = world.add(body);
    world.add<BallJoint>(hook, bar, joint).beta = method.beta;
    solver.iterations = iterations;
    stepping.projections = method.projections;
  }
  double gap() const { return double(own.gap(0)); }
  // The measurement of the reader's loop.
  Experiment experiment() {
    return {.step = [this] { own.step(h); },
            .bodies = [this] { return std::span<const Body>(own.chain.bodies); },
            .gaps = [this](GapMeter& meter) { meter.add(gap()); },
            .gravity = own.gravity,
            .energy_scale = 9.81 * 0.5};
  }
  double off_engine() const { return double(length(own.chain.bodies[1].x - world.bodies[bar].x)); }
};

void pendulums(const Choice& choice, std::vector<Summary>& lines) {
  char chosen[30];
  std::snprintf(chosen, sizeof chosen, "beta %g", double(choice.beta));
  const std::vector<Method> methods{{"beta 0", 0, 0}, {chosen, choice.beta, 0},
                                    {"beta 1", 1, 0}, {"projection", 0, 1}};
  print_plan("pendulums", int(methods.size()), 1, false);
  CsvFile table(choice.out + "/pendulums.csv",
                {"method", "time_s", "gap_m", "energy_change", "off_engine_m"});
  Motion motion("pendulums", double(h));
  std::deque<Pendulum> all;
  for (std::size_t k = 0; k < methods.size(); ++k) {
    all.emplace_back(methods[k], vec3(0, 0, real(0.6) * real(k)), choice.iterations);
    motion.body({"ball", {0.15, 0.15, 0.15}, methods[k].name});
    motion.body({"box", {bar_size.x, bar_size.y, bar_size.z}});
  }
  std::vector<Run> runs;
  for (Pendulum& pendulum : all) runs.emplace_back(pendulum.experiment());
  std::vector<Body> frame;
  std::vector<Reading> readings;
  for (int n = 0; n <= steps_in(choice.seconds, h); ++n) {
    frame.clear();
    readings.clear();
    for (std::size_t k = 0; k < methods.size(); ++k) {
      Pendulum& pendulum = all[k];
      if (n > 0) {
        runs[k].step();
        step(pendulum.world, pendulum.solver, h, pendulum.stepping);
      }
      table.row({methods[k].name}, {n * double(h), pendulum.gap(),
                                    runs[k].now().energy_drift, pendulum.off_engine()});
      for (const Body& body : pendulum.own.chain.bodies) frame.push_back(body);
      readings.push_back(reading_of(pendulum.experiment(), methods[k].name));
    }
    motion.frame(frame.data(), readings);
  }
  for (std::size_t k = 0; k < methods.size(); ++k)
    lines.push_back({runs[k].measures(), "pendulums", methods[k].name});
  motion.write(choice.out + "/pendulums.motion.json");
}

// ---- a chain that hangs plumb ------------------------------------------------------------------

// Ten cubes of 1 kg, each on a ball joint at the centre of the one before it.
const int links = 10;

ChainLoop cubes(const vec3& along, const Stabilisation& settings) {
  ChainLoop own;
  own.settings = settings;
  for (int k = 0; k <= links; ++k) {
    const vec3 place = real(k) * along;
    own.chain.bodies.push_back(k == 0 ? static_body(place) : box(1, vec3(real(0.4)), place));
    if (k > 0) own.chain.joints.push_back({vec3(0), -along});
  }
  return own;
}

// The sag of the last cube.
void hanging(const Choice& choice) {
  CsvFile table(choice.out + "/hanging.csv", {"start", "iterations", "time_s", "sag_m"});
  for (const bool warm : {false, true}) {
    print_plan("hanging", 1, links, warm);
    for (const int iterations : {4, 10}) {
      ChainLoop own = cubes(vec3(0, -1, 0), {.beta = choice.beta, .warm = warm,
                                             .iterations = iterations});
      const int steps = steps_in(choice.seconds / 2, h);
      for (int n = 0; n <= steps; ++n) {
        if (n > 0) own.step(h);
        table.row({warm ? "warm" : "cold"}, {double(iterations), n * double(h),
                                             -links - double(own.chain.bodies.back().x.y)});
      }
    }
  }
}

// ---- the soft step ------------------------------------------------------------------------------

// The same chain with soft joints: the sag of its end and how far it swings, in the last second.
void soft(const Choice& choice) {
  CsvFile table(choice.out + "/soft.csv", {"substeps", "frequency_hz", "relax", "sag_m", "swing_m",
                                           "predicted_m"});
  const double pi = std::numbers::pi;
  for (const auto& [substeps, frequency] : {std::pair(1, 60), {1, 15}, {4, 60}, {16, 240}})
    for (const int relax : {0, 1}) {
      Chain chain = cubes(vec3(0, -1, 0), {}).chain;
      const SoftStep how{real(frequency), 2, substeps, relax};
      std::vector<vec3> impulses(links, vec3(0));
      double least = 0, most = -1e300;
      const int steps = steps_in(choice.seconds / 2, h);
      for (int n = 1; n <= steps; ++n) {
        soft_step(chain, impulses, how, {0, real(-9.81), 0}, h);
        if (n + 60 < steps) continue;
        const double sag = -links - double(chain.bodies.back().x.y);
        least = n + 60 == steps ? sag : std::min(least, sag);
        most = std::max(most, sag);
      }
      // joint k of n carries n - k + 1 weights; K is 2/m, and 1/m at the wall: n^2 m g in all
      table.row({}, {double(substeps), double(frequency), double(relax), (least + most) / 2,
                     most - least,
                     links * links * 9.81 / (4 * pi * pi * frequency * frequency)});
    }
}

// ---- iterations until the impulses are small ---------------------------------------------------

// A chain that hangs and one that is released level. Each step iterates until no impulse is larger
// than 1/1000 of the largest accumulated impulse.
void stop_early(const Choice& choice) {
  CsvFile table(choice.out + "/early.csv", {"scene", "start", "beta", "iterations_mean",
                                            "iterations_max", "gap_max_m", "gap_end_m"});
  for (const bool level : {false, true})
    for (const auto& [warm, beta] : {std::pair(false, real(0.15)), {true, 0}, {true, real(0.15)}}) {
      ChainLoop own = cubes(level ? vec3(1, 0, 0) : vec3(0, -1, 0),
                            {.beta = beta, .warm = warm, .iterations = 1000,
                             .enough = real(0.001)});
      double sum = 0, most = 0, widest = 0, last = 0;
      const int steps = steps_in(choice.seconds / 2, h);
      for (int n = 0; n < steps; ++n) {
        own.step(h);
        sum += own.iterated();
        most = std::max(most, double(own.iterated()));
        last = 0;
        for (std::size_t k = 0; k < own.chain.joints.size(); ++k)
          last = std::max(last, double(own.gap(k)));
        widest = std::max(widest, last);
      }
      table.row({level ? "swinging" : "hanging", warm ? "warm" : "cold"},
                {double(beta), sum / steps, most, widest, last});
    }
}

}  // namespace

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("Chapter 6: errors fed back, started warm, and projected",
                    {{"iterations", "30", "iterations per step"},
                     {"beta", "0.15", "fraction of the error fed back per step [1]"},
                     {"seconds", "10", "how long the pendulums swing, chains half as long [s]"}});
    if (!options.read(argc, argv)) return;
    const Choice choice{options.count("iterations", 1), real(options.number("beta", 0)),
                        options.number("seconds", 0.1), options.text("out")};
    std::vector<Summary> lines;
    pendulums(choice, lines);
    hanging(choice);
    soft(choice);
    stop_early(choice);
    report(lines, choice.out);
  });
}
