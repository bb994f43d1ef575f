// Exercise 8.2: the two directions of friction as a table of cases.
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
  for (const vec3& off : {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)})
    add("n hardly off an axis", normalize(off + real(is_float ? 0.02 : 1e-8) * vec3(1, -2, 1)));
  Random random(820);
  for (int draw = 0; draw < 20; ++draw) add("tilted", random.turn() * y);
  for (const vec3& v : stand_ins())
    for (const real sign : {1, -1}) add("n parallel to the substitute", sign * v);
  return out;
}

/// The arguments of a case, for the report.
inline std::string tangent_given(const TangentCase& c) {
  return "Case: n " + in_words(c.n) + ", sliding " + in_words(c.sliding) + " m/s.";
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
  CaseTable<Case> table{{"8.2", "the two directions of friction"}, {"t1", "t2"}, {}, {}, {}, {}};
  table.given = tangent_given;
  judge(table, tangents, [](auto two, const Case& c) {
    const auto [t1, t2] = two(c.n, c.sliding);
    return flat(std::vector<vec3>{t1, t2});
  });
  table.right = [](const Case& c) {
    const vec3 t1 = normalize(cross(c.n, cross(c.sliding, c.n)));
    return flat(std::vector<vec3>{t1, cross(c.n, t1)});
  };
  table.cases = tangent_cases();
  table.tolerance = 10 * rounding;
  // what is always the same is so in another way in each answer
  const Numbers first = table.yours(table.cases[0]);
  table.mistakes.push_back(
      {"#fixed-across t2 is always the same: t2 = n x t1", [=, right = table.right](const Case& c) {
        Numbers out = right(c);
        std::copy(first.begin() + 3, first.end(), out.begin() + 3);
        return out;
      }});
  table.mistakes.push_back(
      {"t1 and t2 are always the same: t1 is the direction of sliding. Was a variable never set?",
       [=](const Case&) { return first; }});
  return table;
}

}  // namespace joints::testing
