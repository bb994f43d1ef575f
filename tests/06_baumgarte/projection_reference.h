// Exercise 6.3 done once more, with J by differences: what a position projection gives.
#pragma once

#include "tests/06_baumgarte/warm_cases.h"

namespace joints::testing {

/// The rotation vector [rad] that leads from one orientation to another.
inline vec3 turn_between(const quat& from, const quat& to) {
  quat turn = to * conjugate(from);
  if (turn.w < 0) turn = -turn;
  const vec3 axis(turn.x, turn.y, turn.z);
  const real sine = length(axis);
  return sine > 0 ? 2 * std::atan2(sine, turn.w) / sine * axis : vec3(0);
}

inline Moves between(const Pair& from, const Pair& to) {
  return {to.body1.x - from.body1.x, turn_between(from.body1.q, to.body1.q),
          to.body2.x - from.body2.x, turn_between(from.body2.q, to.body2.q)};
}

template <class Part>
struct ProjectionCase {
  std::string words;
  Part part;
  Pair pair;
};

/// K lambda = -C; none where the part is one-sided and its error is not negative.
template <class Part>
Moves reference_moves(const Part& part, const Pair& pair) {
  constexpr int n = Part::rows;
  const auto& [body1, body2] = pair;
  const Vector<n> C = to_vector(part.error(body1, body2));
  if (Part::one_sided && C[0] >= 0) return {};
  const Jacobian<n> J = numeric_jacobian(part, body1, body2);
  Matrix<n> inverse = dense_K(J, body1, body2);
  invert_symmetric(inverse[0].data(), n);
  Vector<n> lambda{};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) lambda[std::size_t(i)] -= inverse[i][j] * C[std::size_t(j)];
  return response<n>(J, lambda, pair);
}
inline void move_by(const Moves& a, Body& body1, Body& body2) {
  body1.x += a.way1;
  body2.x += a.way2;
  body1.q = normalize(rotation(a.turn1) * body1.q);
  body2.q = normalize(rotation(a.turn2) * body2.q);
}

}  // namespace joints::testing
