// The tests of chapter 5's exercises. Linked with the solution, with the reader's file, with the
// stub and with every known wrong and right answer.
#include <algorithm>

#include "tests/checker/catch.h"
#include "tests/checker/joint_fixtures.h"

using namespace joints;
using namespace joints::testing;

// ---- 5.1 ----------------------------------------------------------------------------------------

namespace {

const Subject cross_block{"5.1", "the block X between point and lock"};
const real half = std::sqrt(real(0.5));  // cos 45 degrees

// The pose for pencil and paper in the chapter's text.
const Body paper1 = static_body(vec3(0));
const Body paper2 = body_with(2, vec3(real(0.4), real(0.5), real(0.4)), vec3(0, -1, 0),
                              quat(half, 0, 0, half));
const Point paper_point{vec3(0), vec3(1, 0, real(0.5))};

// J_t M^-1 J_r^T, entry by entry, with J_t the slopes of the gap and J_r = (0, -E, 0, E).
mat3 product_X(const Point& point, const Pair& pair) {
  const Jacobian<3> J = numeric_jacobian(point, pair.body1, pair.body2);
  const mat3 I1 = inverse_inertia(pair.body1), I2 = inverse_inertia(pair.body2);
  mat3 X;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      X[column][row] = dot(J[row].w2, I2[column]) - dot(J[row].w1, I1[column]);
  return X;
}

// X of those who make a common mistake.
std::vector<MatrixSuspect> wrong_Xs(const Point& point, const Pair& pair) {
  const Body &a = pair.body1, &b = pair.body2;
  const vec3 r1 = to_world(a, point.anchor1_local), r2 = to_world(b, point.anchor2_local);
  const mat3 I1 = inverse_inertia(a), I2 = inverse_inertia(b);
  const auto with_turn = [](Body body, const quat& q) {
    body.q = q;
    return inverse_inertia(body);
  };
  const quat upright(1, 0, 0, 0);
  const mat3 local1 = with_turn(a, upright), local2 = with_turn(b, upright);
  const auto X = [](const vec3& arm1, const mat3& A1, const vec3& arm2, const mat3& A2) {
    return -(skew(arm1) * A1 + skew(arm2) * A2);
  };
  const mat3 right = X(r1, I1, r2, I2), masses(a.inverse_mass + b.inverse_mass);
  const char* const order = "transposed: the rows of X belong to the point and its columns to the "
                            "lock, skew(r) I^-1 and not I^-1 skew(r)";
  const char* const space = "body-space inertia: take inverse_inertia(body)";
  const char* const arms = "body-space arm: a lever is not turned into the world";
  const char* const points = "a point where a lever belongs: r runs from the body's centre to the "
                             "anchor (to_world, not world_point)";
  const vec3 p1 = a.x + r1, p2 = b.x + r2;
  const char* const only_body_1 =  // beside a static body two mistakes look alike
      a.is_static() ? "X is zero: the lever of body 2 goes with the inertia of body 2"
                    : "the share of body 2 is missing";
  return {{-right, "the sign: body 2 has -skew(r2) in the point and E in the lock: a minus"},
          {transpose(right), order}, {-transpose(right), order},
          {X(r1, I1, -r2, I2), "the sign of body 2's share: both shares have the minus"},
          {X(-r1, I1, r2, I2), "the sign of body 1's share: skew(r1) meets -E of the lock"},
          {X(r1, I1, r2, mat3(0)), only_body_1},
          {X(r1, mat3(0), r2, I2), "the share of body 1 is missing"},
          {X(r1, local1, r2, local2), space}, {X(r1, I1, r2, local2), space},
          {X(r1, local1, r2, I2), space},
          {X(r1, with_turn(a, conjugate(a.q)), r2, with_turn(b, conjugate(b.q))),
           "the inertia is turned the wrong way round: R I^-1 R^T, not R^T I^-1 R"},
          {X(r1, I2, r2, I1), "the lever of one body with the inertia of the other"},
          {X(point.anchor1_local, I1, point.anchor2_local, I2), arms},
          {X(point.anchor1_local, I1, r2, I2), arms}, {X(r1, I1, point.anchor2_local, I2), arms},
          {X(p1, I1, p2, I2), points}, {X(p1, I1, r2, I2), points}, {X(r1, I1, p2, I2), points},
          {X(r1, mat3(1), r2, mat3(1)), "the inverse inertia is missing"},
          {X(r1, glm::inverse(I1), r2, glm::inverse(I2)),
           "inertia where inverse inertia belongs: inverse_inertia(body) is the inverse already"},
          {right + masses, "masses do not belong here: the lock turns, and pushes no centre"},
          {right + masses[0][0] * mat3(1, 1, 1, 1, 1, 1, 1, 1, 1),
           "masses do not belong here: the lock turns, and pushes no centre"},
          {-(skew(r1) * I1 * transpose(skew(r1)) + skew(r2) * I2 * transpose(skew(r2))),
           "the lever stands on one side only: this is the share of turning in K of the point"},
          {skew(r1) * I1 * transpose(skew(r1)) + skew(r2) * I2 * transpose(skew(r2)),
           "the lever stands on one side only: this is the share of turning in K of the point"},
          {I1 + I2, "the levers are missing: this is K of the lock"},
          {-(I1 + I2), "the levers are missing: this is K of the lock"},
          {mat3(0), "X is zero: then a turn of the lock would not move the anchor"}};
}

}  // namespace

TEST_CASE("5.1 a turning impulse of the lock moves the anchor of the point", "[5.1]") {
  // world inverse inertia diag(2, 2.5, 2.5), lever (0, 1, 1/2); written column by column
  const mat3 X(0, -1, 2, real(1.25), 0, 0, real(-2.5), 0, 0);
  expect(cross_block, "X", cross_K(paper_point, paper1, paper2), X, K_tolerance,
         wrong_Xs(paper_point, {paper1, paper2}));
}

TEST_CASE("5.1 X is the product of the point's rows and the lock's rows at every pose", "[5.1]") {
  visit_poses<PointFixture>([](int pose, const Point& point, const Pair& pair) {
    expect(cross_block, std::string("X (") + pose_names[pose] + ")",
           cross_K(point, pair.body1, pair.body2), product_X(point, pair), K_tolerance,
           wrong_Xs(point, pair));
  });
}

TEST_CASE("5.1 two static bodies have no X", "[5.1]") {
  expect(cross_block, "X", cross_K(paper_point, paper1, static_body(vec3(1, 2, 3))), mat3(0), 0,
         {{mat3(1), "masses do not belong here: the lock turns, and pushes no centre"}});
}

TEST_CASE("5.1 K of a weld is J M^-1 J^T of all six rows at every pose", "[5.1]") {
  std::vector<Sample> samples;
  visit_poses<WeldFixture>([&](int pose, const Weld& weld, const Pair& pair) {
    const Matrix<6> right = dense_K(numeric_jacobian(weld, pair.body1, pair.body2), pair.body1,
                                    pair.body2);
    Sample sample = K_sample<WeldFixture>(pose, weld, pair, right);
    for (const auto& [X, words] : wrong_Xs(weld.point, pair)) {
      Matrix<6> wrong = right;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) wrong[i][3 + j] = wrong[3 + j][i] = X[j][i];
      if (close(sample.yours, flat(wrong), K_tolerance)) sample.mistakes.push_back(words);
    }
    samples.push_back(sample);
  });
  check(WeldFixture::K, K_report(row_names<WeldFixture>(), samples, K_tolerance));
}

// ---- 5.2 ----------------------------------------------------------------------------------------

namespace {

const Subject carrying{"5.2", "the load of a weld"};
const Subject moving{"5.2", "the load about another point", 2};
const Subject breaking{"5.2", "does a weld break? (1 yes, 0 no)", 3};

void expect_carried(const Vector<6>& impulse, real h) {
  const vec3 push(impulse[0], impulse[1], impulse[2]), turn(impulse[3], impulse[4], impulse[5]);
  const Reaction load = carried(impulse, h);
  const auto mistakes = [&](const vec3& mine, const vec3& other, const vec3& alternate) {
    const char* const threes = "the two threes are exchanged: the point's rows come first";
    return std::vector<VectorSuspect>{
        {mine, "this is the impulse: a force is the impulse over the step h"},
        {h * mine, "times h where it must be divided by h"},
        {-mine / h, "the sign: the load on body 2 is asked, and +lambda acts on body 2"},
        {other / h, threes}, {other, std::string(threes) + ", and h is missing"},
        {alternate / h, "every second number: the point has the first three and the lock the rest"},
        {(mine + other) / h, "force and torque are added up: each has its own three numbers"},
        {cross(push, turn) / h, "no cross product here: about the anchor the lock's own three are "
                                "the whole torque"},
        {vec3(0), "it is left at zero"}};
  };
  expect(carrying, "force", load.force, push / h, 100 * rounding,
         mistakes(push, turn, {impulse[0], impulse[2], impulse[4]}));
  expect(carrying, "torque", load.torque, turn / h, 100 * rounding,
         mistakes(turn, push, {impulse[1], impulse[3], impulse[5]}));
}

void expect_about(const Reaction& load, const vec3& from, const vec3& to) {
  const vec3 &F = load.force, &T = load.torque;
  const Reaction moved = about(load, from, to);
  expect(moving, "torque", moved.torque, T + cross(from - to, F), 10 * rounding,
         {{T - cross(from - to, F), "the sign of the new share, (from - to) x F: from and to are "
                                    "exchanged, or the two sides of the cross product"},
          {T, "the torque is as it was: a force beside the point turns, too"},
          {cross(from - to, F), "the old torque is lost: the new share is added to it"},
          {cross(to - from, F), "the old torque is lost, and the sign of the new share"},
          {T + cross(from, F), "`to` is forgotten: the lever runs from `to` to `from`"},
          {T - cross(from, F), "`to` is forgotten, and the sign of the new share"},
          {T + cross(to, F), "`from` is forgotten: the lever runs from `to` to `from`"},
          {T - cross(to, F), "`from` is forgotten: the lever runs from `to` to `from`"},
          {T + cross(from + to, F), "the lever is a difference: from - to"},
          {T + cross(from - to, T), "the force has the lever, not the torque"},
          {vec3(0), "the torque is lost"}});
  expect(moving, "force", moved.force, F, 10 * rounding,
         {{vec3(0), "the force is lost: it stays what it is"},
          {-F, "the sign of the force: it stays what it is"},
          {F + cross(from - to, F), "the new share belongs to the torque: the force stays"},
          {F + T, "force and torque are added up: the force stays what it is"},
          {T, "force and torque are exchanged"}});
}

}  // namespace

TEST_CASE("5.2 a weld carries its impulses over the time in which it gave them", "[5.2]") {
  expect_carried({0, real(0.5), 0, 0, 0, real(0.25)}, real(0.1));
  expect_carried({real(0.3), real(-0.2), real(0.7), real(-0.4), real(0.1), real(0.6)}, real(0.25));
}

TEST_CASE("5.2 the same load turns more about a point that is farther from its line", "[5.2]") {
  expect_about({vec3(0, 5, 0), vec3(0, 0, real(2.5))}, vec3(1, 0, 0), vec3(0));
  Random random(52);
  for (int draw = 0; draw < 8; ++draw)
    expect_about({random.vector(5), random.vector(5)}, random.vector(2), random.vector(2));
}

TEST_CASE("5.2 a shelf of two kilograms bends its wall by its weight times its lever", "[5.2]") {
  // the centre hangs 1/2 m before the wall; the wall holds 19.62 N up and turns with 9.81 N m
  const vec3 centre(real(0.5), 0, 0);
  expect_about({vec3(0, real(19.62), 0), vec3(0)}, centre, vec3(0));
  expect_about({vec3(0, real(19.62), 0), vec3(0, 0, real(9.81))}, vec3(0), centre);
  const Reaction at_wall = about({vec3(0, real(19.62), 0), vec3(0)}, centre, vec3(0));
  expect(moving, "torque at the wall", at_wall.torque, vec3(0, 0, real(9.81)), 10 * rounding);
}

TEST_CASE("5.2 the impulses row by row and the load about the centre are the same", "[5.2]") {
  Random random(53);
  const Vector<6> impulse{real(0.3), real(-0.2), real(0.7), real(-0.4), real(0.1), real(0.6)};
  const real h = real(0.25);
  visit_poses<WeldFixture>([&](int, const Weld& weld, const Pair& pair) {
    const Jacobian<6> J = weld.jacobian(pair.body1, pair.body2);
    vec3 force(0), torque(0);  // J^T lambda / h of body 2
    for (int i = 0; i < 6; ++i) {
      force += impulse[i] / h * J[i].v2;
      torque += impulse[i] / h * J[i].w2;
    }
    const vec3 anchor = world_point(pair.body2, weld.point.anchor2_local);
    const Reaction at_anchor = carried(impulse, h), load = about(at_anchor, anchor, pair.body2.x);
    const vec3 turn(impulse[3], impulse[4], impulse[5]);
    expect(carrying, "force on body 2", load.force, force, 100 * rounding,
           {{h * force, "this is the impulse: a force is the impulse over the step h"},
            {turn / h, "the two threes are exchanged: the point's rows come first"},
            {-force, "the sign: the load on body 2 is asked"}});
    expect(moving, "torque on body 2 about its centre", load.torque, torque, 100 * rounding,
           {{real(2) * at_anchor.torque - torque, "the sign of the new share, (from - to) x F"},
            {at_anchor.torque, "the torque is as it was: a force beside the point turns, too"},
            {torque - at_anchor.torque, "the old torque is lost: the new share is added to it"},
            {load.torque, "neither `carried` nor `about` loses or adds a torque: look at both"}});
  });
}

namespace {

struct Break {
  const char* words;
  vec3 force, torque;
  bool breaks;
  Strength strength{10, 2};
};
const Break cases[] = {
    {"12 N of 10, 0 N m of 2", vec3(0, 12, 0), vec3(0), true},
    {"0 N of 10, 3 N m of 2", vec3(0), vec3(0, 0, 3), true},
    {"12 N of 10 downwards", vec3(0, 0, -12), vec3(0), true},
    {"3 N m of 2 the other way round", vec3(0), vec3(-3, 0, 0), true},
    {"13.9 N of 10, askew", vec3(8, 8, 8), vec3(0), true},
    {"2.3 N m of 2, askew", vec3(0), vec3(real(1.5), real(-1.5), 1), true},
    {"12 N of 10, 3 N m of 2", vec3(12, 0, 0), vec3(0, 3, 0), true},
    {"9 N of 10, 1.9 N m of 2", vec3(9, 0, 0), vec3(0, real(1.9), 0), false},
    {"8.7 N of 10, askew", vec3(5, 5, 5), vec3(0), false},
    {"1.7 N m of 2, askew", vec3(0), vec3(1, 1, 1), false},
    {"10 N of 10, at the bound", vec3(6, 8, 0), vec3(0), false},
    {"2 N m of 2, at the bound", vec3(0), vec3(0, 0, 2), false},
    {"no load", vec3(0), vec3(0), false},
    {"1e6 N and 1e6 N m, unbounded", vec3(1e6, 0, 0), vec3(0, 1e6, 0), false, {}},
    {"3 N m of 2, force unbounded", vec3(1e6, 0, 0), vec3(0, 3, 0), true, {unbounded, 2}}};

using Rule = std::function<bool(const vec3&, const vec3&, const Strength&)>;
// The usual rule with something else for the length.
Rule either(const std::function<real(const vec3&)>& size) {
  return [=](const vec3& F, const vec3& T, const Strength& s) {
    return size(F) > s.force || size(T) > s.torque;
  };
}
using F3 = const vec3&;
using S = const Strength&;
const std::pair<Rule, const char*> wrong_rules[] = {
    {[](F3 F, F3 T, S s) { return length(F) > s.force && length(T) > s.torque; },
     "`and` where `or` belongs: one of the two is enough to break a weld"},
    {[](F3 F, F3 T, S s) { return length(F) >= s.force || length(T) >= s.torque; },
     "at its bound a weld still holds: > and not >="},
    {[](F3 F, F3 T, S s) { return !(length(F) > s.force || length(T) > s.torque); },
     "the other way round: true means that it breaks"},
    {[](F3 F, F3 T, S s) { return length(F) < s.force || length(T) < s.torque; },
     "the other way round: true means that it breaks"},
    {[](F3 F, F3, S s) { return length(F) > s.force; }, "the torque is not looked at"},
    {[](F3, F3 T, S s) { return length(T) > s.torque; }, "the force is not looked at"},
    {[](F3 F, F3 T, S s) { return length(T) > s.force || length(F) > s.torque; },
     "force and torque are exchanged: each has a bound of its own"},
    {[](F3 F, F3 T, S s) { return length(F) + length(T) > s.force + s.torque; },
     "newtons and newton metres do not add up: each has a bound of its own"},
    {[](F3, F3, S) { return false; }, "it never breaks"},
    {[](F3, F3, S) { return true; }, "it always breaks"},
    {either([](F3 a) { return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)}); }),
     "the largest entry where the length belongs: a weld does not know the axes of the world"},
    {either([](F3 a) { return std::max({a.x, a.y, a.z}); }),
     "the largest entry where the length belongs, and entries may be negative"},
    {either([](F3 a) { return std::abs(a.x) + std::abs(a.y) + std::abs(a.z); }),
     "the sum of the entries where the length belongs"},
    {either([](F3 a) { return a.x + a.y + a.z; }),
     "the sum of the entries where the length belongs, and entries may be negative"},
    {either([](F3 a) { return a.x; }), "one entry where the length belongs"},
    {either([](F3 a) { return a.y; }), "one entry where the length belongs"},
    {either([](F3 a) { return a.z; }), "one entry where the length belongs"},
    {either([](F3 a) { return std::abs(a.x); }), "one entry where the length belongs"},
    {either([](F3 a) { return std::abs(a.y); }), "one entry where the length belongs"},
    {either([](F3 a) { return std::abs(a.z); }), "one entry where the length belongs"},
    {either([](F3 a) { return dot(a, a); }),
     "the square of the length beside the bound itself: take length(...)"}};

}  // namespace

TEST_CASE("5.2 a weld breaks when its force or its torque is too long", "[5.2]") {
  const auto agrees = [](const Rule& rule) {  // with the reader's, in all cases
    return std::all_of(std::begin(cases), std::end(cases), [&](const Break& c) {
      return rule(c.force, c.torque, c.strength) == breaks({c.force, c.torque}, c.strength);
    });
  };
  std::vector<std::string> mistakes;
  for (const auto& [rule, words] : wrong_rules)
    if (agrees(rule)) mistakes.push_back(words);
  for (const Break& c : cases) {
    std::vector<Suspect> suspects;
    for (const std::string& words : mistakes) suspects.push_back({c.breaks ? 0.0 : 1.0, words});
    expect(breaking, c.words, breaks({c.force, c.torque}, c.strength) ? 1 : 0, c.breaks ? 1 : 0, 0,
           suspects);
  }
}
