// The inner loop in its variants on the thesis' performance scene: what a joint and iteration costs
// in each, and what a step takes, all in one run. `./wb bench --loop` calls it.
#include <algorithm>
#include <cstdio>

#include "bench/counted.h"
#include "bench/own_loop.h"
#include "bench/runner.h"
#include "bench/textbook.h"
#include "engine/simd/records.h"
#include "engine/instruments/options.h"
#include "engine/sequential_impulses.h"
#include "engine/step.h"
#include "engine/simd/packed.h"

using namespace joints;
using namespace joints::bench;

namespace {

// ---- the variants -------------------------------------------------------------------------------

// A variant: how its solver is made, and up to how many iterations it is worth the time.
struct Variant {
  std::string name;
  std::function<Setting(int chains, int iterations)> setting;
  int most = 1000;
};

std::vector<TextbookHinge> textbook_hinges(World& world) {
  std::vector<TextbookHinge> hinges;
  for (const auto& joint : world.joints()) {
    Body &a = world.bodies[joint->body1], &b = world.bodies[joint->body2];
    hinges.emplace_back(a, b, a.x, vec3(1, 0, 0), joint->beta);
  }
  return hinges;
}

Setting textbook(int iterations, bool recompute) {
  const auto make = [=]() -> Step {
    auto solver = std::make_shared<TextbookSolver>();
    solver->iterations = iterations;
    solver->recompute = recompute;
    return [solver](World& world, real h) {
      if (solver->joints.empty())
        for (const TextbookHinge& hinge : textbook_hinges(world))
          solver->joints.push_back(std::make_unique<TextbookHinge>(hinge));
      solver->step(world, h);
    };
  };
  return {"", "", iterations, false, make};
}

Setting flat(int iterations) {
  const auto make = [=]() -> Step {
    auto solver = std::make_shared<FlatSolver>();
    solver->iterations = iterations;
    return [solver](World& world, real h) {
      if (solver->hinges.empty()) solver->hinges = textbook_hinges(world);
      solver->step(world, h);
    };
  };
  return {"", "", iterations, false, make};
}

// Chapter 7's loop has bodies of its own: `show` gives them back to the scene.
Setting own(int chains, int iterations, Visits visits) {
  const auto loop = std::make_shared<std::unique_ptr<OwnLoop>>();
  Setting setting{"", "", iterations, false, [=]() -> Step {
                    loop->reset();
                    return [=](World& world, real h) {
                      if (!*loop) *loop = own_loop(world, chains, iterations, visits);
                      (*loop)->step(h);
                    };
                  }};
  setting.show = [=](World& world) { (*loop)->show(world); };
  return setting;
}

// The engine's solvers, which take any joints with limits and motors.
template <class Kind>
Setting engine(Kind solver, int iterations) {
  solver.iterations = iterations;
  return {"", "", iterations, false, [=]() -> Step {
            return [solver](World& world, real h) mutable { step(world, solver, h); };
          }};
}

PackedImpulses wide(Packing packing, bool lanes) {
  PackedImpulses solver;
  solver.packing = packing;
  solver.lanes = lanes;
  return solver;
}

std::vector<Variant> variants() {
  const auto ours = [](Visits visits) {
    return [=](int chains, int n) { return own(chains, n, visits); };
  };
  const auto general = [](const auto& solver) {
    return [=](int, int n) { return engine(solver, n); };
  };
  return {{"recomputed", [](int, int n) { return textbook(n, true); }, 30},
          {"textbook", [](int, int n) { return textbook(n, false); }},
          {"flat", [](int, int n) { return flat(n); }},
          {"whole-joint", ours(Visits::chain_order)},
          {"interleaved", ours(Visits::interleaved)},
          {"lanes", ours(Visits::chain_a_lane)},
          {"lanes coloured", ours(Visits::coloured_lanes)},
          {"engine rows", general(SequentialImpulses{})},
          {"engine packed", general(wide(Packing::islands, false))},
          {"engine lanes", general(wide(Packing::islands, true))},
          {"engine lanes coloured", general(wide(Packing::colours, true))}};
}

// ---- measuring ----------------------------------------------------------------------------------

constexpr int few = 10,
              many = 30;  // iterations: the slope between them is what one iteration costs
constexpr int length = 100;         // bodies of a chain

// A variant on so many chains, and what was measured of it so far.
struct Row {
  Variant variant;
  int chains;
  MakeScene scene{};
  std::vector<double> slope{};                 // ns a joint and iteration, one a round
  struct Point {
    int iterations;
    std::vector<double> us{};  // one a round
    double gap = 0;
  };
  std::vector<Point> points{};
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return (values[n / 2] + values[(n - 1) / 2]) / 2;
}

// One more timing of a count of iterations.
void time_again(const Row& row, Row::Point& point) {
  const Setting setting = row.variant.setting(row.chains, point.iterations);
  const bool takes_long = point.iterations * row.chains > 1500 || row.variant.most < 100;
  const Span span{.steps = takes_long ? 40 : 90};
  point.us.push_back(time_of_step(row.scene, setting, span));
}

// The first look at a count of iterations: what gap it leaves, and how long a step takes.
void look(Row& row, int iterations) {
  const Result result = run(row.scene, row.variant.setting(row.chains, iterations), 1);
  row.points.push_back({iterations, {}, result.gap_rms});
  time_again(row, row.points.back());
}

void add_slope(Row& row) {
  row.slope.push_back(1000 * (row.points[1].us.back() - row.points[0].us.back()) /
                      (double(length - 1) * row.chains * (many - few)));
}

const char* const kind = sizeof(real) == 8 ? "double" : "float";

std::vector<Row> measure(int rounds, bool all_counts) {
  std::vector<Row> rows;
  for (const Variant& variant : variants())
    for (const int chains : {10, 20})
      rows.push_back({variant, chains, [=] { return cubes_on_hinges(chains, length); }});
  for (int round = 0; round < rounds; ++round)  // all variants in each: a slow hour meets all alike
    for (Row& row : rows) {
      std::fprintf(stderr, "round %d of %d: %s, %d chains\n", round + 1, rounds,
                   row.variant.name.c_str(), row.chains);
      if (round == 0) {
        look(row, few);
        look(row, many);
      } else {
        for (Row::Point& point : row.points) time_again(row, point);
      }
      add_slope(row);
    }
  for (Row& row : rows) {
    if (!all_counts) break;
    for (const int iterations : {60, 90, 120, 200}) {
      if (iterations > row.variant.most) break;
      std::fprintf(stderr, "%d iterations: %s, %d chains\n", iterations, row.variant.name.c_str(),
                   row.chains);
      look(row, iterations);
    }
  }
  return rows;
}

void write(FILE* file, const std::vector<Row>& rows) {
  for (const Row& row : rows)
    for (const Row::Point& point : row.points)
      std::fprintf(file, "%s,%d,%d,%s,%.4f,%.3f,,%.8g,\n", row.variant.name.c_str(), row.chains,
                   point.iterations, kind, median(point.us), median(row.slope), point.gap);
}

// ---- counting -----------------------------------------------------------------------------------

// A line for each variant, in the order of the counts that callgrind keeps.
void count_all() {
  const Counted counted{.before = 1, .steps = 1, .few = few, .many = many};
  std::puts("variant,chains,joints,steps,few,many");
  for (const Variant& variant : variants())
    for (const int chains : {10, 20}) {
      std::printf("%s,%d,%d,%d,%d,%d\n", variant.name.c_str(), chains, (length - 1) * chains,
                  counted.steps, counted.few, counted.many);
      count(
          [&](int iterations) -> std::function<void()> {
            const auto scene = std::make_shared<Scene>(cubes_on_hinges(chains, length));
            const Step step = variant.setting(chains, iterations).make();
            return [=] { step(scene->world, real(1) / 60); };
          },
          counted);
    }
}

}  // namespace

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("The inner loop in its variants",
                    {{"csv", "out/loop.csv", "the table"},
                     {"append", "0", "1: add lines to the table that is there"},
                     {"rounds", "7", "how often 10 and 30 iterations are timed"},
                     {"all-counts", "1", "0: no more than 30 iterations"},
                     {"count", "0", "1: for valgrind, measures nothing"}});
    if (!options.read(argc, argv)) return;
    if (options.flag("count")) return count_all();
    const bool append = options.flag("append");
    const std::string path = options.text("csv");
    FILE* file = std::fopen(path.c_str(), append ? "a" : "w");
    if (!file) refuse("--csv " + path + ": cannot be written");
    std::printf("%s: whole-joint to lanes coloured are compiled for %s; the rest for any such "
                "processor,\n  and the engine's lanes (%d) choose their instructions where they "
                "run\n", kind, own_instructions().c_str(), lane_count);
    std::fflush(stdout);
    if (!append)
      std::fputs("variant,chains,iterations,real,us_per_step,ns_per_joint_iteration,"
                 "instructions_per_joint_iteration,gap_rms_m,instructions_per_joint_step\n", file);
    write(file, measure(options.count("rounds", 1), options.flag("all-counts")));
    std::fclose(file);
  });
}
