// Exercise 9.2: what is solved with the factor as a table.
#pragma once

#include "tests/09_direct/factor_cases.h"

namespace joints::testing {

/// Right-hand sides: a row each.
inline std::vector<Numbers> right_sides(const MatrixCase& c) {
  Random random(92);
  std::vector<Numbers> out(3, Numbers(std::size_t(c.size()), 0));
  if (c.size() > 0) out[0][0] = 4;
  for (std::size_t k = 1; k < 3; ++k)
    for (double& b : out[k]) b = double(random.uniform(-3, 3));
  return out;
}

inline constexpr std::size_t numbers_of_solve = 72;

inline CaseTable<MatrixCase> solve_table() {
  auto table = padded_table<MatrixCase>(
      {"9.2", "the solution x with the factor", 2}, numbers_of_solve, [](const MatrixCase& c) {
        std::vector<std::string> out;
        for (int k = 1; k <= 3; ++k)
          for (int i = 0; i < c.size(); ++i)
            out.push_back("x[" + std::to_string(i) + "] for b " + std::to_string(k) + ", node " +
                          std::to_string(node_of(c, i)));
        return out;
      });
  const auto all = [](const MatrixCase& c, auto solved) {
    Numbers out;
    for (const Numbers& b : right_sides(c)) {
      const Numbers x = solved(b);
      out.insert(out.end(), x.begin(), x.end());
    }
    return padded(out, numbers_of_solve);
  };
  table.cases = matrix_cases();
  judge(table, solve,
        [=](auto solve, const MatrixCase& c) {
          const JointMatrix A = right_factor(c);
          return all(c, [&](Numbers x) {
            x.resize(x.size() + 8, 0);
            solve(A, x.data());
            x.resize(x.size() - 8);
            return x;
          });
        });
  table.right = [=](const MatrixCase& c) {
    return all(c, [&](const Numbers& b) { return gauss(c.A, b); });
  };
  tell_where_it_holds(table);
  return table;
}

// ---- both together ------------------------------------------------------------------------------

inline constexpr Subject whole_subject{"9.2", "the solution x with your own factor", 1};

/// The original entries that came with the pivots, in the order of elimination.
inline Numbers pivots_seen;

inline void check_originals(const MatrixCase& c) {
  pivots_seen.clear();
  JointMatrix A = joint_matrix(c);
  factor(A, [](double pivot, double original) {
    pivots_seen.push_back(original);
    return pivot > 1e-9 * original ? 1 / pivot : 0;
  });
  const Numbers& seen = pivots_seen;
  std::size_t n = 0;
  const std::string given = "Matrix: " + c.words + ".";
  const Subject about{"9.2", "the original entry that comes with a pivot", 1, given.c_str()};
  for (int k = 0; k < c.count(); ++k)
    for (int i = 0; i < c.rows[std::size_t(k)]; ++i, ++n) {
      const int row = c.first(k) + i;
      const double yours = n < seen.size() ? seen[n] : 0;
      expect(about,
             "entry of row " + std::to_string(row) + ", node " + std::to_string(k),
             yours, c.A(row, row), 0,
             {{yours, n >= seen.size()
                          ? "#inverse-own `inverse` is not called for this pivot: pass it to "
                            "factor_block()"
                          : "the entry before any product was subtracted: &A.original[node.row], "
                            "each node has its own"}});
    }
}

/// The solution where the dropped row's x is 0 and its equation is left out.
inline Numbers without_dropped(const MatrixCase& c, const Numbers& b) {
  const int gone = c.dropped[0];
  Dense A = c.A;
  Numbers right = b;
  for (int i = 0; i < c.size(); ++i) A(gone, i) = A(i, gone) = 0;
  A(gone, gone) = 1;
  right[std::size_t(gone)] = 0;
  return gauss(A, right);
}

/// factor() and solve() after one another.
inline void check_whole(const MatrixCase& c, const Numbers& b, const Numbers& right) {
  JointMatrix A = joint_matrix(c);
  factor(A, c.inverse);
  Numbers x = b;
  solve(A, x.data());
  const std::string given = "Matrix: " + c.words + ".";
  Subject about = whole_subject;
  about.given = given.c_str();
  for (std::size_t i = 0; i < x.size(); ++i)
    expect(about, "x[" + std::to_string(i) + "]", x[i], right[i],
           1e-8 * (1 + std::abs(right[i])));
}

}  // namespace joints::testing
