// Exercise 8.2: the two directions of friction as a table of cases, with the usual mistakes.
#pragma once

#include "chapters/08_ground/ground.h"
#include "tests/checker/arguments.h"
#include "tests/checker/vector_cases.h"

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
  for (const real speed : {real(1.5e-2), real(1.5e-3), real(2e-4)}) {  // slow, and it does slide
    const std::string slow = "slow, " + short_number(double(speed)) + " m/s";
    out.push_back({slow, y, speed * vec3(real(0.6), 0, real(0.8))});
    out.push_back({slow + ", wall", x, speed * vec3(0, real(0.6), real(0.8))});
    const quat tilt = random.turn();
    out.push_back({slow + ", tilted", tilt * y, speed * (tilt * vec3(real(-0.8), 0, real(0.6)))});
  }
  return out;
}
/// One vector that stands in for the sliding at every n would lie in the plane of n and t1, or be
/// at right angles to t1: if yours is one, it is among these. Any other is just one more n.
inline std::vector<vec3> stand_ins() {
  const vec3 a = normalize(vec3(1, real(-0.3), real(0.5))), b = normalize(vec3(real(0.2), 1, -2));
  const vec3 t = tangents(a, vec3(0))[0], u = tangents(b, vec3(0))[0];
  std::vector<vec3> out;
  for (const vec3& v : {cross(cross(a, t), cross(b, u)), cross(t, u)})
    if (length(v) > real(0.01) && std::isfinite(double(length(v)))) out.push_back(normalize(v));
  return out;
}

/// Where nothing slides: at rest, where the velocity is along n, and where hardly any of it is not.
inline std::vector<TangentCase> rest_cases() {
  const vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  std::vector<TangentCase> out;
  const auto add = [&](const std::string& name, const vec3& n) {
    out.push_back({"at rest, " + name, n, vec3(0)});
    out.push_back({"falling, " + name, n, real(-3) * n});
    out.push_back({"rising, " + name, n, real(1e-3) * n});
    const vec3 aside = std::abs(n.x) < real(0.6) ? cross(n, x) : cross(n, y);
    out.push_back({"falling aside, " + name, n, real(-3) * n + real(5e-5) * normalize(aside)});
    out.push_back({"creeping, " + name, n, real(5e-5) * normalize(aside)});
  };
  add("n = x", x);
  add("n = -x", -x);
  add("n = y", y);
  add("n = -y", -y);
  add("n = z", z);
  add("n = -z", -z);
  for (const real i : {-1, 0, 1})
    for (const real j : {-1, 0, 1})
      for (const real k : {-1, 0, 1})
        if (std::abs(i) + std::abs(j) + std::abs(k) > 1)
          add("n along (" + short_number(double(i)) + ", " + short_number(double(j)) + ", " +
                  short_number(double(k)) + ")", normalize(vec3(i, j, k)));
  add("n askew", {real(0.6), real(0.8), 0});
  add("n near x", normalize(vec3(1, real(0.01), real(-0.02))));
  add("n near y", normalize(vec3(real(0.01), 1, real(0.02))));
  Random random(820);
  for (int draw = 0; draw < 20; ++draw) add("tilted", random.turn() * y);
  for (const vec3& v : stand_ins())
    for (const real sign : {1, -1}) add("n parallel to the substitute", sign * v);
  return out;
}

/// The arguments of a case, for the report.
inline std::string tangent_given(const TangentCase& c) {
  const auto words = [](const vec3& a) {
    return "(" + short_number(double(a.x)) + ", " + short_number(double(a.y)) + ", " +
           short_number(double(a.z)) + ")";
  };
  return "Case: n " + words(c.n) + ", sliding " + words(c.sliding) + " m/s.";
}

inline const char* const stand_in_along_n =
    "#one-stand-in the substitute for the sliding is parallel to n here, so that nothing of it "
    "remains: choose it depending on n";

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
          ? "#lost-at-rest a zero vector has no direction, 0/0 is not a number. Where less than "
            "1e-4 m/s remains, begin with any vector that is not parallel to n"
      : lost_at_rest > 0
          ? stand_in_along_n
          : "#whole-velocity-asked the whole velocity decides whether the point slides: only its "
            "part across n does";
  fail(rest_subject, "t1 or t2 is not a number (" + first + ").\n\nLikely mistake: " + why + "\n");
}

inline CaseTable<TangentCase> tangent_table() {
  using Case = TangentCase;
  const auto unit = [](const vec3& a) { return length(a) > 0 ? normalize(a) : a; };
  const auto numbers = [](const vec3& t1, const vec3& t2) {
    return flat(std::vector<vec3>{t1, t2});
  };
  const auto across = [](const Case& c) { return cross(c.n, cross(c.sliding, c.n)); };
  const auto t1 = [=](const Case& c) { return normalize(across(c)); };
  // another t1, with t2 = n x t1
  const auto with = [=](auto other) {
    return [=](const Case& c) { return numbers(other(c), cross(c.n, other(c))); };
  };
  // another t2
  const auto beside = [=](auto other) {
    return [=](const Case& c) { return numbers(t1(c), other(c)); };
  };
  // your t1 at rest
  const auto resting = [](const Case& c) { return tangents(c.n, vec3(0))[0]; };
  // what counts as nothing below another speed
  const auto nothing_below = [=](real speed) {
    return with([=](const Case& c) { return length(across(c)) < speed ? resting(c) : t1(c); });
  };
  // what stands in for the sliding at rest
  const auto stand_in = [](const Case& c) {
    vec3 axis(0);
    axis[std::abs(c.n.x) < real(0.6) ? 0 : 1] = 1;
    return axis;
  };
  const char* const ignored = "#velocity-forgotten the velocity is ignored, or replaced by a "
                              "variable that was never set: t1 is the direction of sliding";
  const char* const nothing = "slow sliding is ignored: only below 1e-4 m/s across n may t1 be any "
                              "direction";
  const char* const against = "#against-the-sliding t1 is opposite to the sliding: it is the "
                              "direction of sliding, and the impulse is negative";
  const char* const aside = "#across-the-sliding t1 is n x sliding, at right angles to it: t1 is "
                            "the direction of sliding";
  const char* const whole = "#not-projected the part along n is not subtracted: t1 lies in the "
                            "ground";
  const char* const length_1 = "#t1-not-unit-vector t1 is not a unit vector: divide by the length "
                               "of the remaining vector";
  const char* const left_handed = "#left-handed t2 = t1 x n: it is n x t1, so that n, t1 and t2 "
                                  "go round like x, y and z";

  const vec3 fixed_t1 = tangents(tangent_cases()[0].n, tangent_cases()[0].sliding)[0];
  const vec3 fixed_t2 = tangents(tangent_cases()[0].n, tangent_cases()[0].sliding)[1];
  CaseTable<Case> table{{"8.2", "the two directions of friction"}, {"t1", "t2"}, {}, {}, {}, {}};
  table.given = tangent_given;
  table.yours = [=](const Case& c) {
    const std::array<vec3, 2> t = tangents(c.n, c.sliding);
    return numbers(t[0], t[1]);
  };
  table.right = with(t1);
  table.mistakes = {
      {nothing, nothing_below(real(5e-4))},
      {std::string(nothing) + ". Or is a squared length compared with it?",
       nothing_below(real(5e-3))},
      {nothing, nothing_below(real(0.1))},
      {nothing, nothing_below(1)},
      {whole, with([](const Case& c) { return normalize(c.sliding); })},
      {std::string(whole) + ", and it is a unit vector", with([](const Case& c) {
         return c.sliding;
       })},
      {whole, [=](const Case& c) {
         return numbers(normalize(c.sliding), normalize(cross(c.n, c.sliding)));
       }},
      {length_1, with(across)},
      {length_1, [=](const Case& c) { return numbers(across(c), cross(c.n, t1(c))); }},
      {"#t2-not-unit-vector t2 is not a unit vector: take n x t1 with the t1 that has been made "
       "one",
       beside([=](const Case& c) { return cross(c.n, across(c)); })},
      {"#made-unit-vector-first normalised first, then the part along n is subtracted: the other "
       "way round",
       with([](const Case& c) {
         const vec3 s = normalize(c.sliding);
         return s - dot(c.n, s) * c.n;
       })},
      {"divided by the square of the length",
       with([=](const Case& c) { return across(c) / dot(across(c), across(c)); })},
      {"#sign-what-along-n the sign of the part along n: it is subtracted, s = v - (n.v) n",
       with([](const Case& c) { return normalize(c.sliding + dot(c.n, c.sliding) * c.n); })},
      {"#only-along-n only the part along n is kept: that is the one to subtract",
       with([=](const Case& c) {
         const real part = dot(c.n, c.sliding);
         return std::abs(part) < real(1e-4) ? resting(c) : part < 0 ? -c.n : c.n;
       })},
      {"the subtracted part is along the velocity: it is along n, (n.v) n and not (n.v) v",
       with([=](const Case& c) { return unit(c.sliding - dot(c.n, c.sliding) * c.sliding); })},
      {"#n-taken-away n itself is subtracted: subtract the part of the velocity along it, (n.v) n",
       with([=](const Case& c) { return unit(c.sliding - c.n); })},
      {"#half-n-taken-away half of the part along n is subtracted: subtract all of it",
       with([=](const Case& c) {
         return unit(c.sliding - real(0.5) * dot(c.n, c.sliding) * c.n);
       })},
      {"the part along n is subtracted twice: once", with([=](const Case& c) {
         return unit(c.sliding - real(2) * dot(c.n, c.sliding) * c.n);
       })},
      {"the x part of the velocity is subtracted: n may be another axis",
       with([=](const Case& c) { return unit(c.sliding - vec3(c.sliding.x, 0, 0)); })},
      {"#largest-entry divided by the largest entry: by the length", with([=](const Case& c) {
         const vec3 a = across(c);
         return a / std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
       })},
      {"divided by the sum of the entries: by the length", with([=](const Case& c) {
         const vec3 a = across(c);
         return a / (std::abs(a.x) + std::abs(a.y) + std::abs(a.z));
       })},
      {"#fixed-across t2 is always the same: t2 = n x t1",
       beside([=](const Case&) { return fixed_t2; })},
      {"t1 and t2 are always the same: t1 is the direction of sliding. Was a variable never set?",
       [=](const Case&) { return numbers(fixed_t1, fixed_t2); }},
      {"#y-taken-away the y part of the velocity is subtracted: n may be another axis",
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
      {ignored, with(resting)},
      {left_handed, beside([=](const Case& c) { return cross(t1(c), c.n); })},
      {"#exchanged t1 and t2 are exchanged: the first one is the direction of sliding",
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

}  // namespace joints::testing
