// The stability suite's own scenes, words and cases: a handful of them, run as the suite runs them.
#include "bench/stability.h"

#include <map>
#include <set>

#include "tests/checker/catch.h"
#include "tests/oracle/oracle.h"

using namespace joints;
using namespace joints::bench;
using joints::testing::tolerance;

namespace {

// What a case tells when it is asked for few values.
std::vector<Line> lines_of(const std::string& id) {
  std::vector<Line> out;
  for (const Case& one : cases())
    if (one.id == id) one.run(true, [&](const Line& line) { out.push_back(line); });
  return out;
}

Result after(const MakeScene& make, const Method& method, int steps) {
  return run(make, setting_of(method), 1, {.h = real(1) / 60, .steps = steps});
}

}  // namespace

TEST_CASE("the stability suite has every case from X1 to X17 and no other") {
  std::set<std::string> ids;
  for (const Case& one : cases()) ids.insert(one.id);
  std::set<std::string> expected;
  for (int k = 1; k <= 17; ++k) expected.insert("X" + std::to_string(k));
  CHECK(ids == expected);
}

TEST_CASE("a number that is known is ok within its tolerance and off outside and nan is neither") {
  CHECK(compared({}, 2, 2.01, 0.02).status == "ok");
  CHECK(compared({}, 2, 2.03, 0.02).status == "off");
  CHECK(compared({}, 2, none, 0.02).status == "nan");
  CHECK(compared({}, 2, -2, 0.02).expected == 2);
  CHECK(judged({}, 7, false).status == "off");
  CHECK(judged({}, unbounded, true).status == "nan");
  Result lost;
  lost.finite = false;
  CHECK(status(lost, 1) == "nan");
}

TEST_CASE("the cases whose outcome is known come out as they should") {
  for (const char* id : {"X2", "X5", "X6", "X7", "X9", "X10", "X11", "X12", "X13", "X14", "X15",
                         "X16", "X17"}) {
    int known = 0;
    for (const Line& line : lines_of(id)) {
      if (std::isnan(line.expected)) continue;
      CAPTURE(line.id, line.method, line.parameter, line.value, line.expected, line.measured);
      CHECK(line.status == "ok");
      ++known;
    }
    CAPTURE(id);
    CHECK(known > 0);
  }
}

TEST_CASE("a spinning box keeps its energy where the usual steps gain or lose it") {
  std::map<std::string, int> ok, all;
  for (const Line& line : lines_of("X8")) {
    ++all[line.method];
    ok[line.method] += line.status == "ok";
  }
  CHECK(ok["implicit midpoint (the engine)"] == 4);
  CHECK(ok["explicit Euler (for comparison)"] < all["explicit Euler (for comparison)"]);
  CHECK(ok["implicit Euler (for comparison)"] < all["implicit Euler (for comparison)"]);
}

TEST_CASE("a chain of hinges that stays in its plane iterations as fast as equal masses in a row") {
  // along the chain the cubes are masses in a row: cos^2(pi/2n); across it they are a beam, and a
  // beam is far slower
  for (int n : {5, 10}) {
    const Rates rates = rates_of([=] { return cubes_on_hinges(1, n + 1); });
    const double c = std::cos(3.14159265358979 / (2 * n));
    CHECK(rates.possible == Approx(c * c).margin(tolerance(1e-4, 2e-3)));
    CHECK(1 - rates.any < 0.1 * (1 - rates.possible));
  }
}

TEST_CASE(
    "warm starting beyond the criterion is flagged and one iteration of a long chain breaks it") {
  const MakeScene chain = [] { return cubes_on_hinges(1, 11); };
  const Rates rates = rates_of(chain);
  const Method few{.name = "warm 1", .iterations = 1, .warm = true, .beta = real(0.5)};
  const Method enough{.name = "warm 30", .iterations = 30, .warm = true};
  const Method cold{.name = "cold 30"};
  Line line;
  add_criterion(line, few, rates);
  CHECK(line.criterion == 0);
  CHECK(after(chain, few, 300).energy_drift > 0.02);
  add_criterion(line, enough, rates);
  CHECK(line.criterion == 1);
  CHECK(after(chain, enough, 300).energy_drift < 0.02);
  Line empty;
  add_criterion(empty, cold, rates);
  CHECK(std::isnan(empty.criterion));
}

TEST_CASE("S5 three hinges come to their reference with substeps and by less the finer they are") {
  const MakeScene chain = [] { return cubes_on_hinges(1, 4); };
  const Result whole = after(chain, {.name = "cold 100", .iterations = 100}, 60);
  const Result sixteen =
      after(chain, {.name = "16 substeps", .iterations = 30, .substeps = 16}, 60);
  CHECK(whole.tip_error > 0.02);
  CHECK(whole.tip_error < 0.15);
  CHECK(sixteen.tip_error < whole.tip_error / 8);
}

TEST_CASE("S1 in its plane stays there and S7 goes out of it for want of iterations") {
  const auto plane = [] { return cubes_on_hinges(1, 21); };
  CHECK(after(plane, {.name = "cold 10", .iterations = 10}, 120).sideways < tolerance(1e-9, 1e-3));
  const auto side = [] {
    BenchScene scene = cubes_on_hinges(1, 5);
    scene.world.gravity = sideways_gravity().world.gravity;
    return scene;
  };
  const Method few{.name = "cold 10", .iterations = 10};
  const Method many{.name = "cold 1000", .iterations = 1000};
  const double at_10 = after(side, few, 60).sideways, at_1000 = after(side, many, 60).sideways;
  CHECK(at_10 > 0.1);
  CHECK(at_1000 < 0.1 * at_10);
  CHECK(sideways_gravity().marks.size() == 990);
  CHECK(loaded_axes().marks.size() == 10);
}

TEST_CASE("S3 begins as a quarter of a circle with chords of 1 m between its static ends") {
  for (bool hinges : {true, false}) {
    BenchScene scene = hanging_bridge(hinges);
    const auto start = poses(scene.world.bodies);
    REQUIRE(start.size() == 42);
    CHECK(scene.marks.size() == 41);
    for (const Mark& mark : scene.marks) {
      CHECK(length(start[mark.body2].x - start[mark.body1].x) == Approx(1).epsilon(1e-5));
      CHECK(gap(mark, start) < 1e-5);
    }
    CHECK(std::abs(start[0].x.y) < 1e-5);
    CHECK(std::abs(start[41].x.y) < 1e-5);
    CHECK(start[21].x.y < -7);
    CHECK(1 / double(scene.world.bodies.at(21).inverse_mass) == Approx(100));
    const Result fell = after([=] { return hanging_bridge(hinges); }, {.name = "cold 30"}, 30);
    CHECK(fell.finite);
    CHECK(fell.gap_max > 1e-4);  // a heavy middle: soft at 30 iterations
  }
}

TEST_CASE("S4 the motor comes to 3 rad per s and with limits rests at 60 degrees") {
  BenchScene free = motor(), stopped = motor_into_limit(), falling = limit();
  Watch a{free.world}, b{stopped.world}, c{falling.world};
  for (int k = 0; k < 300; ++k)
    for (Watch* watch : {&a, &b, &c}) watch->step(real(1) / 60);
  CHECK((a.finite && b.finite && c.finite));
  const double sixty = 3.14159265358979 / 3;
  CHECK(double(hinge_of(free).speed(free.world.bodies)) == Approx(3).epsilon(1e-3));
  CHECK(double(hinge_of(stopped).position(stopped.world.bodies)) == Approx(sixty).epsilon(1e-4));
  CHECK(double(hinge_of(falling).position(falling.world.bodies)) == Approx(sixty).epsilon(1e-4));
}

TEST_CASE("a heavy end of any mass is a scene whose tip is compared with nothing") {
  const Result result =
      after([] { return heavy_end_unreferenced(1e6); }, {.name = "cold 10", .iterations = 10}, 60);
  CHECK(result.finite);
  CHECK(result.tip_error == 0);
  CHECK(result.steps == 60);
}

TEST_CASE("a run that leaves the numbers ends there and is called nan") {
  Setting wild = setting_of({.name = "wild"});
  wild.make = [] {
    return [n = 0](World& world, real) mutable {
      if (++n == 5) world.bodies.at(1).v.x = unbounded;
    };
  };
  const Result result = run([] { return cubes_on_hinges(1, 3); }, wild, 1);
  CHECK(result.steps == 5);
  CHECK_FALSE(result.finite);
  CHECK(result.status == "nan");
}
