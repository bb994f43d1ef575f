// Exercise 6.3 done once more, with J by differences: what a position projection gives.
#pragma once

#include "tests/06_baumgarte/warm_cases.h"
#include "tests/checker/arguments.h"

namespace joints::testing {

/// The rotation vector [rad] that leads from one orientation to another.
inline vec3 turn_between(const quat& from, const quat& to) {
  quat turn = to * conjugate(from);
  if (turn.w < 0) turn = -turn;
  const vec3 axis(turn.x, turn.y, turn.z);
  const real sine = length(axis);
  return sine > 0 ? 2 * std::atan2(sine, turn.w) / sine * axis : vec3(0);
}

/// The four moves of a projection, and their names in reports.
struct OneMove {
  vec3 Moves::*of;
  std::string words;
};
inline const OneMove four_moves[] = {{&Moves::way1, "the move of body 1"},
                                     {&Moves::turn1, "the rotation of body 1"},
                                     {&Moves::way2, "the move of body 2"},
                                     {&Moves::turn2, "the rotation of body 2"}};
inline Moves sum(const Moves& a, const Moves& b) {
  return {a.way1 + b.way1, a.turn1 + b.turn1, a.way2 + b.way2, a.turn2 + b.turn2};
}
inline Moves velocities_of(const Pair& pair) {
  return {pair.body1.v, pair.body1.w, pair.body2.v, pair.body2.w};
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

inline const Distance& rod_of(const Rope<Distance>& rope) { return rope.rod; }
inline const Point& rod_of(const Point& point) { return point; }

/// K lambda = -C and all that belongs to it, with J by differences.
template <class Part>
struct ProjectionReference {
  static constexpr int n = Part::rows;
  Part part;
  Pair pair;
  Jacobian<n> J;
  Matrix<n> K;
  Vector<n> C;

  ProjectionReference(const Part& part, const Pair& pair)
      : part(part), pair(pair), J(numeric_jacobian(part, pair.body1, pair.body2)),
        K(dense_K(J, pair.body1, pair.body2)), C(to_vector(part.error(pair.body1, pair.body2))) {}

  static Vector<n> solved(Matrix<n> K, const Vector<n>& C) {
    invert_symmetric(K.m[0].data(), n);
    return times(K, C);
  }
  static Vector<n> times(const Matrix<n>& K, const Vector<n>& C) {
    Vector<n> out{};
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) out[i] -= K[i][j] * C[j];
    return out;
  }
  Vector<n> lambda() const { return solved(K, C); }
  Moves moves() const { return response<n>(J, lambda(), pair); }
  /// With the error, K or J of another one, by the bits of `which`, and in words which.
  ProjectionReference with(const ProjectionReference& other, int which) const {
    ProjectionReference out = *this;
    if (which & 1) out.C = other.C;
    if (which & 2) out.K = other.K;
    if (which & 4) out.J = other.J;
    return out;
  }
  static std::string words(int which) {
    const char* const words[] = {"error", "K", "jacobian"};
    std::string out;
    for (int k = 0; k < 3; ++k)
      if (which >> k & 1) out += (out.empty() ? "" : ", ") + std::string(words[k]);
    return out;
  }
  Vector<n> without_K() const {
    Vector<n> out{};
    for (int i = 0; i < n; ++i) out[i] = -C[i];
    return out;
  }
  Vector<n> each_row_alone() const {
    Vector<n> out{};
    for (int i = 0; i < n; ++i) out[i] = -C[i] / K[i][i];
    return out;
  }
  Vector<n> with_velocities() const {
    Vector<n> all = C;
    for (int i = 0; i < n; ++i) all[i] += row_velocity(J[i], pair.body1, pair.body2);
    return solved(K, all);
  }
  /// The rows with other levers: w1 = -(r1 x n), w2 = r2 x n for each direction n.
  Jacobian<n> levers(const vec3& r1, const vec3& r2) const {
    Jacobian<n> out = J;
    for (int i = 0; i < n; ++i) {
      out[i].w1 = cross(r1, J[i].v1);
      out[i].w2 = cross(r2, J[i].v2);
    }
    return out;
  }
};

/// The moves of a projection; none where the part is one-sided and its error is not negative.
template <class Part>
Moves reference_moves(const Part& part, const Pair& pair) {
  const ProjectionReference<Part> reference(part, pair);
  return Part::one_sided && reference.C[0] >= 0 ? Moves{} : reference.moves();
}
inline void move_by(const Moves& a, Body& body1, Body& body2) {
  body1.x += a.way1;
  body2.x += a.way2;
  body1.q = normalize(rotation(a.turn1) * body1.q);
  body2.q = normalize(rotation(a.turn2) * body2.q);
}

}  // namespace joints::testing
