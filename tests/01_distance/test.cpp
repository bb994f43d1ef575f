// The tests of chapter 1's exercises. Linked with the solution, with the reader's file, with the
// stub and with every known wrong and right answer.
#include "chapters/01_distance/distance_joint.h"
#include "engine/sequential_impulses.h"
#include "tests/checker/catch.h"
#include "tests/checker/fixtures.h"

using namespace joints;
using namespace joints::testing;

namespace {

// The pose for pencil and paper in the chapter's text.
const Body paper1 = body_with(2, vec3(1), vec3(0));
const Body paper2 = [] {
  Body body = body_with(3, vec3(1), vec3(real(1.2), real(1.6), 0));
  body.v = vec3(1, real(0.5), 0);
  return body;
}();
const Row paper_J{vec3(real(-0.6), real(-0.8), 0), vec3(0), vec3(real(0.6), real(0.8), 0), vec3(0)};

// A row with angular parts, for the impulse.
const Row turning_J{vec3(real(-0.6), real(-0.8), 0), vec3(real(0.2), real(-0.5), real(0.9)),
                    vec3(real(0.6), real(0.8), 0), vec3(real(0.7), real(0.1), real(-0.3))};

Pair moving_pair() {
  Pair pair = uneven_pair();
  Random random(5);
  move_together(pair, random);
  for (Body* body : {&pair.body1, &pair.body2}) {
    body->v = random.vector(2);
    body->w = random.vector(2);
  }
  return pair;
}

const real h = real(1) / 60;

}  // namespace

// ---- 1.1 and 1.2 --------------------------------------------------------------------------------

TEST_CASE("1.1 the row of a rod points from centre to centre", "[1.1]") {
  check_jacobian<CentreDistanceFixture>({real(1.5)}, {paper1, paper2}, to_jacobian(paper_J));
}

TEST_CASE("1.1 the row of a rod is the slope of its length at every pose", "[1.1]") {
  check_jacobian<CentreDistanceFixture>();
}

TEST_CASE("1.1 a rod between centres that coincide has no direction and no row", "[1.1]") {
  const Row J = CentreDistance{1}.jacobian(paper1, paper1);
  expect(CentreDistanceFixture::J, "v2 where the centres coincide", J.v2, vec3(0), 0);
}

TEST_CASE("1.2 a rod feels two masses in series", "[1.2]") {
  check_K<CentreDistanceFixture>({real(1.5)}, {paper1, paper2}, to_matrix(real(5) / 6));
}

TEST_CASE("1.2 K of a rod is J M^-1 J^T at every pose", "[1.2]") {
  check_K<CentreDistanceFixture>();
}

TEST_CASE("1.2 a static body adds nothing to K", "[1.2]") {
  const Body wall = static_body(vec3(0));
  expect(CentreDistanceFixture::K, "K beside a wall",
         double(CentreDistance{2}.K(wall, paper2)), 1.0 / 3, rounding);
  expect(CentreDistanceFixture::K, "K between two walls",
         double(CentreDistance{2}.K(wall, static_body(vec3(1, 0, 0)))), 0, 0);
}

// ---- 1.3 ----------------------------------------------------------------------------------------

namespace {
const Subject impulse{"1.3", "the impulse of a row"};
const Subject application{"1.3", "applying the impulse of a row", 2};
}  // namespace

TEST_CASE("1.3 the impulse is what the row lacks over K", "[1.3]") {
  const double JV = 1, K = 5.0 / 6, b = 6;
  expect(impulse, "lambda", double(row_impulse(paper_J, real(K), real(b), paper1, paper2)),
         -(JV + b) / K, 1e2 * rounding,
         {{(JV + b) / K, "the sign: the impulse works against J V + b"},
          {-(JV + b) * K, "times K where it must be divided by K"},
          {-JV / K, "the bias is missing: the error is not fed back"},
          {-b / K, "J V is missing"},
          {-(JV - b) / K, "the sign of the bias"}});
}

TEST_CASE("1.3 a row without an error still stops what changes it", "[1.3]") {
  expect(impulse, "lambda where the bias is 0",
         double(row_impulse(paper_J, real(5) / 6, 0, paper1, paper2)), -1.2, 1e2 * rounding,
         {{0, "nothing is done where the bias is 0. C = 0 does not mean that there is nothing to "
              "solve: the velocity J V would change C"}});
}

TEST_CASE("1.3 a row that nothing can move gets no impulse", "[1.3]") {
  expect(impulse, "lambda where K = 0",
         double(row_impulse(paper_J, 0, real(6), static_body(vec3(0)), static_body(vec3(1)))), 0,
         0);
}

TEST_CASE("1.3 an impulse changes velocities by M^-1 J^T lambda", "[1.3]") {
  const Pair before = moving_pair();
  Pair after = before;
  const real lambda = real(0.8);
  apply_impulse(turning_J, lambda, after.body1, after.body2);
  const char* const sign = "the sign: velocities grow by +M^-1 J^T lambda";
  const char* const set = "the velocity is set where it must grow: += and not =";
  const auto v = [&](const Body& a, const Body& other, const Body& b, const vec3& J,
                     const char* name) {
    const vec3 right = a.v + a.inverse_mass * lambda * J;
    expect(application, name, b.v, right, 10 * rounding,
           {{real(2) * a.v - right, sign},
            {a.v, "this velocity is not changed at all"},
            {right - a.v, set},
            {a.v + lambda / a.inverse_mass * J, "mass where inverse mass belongs"},
            {a.v + lambda * J, "the inverse mass is missing"},
            {a.v + a.inverse_mass * J, "lambda is missing"},
            {a.v + other.inverse_mass * lambda * J, "the inverse mass of the other body"}});
  };
  const auto w = [&](const Body& a, const Body& other, const Body& b, const vec3& J,
                     const char* name) {
    const vec3 right = a.w + inverse_inertia(a) * (lambda * J);
    expect(application, name, b.w, right, 10 * rounding,
           {{real(2) * a.w - right, sign},
            {a.w, "this velocity is not changed at all"},
            {right - a.w, set},
            {a.w + lambda * J, "the inverse inertia is missing"},
            {a.w + a.inverse_inertia_local * (lambda * J),
             "body-space inertia: take inverse_inertia(body)"},
            {a.w + glm::inverse(inverse_inertia(a)) * (lambda * J),
             "inertia where inverse inertia belongs"},
            {a.w + a.inverse_mass * lambda * J, "inverse mass where inverse inertia belongs"},
            {a.w + inverse_inertia(a) * J, "lambda is missing"},
            {a.w + inverse_inertia(other) * (lambda * J), "the inertia of the other body"}});
  };
  const Body &a = before.body1, &b = before.body2;
  v(a, b, after.body1, turning_J.v1, "v1");
  w(a, b, after.body1, turning_J.w1, "w1");
  v(b, a, after.body2, turning_J.v2, "v2");
  w(b, a, after.body2, turning_J.w2, "w2");
}

TEST_CASE("1.3 after its impulse a row holds and a second one is zero", "[1.3]") {
  Pair pair = moving_pair();
  const real K = dense_K(to_jacobian(turning_J), pair.body1, pair.body2)[0][0];
  const real bias = real(0.7);
  apply_impulse(turning_J, row_impulse(turning_J, K, bias, pair.body1, pair.body2), pair.body1,
                pair.body2);
  expect(impulse, "J V + b after the impulse",
         double(row_velocity(turning_J, pair.body1, pair.body2) + bias), 0, 10 * rounding);
  expect(impulse, "a second impulse",
         double(row_impulse(turning_J, K, bias, pair.body1, pair.body2)), 0, 10 * rounding);
}

TEST_CASE("1.3 a static body is not moved by an impulse", "[1.3]") {
  Body wall = static_body(vec3(0)), body = paper2;
  apply_impulse(paper_J, real(5), wall, body);
  expect(application, "v of a static body", wall.v, vec3(0), 0);
  expect(application, "w of a static body", wall.w, vec3(0), 0);
}

// ---- 1.4 ----------------------------------------------------------------------------------------

namespace {
const Subject stepping{"1.4", "the step"};
const real g = real(-9.81);
const char* const not_a_force = "lambda is an impulse, not a force: it is not multiplied by h";
}  // namespace

TEST_CASE("1.4 a free body falls by Euler's semi-implicit rule", "[1.4]") {
  std::vector<Body> bodies{ball(2, 1, vec3(0)), static_body(vec3(1, 1, 1))};
  StepSettings settings;
  for (int n = 0; n < 3; ++n) step(bodies, {}, settings);
  expect(stepping, "v.y after three steps", double(bodies[0].v.y), double(3 * g * h), 10 * rounding,
         {{0, "gravity does not act"},
          {double(3 * g), "v grows by g, not by h g"},
          {double(3 * g * h / 2), "gravity is multiplied by the inverse mass: all fall alike"},
          {double(6 * g * h), "gravity is multiplied by the mass: all bodies fall alike"}});
  expect(stepping, "x.y after three steps", double(bodies[0].x.y), double(6 * g * h * h),
         10 * rounding,
         {{double(3 * g * h * h), "the old velocity moves the body: change v first, then x"},
          {0, "the place does not change"},
          {double(6 * g * h), "x grows by v, not by h v"}});
  expect(stepping, "v of a static body", bodies[1].v, vec3(0), 0,
         {{h * settings.gravity * real(3), "gravity moves a static body"}});
  expect(stepping, "x of a static body", bodies[1].x, vec3(1, 1, 1), 0);
}

TEST_CASE("1.4 every sweep of a step takes away its share of the error", "[1.4]") {
  // A chain that hangs plumb: 1 kg carries 3 kg, which are falling at 1 m/s. A sweep solves the
  // upper rod, then the lower one, which leaves the lower ball m2/(m1+m2) = 3/4 of its velocity.
  std::vector<Body> bodies{static_body(vec3(0)), ball(1, real(0.1), vec3(0, -1, 0)),
                           ball(3, real(0.1), vec3(0, -3, 0))};
  bodies[2].v.y = -1;
  const real start = -1 + g * h;  // after gravity
  for (int iterations : {10, 3, 1}) {
    std::vector<Body> hanging = bodies;
    StepSettings settings;
    settings.iterations = iterations;
    step(hanging, {{0, 1, 1}, {1, 2, 2}}, settings);
    // the share of each impulse that is applied, at once or when all of a sweep are known
    const auto lower_ball = [&](real share, bool at_once) {
      real upper = g * h, lower = start;
      for (int n = 0; n < iterations; ++n) {
        real apart = lower - upper;
        upper -= share * upper;
        if (at_once) apart = lower - upper;
        upper += share * real(0.75) * apart;
        lower -= share * real(0.25) * apart;
      }
      return double(lower);
    };
    const real fall = start * std::pow(real(0.75), real(iterations));
    expect(stepping, "v of the ceiling", hanging[0].v, vec3(0), 0,
           {{h * settings.gravity, "gravity moves a static body"}});
    expect(stepping, "v.y of the lower ball, " + std::to_string(iterations) + " sweeps",
           double(hanging[2].v.y), double(fall), 10 * rounding,
           {{double(start), "no impulse was applied. A row whose error is 0 is solved all the "
                            "same, for the sake of its velocity"},
            {double(fall - std::pow(real(0.75), real(iterations)) * g * h + g * h),
             "forces after the rows: the rods cannot answer to gravity any more"},
            {double(start * real(0.75)), "only one sweep was done. The loop over the sweeps is "
                                         "outside, the loop over the links inside"},
            {double(fall / real(0.75)), "one sweep too few, or the links from last to first"},
            {double(fall * real(0.75)), "one sweep too many"},
            {lower_ball(1, false), "all impulses of a sweep from the same velocities: apply each "
                                   "one before the next is computed"},
            {lower_ball(h, true), not_a_force}});
  }
}

TEST_CASE("1.4 a stretched rod loses the share beta of its error in a step", "[1.4]") {
  std::vector<Body> bodies{static_body(vec3(0)), ball(2, 1, vec3(real(1.1), 0, 0))};
  StepSettings settings;
  settings.gravity = vec3(0);
  step(bodies, {{0, 1, 1}}, settings);
  expect(stepping, "error after a step", double(bodies[1].x.x) - 1, 0.08, 10 * rounding,
         {{0.1, "the bias of the row is not used, or places are moved before velocities are right"},
          {0.1 - 0.02 * (1 - std::pow(1 - double(h), 30)), not_a_force},
          {0.12, "the sign of the bias: the rod grows"}});
}

TEST_CASE("1.4 the order is forces then rows then places", "[1.4]") {
  // a pendulum at its lowest point that swings to the right and comes down at 1 m/s
  std::vector<Body> bodies{static_body(vec3(0)), ball(1, real(0.1), vec3(0, -1, 0))};
  bodies[1].v = vec3(1, -1, 0);
  StepSettings settings;
  settings.beta = 0;
  step(bodies, {{0, 1, 1}}, settings);
  const real unsolved = -1 + g * h;
  expect(stepping, "v of the ceiling", bodies[0].v, vec3(0), 0,
         {{h * settings.gravity, "gravity moves a static body"}});
  expect(stepping, "x of the bob", bodies[1].x, vec3(h, -1, 0), 10 * rounding,
         {{vec3(h, -1 + h * (g * h), 0), "forces after the rows: the rod gives way"},
          {vec3(h, -1 + h * unsolved, 0), "no impulse was applied. A row whose error is 0 is "
                                          "solved all the same, for the sake of its velocity"},
          {vec3(h, -1 + h * unsolved * std::pow(1 - h, real(30)), 0),
           not_a_force},
          {vec3(h, -1 - h, 0), "places before the velocities: the old velocity moves the body"},
          {vec3(0, -1, 0), "the place does not change"}});
}

// ---- 1.5 ----------------------------------------------------------------------------------------

namespace {
const Subject clamping{"1.5", "the clamped sum of a rope"};
const char* const never_back =
    "a rope never gives back what it pulled too much: it is the sum over all sweeps of the step "
    "that must not push, not each impulse";
std::string number(double a) { return std::to_string(a).substr(0, a < 0 ? 4 : 3); }
}  // namespace

TEST_CASE("1.5 a rope may give back what it pulled but never push", "[1.5]") {
  struct Case {
    double sum, dlambda, applied;
  };
  for (const Case& c : {Case{0, 2, 2}, Case{0, -1, 0}, Case{3, -1, -1}, Case{3, -5, -3},
                        Case{3, 0.5, 0.5}}) {
    real sum = real(c.sum);
    const real applied = clamp_sum(real(c.dlambda), sum);
    const std::string entry =
        "sum " + number(c.sum) + ", dlambda " + number(c.dlambda) + ": ";
    const bool clamped = sum != real(c.sum + c.dlambda);
    expect(clamping, entry + "applied", double(applied), c.applied, rounding,
           {{std::max(c.dlambda, 0.0), "each impulse is clamped: it is the sum that must not push"},
            {c.dlambda, clamped ? "all of dlambda is returned: return by how much the sum grew"
                                : "nothing is clamped"},
            {c.sum + c.applied, "the new sum is returned instead of its growth"},
            {-c.applied, "the sign of the growth"},
            {std::min(c.sum + c.dlambda, 0.0) - c.sum,
             "max and min are mixed up: the sum must not fall below 0"}});
    expect(clamping, entry + "new sum", double(sum), c.sum + c.applied, rounding,
           {{c.sum, "the sum is not kept"}});
  }
}

TEST_CASE("1.5 sweeps that may take back end where both ropes agree", "[1.5]") {
  // two ropes hold one body; overshoot of the first must be taken back by later sweeps
  Body wall = static_body(vec3(0)), body = ball(1, real(0.1), vec3(0));
  const Row J1{vec3(-1, 0, 0), vec3(0), vec3(1, 0, 0), vec3(0)};
  const Row J2{vec3(real(-0.8), real(-0.6), 0), vec3(0), vec3(real(0.8), real(0.6), 0), vec3(0)};
  body.v = vec3(-1, -3, 0);
  real sum1 = 0, sum2 = 0;
  const auto solve = [&](const Row& J, real& sum) {  // row_impulse and apply_impulse, written out
    const real dlambda = -row_velocity(J, wall, body) / body.inverse_mass;
    body.v += body.inverse_mass * clamp_sum(dlambda, sum) * J.v2;
  };
  for (int sweep = 0; sweep < 200; ++sweep) {
    solve(J1, sum1);
    solve(J2, sum2);
  }
  // only the second rope is taut: lambda2 = 0.8*1 + 0.6*3 = 2.6, v = (-1, -3) + 2.6 (0.8, 0.6)
  expect(clamping, "pull of rope 1 [N s]", double(sum1), 0, 100 * rounding, {{1, never_back}});
  expect(clamping, "pull of rope 2 [N s]", double(sum2), 2.6, 100 * rounding);
  expect(clamping, "velocity of the body", body.v, vec3(real(1.08), real(-1.44), 0),
         100 * rounding);
}

TEST_CASE("1.5 a slack rope leaves a falling body alone", "[1.5]") {
  std::vector<Body> bodies{static_body(vec3(0)), ball(1, real(0.1), vec3(0, real(-0.5), 0))};
  step(bodies, {{0, 1, 1, true}}, StepSettings{});
  expect(clamping, "v.y under a slack rope", double(bodies[1].v.y), -9.81 * double(h),
         10 * rounding,
         {{-0.5 / double(h), "a rope pushes: its impulses are not clamped (does step of 1.4 call "
                             "clamp_sum for a rope?)"}});
}

TEST_CASE("1.5 a step keeps the sum of a rope from sweep to sweep", "[1.5]") {
  // the two ropes of the test above, in the step of 1.4
  std::vector<Body> bodies{ball(1, real(0.1), vec3(0)), static_body(vec3(-1, 0, 0)),
                           static_body(vec3(real(-0.8), real(-0.6), 0))};
  bodies[0].v = vec3(1, 3, 0);
  StepSettings settings;
  settings.gravity = vec3(0);
  settings.iterations = 200;
  step(bodies, {{1, 0, 1, true}, {2, 0, 1, true}}, settings);
  expect(clamping, "velocity of the body", bodies[0].v, vec3(real(-1.08), real(1.44), 0),
         100 * rounding,
         {{vec3(real(-1.44), real(1.92), 0), never_back},
          {vec3(1, 3, 0), "the ropes do not pull"}});
}

TEST_CASE("1.5 a taut rope carries a body and a slack one does not", "[1.5]") {
  std::vector<Body> bodies{static_body(vec3(0)), ball(1, real(0.1), vec3(0, -1, 0))};
  for (int n = 0; n < 60; ++n) step(bodies, {{0, 1, 1, true}}, StepSettings{});
  expect(clamping, "y after hanging for a second", double(bodies[1].x.y), -1, 1e-4);
}

// ---- 1.6 ----------------------------------------------------------------------------------------

TEST_CASE("1.6 the row of a rod between anchors has a lever in it", "[1.6]") {
  const Pair pair{static_body(vec3(0)), box(2, vec3(1), vec3(1, 0, 0))};
  const Distance rod{vec3(0), vec3(0, real(0.5), 0), 1};
  const real size = std::sqrt(real(5));
  const vec3 n(2 / size, 1 / size, 0);
  check_jacobian<DistanceFixture>(rod, pair,
                                  to_jacobian(Row{-n, vec3(0), n, vec3(0, 0, -1 / size)}));
}

TEST_CASE("1.6 K of a rod between anchors has a share of the rotation in it", "[1.6]") {
  const Pair pair{static_body(vec3(0)), box(2, vec3(1), vec3(1, 0, 0))};
  check_K<DistanceFixture>({vec3(0), vec3(0, real(0.5), 0), 1}, pair, to_matrix(real(1.1)));
}

TEST_CASE("1.6 a rod between points that coincide has no direction and no row", "[1.6]") {
  const Body cube1 = box(2, vec3(1), vec3(0)), cube2 = box(3, vec3(1), vec3(1, 0, 0));
  const Distance rod{vec3(real(0.5), 0, 0), vec3(real(-0.5), 0, 0), 1};
  const Row J = rod.jacobian(cube1, cube2);
  expect(DistanceFixture::J, "v2 where the points coincide", J.v2, vec3(0), rounding);
  expect(DistanceFixture::K, "K where the points coincide", double(rod.K(cube1, cube2)), 5.0 / 6,
         rounding);
}

TEST_CASE("1.6 the row of a rod between anchors is the slope of its length at every pose",
          "[1.6]") {
  check_jacobian<DistanceFixture>();
}

TEST_CASE("1.6 K of a rod between anchors is J M^-1 J^T at every pose", "[1.6]") {
  check_K<DistanceFixture>();
}

TEST_CASE("1.6 a rod between centres has no lever", "[1.6]") {
  const Row J = Distance{vec3(0), vec3(0), 1}.jacobian(paper1, paper2);
  expect(DistanceFixture::J, "w1", J.w1, vec3(0), 0);
  expect(DistanceFixture::J, "w2", J.w2, vec3(0), 0);
}
