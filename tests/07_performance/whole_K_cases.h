// Exercise 7.2 as samples of K at every pose, each with its usual mistakes. The three parts of K
// are explained one by one, so that a mistake in each of them is found.
#pragma once

#include "tests/07_performance/loop_hinges.h"

namespace joints::testing {

inline constexpr Subject whole_K_subject{"7.2", "K of a hinge's five rows"};
inline const std::vector<std::string> five_rows{"C.x", "C.y", "C.z", "a1.b", "a1.c"};

/// Yours, for the hinge's numbers as they should be.
inline Matrix<5> your_K(const HingeCase& c) {
  return whole_K(twin_numbers(c), c.pair.body1.inverse_mass, c.pair.body2.inverse_mass);
}

/// K in its parts: point, what stands beside it, below it, and the axis.
struct KParts {
  mat3 point{0};                    // symmetric
  std::array<vec3, 2> beside{}, below{};
  std::array<std::array<real, 2>, 2> axis{};
};

/// What the parts are made of.
struct KSource {
  real m1, m2;
  vec3 r1, r2;
  mat3 I1, I2;
  std::array<vec3, 2> a;
  explicit KSource(const HingeCase& c)
      : m1(c.pair.body1.inverse_mass), m2(c.pair.body2.inverse_mass), r1(twin_lever(c, false)),
        r2(twin_lever(c, true)), I1(twin_inertia(c, false)), I2(twin_inertia(c, true)),
        a(twin_rows(c)) {}
  static mat3 turns(const vec3& r, const mat3& I) { return skew(r) * I * transpose(skew(r)); }
  mat3 point() const { return mat3(m1 + m2) + turns(r1, I1) + turns(r2, I2); }
  vec3 beside(int j) const { return -(cross(r1, I1 * a[j]) + cross(r2, I2 * a[j])); }
  real axis(int i, int j) const { return dot(a[i], (I1 + I2) * a[j]); }
};

/// A part as numbers: 9 of the point, 12 beside and below, 4 of the axis.
inline Numbers part_of(const Matrix<5>& K, int part) {
  Numbers out;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      if ((i < 3 && j < 3 ? 0 : i >= 3 && j >= 3 ? 2 : 1) == part) out.push_back(double(K[i][j]));
  return out;
}

/// The mistakes of one part, and what K would be: only that part of it counts.
using KMistakes = std::vector<std::pair<std::string, Matrix<5>>>;

inline KMistakes wrong_points(const KSource& s) {
  KMistakes out;
  const auto add = [&](const char* words, const mat3& point) {
    Matrix<5> K;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) K[i][j] = point[j][i];
    out.push_back({words, K});
  };
  const mat3 masses(s.m1 + s.m2), t1 = s.turns(s.r1, s.I1), t2 = s.turns(s.r2, s.I2);
  add("the point's 3x3 is not written yet", mat3(0));
  add("the inverse masses are missing on the diagonal", t1 + t2);
  mat3 everywhere = masses + t1 + t2;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (i != j) everywhere[i][j] += s.m1 + s.m2;
  add("the inverse masses are added to all nine entries: they stand on the diagonal", everywhere);
  add("the inverse mass of body 1 is missing", mat3(s.m2) + t1 + t2);
  add("the inverse mass of body 2 is missing", mat3(s.m1) + t1 + t2);
  if (s.m1 > 0 && s.m2 > 0) {
    add("one over the sum of the masses: each mass is inverted first, then they are added",
        mat3(1 / (1 / s.m1 + 1 / s.m2)) + t1 + t2);
    add("the masses: you are given the inverse masses, 1/m already",
        mat3(1 / s.m1 + 1 / s.m2) + t1 + t2);
  }
  add("one over the sum of the inverse masses: you are given 1/m already, add them",
      mat3(1 / (s.m1 + s.m2)) + t1 + t2);
  add("only the inverse masses: the turns are missing in the point's 3x3", masses);
  add("the turns of body 2 are missing in the point's 3x3", masses + t1);
  add("the turns of body 1 are missing in the point's 3x3", masses + t2);
  add("the sign of the turns: skew(r) I^-1 skew(r) lacks a transpose", masses - t1 - t2);
  add("the sign of the turns of body 1: the shares of both bodies are added", masses - t1 + t2);
  add("the sign of the turns of body 2: the shares of both bodies are added", masses + t1 - t2);
  add("the levers, or the inverse inertias, are exchanged in the point's 3x3: r1 belongs to I1",
      masses + s.turns(s.r2, s.I1) + s.turns(s.r1, s.I2));
  add("I1 is taken twice in the point's 3x3", masses + t1 + s.turns(s.r2, s.I1));
  add("I2 is taken twice in the point's 3x3", masses + s.turns(s.r1, s.I2) + t2);
  add("r1 is taken twice in the point's 3x3", masses + t1 + s.turns(s.r1, s.I2));
  add("r2 is taken twice in the point's 3x3", masses + s.turns(s.r2, s.I1) + t2);
  add("the inverse inertias are missing in the point's 3x3",
      masses + s.turns(s.r1, mat3(1)) + s.turns(s.r2, mat3(1)));
  add("the point's 3x3 has only its diagonal", mat3(vec3(masses[0][0] + t1[0][0] + t2[0][0], 0, 0),
      vec3(0, masses[0][0] + t1[1][1] + t2[1][1], 0),
      vec3(0, 0, masses[0][0] + t1[2][2] + t2[2][2])));
  return out;
}

inline KMistakes wrong_crosses(const KSource& s) {
  KMistakes out;
  const auto add = [&](const std::string& words, const std::array<vec3, 2>& beside,
                       const std::array<vec3, 2>& below) {
    Matrix<5> K;
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 3; ++i) {
        K[i][3 + j] = beside[j][i];
        K[3 + j][i] = below[j][i];
      }
    out.push_back({words, K});
  };
  const auto both = [&](const std::string& words, auto column) {
    const std::array<vec3, 2> columns{column(0), column(1)};
    add(words, columns, columns);
  };
  const std::array<vec3, 2> right{s.beside(0), s.beside(1)}, none{vec3(0), vec3(0)};
  const auto x1 = [&](int j) { return cross(s.r1, s.I1 * s.a[j]); };
  const auto x2 = [&](int j) { return cross(s.r2, s.I2 * s.a[j]); };
  both("what stands between the point and the axis is missing: these are two blocks, not one",
       [](int) { return vec3(0); });
  both("the sign of what stands between the point and the axis: -(r1 x I1 a + r2 x I2 a)",
       [&](int j) { return x1(j) + x2(j); });
  add("the columns beside the point are not mirrored: they stand below it once more, as rows",
      right, none);
  add("the rows below the point are not mirrored: they stand beside it once more, as columns",
      none, right);
  add("mirrored with the other sign: K is symmetric", right, {-right[0], -right[1]});
  add("mirrored with the other sign: K is symmetric. And the columns beside the point have a minus",
      {-right[0], -right[1]}, right);
  add("the first column is written twice below the point", right, {right[0], right[0]});
  both("the columns of the two axis rows are exchanged",
       [&](int j) { return -x1(1 - j) - x2(1 - j); });
  both("the columns have the first axis row twice", [&](int) { return right[0]; });
  both("the columns have the second axis row twice", [&](int) { return right[1]; });
  add("the second column is missing: there are two axis rows", {right[0], vec3(0)},
      {right[0], vec3(0)});
  both("body 2 is missing in what stands between the point and the axis",
       [&](int j) { return -x1(j); });
  both("body 1 is missing in what stands between the point and the axis",
       [&](int j) { return -x2(j); });
  both("the sign of body 1 between the point and the axis: its minus stands in both rows, and "
       "minus times minus is plus", [&](int j) { return x1(j) - x2(j); });
  both("the sign of body 2 between the point and the axis: the shares of both bodies are added",
       [&](int j) { return x2(j) - x1(j); });
  both("the inverse inertias are missing between the point and the axis: r x (I^-1 a)",
       [&](int j) { return -cross(s.r1, s.a[j]) - cross(s.r2, s.a[j]); });
  both("first the inverse inertia, then the lever: r x (I^-1 a), not I^-1 (r x a)",
       [&](int j) { return -(s.I1 * cross(s.r1, s.a[j])) - s.I2 * cross(s.r2, s.a[j]); });
  both("the same with the other sign: r x (I^-1 a), not I^-1 (r x a), and a minus",
       [&](int j) { return s.I1 * cross(s.r1, s.a[j]) + s.I2 * cross(s.r2, s.a[j]); });
  both("the levers, or the inverse inertias, are exchanged between the point and the axis: r1 "
       "belongs to I1",
       [&](int j) { return -cross(s.r2, s.I1 * s.a[j]) - cross(s.r1, s.I2 * s.a[j]); });
  both("r1 is taken twice between the point and the axis",
       [&](int j) { return -x1(j) - cross(s.r1, s.I2 * s.a[j]); });
  both("r2 is taken twice between the point and the axis",
       [&](int j) { return -cross(s.r2, s.I1 * s.a[j]) - x2(j); });
  both("I1 is taken twice between the point and the axis",
       [&](int j) { return -x1(j) - cross(s.r2, s.I1 * s.a[j]); });
  both("I2 is taken twice between the point and the axis",
       [&](int j) { return -cross(s.r1, s.I2 * s.a[j]) - x2(j); });
  return out;
}

inline KMistakes wrong_axes(const KSource& s) {
  KMistakes out;
  const auto add = [&](const char* words, auto entry) {
    Matrix<5> K;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) K[3 + i][3 + j] = entry(i, j);
    out.push_back({words, K});
  };
  const auto with = [&](const mat3& I) {
    return [=](int i, int j) { return dot(s.a[i], I * s.a[j]); };
  };
  add("the axis' 2x2 is not written yet", with(mat3(0)));
  add("body 2 is missing in the axis' 2x2", with(s.I1));
  add("body 1 is missing in the axis' 2x2", with(s.I2));
  add("the sign of body 2 in the axis' 2x2: the shares of both bodies are added",
      with(s.I1 - s.I2));
  add("the sign of body 1 in the axis' 2x2: the shares of both bodies are added",
      with(s.I2 - s.I1));
  add("the sign of the axis' 2x2", with(-s.I1 - s.I2));
  add("the inverse inertias are missing in the axis' 2x2", with(mat3(1)));
  add("the inverse masses are added in the axis' 2x2: these rows turn and do not push",
      [&](int i, int j) { return s.axis(i, j) + (i == j ? s.m1 + s.m2 : real(0)); });
  add("what stands beside the diagonal is missing in the axis' 2x2: its rows move each other",
      [&](int i, int j) { return i == j ? s.axis(i, j) : real(0); });
  add("the axis' 2x2 is filled on one side of its diagonal only: K is symmetric",
      [&](int i, int j) { return i <= j ? s.axis(i, j) : real(0); });
  add("the first axis row twice in the axis' 2x2", [&](int, int) { return s.axis(0, 0); });
  add("the second axis row twice in the axis' 2x2", [&](int, int) { return s.axis(1, 1); });
  add("the axis rows are exchanged in the axis' 2x2",
      [&](int i, int j) { return s.axis(1 - i, 1 - j); });
  return out;
}

/// What all of K would be if a body, or its numbers, were taken wrongly everywhere.
inline KMistakes wrong_wholes(const HingeCase& c) {
  KMistakes out;
  const auto add = [&](const char* words, auto change) {
    KSource s(c);
    change(s);
    out.push_back({words, product_K(hinge_rows(s.r1, s.r2, s.a), s.m1, s.I1, s.m2, s.I2)});
  };
  add("body 1 is missing", [](KSource& s) { s.m1 = 0, s.I1 = mat3(0); });
  add("body 2 is missing", [](KSource& s) { s.m2 = 0, s.I2 = mat3(0); });
  add("the levers, or the inverse inertias, are exchanged: r1 and I1 belong to body 1",
      [](KSource& s) { std::swap(s.r1, s.r2); });
  add("the inverse inertias are exchanged: I1 belongs to body 1",
      [](KSource& s) { std::swap(s.I1, s.I2); });
  add("I1 is taken for both bodies", [](KSource& s) { s.I2 = s.I1; });
  add("I2 is taken for both bodies", [](KSource& s) { s.I1 = s.I2; });
  add("r1 is taken for both bodies", [](KSource& s) { s.r2 = s.r1; });
  add("r2 is taken for both bodies", [](KSource& s) { s.r1 = s.r2; });
  add("the levers are missing", [](KSource& s) { s.r1 = s.r2 = vec3(0); });
  add("the inverse inertias are missing: I1 and I2", [](KSource& s) { s.I1 = s.I2 = mat3(1); });
  add("the second row takes the first axis row again", [](KSource& s) { s.a[1] = s.a[0]; });
  Matrix<5> K = out[0].second;
  K = {};
  out.push_back({"nothing is written yet", K});
  const KSource s(c);
  K = product_K(hinge_rows(s.r1, s.r2, s.a), s.m1, s.I1, s.m2, s.I2);
  invert_symmetric(K[0].data(), 5);
  out.push_back({"the inverse of K: K itself is wanted, the loop inverts it", K});
  return out;
}

/// Everything that would explain your K: all of it at once, or each of its parts that is wrong.
inline std::vector<std::string> explain_K(const HingeCase& c, const Matrix<5>& yours,
                                          const Matrix<5>& right) {
  std::vector<std::string> out;
  for (const auto& [words, K] : wrong_wholes(c))
    if (close(flat(yours), flat(K), K_tolerance)) out.push_back(words);
  if (!out.empty()) return out;
  const KSource s(c);
  const KMistakes parts[] = {wrong_points(s), wrong_crosses(s), wrong_axes(s)};
  for (int part = 0; part < 3; ++part) {
    const Numbers mine = part_of(yours, part);
    if (close(mine, part_of(right, part), K_tolerance)) continue;
    std::vector<std::string> longer;
    for (const auto& [words, K] : parts[part])
      if (close(mine, part_of(K, part), K_tolerance)) {
        if (out.empty()) longer.push_back(words);
        for (const std::string& before : out) longer.push_back(before + "; and " + words);
      }
    if (longer.empty()) return {};
    out = longer;
  }
  return out;
}

inline Sample whole_K_sample(int pose, const HingeCase& c, const Matrix<5>& right) {
  const Matrix<5> yours = your_K(c);
  Sample sample{pose, flat(yours), flat(right), {}};
  if (!close(sample.yours, sample.right, K_tolerance))
    sample.mistakes = explain_K(c, yours, right);
  return sample;
}
/// Yours beside J M^-1 J^T, with J by differences of the five errors, at every pose.
inline std::vector<Sample> whole_K_samples() {
  std::vector<Sample> samples;
  visit_poses<LoopHingeFixture>([&](int pose, const LoopHinge& hinge, const Pair& pair) {
    const HingeCase c{"", hinge, pair, 1};
    const auto J = numeric_jacobian(hinge, pair.body1, pair.body2);
    samples.push_back(whole_K_sample(pose, c, dense_K(J, pair.body1, pair.body2)));
  });
  return samples;
}

/// The rates of the five errors after an impulse of 1 along one of the rows, on bodies at rest: a
/// push at both anchors, or a turn, and then both bodies move a little ahead and back.
inline Vector<5> rates_after_an_impulse(const HingeCase& c, int row) {
  const vec3 push = row < 3 ? unit_vector(row) : vec3(0);
  const vec3 turn = row < 3 ? vec3(0) : twin_rows(c)[std::size_t(row - 3)];
  const auto moved = [&](bool second, real time) {
    Body body = c.body(second);
    const real sign = second ? time : -time;
    const vec3 r = twin_lever(c, second);
    body.x += sign * body.inverse_mass * push;
    const vec3 w = twin_inertia(c, second) * (cross(r, push) + turn);
    body.q = normalize(rotation(sign * w) * body.q);
    return body;
  };
  const real time = difference_step;
  const Vector<5> ahead = c.hinge.error(moved(false, time), moved(true, time));
  const Vector<5> behind = c.hinge.error(moved(false, -time), moved(true, -time));
  Vector<5> out;
  for (std::size_t i = 0; i < 5; ++i) out[i] = (ahead[i] - behind[i]) / (2 * time);
  return out;
}

}  // namespace joints::testing
