// The operations on a record: its K^-1, its warm start, its solve. Each file that is compiled for
// an instruction set includes it. Number is one number or one per lane, so every formula is that of
// one block (records.h draws the memory). form_K, errors and apply are those of its kind of rows
// (point_rows.h, any_rows.h); everything else is the same for all kinds.
#pragma once

#include "engine/simd/any_rows.h"
#include "engine/simd/point_rows.h"

/// \addtogroup world
/// @{
namespace joints {
/// \cond

// ---- once per step ------------------------------------------------------------------------------

// K^-1 and the clamp responses.
template <class Rows, int N, bool hard, class Number>
inline void prepare_record(Record<Rows, N, hard, Number>& record, const Velocities<Number>& body1,
                           const Velocities<Number>& body2, real relaxation) {
  Number* const inverse_K = record.inverse_K;
  form_K(record.rows, body1, body2, inverse_K);
  invert_lower<N>(inverse_K);
  if constexpr (hard) {
    for (int k = 0; k < N * (N + 1) / 2; ++k) inverse_K[k] = relaxation * inverse_K[k];
  } else {
    Bounds<N, Number>& bounds = record.bounds;
    const Number over_last =
        inverse_above(inverse_K[lower_index(N - 1, N - 1)], Number::of(0));
    for (int i = 0; i < N; ++i)
      bounds.clamp_response[i] = inverse_K[lower_index(N - 1, i)] * over_last;
    const Number mass_scale = Number::of(relaxation) - bounds.impulse_scale;
    for (int k = 0; k < N * (N + 1) / 2; ++k) inverse_K[k] = mass_scale * inverse_K[k];
  }
}

// Applies `ratio` times the accumulated impulses; a row that depends on others gets none. With 0
// they are set to zero, even if they are not finite.
template <class Rows, int N, bool hard, class Number>
inline void warm_record(Record<Rows, N, hard, Number>& record, Velocities<Number>& body1,
                        Velocities<Number>& body2, real ratio) {
  Number* const lambda = record.lambda;
  for (int i = 0; i < N; ++i) {
    const Number& diagonal = record.inverse_K[lower_index(i, i)];
    if (ratio == 0) lambda[i] = Number::of(0);
    lambda[i] = where_above(diagonal, Number::of(0), ratio * lambda[i]);
  }
  if (ratio != 0) apply(record.rows, lambda, body1, body2);
}

// ---- in every iteration -------------------------------------------------------------------------

// One solve of a block, by the same formulas as in SequentialImpulses::solve_block.
template <class Rows, int N, bool hard, class Number>
inline void solve_record(Record<Rows, N, hard, Number>& record, Velocities<Number>& body1,
                         Velocities<Number>& body2) {
  Number e[N], dlambda[N];  // the errors of the velocities, and the changes of the impulses
  errors(record.rows, body1, body2, e);
  Number* const lambda = record.lambda;
  const Number* const inverse_K = record.inverse_K;
  for (int i = 0; i < N; ++i) {
    dlambda[i] = -(inverse_K[lower_index(i, 0)] * e[0]);
    for (int j = 1; j < N; ++j) dlambda[i] = dlambda[i] - inverse_K[lower_index(i, j)] * e[j];
  }
  if constexpr (!hard) {
    const Bounds<N, Number>& bounds = record.bounds;
    for (int i = 0; i < N; ++i) dlambda[i] = dlambda[i] - bounds.impulse_scale * lambda[i];
    const Number wanted = lambda[N - 1] + dlambda[N - 1];
    const Number kept = lesser(greater(wanted, bounds.lower), bounds.upper), cut = kept - wanted;
    for (int i = 0; i < N - 1; ++i) dlambda[i] = dlambda[i] + bounds.clamp_response[i] * cut;
    dlambda[N - 1] = kept - lambda[N - 1];
    lambda[N - 1] = kept;  // exactly at the bound
  }
  for (int i = 0; i < N - !hard; ++i) lambda[i] = lambda[i] + dlambda[i];
  apply(record.rows, dlambda, body1, body2);
}

// Sets the bounds of a following row to -+factor times the impulse that it follows.
// \param followed for each lane, the index of that impulse in `numbers`
template <int ends, class Number>
inline void move_bounds(FollowingRecord<ends, Number>& record, const real* numbers,
                        const int* followed) {
  Number impulse;
  for (int lane = 0; lane < width_of<Number>; ++lane)
    scatter(numbers[followed[lane]], impulse, lane);
  record.bounds.upper = record.factor * impulse;
  record.bounds.lower = -record.bounds.upper;
}

// ---- a pass over all groups ---------------------------------------------------------------------

// Calls f(record, body1, body2, number) for every group: one switch for groups of the same kind.
template <class Number, class F>
inline void each_group(const LaneWork& work, const F& f) {
  for (int k = 0; k < work.count;) {
    const LaneGroup& group = work.groups[k];
    use_record<Number>(group, work.numbers + group.first, [&](auto& first) JOINTS_INLINED {
      auto* record = &first;
      for (const int end = k + group.alike; k < end; ++k) {
        record = reinterpret_cast<decltype(record)>(work.numbers + work.groups[k].first);
        with_bodies<Number, std::decay_t<decltype(first)>::ends>(
            work.bodies, k,
            [&](auto& body1, auto& body2) JOINTS_INLINED { f(*record, body1, body2, k); });
      }
    });
  }
}

template <class Number>
inline void run(const LaneWork& work, Pass pass, real parameter) {
  switch (pass) {
    case Pass::prepare:
      return each_group<Number>(work, [=](auto& record, auto& body1, auto& body2, int) {
        prepare_record(record, body1, body2, parameter);
      });
    case Pass::warm:
      return each_group<Number>(work, [=](auto& record, auto& body1, auto& body2, int) {
        warm_record(record, body1, body2, parameter);
      });
    case Pass::iterate:
      return each_group<Number>(work, [&](auto& record, auto& body1, auto& body2, int k) {
        if constexpr (requires { record.factor; })
          move_bounds(record, work.numbers, work.followed + k * width_of<Number>);
        solve_record(record, body1, body2);
      });
  }
}
// The same for groups of one block or of one per lane.
template <class Single, class Lanes>
inline void run(const LaneWork& work, Pass pass, real parameter) {
  work.width > 1 ? run<Lanes>(work, pass, parameter) : run<Single>(work, pass, parameter);
}

/// \endcond
}  // namespace joints
/// @}
