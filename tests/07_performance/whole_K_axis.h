// Exercise 7.2: what can go wrong in K in the axis' 2x2.
#pragma once

#include "tests/07_performance/whole_K_parts.h"

namespace joints::testing {

inline const char* const told_axis_dot_product_same =
    "#axis-dot-product-same the dot product is taken with the same row twice: row i with column "
    "j,";

inline KPart axis_part() {
  using S = KSource;
  const auto products = [](auto I, auto column) {  // a_i . I a_column
    return [=](const S& s, std::size_t k) {
      mat3 out(0);
      for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j)
          out[int(j)][int(i)] = dot(s.a[i], I(s, k) * s.a[column(j)]);
      return out;
    };
  };
  const auto I = [](const S& s, std::size_t k) { return s.I[k]; };
  const auto same = [](std::size_t j) { return j; };
  const auto where = [](auto entry) {
    return [=](const mat3& A, const S& s) {
      Matrix<5> K;
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) K[3 + i][3 + j] = entry(A, i, j, s);
      return K;
    };
  };
  const auto kept = [=](auto keep) {
    return where([=](const mat3& A, int i, int j, const S&) {
      return keep(i, j) ? A[j][i] : real(0);
    });
  };
  const char* const one_side = "it is filled on one side of its diagonal only: K is symmetric,";
  return {
      " in the axis' 2x2",
      {{"", "", products(I, same)},
       {"body % is missing", "it is not written yet",
        [](const S&, std::size_t) { return mat3(0); }},
       {"the sign of body %: the terms of both bodies are added", "the sign",
        products([](const S& s, std::size_t k) { return -s.I[k]; }, same)},
       {"I@ in the place of I%", "",
        products([](const S& s, std::size_t k) { return s.I[1 - k]; }, same)},
       {"I% is missing", "the inverse inertias are missing",
        products([](const S&, std::size_t) { return mat3(1); }, same)},
       {"I% of the first axis row in both columns", "I of the first axis row in both columns",
        products(I, [](std::size_t) { return std::size_t(0); })},
       {"I% of the second axis row in both columns", "I of the second axis row in both columns",
        products(I, [](std::size_t) { return std::size_t(1); })},
       {"I% of the other axis row", "I of the other axis row",
        products(I, [](std::size_t j) { return 1 - j; })},
       {"body % is added twice", "both bodies are added twice",
        products([](const S& s, std::size_t k) { return real(2) * s.I[k]; }, same)}},
      {{"", kept([](int, int) { return true; })},
       {"the inverse masses are added: these rows turn and do not push,",
        where([](const mat3& A, int i, int j, const S& s) {
          return A[j][i] + (i == j ? s.masses() : real(0));
        })},
       {"the entries beside the diagonal are missing: its rows change each other's rates,",
        kept([](int i, int j) { return i == j; })},
       {"the inverse inertias are missing, and so is one of the bodies",
        where([](const mat3&, int i, int j, const S& s) {
          return dot(s.a[std::size_t(i)], s.a[std::size_t(j)]);
        })},
       {one_side, kept([](int i, int j) { return i <= j; })},
       {one_side, kept([](int i, int j) { return i >= j; })},
       {"its second column is missing,", kept([](int, int j) { return j == 0; })},
       {"its first column is missing,", kept([](int, int j) { return j == 1; })},
       {told_axis_dot_product_same,
        where([](const mat3& A, int, int j, const S&) { return A[j][j]; })},
       {told_axis_dot_product_same,
        where([](const mat3& A, int i, int, const S&) { return A[i][i]; })},
       {"the first axis row stands on the left in both rows: row i, not row[0],",
        where([](const mat3& A, int, int j, const S&) { return A[j][0]; })},
       {"the first axis row twice", where([](const mat3& A, int, int, const S&) {
          return A[0][0];
        })},
       {"the second axis row twice", where([](const mat3& A, int, int, const S&) {
          return A[1][1];
        })},
       {"the axis rows are exchanged", where([](const mat3& A, int i, int j, const S&) {
          return A[1 - j][1 - i];
        })}}};
}

}  // namespace joints::testing
