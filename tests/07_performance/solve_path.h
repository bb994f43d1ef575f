// Exercise 7.4: the path of a solve, e, lambda, P and T, as it should be and as it must have been
// for the reader's velocities to come out: where do the two part?
#pragma once

#include <cstdio>

#include "tests/07_performance/solve_cases.h"
#include "tests/checker/arguments.h"

namespace joints::testing {

/// The numbers on the way from the velocities before to those after. P and T are known from both
/// bodies, e and lambda from body 2.
struct SolvePath {
  Vector<5> e, lambda;
  std::array<vec3, 2> P, T;
};

inline SolvePath right_path(const SolveCase& c) {
  const SolveReference reference(c);
  SolvePath out;
  out.e = reference.e();
  out.lambda = reference.lambda();
  out.P.fill(vec3(out.lambda[0], out.lambda[1], out.lambda[2]));
  out.T.fill(out.lambda[3] * reference.a[0] + out.lambda[4] * reference.a[1]);
  return out;
}
/// Worked back from velocities after a solve; both bodies have to move.
inline SolvePath path_to(const SolveCase& c, const FourVelocities& after) {
  const SolveReference reference(c);
  SolvePath out;
  for (std::size_t k = 0; k < 2; ++k) {
    const real sign = k == 0 ? -1 : 1;
    const auto given = [&](std::size_t line) {
      return sign * (inverse(reference.inverse_M[line]) * (after[line] - reference.V[line]));
    };
    out.P[k] = given(2 * k);
    out.T[k] = given(2 * k + 1) - cross(k == 0 ? reference.r1 : reference.r2, out.P[k]);
  }
  // T = lambda4 a_1 + lambda5 a_2, as near as can be
  const vec3 &a = reference.a[0], &b = reference.a[1], &T = out.T[1];
  const real aa = dot(a, a), ab = dot(a, b), bb = dot(b, b), det = aa * bb - ab * ab;
  const real x = dot(a, T), y = dot(b, T);
  out.lambda = {out.P[1].x, out.P[1].y, out.P[1].z, (bb * x - ab * y) / det,
                (aa * y - ab * x) / det};
  Matrix<5> K = reference.inverse_K;
  invert_symmetric(K[0].data(), 5);
  out.e = {};
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      out.e[std::size_t(i)] -= K[i][j] * out.lambda[std::size_t(j)];
  return out;
}
inline bool both_move(const SolveCase& c) {
  return c.body1.inverse_mass > 0 && c.body2.inverse_mass > 0;
}
inline Numbers numbers_of(const vec3& a) { return {double(a.x), double(a.y), double(a.z)}; }
inline Numbers numbers_of(const Vector<5>& a) { return Numbers(a.begin(), a.end()); }
inline constexpr double path_tolerance = is_float ? 1e-2 : 1e-8;

/// The path of Eq. 7-6 step by step, and beside it yours.
inline std::string path_words(const SolveCase& c) {
  const FourVelocities after = velocities_of(solved(c));
  const bool two = both_move(c) && all_finite(flat(after)) && no_number(flat(after)).empty();
  const SolvePath right = right_path(c), yours = two ? path_to(c, after) : right;
  std::string out = two ? "\nThe path of Eq. 7-6. Yours is worked back from your velocities:\n"
                        : "\nThe path of Eq. 7-6, as it should be:\n";
  const auto line = [&](const char* step, const std::string& whose, const Numbers& numbers,
                        bool same) {
    char text[200];
    std::snprintf(text, sizeof text, "  %-8s%-9s", step, whose.c_str());
    out += text;
    for (const double number : numbers) {
      const double a = std::abs(number) < 5e-5 ? 0 : number;
      std::snprintf(text, sizeof text, std::abs(a) < 1e4 ? "%10.4f" : "%10.1e", a);
      out += text;
    }
    out += same ? "\n" : "  x\n";
  };
  const auto steps = [&](const char* step, const Numbers& expected,
                         const std::vector<std::pair<std::string, Numbers>>& mine) {
    line(step, two ? "right" : "", expected, true);
    for (const auto& [whose, numbers] : mine)
      if (two) line("", whose, numbers, close(numbers, expected, path_tolerance));
  };
  steps("e", numbers_of(right.e), {{"yours", numbers_of(yours.e)}});
  steps("lambda", numbers_of(right.lambda), {{"yours", numbers_of(yours.lambda)}});
  steps("P", numbers_of(right.P[0]),
        {{"from v1", numbers_of(yours.P[0])}, {"from v2", numbers_of(yours.P[1])}});
  steps("T", numbers_of(right.T[0]),
        {{"from w1", numbers_of(yours.T[0])}, {"from w2", numbers_of(yours.T[1])}});
  return out;
}

/// Where on the path yours goes wrong, in words, from all cases in which both bodies move; "" where
/// that cannot be told.
inline std::string place_on_path() {
  bool agree = true;                           // do both bodies say the same of P and T?
  std::array<bool, 4> lines{true, true, true, true};  // does a line say what is right?
  std::vector<Compared> of_e;
  for (const SolveCase& c : solve_cases()) {
    if (!both_move(c)) continue;
    const SolvePath right = right_path(c), yours = path_to(c, velocities_of(solved(c)));
    const auto same = [](const vec3& a, const vec3& b) {
      return close(numbers_of(a), numbers_of(b), path_tolerance);
    };
    const SolveReference reference(c);
    const vec3 T = yours.lambda[3] * reference.a[0] + yours.lambda[4] * reference.a[1];
    agree = agree && same(yours.P[0], yours.P[1]) && same(yours.T[0], yours.T[1]) &&
            same(yours.T[1], T);
    for (std::size_t k = 0; k < 2; ++k) {
      lines[2 * k] = lines[2 * k] && same(yours.P[k], right.P[0]);
      lines[2 * k + 1] = lines[2 * k + 1] && same(yours.T[k], right.T[0]);
    }
    of_e.push_back({numbers_of(yours.e), numbers_of(right.e)});
  }
  const std::vector<std::string> e{"e[0]", "e[1]", "e[2]", "e[3]", "e[4]"};
  std::vector<std::string> wrong;
  if (agree) {
    for (std::size_t i = 0; i < 5; ++i)
      if (std::any_of(of_e.begin(), of_e.end(), [&](const Compared& c) {
            return !near(c.yours[i], c.right[i], path_tolerance);
          }))
        wrong.push_back(e[i]);
    if (wrong.empty() || wrong.size() == 5) return "";
    return "in e, first of all: " + joined(wrong) +
           (wrong.size() == 1 ? " is wrong" : " are wrong") + ", and the rest follows correctly "
                                                              "from e";
  }
  const char* const names[] = {"v1", "w1", "v2", "w2"};
  for (std::size_t k = 0; k < 4; ++k)
    if (!lines[k]) wrong.push_back(names[k]);
  if (wrong.empty() || wrong.size() > 2) return "";
  return std::string("in the ") + (wrong.size() == 1 ? "line of " : "lines of ") + joined(wrong) +
         ": e, lambda, P and T are right, because the other lines are";
}

/// A solve of one hinge beside the right one. Fails with the path in the report.
inline void check_solve(const SolveCase& c, const Numbers& expected, const char* beside) {
  CaseTable<SolveCase> table = solve_table();
  const bool right = close(table.yours(c), expected, table.tolerance);
  read_off(table, [] { return place_on_path(); });
  check_numbers(table, c, expected, beside, right ? "" : path_words(c));
}

}  // namespace joints::testing
