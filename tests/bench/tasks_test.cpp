// The scenes that are for something: what they find, where it is known, and the methods' words.
#include "bench/named.h"
#include "bench/tasks.h"
#include "tests/checker/catch.h"
#include "tests/oracle/oracle.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

using namespace joints;
using namespace joints::bench;
using namespace joints::testing;

namespace {

// How far a scene's finding is from the expected value.
double miss(const MakeScene& make, const std::string& method, int steps) {
  const Finding finding = make().finding;
  return std::abs(run(make, setting_named(method), 1, {.steps = steps}).found - finding.expected);
}

}  // namespace

TEST_CASE("an arm whose joints and drives are exact has its tool where their angles put it") {
  CHECK(miss(arm, "placed", 60) < tolerance(0.02, 0.5));      // [mm]
  CHECK(miss(arm, "plain", 60) > 0.1);                        // velocities alone drift
  CHECK(miss(arm, "shake", 60) < tolerance(0.02, 0.5));       // with and without leapfrog
  CHECK(miss(arm, "si30", 60) > 100);
}

TEST_CASE("a chain of soft joints gives way by the sum of what its springs do") {
  for (const double hertz : {20.0, 60.0}) {
    const MakeScene chain = [=] { return sprung_chain(10, hertz); };
    CHECK(chain().finding.expected ==
          Approx(9810 / std::pow(2 * 3.14159265358979 * hertz, 2) * (11 + 2 * 55)));
    CHECK(miss(chain, "velocity", 600) < tolerance(1e-3, 0.05));
    CHECK(miss(chain, "si30", 600) > 0.01);
  }
}

TEST_CASE("what hangs on exact joints stays, and a beam of welds does not sag") {
  CHECK(miss([] { return hung_chain(10, 1000); }, "velocity", 300) < tolerance(1e-6, 1e-2));
  CHECK(miss([] { return hung_chain(10, 1000); }, "si30", 300) > 1);
  CHECK(miss([] { return welded_beam(20); }, "velocity", 300) < tolerance(1e-6, 1));
  CHECK(miss([] { return welded_beam(20); }, "si30", 300) > 1000);
}

TEST_CASE("the links of a loaded rope bridge keep their length with added inertia") {
  CHECK(miss(rope_bridge, "inertia", 300) < tolerance(1e-3, 1));
  CHECK(miss(rope_bridge, "si30", 300) > 1000);
}

TEST_CASE("a crane has the speed of its motor after a second, and rests at its limit") {
  CHECK(miss(driven_crane, "placed", 60) < 1e-3);      // [rad/s]
  CHECK(miss(driven_crane, "si30", 60) > 5e-3);
  CHECK(miss(stopped_crane, "velocity", 600) < 0.01);  // [degrees]
}

TEST_CASE("a method's word may name substeps, and one that is none is refused") {
  const MakeScene chain = [] { return cubes_on_hinges(1, 4); };
  const auto tip = [&](const std::string& method) {
    return run(chain, setting_named(method), 1, {.steps = 60}).tip_error;
  };
  CHECK(tip("shake/4") < 0.08 * tip("shake"));  // second order: a sixteenth
  CHECK(tip("shake/1") == tip("shake"));
  CHECK_THROWS_AS(setting_named("shaken"), std::invalid_argument);
  CHECK_THROWS_AS(setting_named("shake/none"), std::invalid_argument);
}

TEST_CASE("a table keeps one scene by its name and refuses one that is not there") {
  struct Entry {
    std::string name;
  };
  std::vector<Entry> list{{"a"}, {"b"}};
  CHECK_THROWS_AS(keep_named(list = {{"a"}}, "b", &Entry::name), std::invalid_argument);
  list = {{"a"}, {"b"}};
  keep_named(list, "", &Entry::name);
  CHECK(list.size() == 2);
  keep_named(list, "b", &Entry::name);
  CHECK((list.size() == 1 && list[0].name == "b"));
  CHECK(words("a  bc d") == std::vector<std::string>{"a", "bc", "d"});
}

TEST_CASE("a table begins with its header once, however often one appends to it") {
  const std::filesystem::path path = std::filesystem::temp_directory_path() /
                                     ("table" + std::to_string(std::random_device{}()) + ".csv");
  const auto add = [&](bool append, const char* line) {
    FILE* file = open_table(path.string(), append, "scene");
    std::fprintf(file, "%s\n", line);
    std::fclose(file);
  };
  const auto lines = [&] {
    std::ifstream file(path);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  add(true, "S1");
  add(true, "S2");
  CHECK(lines() == "scene\nS1\nS2\n");
  add(false, "S3");
  CHECK(lines() == "scene\nS3\n");
  std::filesystem::remove(path);
  CHECK_THROWS_AS(open_table("/nowhere/table.csv", true, "scene"), std::invalid_argument);
}
