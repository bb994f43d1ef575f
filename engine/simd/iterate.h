// The inner loop, written once for any kind of number: one block at a time, or one a lane. Included
// once by each file that is compiled for a kind of processor.
#pragma once

#include "engine/simd/lanes.h"

/// \addtogroup world
/// @{
namespace joints {
/// \cond

// In each lane the lesser, the greater of the two.
inline real lesser(real a, real b) { return a < b ? a : b; }
inline real greater(real a, real b) { return a > b ? a : b; }
template <int P>
inline LanesFor<P> lesser(const LanesFor<P>& a, const LanesFor<P>& b) {
  return {a.all < b.all ? a.all : b.all};
}
template <int P>
inline LanesFor<P> greater(const LanesFor<P>& a, const LanesFor<P>& b) {
  return {a.all > b.all ? a.all : b.all};
}

// From what is wrong with each row to the impulses that take it away: the heart of solve_block.
// `at` walks over the group's numbers: sums, upper half of the inverse, and what is bounded.
template <bool hard, int N, class Number>
inline void impulses(Number*& at, const Number* e, Number* dlambda) {
  Number* const lambda = at;
  const Number* const inverse_K = at + N;
  at += N + N * (N + 1) / 2;
  for (int i = 0; i < N; ++i) {
    const auto entry = [&](int j) {
      return i <= j ? inverse_K[N * i - i * (i - 1) / 2 + j - i]
                    : inverse_K[N * j - j * (j - 1) / 2 + i - j];
    };
    dlambda[i] = -(entry(0) * e[0]);
    for (int j = 1; j < N; ++j) dlambda[i] = dlambda[i] - entry(j) * e[j];
  }
  if constexpr (!hard) {
    const Number &impulse_scale = at[0], &lower = at[1], &upper = at[2], *answer = at + 3;
    at += 3 + N;
    for (int i = 0; i < N; ++i) dlambda[i] = dlambda[i] - impulse_scale * lambda[i];
    const Number wanted = lambda[N - 1] + dlambda[N - 1];
    const Number kept = lesser(greater(wanted, lower), upper), cut = kept - wanted;
    for (int i = 0; i < N - 1; ++i) dlambda[i] = dlambda[i] + answer[i] * cut;
    dlambda[N - 1] = kept - lambda[N - 1];
    lambda[N - 1] = kept;  // at the bound to the last digit
    for (int i = 0; i < N - 1; ++i) lambda[i] = lambda[i] + dlambda[i];
    return;
  }
  for (int i = 0; i < N; ++i) lambda[i] = lambda[i] + dlambda[i];
}

// The next arrow, the next inertia of the group.
template <class Number>
inline Triple<Number> next_triple(const Number*& at) {
  at += 3;
  return {at[-3], at[-2], at[-1]};
}
template <bool isotropic, class Number>
inline auto next_inertia(const Number*& at) {
  if constexpr (isotropic) {
    return *at++;
  } else {
    at += 6;
    return Symmetric<Number>{at[-6], at[-5], at[-4], at[-3], at[-2], at[-1]};
  }
}

// The bounds of a group that follows other sums: multiples of them, as they are now. The numbers of
// one bounded row end with lower, upper, answer, and here a factor. Not inlined: the loop of those
// who follow nothing must not pay for it.
template <class Number>
__attribute__((noinline)) void move_bounds(const LaneIteration& iteration, const LaneGroup& group) {
  constexpr int width = int(sizeof(Number) / sizeof(real));
  const int* const sums = iteration.sums + (&group - iteration.groups) * width;
  real* const lower = iteration.numbers + group.first + 22 * width;
  real *const upper = lower + width, *const factor = lower + 3 * width;
  for (int lane = 0; lane < width; ++lane) {
    upper[lane] = factor[lane] * iteration.numbers[sums[lane]];
    lower[lane] = -upper[lane];
  }
}

// Three rows of a point, and rows that only turn: ball, hinge, weld, with or without a limit.
template <int N, bool hard, bool isotropic, class Number>
inline void solve_point(Number* numbers, Velocities<Number>& body1, Velocities<Number>& body2) {
  const Number* at = numbers;
  const Triple<Number> r1 = next_triple(at), r2 = next_triple(at);
  const auto I1 = next_inertia<isotropic>(at), I2 = next_inertia<isotropic>(at);
  const Number* const bias = at;
  const Number* axis = at + N;
  Number* rest = numbers + (at - numbers) + N + 3 * (N - 3);

  Number e[N], dlambda[N];
  const Triple<Number> gap = body2.v + cross(body2.w, r2) - body1.v - cross(body1.w, r1);
  const Triple<Number> turning = body2.w - body1.w;
  e[0] = bias[0] + gap.x, e[1] = bias[1] + gap.y, e[2] = bias[2] + gap.z;
  for (int i = 3; i < N; ++i) e[i] = bias[i] + dot(next_triple(axis), turning);
  impulses<hard, N>(rest, e, dlambda);

  const Triple<Number> push{dlambda[0], dlambda[1], dlambda[2]};
  Triple<Number> turn1 = cross(r1, push), turn2 = cross(r2, push);
  axis = bias + N;
  for (int i = 3; i < N; ++i) {
    const Triple<Number> turn = dlambda[i] * next_triple(axis);
    turn1 = turn1 + turn;
    turn2 = turn2 + turn;
  }
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - I1 * turn1;
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + I2 * turn2;
}

// Any rows: eighteen numbers each, v1 w1 v2 w2 of J and what an impulse does to the two spins.
template <int N, bool hard, class Number>
inline void solve_any(Number* numbers, Velocities<Number>& body1, Velocities<Number>& body2) {
  const Number* const bias = numbers;
  const Number* at = numbers + N;
  Number e[N], dlambda[N];
  for (int i = 0; i < N; ++i, at += 6) {
    e[i] = bias[i] + dot(next_triple(at), body1.v);
    e[i] = e[i] + dot(next_triple(at), body1.w);
    e[i] = e[i] + dot(next_triple(at), body2.v);
    e[i] = e[i] + dot(next_triple(at), body2.w);
  }
  Number* rest = numbers + 19 * N;
  impulses<hard, N>(rest, e, dlambda);
  at = numbers + N;
  for (int i = 0; i < N; ++i) {
    body1.v = body1.v + body1.inverse_mass * dlambda[i] * next_triple(at);
    at += 3;
    body2.v = body2.v + body2.inverse_mass * dlambda[i] * next_triple(at);
    at += 3;
    body1.w = body1.w + dlambda[i] * next_triple(at);
    body2.w = body2.w + dlambda[i] * next_triple(at);
  }
}

template <int N, class Number>
inline void solve_rows(const LaneGroup& group, Number* numbers, Velocities<Number>& body1,
                       Velocities<Number>& body2) {
  if constexpr (N >= 3) {
    if (group.point) {
      if (group.hard && group.isotropic) return solve_point<N, true, true>(numbers, body1, body2);
      if (group.hard) return solve_point<N, true, false>(numbers, body1, body2);
      if (group.isotropic) return solve_point<N, false, true>(numbers, body1, body2);
      return solve_point<N, false, false>(numbers, body1, body2);
    }
  }
  if (group.hard) return solve_any<N, true>(numbers, body1, body2);
  return solve_any<N, false>(numbers, body1, body2);
}

template <class Number>
inline void solve_group(const LaneIteration& iteration, const LaneGroup& group, Number* numbers,
                        Velocities<Number>& body1, Velocities<Number>& body2) {
  switch (group.rows) {
    case 1:
      if (group.follows) move_bounds<Number>(iteration, group);
      return solve_rows<1>(group, numbers, body1, body2);
    case 2: return solve_rows<2>(group, numbers, body1, body2);
    case 3: return solve_rows<3>(group, numbers, body1, body2);
    case 4: return solve_rows<4>(group, numbers, body1, body2);
    case 5: return solve_rows<5>(group, numbers, body1, body2);
    case 6: return solve_rows<6>(group, numbers, body1, body2);
  }
}

// Number is real, or the lanes of a file.
template <class Number>
inline void iterate_all(const LaneIteration& iteration) {
  constexpr int width = int(sizeof(Number) / sizeof(real));
  for (int k = 0; k < iteration.count; ++k) {
    const LaneGroup& group = iteration.groups[k];
    Number* const numbers = reinterpret_cast<Number*>(iteration.numbers + group.first);
    const int* const ends = iteration.ends + group.first_end;
    if constexpr (width == 1) {
      solve_group(iteration, group, numbers, iteration.bodies[ends[0]], iteration.bodies[ends[1]]);
    } else if (iteration.columns) {
      auto* const columns = reinterpret_cast<Velocities<Number>*>(iteration.bodies);
      solve_group(iteration, group, numbers, columns[ends[0]], columns[ends[1]]);
    } else {
      Velocities<Number> body1, body2;
      load(iteration.bodies, ends, body1);
      load(iteration.bodies, ends + width, body2);
      solve_group(iteration, group, numbers, body1, body2);
      store(iteration.bodies, ends, body1);
      store(iteration.bodies, ends + width, body2);
    }
  }
}

/// \endcond
}  // namespace joints
/// @}
