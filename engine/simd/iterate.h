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
template <class Rows, int N, bool hard, class Number>
inline void impulses(Record<Rows, N, hard, Number>& record, const Number* e, Number* dlambda) {
  Number* const lambda = record.impulses.sum;
  for (int i = 0; i < N; ++i) {
    dlambda[i] = -(record.impulses.entry(i, 0) * e[0]);
    for (int j = 1; j < N; ++j) dlambda[i] = dlambda[i] - record.impulses.entry(i, j) * e[j];
  }
  if constexpr (!hard) {
    const Bounds<N, Number>& bounds = record.bounds;
    for (int i = 0; i < N; ++i) dlambda[i] = dlambda[i] - bounds.impulse_scale * lambda[i];
    const Number wanted = lambda[N - 1] + dlambda[N - 1];
    const Number kept = lesser(greater(wanted, bounds.lower), bounds.upper), cut = kept - wanted;
    for (int i = 0; i < N - 1; ++i) dlambda[i] = dlambda[i] + bounds.answer[i] * cut;
    dlambda[N - 1] = kept - lambda[N - 1];
    lambda[N - 1] = kept;  // at the bound to the last digit
    for (int i = 0; i < N - 1; ++i) lambda[i] = lambda[i] + dlambda[i];
    return;
  }
  for (int i = 0; i < N; ++i) lambda[i] = lambda[i] + dlambda[i];
}

// Three rows of a point, and rows that only turn: ball, hinge, weld, with or without a limit.
template <int N, bool isotropic, bool hard, class Number>
inline void solve_record(Record<PointRows<N, isotropic, Number>, N, hard, Number>& record,
                         Velocities<Number>& body1, Velocities<Number>& body2) {
  const PointRows<N, isotropic, Number>& rows = record.rows;
  const Triple<Number> r1 = rows.r1, r2 = rows.r2;
  Number e[N], dlambda[N];
  const Triple<Number> gap = body2.v + cross(body2.w, r2) - body1.v - cross(body1.w, r1);
  const Triple<Number> turning = body2.w - body1.w;
  e[0] = rows.bias[0] + gap.x, e[1] = rows.bias[1] + gap.y, e[2] = rows.bias[2] + gap.z;
  for (int i = 3; i < N; ++i) e[i] = rows.bias[i] + dot(rows.axis[i - 3], turning);
  impulses(record, e, dlambda);

  const Triple<Number> push{dlambda[0], dlambda[1], dlambda[2]};
  Triple<Number> turn1 = cross(r1, push), turn2 = cross(r2, push);
  for (int i = 3; i < N; ++i) {
    const Triple<Number> turn = dlambda[i] * rows.axis[i - 3];
    turn1 = turn1 + turn;
    turn2 = turn2 + turn;
  }
  const auto I1 = rows.I1, I2 = rows.I2;
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - I1 * turn1;
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + I2 * turn2;
}

// Any rows.
template <int N, bool hard, class Number>
inline void solve_record(Record<AnyRows<N, Number>, N, hard, Number>& record,
                         Velocities<Number>& body1, Velocities<Number>& body2) {
  const AnyRows<N, Number>& rows = record.rows;
  Number e[N], dlambda[N];
  for (int i = 0; i < N; ++i) {
    e[i] = rows.bias[i] + dot(rows.row[i].v1, body1.v);
    e[i] = e[i] + dot(rows.row[i].w1, body1.w);
    e[i] = e[i] + dot(rows.row[i].v2, body2.v);
    e[i] = e[i] + dot(rows.row[i].w2, body2.w);
  }
  impulses(record, e, dlambda);
  for (int i = 0; i < N; ++i) {
    body1.v = body1.v + body1.inverse_mass * dlambda[i] * rows.row[i].v1;
    body2.v = body2.v + body2.inverse_mass * dlambda[i] * rows.row[i].v2;
    body1.w = body1.w + dlambda[i] * rows.row[i].turn1;
    body2.w = body2.w + dlambda[i] * rows.row[i].turn2;
  }
}

// The bounds of a row that follows: multiples of other sums, as they are now.
// \param sums of each lane, which number it follows
template <class Number>
inline void move_bounds(FollowingRecord<Number>& record, const real* numbers, const int* sums) {
  for (int lane = 0; lane < int(sizeof(Number) / sizeof(real)); ++lane) {
    const real bound = gather<real>(record.factor, lane) * numbers[sums[lane]];
    scatter(-bound, record.bounds.lower, lane);
    scatter(bound, record.bounds.upper, lane);
  }
}

// Number is real, or the lanes of a file.
template <class Number>
inline void iterate_all(const LaneIteration& all) {
  constexpr int width = int(sizeof(Number) / sizeof(real));
  for (int k = 0; k < all.count; ++k) {
    const LaneGroup& group = all.groups[k];
    with_bodies<Number>(all.bodies, k, [&](auto& body1, auto& body2) JOINTS_INLINED {
      use_record<Number>(group, all.numbers + group.first, [&](auto& record) JOINTS_INLINED {
        if constexpr (requires { record.factor; })
          move_bounds(record, all.numbers, all.sums + k * width);
        solve_record(record, body1, body2);
      });
    });
  }
}

/// \endcond
}  // namespace joints
/// @}
