// Exercise 8.2 as tables of cases, each with its usual mistakes: the two directions of friction,
// and what a visit adds to the impulse along one of them.
#pragma once

#include <algorithm>

#include "chapters/08_ground/ground.h"
#include "tests/warm_cases.h"

namespace joints::testing {

// ---- 8.2 the tangents ---------------------------------------------------------------------------

struct TangentCase {
  std::string words;
  vec3 n, sliding;
};

/// Bodies that slide over level and tilted ground, and fall or rise at the same time.
inline std::vector<TangentCase> tangent_cases() {
  const vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  std::vector<TangentCase> out{{"level, along x", y, real(3) * x},
                               {"level, along -z", y, real(-0.5) * z},
                               {"level, falling", y, {3, -2, real(-4)}},
                               {"wall along x", x, {2, real(0.3), real(-0.4)}},
                               {"wall along -x", -x, {1, real(-0.4), real(0.3)}},
                               {"wall along z", z, {real(0.5), 1, real(0.2)}},
                               {"ceiling", -y, {real(0.7), 2, real(0.2)}}};
  Random random(82);
  for (int draw = 0; draw < 8; ++draw)
    out.push_back({"tilted", random.turn() * y, random.vector(2)});
  for (const real speed : {real(1e-2), real(1e-3)})  // slow, and it does slide
    out.push_back({"slow, " + short_number(double(speed)) + " m/s", y,
                   speed * vec3(real(0.6), 0, real(0.8))});
  return out;
}
/// Where nothing slides: at rest, and where all of the velocity is along n.
inline std::vector<TangentCase> rest_cases() {
  const vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  std::vector<TangentCase> out;
  const auto add = [&](const std::string& name, const vec3& n) {
    out.push_back({"at rest, " + name, n, vec3(0)});
    out.push_back({"falling, " + name, n, real(-3) * n});
    out.push_back({"rising, " + name, n, real(1e-3) * n});
  };
  add("n = x", x);
  add("n = -x", -x);
  add("n = y", y);
  add("n = z", z);
  add("n = -z", -z);
  add("n askew", {real(0.6), real(0.8), 0});
  add("n near x", normalize(vec3(1, real(0.01), real(-0.02))));
  add("n near y", normalize(vec3(real(0.01), 1, real(0.02))));
  Random random(820);
  for (int draw = 0; draw < 20; ++draw) add("tilted", random.turn() * y);
  return out;
}

inline constexpr Subject rest_subject{"8.2", "the two directions of friction where nothing slides"};

/// No direction may be lost: which of the rest cases are, tells why.
inline void check_rest_is_finite() {
  int at_rest = 0, lost_at_rest = 0, lost_in_flight = 0;
  std::string first;
  for (const TangentCase& c : rest_cases()) {
    const std::array<vec3, 2> t = tangents(c.n, c.sliding);
    const bool lost = !std::isfinite(double(dot(t[0], t[0]) + dot(t[1], t[1])));
    const bool rests = length(c.sliding) == 0;
    at_rest += rests;
    (rests ? lost_at_rest : lost_in_flight) += lost;
    if (lost && first.empty()) first = c.words;
  }
  if (first.empty()) return;
  const char* const why =
      lost_at_rest == at_rest
          ? "a zero vector has no direction, 0/0 is not a number. Where less than 1e-4 m/s is "
            "left, begin with any vector that is not along n"
      : lost_at_rest > 0
          ? "the vector that stands in for the sliding is along n here, so that nothing of it is "
            "left: choose it by looking at n"
          : "the whole velocity is asked whether anything slides: ask what is left of it across n";
  fail(rest_subject, "t1 or t2 is not a number (" + first + ").\n\nLikely mistake: " + why + "\n");
}

inline CaseTable<TangentCase> tangent_table() {
  using Case = TangentCase;
  const auto numbers = [](const vec3& t1, const vec3& t2) { return flat({t1, t2}); };
  const auto across = [](const Case& c) { return c.sliding - dot(c.n, c.sliding) * c.n; };
  const auto t1 = [=](const Case& c) { return normalize(across(c)); };
  // another t1, with t2 = n x t1
  const auto with = [=](auto other) {
    return [=](const Case& c) { return numbers(other(c), cross(c.n, other(c))); };
  };
  // another t2
  const auto beside = [=](auto other) {
    return [=](const Case& c) { return numbers(t1(c), other(c)); };
  };
  // what stands in for the sliding at rest
  const auto stand_in = [](const Case& c) {
    return std::abs(c.n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0);
  };
  const char* const ignored = "the velocity is not looked at: t1 looks where the point slides";
  const char* const against = "t1 looks against the sliding: it looks where the point slides, the "
                              "impulse is negative then";
  const char* const aside = "t1 is n x sliding, at right angles to it: t1 looks where the point "
                            "slides";
  const char* const whole = "what is along n is not taken away: t1 lies in the ground";
  const char* const length_1 = "t1 is not a unit vector: divide by the length of what is left";
  const char* const left_handed = "t2 = t1 x n: it is n x t1, so that n, t1 and t2 go round "
                                  "like x, y and z";

  CaseTable<Case> table{{"8.2", "the two directions of friction"}, {"t1", "t2"}, {}, {}, {}, {}};
  table.yours = [=](const Case& c) {
    const std::array<vec3, 2> t = tangents(c.n, c.sliding);
    return numbers(t[0], t[1]);
  };
  table.right = with(t1);
  table.mistakes = {
      {whole, with([](const Case& c) { return normalize(c.sliding); })},
      {std::string(whole) + ", and it is a unit vector", with([](const Case& c) {
         return c.sliding;
       })},
      {whole, [=](const Case& c) {
         return numbers(normalize(c.sliding), normalize(cross(c.n, c.sliding)));
       }},
      {length_1, with(across)},
      {length_1, [=](const Case& c) { return numbers(across(c), cross(c.n, t1(c))); }},
      {"t2 is not a unit vector: take n x t1 with the t1 that has been made one",
       beside([=](const Case& c) { return cross(c.n, across(c)); })},
      {"made a unit vector first, then what is along n is taken away: the other way round",
       with([](const Case& c) {
         const vec3 s = normalize(c.sliding);
         return s - dot(c.n, s) * c.n;
       })},
      {"divided by the square of the length",
       with([=](const Case& c) { return across(c) / dot(across(c), across(c)); })},
      {"the sign of what is along n: it is taken away, s = v - (n.v) n",
       with([](const Case& c) { return normalize(c.sliding + dot(c.n, c.sliding) * c.n); })},
      {"only what is along n is kept: that is what has to go",
       with([](const Case& c) { return normalize(dot(c.n, c.sliding) * c.n); })},
      {"the y part of the velocity is taken away: n need not be the y axis",
       with([](const Case& c) {
         return normalize(c.sliding - vec3(0, c.sliding.y, 0));
       })},
      {against,
       with([=](const Case& c) { return -t1(c); })},
      {against,
       [=](const Case& c) { return numbers(-t1(c), cross(c.n, t1(c))); }},
      {ignored, with([=](const Case& c) {
         return normalize(stand_in(c) - dot(c.n, stand_in(c)) * c.n);
       })},
      {ignored, with([=](const Case& c) { return normalize(cross(c.n, stand_in(c))); })},
      {left_handed, beside([=](const Case& c) { return cross(t1(c), c.n); })},
      {"t1 and t2 are exchanged: the first one looks where the point slides",
       [=](const Case& c) { return numbers(cross(c.n, t1(c)), t1(c)); }},
      {aside,
       with([=](const Case& c) { return cross(c.n, t1(c)); })},
      {aside,
       with([=](const Case& c) { return cross(t1(c), c.n); })},
      {"t1 twice: t2 = n x t1", beside(t1)},
      {"t2 is at right angles to the velocity, not to n: t2 = n x t1",
       beside([=](const Case& c) { return normalize(cross(c.sliding, t1(c))); })},
      {"t2 is missing: t2 = n x t1", beside([](const Case&) { return vec3(0); })},
      {"n is among the two: both directions lie in the ground",
       beside([](const Case& c) { return c.n; })}};
  table.cases = tangent_cases();
  table.tolerance = 10 * rounding;
  return table;
}

// ---- 8.2 the impulse of friction ----------------------------------------------------------------

struct FrictionCase {
  std::string words;
  double rate, K, mu, normal, sum;
};

inline CaseTable<FrictionCase> friction_table() {
  using Case = FrictionCase;
  const auto clamped = [](double a, double bound) { return std::clamp(a, -bound, bound); };
  const auto step = [](const Case& c) { return -c.rate / c.K; };
  const auto wanted = [=](const Case& c) { return c.sum + step(c); };
  const auto bound = [](const Case& c) { return c.mu * c.normal; };
  // what brings the sum to its new value, and returns by how much it changed
  const auto to = [](auto sum) {
    return [=](const Case& c) { return Numbers{sum(c) - c.sum, sum(c)}; };
  };
  const auto wanting = [=](auto other) {
    return to([=](const Case& c) { return clamped(other(c), bound(c)); });
  };
  const auto bounded = [=](auto other) {
    return to([=](const Case& c) { return clamped(wanted(c), other(c)); });
  };
  const auto right = bounded(bound);
  const auto no_more = [=](const Case& c) { return std::abs(wanted(c)) > bound(c); };
  const char* const each = "the change of each visit is clamped: it is the sum over all visits "
                           "that stays within +-mu normal";
  const char* const inwards = "the bound moves inwards when the normal impulse becomes less, and "
                              "the sum goes with it: clamp the sum anew in each visit";
  const char* const either = ": friction is bounded either way, -mu normal and +mu normal";
  const char* const returns = "what was wanted is returned: return by how much the sum changed";

  CaseTable<Case> table{{"8.2", "the impulse of friction (v is J V, N the normal impulse)", 2},
                        {"change", "sum"}, {}, {}, {}, {}};
  table.yours = [=](const Case& c) {
    real sum = real(c.sum);
    const real change =
        friction_impulse(real(c.rate), real(c.K), real(c.mu), real(c.normal), sum);
    return Numbers{double(change), double(sum)};
  };
  table.right = right;
  table.mistakes = {
      {"the sign: friction works against J V, wanted = sum - rate/K",
       wanting([=](const Case& c) { return c.sum - step(c); })},
      {each,
       [=](const Case& c) {
         const double change = clamped(step(c), bound(c));
         return Numbers{change, c.sum + change};
       }},
      {each,
       [=](const Case& c) {
         const double change = clamped(step(c), bound(c));
         return Numbers{change, change};
       }},
      {inwards, to([=](const Case& c) {
         return std::clamp(wanted(c), std::min(c.sum, -bound(c)), std::max(c.sum, bound(c)));
       })},
      {inwards, to([=](const Case& c) { return no_more(c) ? c.sum : wanted(c); })},
      {inwards, to([=](const Case& c) {
         return std::abs(c.sum) >= bound(c) ? c.sum : clamped(wanted(c), bound(c));
       })},
      {"nothing is done beyond the bound: the sum goes to the bound",
       to([=](const Case& c) { return no_more(c) ? 0 : wanted(c); })},
      {"the bound is mu times the normal impulse: mu is missing",
       bounded([](const Case& c) { return c.normal; })},
      {"the bound is mu times the normal impulse: normal is missing",
       bounded([](const Case& c) { return c.mu; })},
      {"the bound is mu times the normal impulse: times, not divided by mu",
       bounded([](const Case& c) { return c.normal / c.mu; })},
      {"the bound is an impulse already: mu normal, without h",
       bounded([=](const Case& c) { return bound(c) / 60; })},
      {"the bound is an impulse already: mu normal, without h",
       bounded([=](const Case& c) { return bound(c) * 60; })},
      {"the bound is divided by K: it is an impulse already",
       bounded([=](const Case& c) { return bound(c) / c.K; })},
      {"a half of the bound: it is mu normal either way",
       bounded([=](const Case& c) { return bound(c) / 2; })},
      {"mu is taken twice in the bound", bounded([=](const Case& c) { return c.mu * bound(c); })},
      {"nothing is clamped", bounded([](const Case&) { return 1e30; })},
      {"nothing is clamped, and the sum is not stored",
       [=](const Case& c) { return Numbers{step(c), c.sum}; }},
      {std::string("only the upper bound is there") + either,
       to([=](const Case& c) { return std::min(wanted(c), bound(c)); })},
      {std::string("only the lower bound is there") + either,
       to([=](const Case& c) { return std::max(wanted(c), -bound(c)); })},
      {std::string("the sum is kept from 0 to mu normal") + either,
       to([=](const Case& c) { return std::clamp(wanted(c), 0.0, bound(c)); })},
      {std::string("the sum is kept from -mu normal to 0") + either,
       to([=](const Case& c) { return std::clamp(wanted(c), -bound(c), 0.0); })},
      {std::string("the size of what is wanted is clamped") + either,
       to([=](const Case& c) { return std::min(std::abs(wanted(c)), bound(c)); })},
      {"this is what a row does that only pushes, sum >= 0: friction has the bound mu normal",
       to([=](const Case& c) { return std::max(wanted(c), 0.0); })},
      {"the full bound whatever is wanted: friction gives no more than what stops the sliding",
       to([=](const Case& c) { return c.rate > 0 ? -bound(c) : c.rate < 0 ? bound(c) : 0; })},
      {"the full bound whatever is wanted: friction gives no more than what stops the sliding",
       to([=](const Case& c) { return wanted(c) < 0 ? -bound(c) : bound(c); })},
      {"the new sum is added to the old one: it takes its place",
       [=](const Case& c) { return Numbers{right(c)[1], c.sum + right(c)[1]}; }},
      {"the sum is not stored: the next visit has to know it",
       [=](const Case& c) { return Numbers{right(c)[0], c.sum}; }},
      {"the sum that is stored is not clamped",
       [=](const Case& c) { return Numbers{right(c)[0], wanted(c)}; }},
      {"the new sum is returned instead of its change",
       [=](const Case& c) { return Numbers{right(c)[1], right(c)[1]}; }},
      {returns, [=](const Case& c) { return Numbers{step(c), right(c)[1]}; }},
      {returns, [=](const Case& c) { return Numbers{wanted(c), right(c)[1]}; }},
      {"the sign of the change: new sum minus old sum",
       [=](const Case& c) { return Numbers{-right(c)[0], right(c)[1]}; }},
      {"0 is returned: keep the old sum before the new one is stored",
       [=](const Case& c) { return Numbers{0, right(c)[1]}; }},
      {"the sum so far is missing in what is wanted: sum - rate/K", wanting(step)},
      {"the change is added to the sum twice",
       [=](const Case& c) { return Numbers{right(c)[0], right(c)[1] + right(c)[0]}; }},
      {"times K where it must be divided by K",
       wanting([](const Case& c) { return c.sum - c.rate * c.K; })},
      {"K is missing: an impulse is a speed divided by K",
       wanting([](const Case& c) { return c.sum - c.rate; })},
      {"the old sum is divided by K, too",
       wanting([](const Case& c) { return (c.sum - c.rate) / c.K; })}};
  const auto add = [&](double rate, double K, double mu, double normal, double sum) {
    table.cases.push_back({"v " + short_number(rate) + " N " + short_number(normal) + " sum " +
                               short_number(sum), rate, K, mu, normal, sum});
  };
  for (const double way : {1, -1}) {
    add(way * 2.88, 11.0 / 60, 0.5, 1.2, 0);       // the text's: slides on
    add(way * 2.77, 11.0 / 60, 0.5, 1.2, way * -0.6);  // and once more
    add(way * 0.05, 0.4, 0.5, 1.2, 0);             // within the bound: stops
    add(way * 0.05, 0.4, 0.5, 1.2, way * -0.2);
    add(way * -0.1, 0.4, 0.5, 1.2, way * -0.4);    // gives back
    add(way * -3, 0.4, 0.5, 1.2, way * -0.4);      // gives all back, and brakes the other way
    add(0, 0.4, 0.5, 0.7, way * 0.6);              // the normal impulse has become less
    add(way * 0.05, 0.4, 0.5, 0.7, way * 0.6);
    add(way * -1, 0.4, 0.5, 0.7, way * 0.6);
    add(0, 0.4, 0.5, 0, way * 0.6);                // lifted off
    add(way * 2, 2.5, 1.5, 3, way * 1.5);          // a rough ground, a light body
    add(way * 2, 2.5, 0, 3, 0);                    // no friction
  }
  table.tolerance = 10 * rounding;
  return table;
}

/// For a test of another kind: the table's mistakes explain whatever is wrong.
inline void expect_friction(const std::string& entry, double yours, double right,
                            std::vector<Suspect> otherwise = {}) {
  const CaseTable<FrictionCase> table = friction_table();
  const double tolerance = 100 * rounding;
  const bool same = std::abs(yours - right) <= tolerance;
  expect(table.subject, entry, yours, right, tolerance,
         same ? std::vector<Suspect>{} : table.explain(yours, otherwise));
}

}  // namespace joints::testing
