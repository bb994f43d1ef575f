// The numeric reference of a part: its Jacobian by central differences, its K from that.
#pragma once

#include <random>

#include "engine/matrix.h"

namespace joints::testing {

inline constexpr bool is_float = std::numeric_limits<real>::digits < 50;
/// Step of the central differences, and how far they may be from the exact slope (math: 1e-7 in
/// double, 5e-4 in float; masses and lengths are of order 1).
inline constexpr real difference_step = is_float ? real(5e-3) : real(1e-5);
inline constexpr double difference_tolerance = is_float ? 5e-4 : 1e-7;
/// For formulas that agree to rounding.
inline constexpr double rounding = is_float ? 1e-4 : 1e-11;

/// The body after a small move along coordinate 0 to 5: x, y, z, then turns about x, y, z.
/// Turning is the exponential map, so that J is the slope of C for velocities v and w.
inline Body nudged(Body body, int coordinate, real amount) {
  vec3 move(0);
  move[coordinate % 3] = amount;
  if (coordinate < 3) body.x += move;
  else body.q = normalize(rotation(move) * body.q);
  return body;
}

/// J by central differences of the part's error.
template <class Part>
Jacobian<Part::rows> numeric_jacobian(const Part& part, const Body& body1, const Body& body2) {
  Jacobian<Part::rows> J;
  for (int k = 0; k < 12; ++k) {
    const real step = difference_step;
    const int c = k % 6;
    const auto error = [&](real amount) {
      return k < 6 ? to_vector(part.error(nudged(body1, c, amount), body2))
                   : to_vector(part.error(body1, nudged(body2, c, amount)));
    };
    const auto ahead = error(step), behind = error(-step);
    for (int i = 0; i < Part::rows; ++i) {
      Row& row = J[i];
      vec3& block = k < 3 ? row.v1 : k < 6 ? row.w1 : k < 9 ? row.v2 : row.w2;
      block[k % 3] = (ahead[i] - behind[i]) / (2 * step);
    }
  }
  return J;
}

/// J M^-1 J^T with any 3x3 matrix in place of each inverse inertia and any factor for 1/m. A column
/// is what the rows see of the velocities after an impulse of 1 along one of them.
template <int N>
Matrix<N> product_K(const Jacobian<N>& J, real m1, const mat3& I1, real m2, const mat3& I2) {
  Matrix<N> K;
  for (int j = 0; j < N; ++j) {
    Body one, two;
    one.v = m1 * J[j].v1, one.w = I1 * J[j].w1;
    two.v = m2 * J[j].v2, two.w = I2 * J[j].w2;
    for (int i = 0; i < N; ++i) K[i][j] = row_velocity(J[i], one, two);
  }
  return K;
}

/// J M^-1 J^T.
template <int N>
Matrix<N> dense_K(const Jacobian<N>& J, const Body& body1, const Body& body2) {
  return product_K(J, body1.inverse_mass, inverse_inertia(body1), body2.inverse_mass,
                   inverse_inertia(body2));
}

/// Repeatable random numbers, the same on every machine.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  real uniform(real low, real high) {
    return low + (high - low) * real(engine_() / 4294967296.0);
  }
  vec3 vector(real size) {
    const real x = uniform(-size, size), y = uniform(-size, size), z = uniform(-size, size);
    return {x, y, z};
  }
  quat turn(real size = 3) { return rotation(vector(size)); }

 private:
  std::mt19937 engine_;
};

/// Two bodies of unequal mass and uneven inertia; body 1 unturned, body 2 not.
struct Pair {
  Body body1, body2;
};
inline Pair uneven_pair() {
  Pair pair{body_with(real(2.5), vec3(real(0.4), real(0.9), real(1.2)),
                      vec3(real(0.3), real(-0.2), real(0.5))),
            body_with(real(0.7), vec3(real(0.2), real(0.15), real(0.11)),
                      vec3(real(1.1), real(0.9), real(-0.3)),
                      rotation(vec3(real(0.7), real(-0.4), real(0.5))))};
  return pair;
}
/// The same pair turned and moved as one.
inline void move_together(Pair& pair, Random& random) {
  const quat turn = random.turn();
  const vec3 move = random.vector(2);
  for (Body* body : {&pair.body1, &pair.body2}) {
    body->x = turn * body->x + move;
    body->q = normalize(turn * body->q);
  }
}

}  // namespace joints::testing
