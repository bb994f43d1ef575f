// The inner loop on lanes. Included once by each file that is compiled for a kind of processor;
// what stands here is that file's own.
#pragma once

#include "engine/lanes.h"

namespace joints {
namespace {

// A group's numbers, in their order: scales and bounds, then sums, biases, answers and inverse K.
struct GroupNumbers {
  Lanes *mass_scale, *impulse_scale, *lower, *upper, *lambda, *bias, *answer, *inverse_K, *rest;
  GroupNumbers(Lanes* at, int rows)
      : mass_scale(at), impulse_scale(at + 1), lower(at + 2), upper(at + 3), lambda(at + 4),
        bias(lambda + rows), answer(bias + rows), inverse_K(answer + rows),
        rest(inverse_K + rows * rows) {}
};

struct Vector3 {
  Lanes x, y, z;
};
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Lanes dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector3 vector3(const Lanes* at) { return {at[0], at[1], at[2]}; }
inline void add(Lanes* sum, const Vector3& a) {
  sum[0] += a.x;
  sum[1] += a.y;
  sum[2] += a.z;
}
// A symmetric matrix of six numbers (xx, yy, zz, xy, xz, yz) times an arrow.
inline Vector3 times(const Lanes* m, const Vector3& a) {
  return {m[0] * a.x + m[3] * a.y + m[4] * a.z, m[3] * a.x + m[1] * a.y + m[5] * a.z,
          m[4] * a.x + m[5] * a.y + m[2] * a.z};
}

// From what is wrong with each row to the impulses that take it away: the heart of solve_block.
template <int N>
inline void impulses(const GroupNumbers& g, const Lanes* e, Lanes* dlambda) {
  for (int i = 0; i < N; ++i) {
    Lanes sum = g.inverse_K[i * N] * e[0];
    for (int j = 1; j < N; ++j) sum += g.inverse_K[i * N + j] * e[j];
    dlambda[i] = -*g.mass_scale * sum - *g.impulse_scale * g.lambda[i];
  }
  const Lanes wanted = g.lambda[N - 1] + dlambda[N - 1];
  const Lanes below = wanted < *g.lower ? *g.lower : wanted;
  const Lanes kept = below > *g.upper ? *g.upper : below, cut = kept - wanted;
  for (int i = 0; i < N; ++i) dlambda[i] += g.answer[i] * cut;
  for (int i = 0; i < N; ++i) g.lambda[i] += dlambda[i];
}

// Three rows of a point, and rows that only turn: hinge, weld, ball, with or without a limit.
template <int N>
inline void solve_point(const LaneGroup& group, Lanes* numbers, LaneBody* bodies) {
  const GroupNumbers g(numbers + group.first, N);
  const Vector3 r1 = vector3(g.rest), r2 = vector3(g.rest + 3);
  const Lanes *I1 = g.rest + 6, *I2 = g.rest + 12, *axis = g.rest + 18;
  BodyLanes body1, body2;
  load(bodies, group.body1, body1);
  load(bodies, group.body2, body2);
  const Vector3 w1 = vector3(body1.w()), w2 = vector3(body2.w());

  Lanes e[N], dlambda[N];
  const Vector3 s1 = cross(w1, r1), s2 = cross(w2, r2);
  e[0] = g.bias[0] + (body2.v()[0] + s2.x) - (body1.v()[0] + s1.x);
  e[1] = g.bias[1] + (body2.v()[1] + s2.y) - (body1.v()[1] + s1.y);
  e[2] = g.bias[2] + (body2.v()[2] + s2.z) - (body1.v()[2] + s1.z);
  const Vector3 turning{w2.x - w1.x, w2.y - w1.y, w2.z - w1.z};
  for (int i = 3; i < N; ++i) e[i] = g.bias[i] + dot(vector3(axis + 3 * (i - 3)), turning);
  impulses<N>(g, e, dlambda);

  const Vector3 push{dlambda[0], dlambda[1], dlambda[2]};
  Vector3 turn1 = cross(r1, push), turn2 = cross(r2, push);
  for (int i = 3; i < N; ++i) {
    const Lanes* a = axis + 3 * (i - 3);
    turn1.x += dlambda[i] * a[0], turn1.y += dlambda[i] * a[1], turn1.z += dlambda[i] * a[2];
    turn2.x += dlambda[i] * a[0], turn2.y += dlambda[i] * a[1], turn2.z += dlambda[i] * a[2];
  }
  const Vector3 answer1 = times(I1, turn1), answer2 = times(I2, turn2);
  const Lanes m1 = body1.inverse_mass(), m2 = body2.inverse_mass();
  add(body1.v(), {-m1 * push.x, -m1 * push.y, -m1 * push.z});
  add(body1.w(), {-answer1.x, -answer1.y, -answer1.z});
  add(body2.v(), {m2 * push.x, m2 * push.y, m2 * push.z});
  add(body2.w(), answer2);
  store(bodies, group.body1, body1);
  store(bodies, group.body2, body2);
}

// Any rows: eighteen numbers each, v1 w1 v2 w2 of J and what an impulse does to the two spins.
template <int N>
inline void solve_any(const LaneGroup& group, Lanes* numbers, LaneBody* bodies) {
  const GroupNumbers g(numbers + group.first, N);
  BodyLanes body1, body2;
  load(bodies, group.body1, body1);
  load(bodies, group.body2, body2);
  Lanes e[N], dlambda[N];
  for (int i = 0; i < N; ++i) {
    const Lanes* row = g.rest + 18 * i;
    e[i] = g.bias[i] + dot(vector3(row), vector3(body1.v())) +
           dot(vector3(row + 3), vector3(body1.w())) + dot(vector3(row + 6), vector3(body2.v())) +
           dot(vector3(row + 9), vector3(body2.w()));
  }
  impulses<N>(g, e, dlambda);
  for (int i = 0; i < N; ++i) {
    const Lanes* row = g.rest + 18 * i;
    const Lanes along1 = body1.inverse_mass() * dlambda[i];
    const Lanes along2 = body2.inverse_mass() * dlambda[i];
    for (int k = 0; k < 3; ++k) {
      body1.v()[k] += along1 * row[k];
      body2.v()[k] += along2 * row[6 + k];
      body1.w()[k] += dlambda[i] * row[12 + k];
      body2.w()[k] += dlambda[i] * row[15 + k];
    }
  }
  store(bodies, group.body1, body1);
  store(bodies, group.body2, body2);
}

inline void sweep_all(const LaneGroup* groups, int count, LaneNumber* memory, LaneBody* bodies) {
  Lanes* const numbers = reinterpret_cast<Lanes*>(memory);
  for (int k = 0; k < count; ++k) {
    const LaneGroup& group = groups[k];
    switch (group.point ? 10 + group.rows : group.rows) {
      case 1: solve_any<1>(group, numbers, bodies); break;
      case 2: solve_any<2>(group, numbers, bodies); break;
      case 3: solve_any<3>(group, numbers, bodies); break;
      case 4: solve_any<4>(group, numbers, bodies); break;
      case 5: solve_any<5>(group, numbers, bodies); break;
      case 6: solve_any<6>(group, numbers, bodies); break;
      case 13: solve_point<3>(group, numbers, bodies); break;
      case 14: solve_point<4>(group, numbers, bodies); break;
      case 15: solve_point<5>(group, numbers, bodies); break;
      case 16: solve_point<6>(group, numbers, bodies); break;
    }
  }
}

}  // namespace
}  // namespace joints
