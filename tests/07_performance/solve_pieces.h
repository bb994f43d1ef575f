// Exercise 7.4: the usual mistakes with a solve, each a change of one piece of its path.
#pragma once

#include "tests/07_performance/solve_terms.h"

namespace joints::testing {

/// The mistakes that have a name of their own.
inline Pieces<SolveReference> usual_pieces() {
  using T = SolveReference;
  const auto times = [](Jacobian<5> T::*rows, int from, int to, real v1, real w1, real v2,
                        real w2) {
    return [=](T& t) { t.*rows = T::scaled(t.*rows, from, to, v1, w1, v2, w2); };
  };
  const auto read = &T::read, push = &T::push;
  const auto of_K = [](auto keep) {
    return [=](T& t) {
      for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 5; ++j)
          if (!keep(i, j)) t.inverse_K[i][j] = 0;
    };
  };
  const auto packed = [](auto place) {  // another order of the 15 numbers
    return [=](T& t) {
      const Matrix<5> right = t.inverse_K;
      real numbers[15];
      int n = 0;
      for (int i = 0; i < 5; ++i)
        for (int j = i; j < 5; ++j) numbers[n++] = right[i][j];
      for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 5; ++j) t.inverse_K[i][j] = numbers[place(i, j)];
    };
  };
  const auto rows_with = [](auto r1, auto r2) {
    return [=](T& t) { return hinge_rows(r1(t), r2(t), t.a); };
  };
  const auto exchanged = rows_with([](T& t) { return t.r2; }, [](T& t) { return t.r1; });
  const auto opposite = rows_with([](T& t) { return -t.r1; }, [](T& t) { return -t.r2; });
  const auto swap_rows = [](Jacobian<5>& J) { std::swap(J[3], J[4]); };
  return {
      {"the sign: lambda = -K^-1 e works against e, and +lambda acts on body 2",
       times(push, 0, 5, -1, -1, -1, -1)},
      {"#copies nothing changes: the bodies are references, and lambda is applied to them",
       times(push, 0, 5, 0, 0, 0, 0)},
      {"#both-same-way both bodies are pushed the same way: body 1 gets the opposite of the "
       "impulse of body 2",
       times(push, 0, 5, -1, -1, 1, 1)},
      {"both bodies get the same turn: w1 -= I1 (r1 x P + T)", times(push, 0, 5, 1, -1, 1, 1)},
      {"both bodies get the same push: v1 -= P/m1", times(push, 0, 5, -1, 1, 1, 1)},
      {"#only-body-2 it acts on body 2 only: body 1 gets the opposite",
       times(push, 0, 5, 0, 0, 1, 1)},
      {"it acts on body 1 only: body 2 gets the opposite", times(push, 0, 5, 1, 1, 0, 0)},
      {"the push changes w only: v1 -= P/m1, v2 += P/m2", times(push, 0, 5, 0, 1, 0, 1)},
      {"#turn-only the push changes v only: w gets r x P, too", times(push, 0, 3, 1, 0, 1, 0)},
      {"only v changes: w gets r x P + T", times(push, 0, 5, 1, 0, 1, 0)},
      {"#lambda-over-e lambda is written over e while e is still being read: keep them apart",
       [](T& t) {
         t.on_lambda.push_back([](T& t, Vector<5>& lambda) {
           Vector<5> e = t.e();
           for (std::size_t i = 0; i < 5; ++i) {
             real sum = 0;
             for (std::size_t j = 0; j < 5; ++j) sum -= t.inverse_K[int(i)][int(j)] * e[j];
             e[i] = sum;
           }
           lambda = e;
         });
       }},
      {"#k-over-e K^-1 e is written over e while e is still being read: give inverse_K_times "
       "another array",
       [](T& t) {
         t.on_lambda.push_back([](T& t, Vector<5>& lambda) {
           Vector<5> e = t.e();
           for (std::size_t i = 0; i < 5; ++i) {
             real sum = 0;
             for (std::size_t j = 0; j < 5; ++j) sum += t.inverse_K[int(i)][int(j)] * e[j];
             e[i] = sum;
           }
           for (std::size_t i = 0; i < 5; ++i) lambda[i] = -e[i];
         });
       }},
      {"#without-the-turn the turn T is missing: w gets r x P + T, with T = lambda4 a_1 + lambda5 "
       "a_2",
       times(push, 3, 5, 1, 0, 1, 0)},
      {"the turn T is missing on body 1", times(push, 3, 5, 1, 0, 1, 1)},
      {"the turn T is missing on body 2", times(push, 3, 5, 1, 1, 1, 0)},
      {"the sign of the turn T: w1 loses it, w2 gets it", times(push, 3, 5, 1, -1, 1, -1)},
      {"both bodies get the turn T the same way: w1 loses it", times(push, 3, 5, 1, -1, 1, 1)},
      {"only lambda4 turns: T = lambda4 a_1 + lambda5 a_2", times(push, 4, 5, 1, 0, 1, 0)},
      {"only lambda5 turns: T = lambda4 a_1 + lambda5 a_2", times(push, 3, 4, 1, 0, 1, 0)},
      {"the sign of the push P: v1 loses it, v2 gets it", times(push, 0, 3, -1, -1, -1, -1)},
      {"half of lambda is applied", times(push, 0, 5, real(0.5), real(0.5), real(0.5), real(0.5))},
      {"lambda is applied twice", times(push, 0, 5, 2, 2, 2, 2)},
      {"P x r in the place of r x P", [=](T& t) {
         const Jacobian<5> rows = opposite(t);
         for (int i = 0; i < 3; ++i) t.push[i] = rows[i];
       }},
      {"#r-x-w-place r x w in the place of w x r in the gap's rate",
       [=](T& t) { t.read = opposite(t); }},
      {"r x w and P x r: w x r in the gap's rate, r x P in the effect of the push",
       [=](T& t) { t.read = t.push = opposite(t); }},
      {"the levers are exchanged in the gap's rate: r1 belongs to w1",
       [=](T& t) { t.read = exchanged(t); }},
      {"#levers-exchanged-push the levers are exchanged in the effect of the push: r1 belongs to "
       "body 1",
       [=](T& t) { t.push = exchanged(t); }},
      {"#levers-are-exchanged-r1 the levers are exchanged: r1 belongs to body 1",
       [=](T& t) { t.read = t.push = exchanged(t); }},
      {"r1 is taken for both bodies",
       [=](T& t) { t.read = t.push = hinge_rows(t.r1, t.r1, t.a); }},
      {"r2 is taken for both bodies",
       [=](T& t) { t.read = t.push = hinge_rows(t.r2, t.r2, t.a); }},
      {"w1 and w2 are exchanged in e", [](T& t) {
         for (int i = 0; i < 5; ++i) std::swap(t.read[i].w1, t.read[i].w2);
       }},
      {"the levers are missing in the gap's rate: v2 + w2 x r2 - v1 - w1 x r1",
       times(read, 0, 3, 1, 0, 1, 0)},
      {"w1 x r1 is missing in the gap's rate", times(read, 0, 3, 1, 0, 1, 1)},
      {"w2 x r2 is missing in the gap's rate", times(read, 0, 3, 1, 1, 1, 0)},
      {"v1 and v2 are missing in the gap's rate", times(read, 0, 3, 0, 1, 0, 1)},
      {"body 1 is missing in e: the rates are of body 2 less those of body 1",
       times(read, 0, 5, 0, 0, 1, 1)},
      {"body 2 is missing in e: the rates are of body 2 less those of body 1",
       times(read, 0, 5, 1, 1, 0, 0)},
      {"#velocities-added the velocities of body 1 are added in e: the rates are of body 2 less "
       "those of body 1",
       times(read, 0, 5, -1, -1, 1, 1)},
      {"#body-1-less-2 the velocities in the point's rows are those of body 1 less those of body "
       "2: the other way round",
       times(read, 0, 3, -1, -1, -1, -1)},
      {"the velocities in the axis' rows are those of body 1 less those of body 2: the other way "
       "round",
       times(read, 3, 5, -1, -1, -1, -1)},
      {"#sign-e-point-s the sign of e in the point's rows: rates of body 2 less those of body 1",
       [=](T& t) {
         t.read = T::scaled(t.read, 0, 3, -1, -1, -1, -1);
         for (int i = 0; i < 3; ++i) t.bias[i] = -t.bias[i];
       }},
      {"the sign of J V: e = bias + J V, and C grows when body 2 moves positively",
       times(read, 0, 5, -1, -1, -1, -1)},
      {"the sign of w1 x r1 in the gap's rate: it is taken away", times(read, 0, 3, 1, -1, 1, 1)},
      {"the sign of w2 x r2 in the gap's rate: it is added", times(read, 0, 3, 1, 1, 1, -1)},
      {"#without-w1-axis-rows w1 is missing in the axis rows: a_j . (w2 - w1)",
       times(read, 3, 5, 1, 0, 1, 1)},
      {"w2 is missing in the axis rows: a_j . (w2 - w1)", times(read, 3, 5, 1, 1, 1, 0)},
      {"the sign in the axis rows: a_j . (w2 - w1)", times(read, 3, 5, 1, -1, 1, -1)},
      {"w1 + w2 in the axis rows: a_j . (w2 - w1)", times(read, 3, 5, 1, -1, 1, 1)},
      {"v in the place of w in the axis rows: a_j . (w2 - w1)", [](T& t) {
         for (std::size_t j = 0; j < 2; ++j)
           t.read[int(3 + j)] = {-t.a[j], vec3(0), t.a[j], vec3(0)};
       }},
      {"v in the place of w in the first axis row: a_1 . (w2 - w1)",
       [](T& t) { t.read[3] = {-t.a[0], vec3(0), t.a[0], vec3(0)}; }},
      {"v in the place of w in the second axis row: a_2 . (w2 - w1)",
       [](T& t) { t.read[4] = {-t.a[1], vec3(0), t.a[1], vec3(0)}; }},
      {"the axis rows are exchanged in e", [=](T& t) { swap_rows(t.read); }},
      {"the axis rows are exchanged in the turn T", [=](T& t) { swap_rows(t.push); }},
      {"the first axis row twice in e", [](T& t) { t.read[4] = t.read[3]; }},
      {"the first axis row twice in the turn T", [](T& t) { t.push[4] = t.push[3]; }},
      {"#bias-forgotten-e-bias the bias is forgotten: e = bias + J V", [](T& t) { t.bias = {}; }},
      {"the bias of the axis is forgotten", [](T& t) { t.bias[3] = t.bias[4] = 0; }},
      {"the bias of the point is forgotten", [](T& t) { t.bias[0] = t.bias[1] = t.bias[2] = 0; }},
      {"#sign-point-s-bias the sign of the point's bias: e = bias + J V",
       [](T& t) { t.bias[0] = -t.bias[0], t.bias[1] = -t.bias[1], t.bias[2] = -t.bias[2]; }},
      {"the sign of the axis' bias: e = bias + J V",
       [](T& t) { t.bias[3] = -t.bias[3], t.bias[4] = -t.bias[4]; }},
      {"the sign of the bias: e = bias + J V", [](T& t) {
         for (real& b : t.bias) b = -b;
       }},
      {"the velocities are forgotten: e = bias + J V", times(read, 0, 5, 0, 0, 0, 0)},
      {"the inverse inertias are missing: w1 -= I1 (r1 x P + T)",
       [](T& t) { t.lines.inverse_M[1] = t.lines.inverse_M[3] = mat3(1); }},
      {"the inverse inertia of body 1 is missing", [](T& t) { t.lines.inverse_M[1] = mat3(1); }},
      {"the inverse inertia of body 2 is missing", [](T& t) { t.lines.inverse_M[3] = mat3(1); }},
      {"the inverse masses are missing: v1 -= P/m1",
       [](T& t) { t.lines.inverse_M[0] = t.lines.inverse_M[2] = mat3(1); }},
      {"the inverse mass of body 1 is missing", [](T& t) { t.lines.inverse_M[0] = mat3(1); }},
      {"the inverse mass of body 2 is missing", [](T& t) { t.lines.inverse_M[2] = mat3(1); }},
      {"the inverse inertias are exchanged: I1 belongs to body 1",
       [](T& t) { std::swap(t.lines.inverse_M[1], t.lines.inverse_M[3]); }},
      {"I1 is taken for both bodies", [](T& t) { t.lines.inverse_M[3] = t.lines.inverse_M[1]; }},
      {"I2 is taken for both bodies", [](T& t) { t.lines.inverse_M[1] = t.lines.inverse_M[3]; }},
      {"the inverse mass of body 1 is taken for both",
       [](T& t) { t.lines.inverse_M[2] = t.lines.inverse_M[0]; }},
      {"the inverse mass of body 2 is taken for both",
       [](T& t) { t.lines.inverse_M[0] = t.lines.inverse_M[2]; }},
      {"the inverse masses are exchanged",
       [](T& t) { std::swap(t.lines.inverse_M[0], t.lines.inverse_M[2]); }},
      {"K^-1 is missing: lambda = -K^-1 e", [](T& t) {
         t.inverse_K = {};
         for (int i = 0; i < 5; ++i) t.inverse_K[i][i] = 1;
       }},
      {"#upper-half-only only the upper half of K^-1 is used: place(i, j) gives the lower one, too",
       of_K([](int i, int j) { return i <= j; })},
      {"only the lower half of K^-1 is used: place(i, j) gives the upper one, too",
       of_K([](int i, int j) { return i >= j; })},
      {"#diagonal-only only the diagonal of K^-1 is used",
       of_K([](int i, int j) { return i == j; })},
      {"#two-blocks the entries of K^-1 between the point and the axis are not used: these are two "
       "blocks",
       of_K([](int i, int j) { return (i < 3) == (j < 3); })},
      {"#another-order-k K^-1 is read in another order: take place(i, j), row after row of the "
       "upper half",
       packed([](int i, int j) {
         return std::max(i, j) * (std::max(i, j) + 1) / 2 + std::min(i, j);
       })},
      {"#read-if-full K^-1 is read as if all 25 entries stood there: take place(i, j), only 15 do",
       packed([](int i, int j) { return std::min(5 * i + j, 14); })}};
}

inline const CaseTable<SolveCase>& solve_table() {
  static const CaseTable<SolveCase> table = [] {
    using Case = SolveCase;
    CaseTable<Case> out{{"7.4", "the solve of a whole hinge"},
                        with_xyz({"v1", "w1", "v2", "w2"}), {}, {}, {}, solve_cases()};
    out.yours = [](const Case& c) { return flat(velocities_of(solved(c))); };
    out.right = [](const Case& c) { return flat(SolveReference(c).solved()); };
    out.tolerance = is_float ? 1e-3 : 1e-10;
    Pieces<SolveReference> pieces = usual_pieces();
    for (const auto& more : {wrong_lines(&SolveReference::lines, false), any_pieces()})
      pieces.insert(pieces.end(), more.begin(), more.end());
    add_pieces(out, [](const Case& c) { return SolveReference(c); },
               [](const SolveReference& t) { return flat(SolveReference(t).solved()); }, pieces);
    return out;
  }();
  return table;
}

}  // namespace joints::testing
