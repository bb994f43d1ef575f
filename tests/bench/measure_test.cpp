// The measures, on motions whose numbers are known, and the files that runs leave behind.
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "engine/instruments/measure.h"
#include "engine/instruments/record.h"
#include "joints/hinge_joint.h"
#include "tests/checker/catch.h"
#include "tests/oracle/oracle.h"

using namespace joints;
using namespace joints::testing;
using glm::dquat;
using glm::dvec3;

namespace {

const double no_number = std::numeric_limits<double>::quiet_NaN();

std::string path_of(const std::string& name) {
  return (std::filesystem::temp_directory_path() /
          ("joints_" + std::to_string(getpid()) + "_" + name)).string();
}
std::string contents(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  std::filesystem::remove(path);
  return text.str();
}

// Just enough of a JSON reader: true when the whole text is one value. As tools/pictures/motion.py
// does, it takes the nan and inf of C++ for numbers.
struct Json {
  std::string text;
  std::size_t at = 0;
  void space() {
    while (at < text.size() && std::isspace(static_cast<unsigned char>(text[at]))) ++at;
  }
  bool take(const std::string& word) {
    space();
    if (text.compare(at, word.size(), word) != 0) return false;
    at += word.size();
    return true;
  }
  bool string() {
    if (!take("\"")) return false;
    for (; at < text.size() && text[at] != '"'; ++at) {
      if (static_cast<unsigned char>(text[at]) < 0x20) return false;
      if (text[at] == '\\') ++at;
    }
    return take("\"");
  }
  bool number() {
    space();
    const std::string digits = "+-.e0123456789";
    if (text.compare(at, 4, "-nan") == 0 || text.compare(at, 4, "-inf") == 0) return false;
    const std::size_t from = at;
    while (at < text.size() && digits.find(text[at]) != std::string::npos) ++at;
    return at > from;
  }
  bool list(const std::string& close, bool keys) {
    if (take(close)) return true;
    do {
      if (keys && !(string() && take(":"))) return false;
      if (!value()) return false;
    } while (take(","));
    return take(close);
  }
  bool value() {
    if (take("{")) return list("}", true);
    if (take("[")) return list("]", false);
    return string() || number() || take("nan") || take("-nan") || take("inf") || take("-inf");
  }
  bool whole() { return value() && (space(), at == text.size()); }
};

}  // namespace

TEST_CASE("the gap of a mark is the distance of its two anchors in the world") {
  // body 1 turned a quarter about z: its anchor (1, 0, 0) stands at (0, 1, 0)
  const std::vector<Pose> poses{{dvec3(0), glm::angleAxis(std::acos(0.0), dvec3(0, 0, 1))},
                                {dvec3(3, 1, 0), dquat(1, 0, 0, 0)}};
  Mark mark{0, 1, dvec3(1, 0, 0), dvec3(0, 0, 4), dvec3(0), dvec3(0)};
  CHECK(gap(mark, poses) == Approx(5).epsilon(1e-12));
  CHECK(axis_error(mark, poses) == 0);  // no axes
  mark.axis1_local = dvec3(1, 0, 0);    // stands along y
  for (const auto& [axis, angle] : {std::pair{dvec3(0, 1, 0), 0.0},
                                    {dvec3(1, 0, 0), std::acos(0.0)},
                                    {dvec3(0, -1, 0), 2 * std::acos(0.0)},
                                    {dvec3(std::sin(1e-9), std::cos(1e-9), 0), 1e-9}}) {
    mark.axis2_local = axis;
    CHECK(axis_error(mark, poses) == Approx(angle).epsilon(1e-6).margin(1e-15));
  }
}

TEST_CASE("a gap meter gives root mean square and maximum and does not swallow a NaN") {
  const Mark mark{0, 1, {}, {}, dvec3(1, 0, 0), dvec3(1, 0, 0)};
  const auto at = [](double x) {
    return std::vector<Pose>{{}, {dvec3(x, 0, 0), dquat(1, 0, 0, 0)}};
  };
  GapMeter meter;
  CHECK(meter.rms() == 0);
  for (double x : {1.0, -7.0, 2.0}) meter.look({mark}, at(x));
  CHECK(meter.maximum() == 7);
  CHECK(meter.rms() == Approx(std::sqrt(18.0)).epsilon(1e-14));
  meter.look({mark}, at(no_number));
  meter.look({mark}, at(1));  // a body that came back does not make it good
  CHECK(std::isnan(meter.maximum()));
  CHECK(std::isnan(meter.rms()));
  GapMeter axes;
  std::vector<Pose> turned = at(0);
  turned[1].q.w = no_number;
  axes.look({mark}, turned);
  axes.look({mark}, at(0));
  CHECK(std::isnan(axes.axis_maximum()));
}

TEST_CASE("the measures see what the world holds") {
  World world;
  Body body = box(3, vec3(1, 2, 3), vec3(1, 2, 3), rotation(vec3(1, 0, 0)));
  body.v = vec3(1, 2, -2);
  body.w = to_world(body, vec3(0, 0, 4));
  world.add(static_body(vec3(7, 0, 0)));
  world.add(body);
  const std::vector<Pose> seen = poses(world.bodies);
  REQUIRE(seen.size() == 2);
  CHECK(seen[0].x == dvec3(7, 0, 0));
  CHECK(seen[1].x == dvec3(1, 2, 3));
  CHECK(seen[1].q.w == double(body.q.w));
  CHECK(seen[1].q.x == double(body.q.x));
  CHECK(kinetic_energy(body) == Approx(0.5 * 3 * 9 + 0.5 * 1.25 * 16).epsilon(1e-5));
  CHECK(kinetic_energy(world.bodies.at(0)) == 0);
  const double kinetic = 0.5 * 3 * 9 + 0.5 * 1.25 * 16;
  CHECK(energy(all_of(world.bodies), vec3(0, -10, 1)) ==
        Approx(kinetic + 3 * (20 - 3)).epsilon(1e-5));
}

TEST_CASE("the momentum of bodies in the air stays, and a push changes it by its lever") {
  World world;
  world.gravity = vec3(0);
  world.add(static_body(vec3(9)));
  const quat q = rotation(vec3(real(0.4), -1, real(0.2)));
  const BodyId a = world.add(body_with(2, vec3(1, 2, 3), vec3(1, 2, 3), q));
  const BodyId b = world.add(body_with(3, vec3(2, 1, 2), vec3(2, 2, 3), q));
  world.add<HingeJoint>(a, b, vec3(1.5, 2, 3), vec3(1, 1, 0));
  world.bodies[a].v = vec3(1, -2, 3);
  world.bodies[b].w = vec3(real(0.1), real(-0.3), real(0.2));
  const Momentum start = momentum(all_of(world.bodies));
  CHECK(length(start.linear - dvec3(2, -4, 6)) < tolerance(1e-12, 1e-5));
  SequentialImpulses solver;
  solver.iterations = 100;
  for (int n = 0; n < 100; ++n) step(world, solver, real(1e-3));
  const Momentum now = momentum(all_of(world.bodies));
  CHECK(length(now.linear - start.linear) < tolerance(1e-10, 1e-4));
  CHECK(length(now.angular - start.angular) < tolerance(1e-4, 1e-3));
  // An impulse of 6 N s along y at the point (1, 0, 0) from the centre, itself at (1, 2, 3).
  Body body = body_with(2, vec3(4), vec3(1, 2, 3));
  body.v = vec3(0, 3, 0);
  body.w = vec3(0, 0, real(1.5));
  const Momentum pushed = momentum({&body, 1});
  CHECK(length(pushed.linear - dvec3(0, 6, 0)) < 1e-6);
  CHECK(length(pushed.angular - dvec3(-18, 0, 12)) < 1e-5);
}

TEST_CASE("a table refuses a row of another width and writes what it was given") {
  const std::string path = path_of("table.csv");
  {
    CsvFile table(path, {"word", "x", "y"});
    table.row({"one, two"}, {1.5, -2e-9});
    CHECK_THROWS_AS(table.row({1, 2}), std::invalid_argument);
    CHECK_THROWS_AS(table.row({"a", "b"}, {1, 2}), std::invalid_argument);
    table.row({0.1, 2, no_number});
  }
  CHECK(contents(path) == "word,x,y\n\"one, two\",1.5,-2e-09\n0.1,2,nan\n");
  CHECK_THROWS_AS(CsvFile("/dev/null/nowhere/table.csv", {"x"}), std::invalid_argument);
}

TEST_CASE("a recorded motion can be read whatever its title and wherever its bodies went") {
  const std::string path = path_of("motion.json");
  Motion motion("a \"door\" \\ slammed", 0.01, 2);
  motion.body({"ball", {1, 1, 1}, "the \"one\""});
  motion.body({});
  motion.line({0, 1, {0, 1, 0}, {0, 0, 2}});
  Body bodies[] = {ball(1, 1, vec3(real(0.25), 0, 0)), static_body(vec3(3))};
  for (int frame = 0; frame < 4; ++frame) {
    motion.frame(bodies, {{"a \"b\"", 0.25, -3}});
    bodies[0].x.y = frame == 1 ? std::numeric_limits<real>::quiet_NaN() : real(1e30) * real(1e8);
  }
  motion.write(path);
  Json json{contents(path)};
  CHECK(json.whole());
  CHECK(json.text.find("\"dt\":0.02") != std::string::npos);
  CHECK(json.text.find("[1,1,1],\"label\":\"the \\\"one\\\"\"},") != std::string::npos);
  CHECK(json.text.find(",{\"kind\":\"box\",\"size\":[1,1,1]}") != std::string::npos);
  CHECK(json.text.find("[0,[0,1,0],1,[0,0,2]]") != std::string::npos);
  CHECK(json.text.find("[0.25,0,0,1,0,0,0,3,3,3,1,0,0,0]") != std::string::npos);
  CHECK(json.text.find("\"readings\":[\n[[\"a \\\"b\\\"\",0.25,-3]],\n[[") != std::string::npos);
  CHECK_THROWS_AS(motion.frame(bodies), std::invalid_argument);
  CHECK_THROWS_AS(Motion("no frames", 0.01, 0), std::invalid_argument);
  CHECK_THROWS_AS(Motion("no time", no_number, 1), std::invalid_argument);
}

TEST_CASE("a body that turns fast is recorded in every step, a slow one in every other") {
  const std::string path = path_of("turning.json");
  for (const bool fast : {false, true}) {
    Motion motion("turning", 0.01, 2);
    motion.body({});
    Body body = static_body(vec3(0));
    for (int n = 0; n < 5; ++n) {
      body.q = rotation(vec3(0, real(n < 4 ? 0 : fast ? 0.52 : 0.48), 0));
      motion.frame(&body);
    }
    motion.write(path);
    const std::string text = contents(path);
    CHECK((text.find("\"dt\":0.01,") != std::string::npos) == fast);
    CHECK((text.find("\"dt\":0.02,") != std::string::npos) == !fast);
    const std::string frames = text.substr(text.find("\"frames\""));
    CHECK(std::count(frames.begin(), frames.end(), '\n') == (fast ? 10 : 6) + 1);
  }
}
