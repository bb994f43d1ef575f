// Exercise 7.4, one solve of a whole block: the cases, and the path from the velocities before to
// those after, in pieces.
#pragma once

#include "tests/07_performance/loop_hinges.h"
#include "tests/checker/impulse_lines.h"

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
/// Yours, for one hinge.
inline SolveCase solved(SolveCase c) {
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

/// What a solve is made of, each piece by itself, so that a mistake changes one of them.
struct SolveReference {
  using Step = Call<void(SolveReference&, Vector<5>&)>;
  vec3 r1, r2;              ///< levers
  std::array<vec3, 2> a;    ///< axis rows
  Jacobian<5> read, push;   ///< J of e, and J of the effect of lambda
  ImpulseLines lines;       ///< how v1, w1, v2, w2 get it
  Matrix<5> inverse_K;
  Vector<5> bias;
  FourVelocities V;
  std::vector<Step> on_e, on_lambda, after;  ///< what else becomes of e, of lambda, of V

  explicit SolveReference(const SolveCase& c)
      : r1(to_vec3(c.hinge.r1)), r2(to_vec3(c.hinge.r2)),
        a{to_vec3(c.hinge.axis_row[0]), to_vec3(c.hinge.axis_row[1])},
        read(hinge_rows(r1, r2, a)), push(read), V(velocities_of(c)) {
    lines.inverse_M = {mat3(c.body1.inverse_mass), to_mat3(c.hinge.I1), mat3(c.body2.inverse_mass),
                       to_mat3(c.hinge.I2)};
    lines.before = V;
    int place = 0;
    for (std::size_t i = 0; i < 5; ++i) {
      bias[i] = c.hinge.bias[i];
      for (int j = int(i); j < 5; ++j)
        inverse_K[int(i)][j] = inverse_K[j][int(i)] = c.hinge.inverse_K[std::size_t(place++)];
    }
  }
  /// bias + J V.
  Vector<5> e() {
    Vector<5> out;
    for (int i = 0; i < 5; ++i)
      out[std::size_t(i)] = bias[std::size_t(i)] + dot(read[i].v1, V[0]) + dot(read[i].w1, V[1]) +
                            dot(read[i].v2, V[2]) + dot(read[i].w2, V[3]);
    for (const Step& step : on_e) step(*this, out);
    return out;
  }
  Vector<5> lambda(const Vector<5>& e) {
    Vector<5> out{};
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < 5; ++j) out[std::size_t(i)] -= inverse_K[i][j] * e[std::size_t(j)];
    for (const Step& step : on_lambda) step(*this, out);
    return out;
  }
  FourVelocities solved() {
    Vector<5> impulse = lambda(e());
    const FourVectors changes = lines.changes(impulses<5>(push, impulse));
    for (std::size_t k = 0; k < 4; ++k) V[k] += changes[k];
    for (const Step& step : after) step(*this, impulse);
    return V;
  }
  static Jacobian<5> scaled(Jacobian<5> J, int from, int to, real v1, real w1, real v2, real w2) {
    for (int i = from; i < to; ++i)
      J[i] = {v1 * J[i].v1, w1 * J[i].w1, v2 * J[i].v2, w2 * J[i].w2};
    return J;
  }
};

}  // namespace joints::testing
