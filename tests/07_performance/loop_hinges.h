// The hinges of chapter 7's tests: their poses, and their numbers worked out once more.
#pragma once

#include <algorithm>

#include "chapters/07_performance/performance.h"
#include "tests/checker/pose_cases.h"
#include "tests/checker/unit_rates.h"

namespace joints::testing {

// ---- the reference of exercise 7.1 --------------------------------------------------------------

/// A direction turned by a quaternion: q a q^-1.
inline vec3 rotated(const quat& q, const vec3& a) {
  const quat turned = q * quat(0, a.x, a.y, a.z) * conjugate(q);
  return {turned.x, turned.y, turned.z};
}
inline vec3 unit_vector(int k) { return vec3(k == 0, k == 1, k == 2); }
/// The sum of i n n^T over the three principal axes n.
inline mat3 turned_inertia(const quat& q, const vec3& along_axes) {
  mat3 out(0);
  for (int k = 0; k < 3; ++k) {
    const vec3 n = rotated(q, unit_vector(k));
    out += along_axes[k] * glm::outerProduct(n, n);
  }
  return out;
}

/// A hinge whose error is worked out here: the gap, then a1.b and a1.c.
struct LoopHinge : Hinge {
  static constexpr int rows = 5;
  static constexpr bool one_sided = false;
  static constexpr Form form = Form::any;
  Vector<5> error(const Body& body1, const Body& body2) const {
    const vec3 gap = body2.x + rotated(body2.q, point.anchor2_local) - body1.x -
                     rotated(body1.q, point.anchor1_local);
    const vec3 a1 = rotated(body1.q, axis.a1_local);
    return {gap.x, gap.y, gap.z, dot(a1, rotated(body2.q, axis.b_local)),
            dot(a1, rotated(body2.q, axis.c_local))};
  }
};

struct HingeCase {
  std::string words;
  LoopHinge hinge;
  Pair pair;
  real h;
  const Body& body(bool second) const { return second ? pair.body2 : pair.body1; }
  const vec3& anchor(bool second) const {
    return second ? hinge.point.anchor2_local : hinge.point.anchor1_local;
  }
};

// ---- the poses ----------------------------------------------------------------------------------

struct LoopHingeFixture {
  using Part = LoopHinge;
  static constexpr bool exact_when_broken = true;
  static Part make(const Pair& pair) {
    Part part;
    part.point = point_at(pair.body1, pair.body2, vec3(real(0.8), real(0.4), real(-0.6)));
    const vec3 axis = normalize(vec3(real(0.5), real(-0.3), real(0.7)));
    const vec3 across = normalize(cross(axis, vec3(1, 2, 0)));
    part.axis = {to_local(pair.body1, axis), to_local(pair.body2, across),
                 to_local(pair.body2, cross(axis, across))};
    return part;
  }
  static void move_freely(const Part& part, Pair& pair, Random& random) {
    const vec3 anchor = world_point(pair.body1, part.point.anchor1_local);
    const quat turn = rotation(random.uniform(-3, 3) * to_world(pair.body1, part.axis.a1_local));
    pair.body2.x = anchor + turn * (pair.body2.x - anchor);
    pair.body2.q = normalize(turn * pair.body2.q);
  }
};

/// The pose for pencil and paper in the text: body 2 has slipped by (0.03, 0, 0.06).
inline HingeCase paper_hinge() {
  LoopHinge hinge;
  hinge.point.anchor2_local = vec3(0, 0, -2);
  HingeCase c{"pencil and paper", hinge,
              {body_with(2, vec3(1), vec3(0)),
               body_with(1, vec3(real(0.5)), vec3(real(0.03), 0, real(2.06)))},
              1 / real(60)};
  c.pair.body1.w = vec3(0, 0, real(0.5));
  c.pair.body2.v = vec3(real(0.1), real(-0.2), real(0.3));
  c.pair.body2.w = vec3(real(0.5), 0, 0);
  return c;
}

/// Every pose, with bodies that fly, and steps and shares of all sizes; then three special ones.
inline std::vector<HingeCase> hinge_cases() {
  std::vector<HingeCase> out;
  Random random(71);
  for_each_pose<LoopHingeFixture>([&](int pose, const LoopHinge& hinge, const Pair& pair) {
    out.push_back({pose_names[pose], hinge, pair, 1 / random.uniform(50, 120)});
    out.back().hinge.beta = random.uniform(real(0.1), real(0.9));
    for (Body* body : {&out.back().pair.body1, &out.back().pair.body2}) {
      body->v = random.vector(2);
      body->w = random.vector(2);
    }
  });
  for (const char* words : {"1 static", "2 static", "no levers"}) {
    out.push_back(out[out.size() - 4]);
    out.back().words = words;
  }
  const std::size_t n = out.size();
  const auto fix = [](Body& body) { body = static_body(body.x, body.q); };
  fix(out[n - 3].pair.body1);
  fix(out[n - 2].pair.body2);
  out[n - 1].hinge.point = {};
  return out;
}

/// b x a1 and c x a1 from directions in the world.
inline std::array<vec3, 2> axis_rows(const vec3& a1, const vec3& b, const vec3& c) {
  return {cross(b, a1), cross(c, a1)};
}
inline std::array<vec3, 2> reference_rows(const HingeCase& c) {
  return axis_rows(rotated(c.pair.body1.q, c.hinge.axis.a1_local),
                   rotated(c.pair.body2.q, c.hinge.axis.b_local),
                   rotated(c.pair.body2.q, c.hinge.axis.c_local));
}
inline vec3 reference_lever(const HingeCase& c, bool second) {
  return rotated(c.body(second).q, c.anchor(second));
}
inline mat3 reference_inertia(const HingeCase& c, bool second) {
  return turned_inertia(c.body(second).q, c.body(second).inverse_inertia_local);
}
/// The five rows: a gap moves with both anchors, an axis error with the turns alone.
inline Jacobian<5> hinge_rows(const vec3& r1, const vec3& r2, const std::array<vec3, 2>& a) {
  Jacobian<5> J;
  for (int k = 0; k < 3; ++k) J[k] = row_by_rates(unit_vector(k), r1, r2);
  for (int k = 0; k < 2; ++k) J[3 + k] = {vec3(0), -a[k], vec3(0), a[k]};
  return J;
}
/// The numbers of a hinge. inverse_K is K of the five rows, inverted.
inline HingeNumbers<real> reference_numbers(const HingeCase& c) {
  HingeNumbers<real> out{};
  const vec3 r1 = reference_lever(c, false), r2 = reference_lever(c, true);
  const mat3 I1 = reference_inertia(c, false), I2 = reference_inertia(c, true);
  const std::array<vec3, 2> a = reference_rows(c);
  out.r1 = {r1.x, r1.y, r1.z};
  out.r2 = {r2.x, r2.y, r2.z};
  for (int k = 0; k < 2; ++k) out.axis_row[k] = {a[k].x, a[k].y, a[k].z};
  out.I1 = {I1[0][0], I1[1][1], I1[2][2], I1[0][1], I1[0][2], I1[1][2]};
  out.I2 = {I2[0][0], I2[1][1], I2[2][2], I2[0][1], I2[0][2], I2[1][2]};
  const Vector<5> C = c.hinge.error(c.pair.body1, c.pair.body2);
  for (int i = 0; i < 5; ++i) out.bias[i] = c.hinge.beta * C[i] / c.h;
  Matrix<5> K = product_K(hinge_rows(r1, r2, a), c.pair.body1.inverse_mass, I1,
                          c.pair.body2.inverse_mass, I2);
  invert_symmetric(K[0].data(), 5);
  int place = 0;
  for (int i = 0; i < 5; ++i)
    for (int j = i; j < 5; ++j) out.inverse_K[place++] = K[i][j];
  return out;
}

inline void append(Numbers& out, const Triple<real>& a) {
  out.insert(out.end(), {double(a.x), double(a.y), double(a.z)});
}

}  // namespace joints::testing
