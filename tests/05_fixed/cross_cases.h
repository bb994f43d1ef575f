// Exercise 5.1: the block X between point and lock at every pose as a table, with its usual
// mistakes.
#pragma once

#include "tests/checker/joint_fixtures.h"
#include "tests/checker/pieces.h"
#include "tests/checker/pose_cases.h"

namespace joints::testing {

struct CrossCase {
  std::string words;
  Point point;
  Pair pair;
  const Body& body(int k) const { return k == 0 ? pair.body1 : pair.body2; }
  const vec3& anchor(int k) const { return k == 0 ? point.anchor1_local : point.anchor2_local; }
};

/// The pose for pencil and paper in the chapter's text.
inline CrossCase paper_weld() {
  const real half = std::sqrt(real(0.5));  // cos 45 degrees
  return {"pencil and paper",
          {vec3(0), vec3(1, 0, real(0.5))},
          {static_body(vec3(0)), body_with(2, vec3(real(0.4), real(0.5), real(0.4)), vec3(0, -1, 0),
                                           quat(half, 0, 0, half))}};
}
inline std::vector<CrossCase> cross_cases() {
  std::vector<CrossCase> out;
  for_each_pose<PointFixture>([&](int pose, const Point& point, const Pair& pair) {
    out.push_back({pose_names[std::size_t(pose)], point, pair});
  });
  for (const char* words : {"1 static", "2 static"}) {
    out.push_back(out[9]);
    out.back().words = words;
    Body& wall = words[0] == '1' ? out.back().pair.body1 : out.back().pair.body2;
    wall = static_body(wall.x, wall.q);
  }
  return out;
}

/// J_t M^-1 J_r^T, entry by entry, with J_t the slopes of the gap and J_r = (0, -E, 0, E).
inline mat3 product_X(const CrossCase& c) {
  const Jacobian<3> J = numeric_jacobian(c.point, c.pair.body1, c.pair.body2);
  const mat3 I1 = inverse_inertia(c.pair.body1), I2 = inverse_inertia(c.pair.body2);
  mat3 X;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      X[column][row] = dot(J[row].w2, I2[column]) - dot(J[row].w1, I1[column]);
  return X;
}
inline Numbers row_after_row(const mat3& X) {
  Numbers out;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) out.push_back(double(X[column][row]));
  return out;
}

/// What X is made of, of body 1 and of body 2.
struct CrossReference {
  CrossCase c;
  std::array<vec3, 2> r;
  std::array<mat3, 2> inertia;
  std::array<real, 2> share{1, 1};
  std::array<bool, 2> inertia_first{};
  Call<mat3(const CrossReference&, const mat3&)> whole;  ///< what becomes of X itself

  explicit CrossReference(const CrossCase& c) : c(c) {
    for (int k = 0; k < 2; ++k) {
      r[k] = to_world(c.body(k), c.anchor(k));
      inertia[k] = inverse_inertia(c.body(k));
    }
  }
  mat3 X() const {
    mat3 out(0);
    for (int k = 0; k < 2; ++k)
      out -= share[k] * (inertia_first[k] ? inertia[k] * skew(r[k]) : skew(r[k]) * inertia[k]);
    return whole ? whole(*this, out) : out;
  }
};

/// The mistakes with the lever, the inertia and the part of one body, for body 1, 2 and both.
inline Pieces<CrossReference> wrong_shares() {
  using T = CrossReference;
  using Change = Call<void(T&, int)>;
  const auto lever = [](auto of) {
    return Change([=](T& t, int k) { t.r[k] = of(t.c, k); });
  };
  const auto inertia = [](auto of) {
    return Change([=](T& t, int k) { t.inertia[k] = of(t.c, k); });
  };
  const auto turned = [](Body body, const quat& q) {
    body.q = q;
    return inverse_inertia(body);
  };
  const std::pair<const char*, Change> levers[] = {
      {"body-space lever, it is not turned into the world: to_world(body, anchor)",
       lever([](const CrossCase& c, int k) { return c.anchor(k); })},
      {"turned the wrong way: to_world, not to_local",
       lever([](const CrossCase& c, int k) { return to_local(c.body(k), c.anchor(k)); })},
      {"a point where a lever belongs: r runs from the body's centre to the anchor (to_world, not "
       "world_point)",
       lever([](const CrossCase& c, int k) { return world_point(c.body(k), c.anchor(k)); })},
      {"the anchor of the other body",
       lever([](const CrossCase& c, int k) { return to_world(c.body(k), c.anchor(1 - k)); })},
      {"turned with the other body: each anchor rides on its own",
       lever([](const CrossCase& c, int k) { return to_world(c.body(1 - k), c.anchor(k)); })},
      {"it ends at the anchor on the other body: that is the same point only while the gap is zero",
       lever([](const CrossCase& c, int k) {
         return world_point(c.body(1 - k), c.anchor(1 - k)) - c.body(k).x;
       })},
      {"the gap in the place of the lever: r runs from the body's centre to the anchor",
       lever([](const CrossCase& c, int) { return c.point.error(c.pair.body1, c.pair.body2); })},
      {"from centre to centre: r runs from the body's centre to the anchor",
       lever([](const CrossCase& c, int) { return c.pair.body2.x - c.pair.body1.x; })},
      {"made a unit vector: a lever keeps its length",
       lever([](const CrossCase& c, int k) {
         return direction(to_world(c.body(k), c.anchor(k)));
       })}};
  const std::pair<const char*, Change> inertias[] = {
      {"#body-space-inertia body-space inertia: take inverse_inertia(body)",
       inertia([=](const CrossCase& c, int k) { return turned(c.body(k), quat(1, 0, 0, 0)); })},
      {"the inertia is turned the wrong way round: R I^-1 R^T, not R^T I^-1 R",
       inertia([=](const CrossCase& c, int k) {
         return turned(c.body(k), conjugate(c.body(k).q));
       })},
      {"inertia where inverse inertia belongs: inverse_inertia(body) is the inverse already",
       inertia([](const CrossCase& c, int k) {
         return c.body(k).is_static() ? mat3(0) : inverse(inverse_inertia(c.body(k)));
       })},
      {"#one-moment one moment stands for all three axes: that is right for a ball alone",
       inertia([](const CrossCase& c, int k) {
         return mat3(c.body(k).inverse_inertia_local.x);
       })},
      {"the inverse inertia is missing", inertia([](const CrossCase&, int) { return mat3(1); })},
      {"#masses-place-inertias the inverse mass in the place of the inverse inertia: the lock "
       "turns, and pushes no centre",
       inertia([](const CrossCase& c, int k) { return mat3(c.body(k).inverse_mass); })}};

  Pieces<T> out;
  const auto add = [&](const std::string& words, int which, const Change& change) {
    out.push_back({words, [=](T& t) {
                     for (int k = 0; k < 2; ++k)
                       if (which >> k & 1) change(t, k);
                   }});
  };
  for (const int which : {3, 1, 2}) {
    const std::string number = which == 3 ? " of both bodies" : " of body " + std::to_string(which);
    const std::string r = which == 3 ? "r1 and r2: " : "r" + std::to_string(which) + ": ";
    for (const auto& [words, change] : levers) add(r + words, which, change);
    for (const auto& [words, change] : inertias) add(words + (" (" + number.substr(4) + ")"), which,
                                                     change);
    if (which == 3) continue;
    const std::string k = std::to_string(which);
    add("the sign of body " + k + "'s term: both terms have the minus" +
            (which == 1 ? ", skew(r1) meets -E of the lock" : ""),
        which, [](T& t, int k) { t.share[k] = -1; });
    add("the term of body " + k + " is missing", which, [](T& t, int k) { t.share[k] = 0; });
    add("the term of body " + k + " in another order: skew(r) I^-1 and not I^-1 skew(r)", which,
        [](T& t, int k) { t.inertia_first[k] = true; });
    add("the lever of body " + std::to_string(3 - which) + " is taken for body " + k + ", too",
        which, lever([](const CrossCase& c, int k) {
          return to_world(c.body(1 - k), c.anchor(1 - k));
        }));
    add("the inertia of body " + std::to_string(3 - which) + " is taken for body " + k + ", too",
        which, inertia([](const CrossCase& c, int k) { return inverse_inertia(c.body(1 - k)); }));
  }
  return out;
}

/// The mistakes with X as a whole.
inline Pieces<CrossReference> wrong_Xs() {
  using T = CrossReference;
  const auto with = [](auto change) {
    return Call<void(T&)>([=](T& t) {
      t.whole = [=](const T& t, const mat3& X) { return change(t, X); };
    });
  };
  const auto both_sides = [](const T& t) {
    mat3 out(0);
    for (int k = 0; k < 2; ++k) out += skew(t.r[k]) * t.inertia[k] * transpose(skew(t.r[k]));
    return out;
  };
  const char* const order = "#transposed transposed: the rows of X belong to the point and its "
                            "columns to the lock, skew(r) I^-1 and not I^-1 skew(r)";
  const char* const masses = "masses do not belong here: the lock turns, and pushes no centre";
  const char* const sides = "the lever is on one side only: this is the rotation's term in K of "
                            "the point";
  const char* const levers = "the levers are missing: this is K of the lock";
  const auto mass = [](const T& t) {
    return t.c.body(0).inverse_mass + t.c.body(1).inverse_mass;
  };
  return {
      {"#sign-body-2-has the sign: body 2 has -skew(r2) in the point and E in the lock: a minus",
       with([](const T&, const mat3& X) { return -X; })},
      {order, with([](const T&, const mat3& X) { return transpose(X); })},
      {std::string(order) + ". And the sign",
       with([](const T&, const mat3& X) { return -transpose(X); })},
      {"#inertias-exchanged the lever of one body with the inertia of the other",
       [](T& t) { std::swap(t.inertia[0], t.inertia[1]); }},
      {"#levers-added-up-first the levers, or the inertias, are added up first: each lever goes "
       "with its own inertia",
       with([](const T& t, const mat3&) {
         return -(skew(t.r[0] + t.r[1]) * (t.inertia[0] + t.inertia[1]));
       })},
      {"a unit matrix is added: there is none in X",
       with([](const T&, const mat3& X) { return X + mat3(1); })},
      {"beside a static body it is zero: the term of the other body stays",
       with([](const T& t, const mat3& X) {
         return t.c.body(0).is_static() || t.c.body(1).is_static() ? mat3(0) : X;
       })},
      {masses, with([=](const T& t, const mat3& X) { return X + mat3(mass(t)); })},
      {masses, with([=](const T& t, const mat3& X) {
         return X + mass(t) * mat3(1, 1, 1, 1, 1, 1, 1, 1, 1);
       })},
      {sides, with([=](const T& t, const mat3&) { return both_sides(t); })},
      {sides, with([=](const T& t, const mat3&) { return -both_sides(t); })},
      {"#k-point this is K of the point: X is the effect of the lock on the point",
       with([=](const T& t, const mat3&) { return mat3(mass(t)) + both_sides(t); })},
      {levers, with([](const T& t, const mat3&) { return t.inertia[0] + t.inertia[1]; })},
      {levers, with([](const T& t, const mat3&) { return -(t.inertia[0] + t.inertia[1]); })},
      {"#last-column-never-filled X is zero: then a turn of the lock would not move the anchor",
       with([](const T&, const mat3&) { return mat3(0); })}};
}

inline CaseTable<CrossCase> cross_table() {
  std::vector<std::string> entries;
  for (const char row : {'x', 'y', 'z'})
    for (const char column : {'x', 'y', 'z'})
      entries.push_back(std::string("X[") + row + ", " + column + "]");
  CaseTable<CrossCase> table{{"5.1", "the block X between point and lock"}, entries, {}, {}, {},
                             cross_cases()};
  table.yours = [](const CrossCase& c) {
    return row_after_row(cross_K(c.point, c.pair.body1, c.pair.body2));
  };
  table.right = [](const CrossCase& c) { return row_after_row(product_X(c)); };
  table.tolerance = K_tolerance;
  Pieces<CrossReference> pieces = wrong_Xs();
  for (const auto& piece : wrong_shares()) pieces.push_back(piece);
  add_pieces(table, [](const CrossCase& c) { return CrossReference(c); },
             [](const CrossReference& t) { return row_after_row(t.X()); }, pieces);
  return table;
}

}  // namespace joints::testing
