// Rows of any kind, side by side or of a single block: the three functions that every kind of rows
// has (point_rows.h).
#pragma once

#include "engine/simd/lanes.h"

/// \addtogroup world
/// @{
namespace joints {
/// \cond

// The body of a half row: with two ends body 1, then body 2; with one it is body 2.
template <int ends, class V>
inline V& body_of(int end, V& body1, V& body2) {
  return end + 1 < ends ? body1 : body2;
}

template <BlockKind kind, class Number, int N = kind.rows, int ends = kind.ends()>
inline void form_K(const AnyRows<kind, Number>& rows, const Velocities<Number>& body1,
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

template <BlockKind kind, class Number, int N = kind.rows, int ends = kind.ends()>
inline void errors(const AnyRows<kind, Number>& rows, const Velocities<Number>& body1,
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

template <BlockKind kind, class Number, int N = kind.rows, int ends = kind.ends()>
inline void apply(const AnyRows<kind, Number>& rows, const Number* lambda,
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

// The eight numbers of a body as one register (float) or two (double).
typedef VectorOf<real, false>::type Wide;
constexpr int parts = 8 / lane_count;
template <class Number>
inline const Wide* wide(const Velocities<Number>& of) {
  return reinterpret_cast<const Wide*>(&of);
}
// The sum over both bodies, or over the one, of f(end, part of eight numbers).
template <int ends, class Number, class F>
inline Number sum_of_products(const F& f) {
  Wide sum;
  for (int part = 0; part < parts; ++part) {
    Wide all = f(0, part);
    if (ends == 2) all += f(1, part);
    sum = part == 0 ? all : sum + all;
  }
  for (int half = lane_count / 2; half > 0; half /= 2)
    for (int k = 0; k < half; ++k) sum[k] += sum[k + half];
  return {sum[0]};
}

template <BlockKind kind, class Number, int N = kind.rows, int ends = kind.ends()>
inline void form_K(const SingleRows<kind, Number>& rows, const Velocities<Number>&,
                   const Velocities<Number>&, Number* K) {
  for (int i = 0; i < N; ++i)
    for (int j = 0; j <= i; ++j)
      K[lower_index(i, j)] = sum_of_products<ends, Number>([&](int end, int part) {
        return wide(rows.row[i][end].J)[part] * wide(rows.row[j][end].response)[part];
      });
}

template <BlockKind kind, class Number, int N = kind.rows, int ends = kind.ends()>
inline void errors(const SingleRows<kind, Number>& rows, const Velocities<Number>& body1,
                   const Velocities<Number>& body2, Number* e) {
  for (int i = 0; i < N; ++i)
    e[i] = rows.bias[i] + sum_of_products<ends, Number>([&](int end, int part) {
             return wide(rows.row[i][end].J)[part] *
                    wide(body_of<ends>(end, body1, body2))[part];
           });
}

template <BlockKind kind, class Number, int N = kind.rows, int ends = kind.ends()>
inline void apply(const SingleRows<kind, Number>& rows, const Number* lambda,
                  Velocities<Number>& body1, Velocities<Number>& body2) {
  for (int end = 0; end < ends; ++end) {
    Wide* const body = reinterpret_cast<Wide*>(&body_of<ends>(end, body1, body2));
    for (int part = 0; part < parts; ++part) {
      Wide sum = body[part];
      for (int i = 0; i < N; ++i) sum += lambda[i].all * wide(rows.row[i][end].response)[part];
      body[part] = sum;
    }
  }
}

/// \endcond
}  // namespace joints
/// @}
