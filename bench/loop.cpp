// The inner loop in its variants on the thesis' performance scene: the time of each per joint and
// iteration and per step, all in one run. `./wb bench --loop` calls it.
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "bench/counted.h"
#include "bench/named.h"
#include "bench/roofs.h"
#include "engine/instruments/options.h"
#include "engine/simd/records.h"

using namespace joints;
using namespace joints::bench;

namespace {

// ---- the variants -------------------------------------------------------------------------------

// A variant, and up to how many iterations it is worth the time.
struct Variant {
  std::string name;
  Way way;
  int most = 1000;
};

std::vector<Variant> variants() {
  const auto hinges = [](Visits visits) { return Way{.loop = Loop::hinges, .visits = visits}; };
  return {{"recomputed", {.loop = Loop::recomputed}, 30},
          {"textbook", {.loop = Loop::textbook}},
          {"flat", {.loop = Loop::flat}},
          {"whole-joint", hinges(Visits::chain_order)},
          {"interleaved", hinges(Visits::interleaved)},
          {"lanes", hinges(Visits::chain_a_lane)},
          {"lanes coloured", hinges(Visits::coloured_lanes)},
          {"engine rows", {.loop = Loop::rows}},
          {"engine packed", {.loop = Loop::packed}},
          {"engine lanes", {.loop = Loop::lanes}},
          {"engine lanes coloured", {.loop = Loop::lanes, .packing = Packing::colours}}};
}

// ---- measuring ----------------------------------------------------------------------------------

constexpr int few = 10,
              many = 30;  // iterations: the slope between them is the cost of one
constexpr int length = 100;         // bodies of a chain

// A variant on a number of chains, and its measurements so far.
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
  const Setting setting = row.variant.way.setting(point.iterations);
  const bool takes_long = point.iterations * row.chains > 1500 || row.variant.most < 100;
  const Span span{.steps = takes_long ? 40 : 90};
  point.us.push_back(time_of_step(row.scene, setting, span));
}

// The first look at a count of iterations: what gap it leaves, and how long a step takes.
void look(Row& row, int iterations) {
  const Result result = run(row.scene, row.variant.way.setting(iterations), 1);
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

// The limits of the machine, beside the table.
void write_roofs(const std::string& path) {
  FILE* file = open_table(path, false, "roof,lanes,per_ns");
  for (const Roof& roof : roofs())
    std::fprintf(file, "%s,%d,%.1f\n", roof.name.c_str(), roof.lanes, roof.per_ns);
  std::fclose(file);
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
            const auto scene = std::make_shared<BenchScene>(cubes_on_hinges(chains, length));
            const Step step = variant.way.setting(iterations).make();
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
    std::printf("%s: whole-joint to lanes coloured are compiled for %s; the rest for any such "
                "processor,\n  and the engine's lanes (%d) choose their instructions where they "
                "run\n", kind, own_instructions().c_str(), lane_count);
    std::fflush(stdout);
    FILE* file = open_table(path, append,
                            "variant,chains,iterations,real,us_per_step,ns_per_joint_iteration,"
                            "instructions_per_joint_iteration,gap_rms_m,"
                            "instructions_per_joint_step");
    write(file, measure(options.count("rounds", 1), options.flag("all-counts")));
    std::fclose(file);
    if (!append) write_roofs(std::filesystem::path(path).replace_filename("roofs.csv").string());
  });
}
