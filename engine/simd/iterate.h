// The operations on a record: its K^-1, its warm start, its solve. Each file that is compiled for
// an instruction set includes it. Number is one number or one per lane, so every formula is that of
// one block (records.h draws the memory). A solve is errors, impulses, apply; every kind of rows
// has three functions, and everything else is the same for all kinds:
//   form_K   J M^-1 J^T, lower triangle
//   errors   bias + J V
//   apply    V += M^-1 J^T lambda
#pragma once

#include "engine/simd/lanes.h"

/// \addtogroup world
/// @{
namespace joints {
/// \cond

// ---- three rows of a point and N - 3 angular rows: ball, hinge, weld, with or without a limit ---

// K += skew(r) I skew(r)^T, of one body.
template <class Number>
inline void add_lever(Number* K, const Triple<Number>& r, const Number& I) {
  const Triple<Number> Ir = I * r;
  const Number xx = Ir.x * r.x, yy = Ir.y * r.y, zz = Ir.z * r.z;
  K[0] += yy + zz;
  K[1] -= Ir.x * r.y;
  K[2] += xx + zz;
  K[3] -= Ir.x * r.z;
  K[4] -= Ir.y * r.z;
  K[5] += xx + yy;
}
template <class Number>
inline void add_lever(Number* K, const Triple<Number>& r, const Symmetric<Number>& I) {
  const Triple<Number> x{I.xx, I.xy, I.xz}, y{I.xy, I.yy, I.yz}, z{I.xz, I.yz, I.zz};
  const Triple<Number> a = r.z * y - r.y * z, b = r.x * z - r.z * x, c = r.y * x - r.x * y;
  K[0] += r.z * a.y - r.y * a.z;  // a, b, c are I (r x e) with the three unit vectors e
  K[1] += r.x * a.z - r.z * a.x;
  K[2] += r.x * b.z - r.z * b.x;
  K[3] += r.y * a.x - r.x * a.y;
  K[4] += r.y * b.x - r.x * b.y;
  K[5] += r.y * c.x - r.x * c.y;
}

// The inverse mass of both bodies. In an unused lane all numbers of the record are zero, but its
// columns may contain two bodies that no block connects. There it returns 0, so K^-1 is zero, too.
template <class Number>
inline Number used_mass(const Number& mass, const Number& I1, const Number& I2) {
  return where_above(I1 + I2, Number::of(0), mass);
}
template <class Number>
inline Number used_mass(const Number& mass, const Symmetric<Number>& I1,
                        const Symmetric<Number>& I2) {
  return used_mass(mass, I1.xx, I2.xx);
}

template <int N, bool isotropic, class Number>
inline void form_K(const PointRows<N, isotropic, Number>& rows, const Velocities<Number>& body1,
                   const Velocities<Number>& body2, Number* K) {
  K[0] = K[2] = K[5] = used_mass(body1.inverse_mass + body2.inverse_mass, rows.I1, rows.I2);
  K[1] = K[3] = K[4] = Number::of(0);
  add_lever(K, rows.r1, rows.I1);
  add_lever(K, rows.r2, rows.I2);
  for (int i = 3; i < N; ++i) {
    const Triple<Number> w1 = rows.I1 * rows.axis[i - 3], w2 = rows.I2 * rows.axis[i - 3];
    const Triple<Number> gap = cross(w1, rows.r1) + cross(w2, rows.r2), turning = w1 + w2;
    Number* const row = K + lower_index(i, 0);
    row[0] = gap.x, row[1] = gap.y, row[2] = gap.z;
    for (int j = 3; j <= i; ++j) row[j] = dot(rows.axis[j - 3], turning);
  }
}

template <int N, bool isotropic, class Number>
inline void errors(const PointRows<N, isotropic, Number>& rows, const Velocities<Number>& body1,
                   const Velocities<Number>& body2, Number* e) {
  const Triple<Number> v =
      body2.v + cross(body2.w, rows.r2) - body1.v - cross(body1.w, rows.r1);
  const Triple<Number> w = body2.w - body1.w;
  e[0] = rows.bias[0] + v.x, e[1] = rows.bias[1] + v.y, e[2] = rows.bias[2] + v.z;
  for (int i = 3; i < N; ++i) e[i] = rows.bias[i] + dot(rows.axis[i - 3], w);
}

template <int N, bool isotropic, class Number>
inline void apply(const PointRows<N, isotropic, Number>& rows, const Number* lambda,
                  Velocities<Number>& body1, Velocities<Number>& body2) {
  const Triple<Number> P{lambda[0], lambda[1], lambda[2]};
  Triple<Number> L1 = cross(rows.r1, P), L2 = cross(rows.r2, P);  // angular impulses
  for (int i = 3; i < N; ++i) {
    const Triple<Number> couple = lambda[i] * rows.axis[i - 3];
    L1 = L1 + couple;
    L2 = L2 + couple;
  }
  body1.v = body1.v - body1.inverse_mass * P;
  body1.w = body1.w - rows.I1 * L1;
  body2.v = body2.v + body2.inverse_mass * P;
  body2.w = body2.w + rows.I2 * L2;
}

// ---- any rows -----------------------------------------------------------------------------------

// The body of a half row: with two ends body 1, then body 2; with one it is body 2.
template <int ends, class V>
inline V& body_of(int end, V& body1, V& body2) {
  return end + 1 < ends ? body1 : body2;
}

template <int N, int ends, class Number>
inline void form_K(const AnyRows<N, ends, Number>& rows, const Velocities<Number>& body1,
                   const Velocities<Number>& body2, Number* K) {
  for (int i = 0; i < N; ++i)
    for (int j = 0; j <= i; ++j)
      for (int end = 0; end < ends; ++end) {
        const auto &a = rows.row[i][end], &b = rows.row[j][end];
        const Number& inverse_mass = body_of<ends>(end, body1, body2).inverse_mass;
        const Number linear = dot(inverse_mass * a.v, b.v);
        Number& sum = K[lower_index(i, j)];
        sum = (end == 0 ? linear : sum + linear) + dot(a.response_w, b.w);
      }
}

template <int N, int ends, class Number>
inline void errors(const AnyRows<N, ends, Number>& rows, const Velocities<Number>& body1,
                   const Velocities<Number>& body2, Number* e) {
  for (int i = 0; i < N; ++i) {
    e[i] = rows.bias[i];
    for (int end = 0; end < ends; ++end) {
      const auto& [v, w, response_w] = rows.row[i][end];
      const Velocities<Number>& body = body_of<ends>(end, body1, body2);
      e[i] = e[i] + dot(v, body.v) + dot(w, body.w);
    }
  }
}

template <int N, int ends, class Number>
inline void apply(const AnyRows<N, ends, Number>& rows, const Number* lambda,
                  Velocities<Number>& body1, Velocities<Number>& body2) {
  for (int i = 0; i < N; ++i)
    for (int end = 0; end < ends; ++end) {
      const auto& [v, w, response_w] = rows.row[i][end];
      Velocities<Number>& body = body_of<ends>(end, body1, body2);
      body.v = body.v + body.inverse_mass * lambda[i] * v;
      body.w = body.w + lambda[i] * response_w;
    }
}

// ---- any rows of a single block -----------------------------------------------------------------

// Eight numbers of a body in one register (float) or two (double).
template <class Number>
struct Eight {
  typedef typename VectorOf<real, false>::type Wide;
  static constexpr int parts = 8 / lane_count;
  Wide part[parts];
};
template <class Number>
inline const Eight<Number>& eight(const Velocities<Number>& of) {
  return reinterpret_cast<const Eight<Number>&>(of);
}
// The sum over both bodies, or over the one, of f(end, part of eight numbers).
template <int ends, class Number, class F>
inline Number sum_of_products(const F& f) {
  typename Eight<Number>::Wide sum;
  for (int part = 0; part < Eight<Number>::parts; ++part) {
    auto all = f(0, part);
    if (ends == 2) all += f(1, part);
    sum = part == 0 ? all : sum + all;
  }
  for (int half = lane_count / 2; half > 0; half /= 2)
    for (int k = 0; k < half; ++k) sum[k] += sum[k + half];
  return {sum[0]};
}

template <int N, int ends, class Number>
inline void form_K(const SingleRows<N, ends, Number>& rows, const Velocities<Number>&,
                   const Velocities<Number>&, Number* K) {
  for (int i = 0; i < N; ++i)
    for (int j = 0; j <= i; ++j)
      K[lower_index(i, j)] = sum_of_products<ends, Number>([&](int end, int part) {
        return eight(rows.row[i][end].J).part[part] * eight(rows.row[j][end].response).part[part];
      });
}

template <int N, int ends, class Number>
inline void errors(const SingleRows<N, ends, Number>& rows, const Velocities<Number>& body1,
                   const Velocities<Number>& body2, Number* e) {
  for (int i = 0; i < N; ++i)
    e[i] = rows.bias[i] + sum_of_products<ends, Number>([&](int end, int part) {
             return eight(rows.row[i][end].J).part[part] *
                    eight(body_of<ends>(end, body1, body2)).part[part];
           });
}

template <int N, int ends, class Number>
inline void apply(const SingleRows<N, ends, Number>& rows, const Number* lambda,
                  Velocities<Number>& body1, Velocities<Number>& body2) {
  for (int end = 0; end < ends; ++end) {
    auto& body = reinterpret_cast<Eight<Number>&>(body_of<ends>(end, body1, body2));
    for (int part = 0; part < Eight<Number>::parts; ++part) {
      auto sum = body.part[part];
      for (int i = 0; i < N; ++i)
        sum += lambda[i].all * eight(rows.row[i][end].response).part[part];
      body.part[part] = sum;
    }
  }
}

// ---- once per step ------------------------------------------------------------------------------

// K^-1 and the clamp responses.
template <class Rows, int N, bool hard, class Number>
inline void prepare_record(Record<Rows, N, hard, Number>& record, const Velocities<Number>& body1,
                           const Velocities<Number>& body2, real relaxation) {
  Number* const inverse_K = record.impulses.inverse_K;
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
  Number* const lambda = record.impulses.lambda;
  for (int i = 0; i < N; ++i) {
    const Number& diagonal = record.impulses.inverse_K[lower_index(i, i)];
    if (ratio == 0) lambda[i] = Number::of(0);
    lambda[i] = where_above(diagonal, Number::of(0), ratio * lambda[i]);
  }
  if (ratio != 0) apply(record.rows, lambda, body1, body2);
}

// ---- in every iteration -------------------------------------------------------------------------

// From the velocity errors e of a block to the changes of its impulses, clamping included: the same
// formulas as in SequentialImpulses::solve_block.
template <class Rows, int N, bool hard, class Number>
inline void impulses(Record<Rows, N, hard, Number>& record, const Number* e, Number* dlambda) {
  Number* const lambda = record.impulses.lambda;
  const Number* const inverse_K = record.impulses.inverse_K;
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
    for (int i = 0; i < N - 1; ++i) lambda[i] = lambda[i] + dlambda[i];
    return;
  }
  for (int i = 0; i < N; ++i) lambda[i] = lambda[i] + dlambda[i];
}

template <class Rows, int N, bool hard, class Number>
inline void solve_record(Record<Rows, N, hard, Number>& record, Velocities<Number>& body1,
                         Velocities<Number>& body2) {
  Number e[N], dlambda[N];
  errors(record.rows, body1, body2, e);
  impulses(record, e, dlambda);
  apply(record.rows, dlambda, body1, body2);
}

// Sets the bounds of a following row to -+factor times the impulse that it follows.
// \param followed for each lane, the index of that impulse in `numbers`
template <int ends, class Number>
inline void move_bounds(FollowingRecord<ends, Number>& record, const real* numbers,
                        const int* followed) {
  for (int lane = 0; lane < width_of<Number>; ++lane) {
    const real bound = gather<real>(record.factor, lane) * numbers[followed[lane]];
    scatter(-bound, record.bounds.lower, lane);
    scatter(bound, record.bounds.upper, lane);
  }
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

template <Pass pass, class Number>
void run(const LaneWork& work, real parameter) {
  each_group<Number>(work, [&](auto& record, auto& body1, auto& body2, int k) {
    if constexpr (pass == Pass::prepare) prepare_record(record, body1, body2, parameter);
    if constexpr (pass == Pass::warm) warm_record(record, body1, body2, parameter);
    if constexpr (pass == Pass::iterate) {
      if constexpr (requires { record.factor; })
        move_bounds(record, work.numbers, work.followed + k * width_of<Number>);
      solve_record(record, body1, body2);
    }
  });
}

template <class Single, class Lanes>
inline void run(const LaneWork& work, Pass pass, real parameter) {
  const bool lanes = work.width > 1;
  switch (pass) {
    case Pass::prepare:
      return (lanes ? run<Pass::prepare, Lanes> : run<Pass::prepare, Single>)(work, parameter);
    case Pass::warm:
      return (lanes ? run<Pass::warm, Lanes> : run<Pass::warm, Single>)(work, parameter);
    case Pass::iterate:
      return (lanes ? run<Pass::iterate, Lanes> : run<Pass::iterate, Single>)(work, parameter);
  }
}

/// \endcond
}  // namespace joints
/// @}
