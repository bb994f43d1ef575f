// Exercise 6.2 as a table of cases and a list of scenes, each with its usual mistakes: the warm
// start, and when it is safe.
#pragma once

#include <algorithm>

#include "chapters/06_baumgarte/baumgarte.h"
#include "tests/checker/cases.h"
#include "tests/checker/fixtures.h"

namespace joints::testing {

// ---- numbers that are vectors -------------------------------------------------------------------

/// One case of a table whose numbers are vectors, three after three; an entry is one of them.
template <class Case>
void check_vectors(const CaseTable<Case>& table, const Case& c, const Numbers& expected,
                   double tolerance) {
  const Numbers numbers = table.yours(c);
  const auto at = [](const Numbers& a, std::size_t k) {
    return vec3(real(a[3 * k]), real(a[3 * k + 1]), real(a[3 * k + 2]));
  };
  std::vector<std::string> likely;
  if (!close(numbers, expected, tolerance)) likely = table.likely({c});
  for (std::size_t k = 0; k < table.entries.size(); ++k) {
    std::vector<VectorSuspect> suspects;
    for (const std::string& words : likely) suspects.push_back({at(numbers, k), words});
    expect(table.subject, table.entries[k] + " (" + c.words + ")", at(numbers, k),
           at(expected, k), tolerance, suspects);
  }
}
template <class Case>
void check_vectors(const CaseTable<Case>& table) {
  for (const Case& c : table.cases) check_vectors(table, c, table.right(c), table.tolerance);
}

/// For a test of another kind: whatever vector it finds wrong, the table's mistake explains it.
template <class Case>
std::vector<VectorSuspect> why(const CaseTable<Case>& table, const vec3& yours) {
  std::vector<VectorSuspect> out;
  for (const std::string& words : table.likely()) out.push_back({yours, words});
  return out;
}

/// M^-1 J^T lambda: what an impulse does to velocities, or Eq. 6-11 to poses.
struct Moves {
  vec3 way1{0}, turn1{0}, way2{0}, turn2{0};
};
template <int N>
Moves response(const Jacobian<N>& J, const Vector<N>& lambda, const Pair& pair) {
  Moves out;
  for (int i = 0; i < N; ++i) {
    out.way1 += pair.body1.inverse_mass * lambda[i] * J[i].v1;
    out.turn1 += inverse_inertia(pair.body1) * (lambda[i] * J[i].w1);
    out.way2 += pair.body2.inverse_mass * lambda[i] * J[i].v2;
    out.turn2 += inverse_inertia(pair.body2) * (lambda[i] * J[i].w2);
  }
  return out;
}
inline Moves scaled(real one, real two, const Moves& a) {
  return {one * a.way1, one * a.turn1, two * a.way2, two * a.turn2};
}
inline Numbers flat(const std::vector<vec3>& vectors) {
  Numbers out;
  for (const vec3& a : vectors) out.insert(out.end(), {double(a.x), double(a.y), double(a.z)});
  return out;
}

// ---- 6.2 the warm start -------------------------------------------------------------------------

struct WarmCase {
  std::string words;
  Jacobian<3> J;
  double ratio;
  vec3 lambda;
  Pair pair;
};

/// The rows of a ball joint between two turned bodies that fly and spin.
inline WarmCase warm_case(const std::string& words, double ratio, unsigned seed) {
  Random random(seed);
  Pair pair = uneven_pair();
  move_together(pair, random);
  for (Body* body : {&pair.body1, &pair.body2}) {
    body->v = random.vector(2);
    body->w = random.vector(2);
  }
  const Point part = point_at(pair.body1, pair.body2, pair.body1.x + random.vector(1));
  return {words, numeric_jacobian(part, pair.body1, pair.body2), ratio, random.vector(2), pair};
}

inline CaseTable<WarmCase> warm_table() {
  using Case = WarmCase;
  const auto of = [](const vec3& lambda, const Moves& a) {
    return flat({lambda, a.way1, a.turn1, a.way2, a.turn2});
  };
  const auto moves = [](const Case& c) { return response<3>(c.J, to_vector(c.lambda), c.pair); };
  // what is kept of lambda, and what body 1 and body 2 are given of it, by the ratio
  const auto shares = [=](auto share) {
    return [=](const Case& c) {
      const std::array<double, 3> a = share(c.ratio);
      return of(real(a[0]) * c.lambda, scaled(real(a[1]), real(a[2]), moves(c)));
    };
  };
  using A = std::array<double, 3>;
  CaseTable<Case> table{{"6.2", "the warm start"},
                        {"lambda kept", "change of v1", "change of w1", "change of v2",
                         "change of w2"}, {}, {}, {}, {}};
  table.yours = [=](const Case& c) {
    vec3 lambda = c.lambda;
    Pair after = c.pair;
    warm_start(c.J, real(c.ratio), lambda, after.body1, after.body2);
    return of(lambda, {after.body1.v - c.pair.body1.v, after.body1.w - c.pair.body1.w,
                       after.body2.v - c.pair.body2.v, after.body2.w - c.pair.body2.w});
  };
  table.right = shares([](double r) { return A{r, r, r}; });
  table.mistakes = {
      {"nothing is applied where the step has not changed: the bodies feel lambda in every step",
       shares([](double r) { return r == 1 ? A{1, 0, 0} : A{r, r, r}; })},
      {"the ratio is cut to a whole number: it is a real, and half a step is 0.5",
       shares([](double r) { return A{std::floor(r), std::floor(r), std::floor(r)}; })},
      {"only v changes: lambda turns the bodies, too, w gets its share",
       [=](const Case& c) {
         Moves a = scaled(real(c.ratio), real(c.ratio), moves(c));
         a.turn1 = a.turn2 = vec3(0);
         return of(real(c.ratio) * c.lambda, a);
       }},
      {"only w changes: lambda pushes the bodies, too, v gets its share",
       [=](const Case& c) {
         Moves a = scaled(real(c.ratio), real(c.ratio), moves(c));
         a.way1 = a.way2 = vec3(0);
         return of(real(c.ratio) * c.lambda, a);
       }},
      {"the ratio is forgotten: half a step needs half the impulse",
       shares([](double) { return A{1, 1, 1}; })},
      {"divided by the ratio: half a step needs half the impulse",
       shares([](double r) { return A{1 / r, 1 / r, 1 / r}; })},
      {"lambda is set to zero: it must hold what has been applied, for the sweeps go on from there",
       shares([](double r) { return A{0, r, r}; })},
      {"lambda is set to zero, and the ratio is forgotten",
       shares([](double) { return A{0, 1, 1}; })},
      {"the old impulse is applied and the scaled one is kept: scale first, then apply",
       shares([](double r) { return A{r, 1, 1}; })},
      {"the scaled impulse is applied and the old one is kept: lambda must hold what was applied",
       shares([](double r) { return A{1, r, r}; })},
      {"the impulse is applied twice: the sweeps begin where it has been applied once",
       shares([](double r) { return A{r, 2 * r, 2 * r}; })},
      {"the ratio is taken twice for what is applied",
       shares([](double r) { return A{r, r * r, r * r}; })},
      {"the ratio is taken twice", shares([](double r) { return A{r * r, r * r, r * r}; })},
      {"only body 2 feels it: body 1 gets the opposite push, and a turn of its own",
       shares([](double r) { return A{r, 0, r}; })},
      {"only body 1 feels it: +lambda acts on body 2", shares([](double r) { return A{r, r, 0}; })},
      {"the sign of what is applied: +M^-1 J^T lambda, as apply_impulse does",
       shares([](double r) { return A{r, -r, -r}; })},
      {"the sign: the impulse of this step has the sign of the last one",
       shares([](double r) { return A{-r, -r, -r}; })},
      {"nothing is applied: lambda is scaled, but the bodies do not feel it",
       shares([](double r) { return A{r, 0, 0}; })},
      {"nothing is done yet, or copies are changed: lambda is a reference, and so are the bodies",
       shares([](double) { return A{1, 0, 0}; })},
      {"added to the old impulse where it takes its place: = and not +=",
       shares([](double r) { return A{1 + r, r, r}; })},
      {"added to the old impulse where it takes its place: = and not +=",
       shares([](double r) { return A{1 + r, 1 + r, 1 + r}; })},
      {"the bodies are exchanged: body 1 first, then body 2", [=](const Case& c) {
         const Moves a = response<3>(c.J, to_vector(real(c.ratio) * c.lambda),
                                     {c.pair.body2, c.pair.body1});
         return of(real(c.ratio) * c.lambda, {a.way2, a.turn2, a.way1, a.turn1});
       }}};
  table.cases = {warm_case("shorter step", 0.5, 621), warm_case("equal steps", 1, 622),
                 warm_case("longer step", 1.5, 623), warm_case("1 static", 0.8, 624)};
  Body& wall = table.cases.back().pair.body1;
  wall = static_body(wall.x, wall.q);
  table.tolerance = 10 * rounding;
  return table;
}

// ---- 6.2 when it is safe ------------------------------------------------------------------------

inline constexpr Subject criterion{"6.2", "is a warm start safe? (1 yes, 0 no)", 2};

struct SafetyCase {
  double rho;
  int sweeps;
  double beta;
  bool safe;
  std::string words() const {
    return "rho " + short_number(rho) + " sweeps " + std::to_string(sweeps) + " beta " +
           short_number(beta);
  }
};
inline const double ten_links = std::pow(std::cos(std::acos(-1.0) / 20), 2);  // rho of a chain
inline const SafetyCase safety_cases[] = {
    {ten_links, 4, 0.15, false}, {ten_links, 6, 0.15, true}, {ten_links, 10, 0.15, true},
    {ten_links, 10, 0.5, false}, {ten_links, 30, 0.8, true}, {0.9, 1, 0.05, true},
    {0.9, 1, 0.15, false},       {0.9, 2, 0.3, false},       {0.9, 8, 0.9, true},
    {0.99, 30, 0.2, true},       {0.99, 10, 0.2, false},     {0.7, 1, 1, false},
    {0.7, 2, 1, true},           {0.2, 1, 1.5, true},        {0.6, 1, 0.5, true},
    {0.5, 1, 1, false},          {1, 10, 0, false},          {1, 10, 0.2, false},
    {0.999, 10, 0, true},        {0, 1, 1.9, true},          {0.99, 10, 0.5, false},
    {0.9, 1, 1.5, false},       {ten_links, 5, 0.15, false}};

// One row whose sweeps each leave the share rho of what is wrong, with a weight on it, warm: how
// far is it from its place in the end?
inline double runs_away(const SafetyCase& scene) {
  const double h = 1.0 / 60;
  double C = 1e-3, v = 0, kept = 0;  // for 1 kg
  for (int step = 0; step < 2000; ++step) {
    v += -9.81 * h + kept;
    for (int sweep = 0; sweep < scene.sweeps; ++sweep) {
      const double lambda = -(1 - scene.rho) * (v + scene.beta * C / h);
      v += lambda;
      kept += lambda;
    }
    C += h * v;
  }
  return std::abs(C);
}

using SafetyRule = std::function<bool(double, int, double)>;
inline const std::pair<SafetyRule, const char*> wrong_safety_rules[] = {
    {[](double rho, int k, double beta) { return rho * k * (1 + beta) < 1; },
     "rho times k: each sweep leaves rho of what the last one left, that is rho to the power k"},
    {[](double rho, int, double beta) { return rho * (1 + beta) < 1; },
     "the sweeps are forgotten: k of them leave rho to the power k. Or 1 + beta has the power k, "
     "too: only rho has it"},
    {[](double rho, int k, double beta) { return std::pow(rho, 0.5 * k) * (1 + beta) < 1; },
     "the square root: rho is what a whole sweep leaves"},
    {[](double rho, int k, double beta) { return std::pow(rho, 2 * k) * (1 + beta) < 1; },
     "twice the sweeps: rho is what a whole sweep leaves"},
    {[](double rho, int k, double beta) { return std::pow(rho, k - 1) * (1 + beta) < 1; },
     "one sweep less: k sweeps leave rho to the power k, the first one counts, too"},
    {[](double rho, int k, double beta) { return std::pow(rho, k + 1) * (1 + beta) < 1; },
     "one sweep more: k sweeps leave rho to the power k"},
    {[](double rho, int k, double beta) { return std::pow(rho, k) / (1 - beta) < 1; },
     "divided by 1 - beta: rho^k is multiplied by 1 + beta"},
    {[](double rho, int k, double beta) { return std::pow(rho, k) < 1 / beta; },
     "1 is forgotten: 1 + beta and not beta"},
    {[](double rho, int k, double beta) { return std::pow(rho, k) * (1 - beta) < 1; },
     "the sign of beta, or 1 + beta stands on the other side: rho^k times (1 + beta) is compared "
     "with 1. (1 - beta is what a cold step leaves of an error)"},
    {[](double rho, int k, double beta) { return std::pow(rho, k) * (1 + 2 * beta) < 1; },
     "twice beta: it comes once a step"},
    {[](double rho, int k, double beta) { return std::pow(rho, k) + beta < 1; },
     "rho^k + beta < 1, that is rho^k < 1 - beta: rho^k is multiplied by 1 + beta"},
    {[](double rho, int k, double) { return std::pow(rho, k) < 1; },
     "beta is forgotten: the error that is fed back comes on top"},
    {[](double rho, int k, double beta) { return std::pow(rho, k) < beta; },
     "compared with beta: Eq. 6-9 compares rho^k (1 + beta) with 1"},
    {[](double rho, int k, double beta) { return std::pow(rho, k) * (1 + beta) <= 1; },
     "at the bound nothing dies away: < and not <="},
    {[](double rho, int k, double beta) { return std::pow(rho, k) * (1 + beta) > 1; },
     "the other way round: true means safe"},
    {[](double rho, int k, double beta) { return std::pow(rho, k) * (1 + beta) >= 1; },
     "the other way round: true means safe"},
    {[](double, int, double) { return true; }, "it is always safe"},
    {[](double, int, double) { return false; },
     "it is never safe. Are base and exponent exchanged? rho to the power k"}};

/// What explains the reader's answers to all scenes.
inline std::vector<Suspect> explain_criterion(double yours) {
  std::vector<Suspect> out;
  for (const auto& [rule, words] : wrong_safety_rules)
    if (std::all_of(std::begin(safety_cases), std::end(safety_cases),
                    [&rule = rule](const SafetyCase& s) {
                      return rule(s.rho, s.sweeps, s.beta) ==
                             warm_start_is_safe(real(s.rho), s.sweeps, real(s.beta));
                    }))
      out.push_back({yours, words});
  return out;
}

}  // namespace joints::testing
