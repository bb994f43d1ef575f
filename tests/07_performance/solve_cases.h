// Exercise 7.4, one solve of a whole block: the cases, and the path from the velocities before to
// those after.
#pragma once

#include "tests/07_performance/loop_hinges.h"

namespace joints::testing {

struct SolveCase {
  std::string words;
  HingeNumbers<real> hinge;
  Velocities<real> body1, body2;
};

inline Velocities<real> velocities_of(const Body& body) {
  return {{body.v.x, body.v.y, body.v.z}, body.inverse_mass, {body.w.x, body.w.y, body.w.z}, 0};
}
inline SolveCase solve_case(const HingeCase& c) {
  return {c.words, reference_numbers(c), velocities_of(c.pair.body1), velocities_of(c.pair.body2)};
}
inline std::vector<SolveCase> solve_cases() {
  std::vector<SolveCase> out;
  for (const HingeCase& c : hinge_cases()) out.push_back(solve_case(c));
  return out;
}
using Solve = void(const HingeNumbers<real>&, Velocities<real>&, Velocities<real>&);
/// Yours, or a mistake, for one hinge.
inline SolveCase solved(SolveCase c, Solve* solve = joints::solve<real>) {
  solve(c.hinge, c.body1, c.body2);
  return c;
}

inline vec3 to_vec3(const Triple<real>& a) { return {a.x, a.y, a.z}; }
inline mat3 to_mat3(const Symmetric<real>& m) {
  return mat3(m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz);
}

/// v1, w1, v2, w2.
using FourVelocities = std::array<vec3, 4>;
inline FourVelocities velocities_of(const SolveCase& c) {
  return {to_vec3(c.body1.v), to_vec3(c.body1.w), to_vec3(c.body2.v), to_vec3(c.body2.w)};
}
inline Numbers flat(const FourVelocities& V) {
  Numbers out;
  for (const vec3& a : V) append(out, a);
  return out;
}

/// Eq. 7-6 with all five rows written out.
struct SolveReference {
  vec3 r1, r2;                    ///< levers
  std::array<vec3, 2> a;          ///< axis rows
  Jacobian<5> J;
  std::array<mat3, 4> inverse_M;  ///< of v1, w1, v2, w2
  Matrix<5> inverse_K;
  Vector<5> bias;
  FourVelocities V;

  explicit SolveReference(const SolveCase& c)
      : r1(to_vec3(c.hinge.r1)), r2(to_vec3(c.hinge.r2)),
        a{to_vec3(c.hinge.axis_row[0]), to_vec3(c.hinge.axis_row[1])}, J(hinge_rows(r1, r2, a)),
        inverse_M{mat3(c.body1.inverse_mass), to_mat3(c.hinge.I1), mat3(c.body2.inverse_mass),
                  to_mat3(c.hinge.I2)},
        bias(c.hinge.bias), V(velocities_of(c)) {
    std::size_t place = 0;
    for (int i = 0; i < 5; ++i)
      for (int j = i; j < 5; ++j)
        inverse_K[i][j] = inverse_K[j][i] = c.hinge.inverse_K[place++];
  }
  static FourVelocities blocks(const Row& J) { return {J.v1, J.w1, J.v2, J.w2}; }
  /// bias + J V.
  Vector<5> e() const {
    Vector<5> out = bias;
    for (std::size_t i = 0; i < 5; ++i)
      for (std::size_t k = 0; k < 4; ++k) out[i] += dot(blocks(J[int(i)])[k], V[k]);
    return out;
  }
  Vector<5> lambda() const {
    const Vector<5> errors = e();
    Vector<5> out{};
    for (std::size_t i = 0; i < 5; ++i)
      for (std::size_t j = 0; j < 5; ++j) out[i] -= inverse_K[int(i)][j] * errors[j];
    return out;
  }
  FourVelocities solved() const {
    const Vector<5> impulse = lambda();
    FourVelocities out = V;
    for (std::size_t i = 0; i < 5; ++i)
      for (std::size_t k = 0; k < 4; ++k)
        out[k] += inverse_M[k] * (impulse[i] * blocks(J[int(i)])[k]);
    return out;
  }
};

inline CaseTable<SolveCase> solve_table() {
  CaseTable<SolveCase> table{{"7.4", "the solve of a whole hinge"},
                             with_xyz({"v1", "w1", "v2", "w2"}), {}, {}, {}, solve_cases()};
  judge(table, joints::solve<real>, [](Solve* solve, const SolveCase& c) {
    return flat(velocities_of(solved(c, solve)));
  });
  table.right = [](const SolveCase& c) { return flat(SolveReference(c).solved()); };
  table.tolerance = is_float ? 1e-3 : 1e-10;
  table.in_pairs = true;
  return table;
}

}  // namespace joints::testing
