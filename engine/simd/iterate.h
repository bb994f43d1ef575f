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
template <BlockKind kind, class Number, int N = kind.rows>
inline void prepare_record(Record<kind, Number>& record, const Velocities<Number>& body1,
                           const Velocities<Number>& body2, real relaxation) {
  Number* const inverse_K = record.inverse_K;
  form_K(record.rows, body1, body2, inverse_K);
  invert_lower<N>(inverse_K);
  if constexpr (kind.hard) {
    for (int k = 0; k < N * (N + 1) / 2; ++k) inverse_K[k] = relaxation * inverse_K[k];
  } else {
    Bounds<kind, Number>& bounds = record.bounds;
    const Number over_last = inverse_above(inverse_K[lower_index(N - 1, N - 1)], Number::of(0));
    for (int i = 0; i < N; ++i)
      bounds.clamp_response[i] = inverse_K[lower_index(N - 1, i)] * over_last;
    const Number mass_scale = Number::of(relaxation) - bounds.impulse_scale;
    for (int k = 0; k < N * (N + 1) / 2; ++k) inverse_K[k] = mass_scale * inverse_K[k];
  }
}

// Applies `ratio` times the accumulated impulses; a row that depends on others gets none. With 0
// they are set to zero, even if they are not finite.
template <BlockKind kind, class Number, int N = kind.rows>
inline void warm_record(Record<kind, Number>& record, Velocities<Number>& body1,
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
// \param followed for each lane, the index in `numbers` of the impulse that its bounds follow
template <BlockKind kind, class Number, int N = kind.rows>
inline void solve_record(Record<kind, Number>& record, Velocities<Number>& body1,
                         Velocities<Number>& body2, const real* numbers, const int* followed) {
  Number e[N], dlambda[N];  // the errors of the velocities, and the changes of the impulses
  errors(record.rows, body1, body2, e);
  Number* const lambda = record.lambda;
  const Number* const inverse_K = record.inverse_K;
  for (int i = 0; i < N; ++i) {
    dlambda[i] = -(inverse_K[lower_index(i, 0)] * e[0]);
    for (int j = 1; j < N; ++j) dlambda[i] = dlambda[i] - inverse_K[lower_index(i, j)] * e[j];
  }
  if constexpr (!kind.hard) {
    const Bounds<kind, Number>& bounds = record.bounds;
    Number lower = bounds.lower, upper = bounds.upper;
    if constexpr (kind.follows) {  // the bounds are -+upper times the followed impulse
      Number impulse;
      for (int lane = 0; lane < width_of<Number>; ++lane)
        scatter(numbers[followed[lane]], impulse, lane);
      upper = upper * impulse;
      lower = -upper;
    }
    for (int i = 0; i < N; ++i) dlambda[i] = dlambda[i] - bounds.impulse_scale * lambda[i];
    const Number wanted = lambda[N - 1] + dlambda[N - 1];
    const Number kept = lesser(greater(wanted, lower), upper), cut = kept - wanted;
    for (int i = 0; i < N - 1; ++i) dlambda[i] = dlambda[i] + bounds.clamp_response[i] * cut;
    dlambda[N - 1] = kept - lambda[N - 1];
    lambda[N - 1] = kept;  // exactly at the bound
  }
  for (int i = 0; i < N - !kind.hard; ++i) lambda[i] = lambda[i] + dlambda[i];
  apply(record.rows, dlambda, body1, body2);
}

// ---- a pass over all groups ---------------------------------------------------------------------

// Calls f(record, body1, body2, k) for every group k: one switch for groups of the same kind.
template <class Number, class F>
inline void each_group(const LaneWork& work, const F& f) {
  const auto record_of = [&](int k) { return work.numbers + work.groups[k].first; };
  for (int begin = 0, end; begin < work.count; begin = end) {
    end = begin + work.groups[begin].alike;
    use_record<Number>(work.groups[begin], record_of(begin), [&]<class One>(One&) JOINTS_INLINED {
      for (int k = begin; k < end; ++k)
        with_bodies<Number, One::ends>(
            work.bodies, k, [&](auto& body1, auto& body2) JOINTS_INLINED {
              f(*reinterpret_cast<One*>(record_of(k)), body1, body2, k);
            });
    });
  }
}

// A pass over all groups, compiled for the including file's instruction set.
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
        solve_record(record, body1, body2, work.numbers, work.followed + k * width_of<Number>);
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
