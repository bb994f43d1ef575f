// Exercise 7.2: possible mistakes in K, in the point's 3x3 and between point and axis: in the terms
// of body 1 and body 2, and in the notation of their sum.
#pragma once

#include "tests/07_performance/loop_hinges.h"

namespace joints::testing {

/// What the parts are made of.
struct KSource {
  std::array<real, 2> m;  ///< inverse masses
  std::array<vec3, 2> r;
  std::array<mat3, 2> I;
  std::array<vec3, 2> a;
  explicit KSource(const HingeCase& c)
      : m{c.pair.body1.inverse_mass, c.pair.body2.inverse_mass},
        r{reference_lever(c, false), reference_lever(c, true)},
        I{reference_inertia(c, false), reference_inertia(c, true)}, a(reference_rows(c)) {}
  real masses() const { return m[0] + m[1]; }
  Matrix<5> K() const { return product_K(hinge_rows(r[0], r[1], a), m[0], I[0], m[1], I[1]); }
};

/// What a body adds to a part: the point's 3x3, the two columns beside it, the axis' 2x2.
struct Share {
  std::string one, both;  ///< words: % is the number of the body, @ of the other one
  Call<mat3(const KSource&, std::size_t)> of;
};
/// How the sum of both bodies becomes numbers of K.
struct Frame {
  std::string words;
  Call<Matrix<5>(const mat3&, const KSource&)> of;
};
struct KPart {
  std::string where;
  std::vector<Share> shares;  ///< the first one is right
  std::vector<Frame> frames;
};

// ---- the point ----------------------------------------------------------------------------------

/// The turns of one row of the point, those of another one in their place. \param from -1: none
inline Frame turns_in_row(const char* words, int row, int from) {
  return {words, [=](mat3 t, const KSource& s) {
            for (int j = 0; j < 3; ++j) t[j][row] = from < 0 ? real(0) : t[j][from];
            Matrix<5> K;
            for (int i = 0; i < 3; ++i)
              for (int j = 0; j < 3; ++j) K[i][j] = t[j][i] + (i == j ? s.masses() : real(0));
            return K;
          }};
}
inline KPart point_part() {
  using S = KSource;
  const auto turns = [](const vec3& outside, const mat3& I, const vec3& inside) {
    return skew(outside) * I * transpose(skew(inside));
  };
  const auto of = [=](auto outside, auto I, auto inside) {
    return [=](const S& s, std::size_t k) { return turns(outside(s, k), I(s, k), inside(s, k)); };
  };
  const auto r = [](const S& s, std::size_t k) { return s.r[k]; };
  const auto other = [](const S& s, std::size_t k) { return s.r[1 - k]; };
  const auto I = [](const S& s, std::size_t k) { return s.I[k]; };
  const auto plain = [](auto diagonal) {  // the turns, and something on the diagonal
    return [=](const mat3& t, const S& s) {
      Matrix<5> K;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) K[i][j] = t[j][i] + (i == j ? diagonal(s) : real(0));
      return K;
    };
  };
  const auto entries = [](auto masses) {  // the turns, and the masses somewhere
    return [=](const mat3& t, const S& s) {
      Matrix<5> K;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) K[i][j] = t[j][i] + (masses(i, j) ? s.masses() : real(0));
      return K;
    };
  };
  const auto unless = [](auto of) {  // nothing where a body is static
    return [=](const S& s) { return s.m[0] > 0 && s.m[1] > 0 ? of(s) : real(0); };
  };
  const char* const given = "the arguments are 1/m already, add them";
  return {
      " in the point's 3x3",
      {{"", "", of(r, I, r)},
       {"the turns of body % are missing", "only the inverse masses: the turns are missing",
        [](const S&, std::size_t) { return mat3(0); }},
       {"the sign of the turns of body %: the terms of both bodies are added",
        "#transposed-skew the sign of the turns: skew(r) I^-1 skew(r) lacks a transpose",
        [=](const S& s, std::size_t k) { return -turns(s.r[k], s.I[k], s.r[k]); }},
       {"r@ with I%: r% belongs to it",
        "the levers, or the inverse inertias, are exchanged: r1 belongs to I1",
        of(other, I, other)},
       {"I@ with r%: I% belongs to it", "",
        of(r, [](const S& s, std::size_t k) { return s.I[1 - k]; }, r)},
       {"r@ as the outer lever of body %: r% stands on both sides",
        "the outer levers are exchanged",
        of(other, I, r)},
       {"r@ as the inner lever of body %: r% stands on both sides",
        "the inner levers are exchanged",
        of(r, I, other)},
       {"I% is missing", "the inverse inertias are missing",
        of(r, [](const S&, std::size_t) { return mat3(1); }, r)},
       {"the outer lever of body % is missing: (I (r x e)) x r", "the outer levers are missing: "
        "(I (r x e)) x r",
        [](const S& s, std::size_t k) { return s.I[k] * skew(s.r[k]); }},
       {"the inner lever of body % is missing: (I (r x e)) x r", "the inner levers are missing: "
        "(I (r x e)) x r",
        [](const S& s, std::size_t k) { return -skew(s.r[k]) * s.I[k]; }},
       {"I% is applied last: (I (r x e)) x r", "the inverse inertias are applied last: "
        "(I (r x e)) x r",
        [=](const S& s, std::size_t k) { return s.I[k] * turns(s.r[k], mat3(1), s.r[k]); }}},
      {{"", plain([](const S& s) { return s.masses(); })},
       {"#inverse-masses-are-missing the inverse masses are missing on the diagonal",
        plain([](const S&) { return real(0); })},
       {"#inverse-masses-all-nine the inverse masses are added to all nine entries: they stand on "
        "the diagonal",
        entries([](int, int) { return true; })},
       {"#masses-first-row the inverse masses are added to the first row: they stand on the "
        "diagonal",
        entries([](int i, int) { return i == 0; })},
       {"the inverse masses are added to the first column: they stand on the diagonal",
        entries([](int, int j) { return j == 0; })},
       {"the entries below the diagonal are missing: the 3x3 is symmetric, both halves are needed",
        [](const mat3& t, const S& s) {
          Matrix<5> K;
          for (int i = 0; i < 3; ++i)
            for (int j = i; j < 3; ++j) K[i][j] = t[j][i] + (i == j ? s.masses() : real(0));
          return K;
        }},
       {"the inverse masses stand in two places of the diagonal: there are three",
        entries([](int i, int j) { return i == j && i < 2; })},
       {"#masses-place-turns the inverse masses replace the entries on the diagonal: += and not =",
        [](mat3 t, const S& s) {
          Matrix<5> K;
          for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) K[i][j] = i == j ? s.masses() : t[j][i];
          return K;
        }},
       {"the inverse mass of body 1 is missing", plain([](const S& s) { return s.m[1]; })},
       {"the inverse mass of body 2 is missing", plain([](const S& s) { return s.m[0]; })},
       {"the inverse mass of body 1 is added twice", plain([](const S& s) { return 2 * s.m[0]; })},
       {"the inverse mass of body 2 is added twice", plain([](const S& s) { return 2 * s.m[1]; })},
       {"#masses-taken-away the sign of the inverse mass of body 2: both are added",
        plain([](const S& s) { return s.m[0] - s.m[1]; })},
       {"the sign of the inverse mass of body 1: both are added",
        plain([](const S& s) { return s.m[1] - s.m[0]; })},
       {"the sign of the inverse masses: they are added",
        plain([](const S& s) { return -s.masses(); })},
       {"the product of the inverse masses: they are added",
        plain([](const S& s) { return s.m[0] * s.m[1]; })},
       {"the mean of the inverse masses: they are added",
        plain([](const S& s) { return s.masses() / 2; })},
       {"#one-over-whole-mass one over the sum of the masses: each mass is inverted first, then "
        "they are added",
        plain(unless([](const S& s) { return 1 / (1 / s.m[0] + 1 / s.m[1]); }))},
       {std::string("#inverted-once-more the masses: the arguments are the inverse masses, ") +
            given,
        plain([](const S& s) { return 1 / s.m[0] + 1 / s.m[1]; })},
       {std::string("one over the sum of the inverse masses: ") + given,
        plain([](const S& s) { return 1 / s.masses(); })},
       {"it is not written yet", [](const mat3&, const S&) { return Matrix<5>{}; }},
       turns_in_row("the turns of row C.x are missing", 0, -1),
       turns_in_row("the turns of row C.y are missing", 1, -1),
       turns_in_row("the turns of row C.z are missing", 2, -1),
       turns_in_row("row C.y has the turns of row C.x once more", 1, 0),
       turns_in_row("row C.z has the turns of row C.x once more", 2, 0),
       turns_in_row("#point-row-twice row C.z has the turns of row C.y once more", 2, 1),
       {"the last column is not written yet", [](const mat3& t, const S& s) {
          Matrix<5> K;
          for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 2; ++j) K[i][j] = t[j][i] + (i == j ? s.masses() : real(0));
          return K;
        }},
       {"only its diagonal is there", [](const mat3& t, const S& s) {
          Matrix<5> K;
          for (int i = 0; i < 3; ++i) K[i][i] = t[i][i] + s.masses();
          return K;
        }}}};
}

// ---- between the point and the axis -------------------------------------------------------------

/// Two columns, and their places beside the point and below it.
template <class Beside, class Below>
Frame crossing(const std::string& words, Beside beside, Below below) {
  return {words, [=](const mat3& columns, const KSource&) {
            Matrix<5> K;
            for (int j = 0; j < 2; ++j)
              for (int i = 0; i < 3; ++i) {
                K[i][3 + j] = beside(columns, j)[i];
                K[3 + j][i] = below(columns, j)[i];
              }
            return K;
          }};
}
inline KPart cross_part() {
  using S = KSource;
  const auto columns = [](auto of) {
    return [=](const S& s, std::size_t k) {
      return mat3(of(s, k, s.a[0]), of(s, k, s.a[1]), vec3(0));
    };
  };
  const auto share = [](const vec3& r, const mat3& I, const vec3& a) { return -cross(r, I * a); };
  const auto right = [](const mat3& c, int j) { return c[j]; };
  const auto none = [](const mat3&, int) { return vec3(0); };
  const auto minus = [](const mat3& c, int j) { return -c[j]; };
  const auto both = [](const char* words, auto of) { return crossing(words, of, of); };
  return {
      " between the point and the axis",
      {{"", "", columns([=](const S& s, std::size_t k, const vec3& a) {
          return share(s.r[k], s.I[k], a);
        })},
       {"body % is missing in the part", "#without-last-line these are two blocks, not one: "
                                            "nothing is",
        [](const S&, std::size_t) { return mat3(0); }},
       {"the sign of body %", "#sign-one-line the sign of the part",
        columns([=](const S& s, std::size_t k, const vec3& a) {
          return -share(s.r[k], s.I[k], a);
        })},
       {"r@ with I%: r% belongs to it,",
        "the levers, or the inverse inertias, are exchanged",
        columns([=](const S& s, std::size_t k, const vec3& a) {
          return share(s.r[1 - k], s.I[k], a);
        })},
       {"I@ with r%: I% belongs to it,", "", columns([=](const S& s, std::size_t k, const vec3& a) {
          return share(s.r[k], s.I[1 - k], a);
        })},
       {"I% is missing", "the inverse inertias are missing",
        columns([=](const S& s, std::size_t k, const vec3& a) {
          return share(s.r[k], mat3(1), a);
        })},
       {"the lever of body % is missing", "the levers are missing",
        columns([](const S& s, std::size_t k, const vec3& a) { return -(s.I[k] * a); })},
       {"first I%, then the lever: r x (I^-1 a), not I^-1 (r x a),",
        "#lever-first first the inverse inertia, then the lever: r x (I^-1 a), not I^-1 (r x a),",
        columns([](const S& s, std::size_t k, const vec3& a) {
          return -(s.I[k] * cross(s.r[k], a));
        })},
       {"the first axis row twice for body %", "the first axis row twice",
        [=](const S& s, std::size_t k) {
          const vec3 first = share(s.r[k], s.I[k], s.a[0]);
          return mat3(first, first, vec3(0));
        }},
       {"the second axis row twice for body %", "the second axis row twice",
        [=](const S& s, std::size_t k) {
          const vec3 second = share(s.r[k], s.I[k], s.a[1]);
          return mat3(second, second, vec3(0));
        }},
       {"the two axis rows are exchanged for body %", "the columns of the two axis rows are "
        "exchanged",
        [=](const S& s, std::size_t k) {
          return mat3(share(s.r[k], s.I[k], s.a[1]), share(s.r[k], s.I[k], s.a[0]), vec3(0));
        }}},
      {crossing("", right, right),
       crossing("the columns beside the point are not mirrored: they stand below it once more, as "
                "rows,", right, none),
       crossing("the rows below the point are not mirrored: they stand beside it once more, as "
                "columns,", none, right),
       crossing("#mirrored-minus mirrored with the other sign: K is symmetric,", right, minus),
       crossing("mirrored with the other sign: K is symmetric. And the columns beside the point "
                "have a minus,", minus, right),
       crossing("the first column is written twice below the point,", right,
                [](const mat3& c, int) { return c[0]; }),
       both("the second column is missing: there are two axis rows,",
            [](const mat3& c, int j) { return j == 0 ? c[0] : vec3(0); }),
       both("the first column is missing: there are two axis rows,",
            [](const mat3& c, int j) { return j == 1 ? c[1] : vec3(0); }),
       {"#added-up-first the levers, or the inertias, are added up first: each lever goes with "
        "its own,",
        [=](const mat3&, const S& s) {
          Matrix<5> K;
          for (int j = 0; j < 2; ++j) {
            const vec3 column = share(s.r[0] + s.r[1], s.I[0] + s.I[1], s.a[std::size_t(j)]);
            for (int i = 0; i < 3; ++i) K[i][3 + j] = K[3 + j][i] = column[i];
          }
          return K;
        }}}};
}

}  // namespace joints::testing
