// The lane type, a thin wrapper around the compiler's vector type, and the transposition of body
// records to columns and back. The options of the including file choose the instruction set.
#pragma once

#include "engine/simd/records.h"

namespace joints {

/// \cond
#ifdef __AVX2__  // the instruction set that this file is compiled for
#define JOINTS_PROCESSOR 2
#define JOINTS_IN_REGISTERS JOINTS_INLINED  // a fifth faster; without AVX: slow to compile
#else
#define JOINTS_PROCESSOR 0
#define JOINTS_IN_REGISTERS
#endif
typedef float Floats __attribute__((vector_size(32), may_alias));
typedef double Doubles __attribute__((vector_size(32), may_alias));
template <class Number, bool single>
struct VectorOf { typedef Number type; };
template <>
struct VectorOf<float, false> { typedef Floats type; };
template <>
struct VectorOf<double, false> { typedef Doubles type; };
/// \endcond

/// lane_count numbers side by side, one per block; + - * act lane by lane. Each instruction set has
/// its own type, so that the linker cannot merge code compiled for different ones; for the same
/// reason a single number has one, too.
template <int processor, bool single = false>
struct LanesFor {
  typedef typename VectorOf<real, single>::type Vector;  ///< the compiler's vector type, or `real`
  Vector all;        ///< all lanes

  /// The same number in all lanes.
  static LanesFor of(real a) { return {a + Vector{}}; }
  friend LanesFor operator+(const LanesFor& a, const LanesFor& b) { return {a.all + b.all}; }
  friend LanesFor operator-(const LanesFor& a, const LanesFor& b) { return {a.all - b.all}; }
  friend LanesFor operator*(const LanesFor& a, const LanesFor& b) { return {a.all * b.all}; }
  friend LanesFor operator*(real a, const LanesFor& b) { return {a * b.all}; }
  friend LanesFor operator-(const LanesFor& a) { return {-a.all}; }
  friend LanesFor& operator+=(LanesFor& a, const LanesFor& b) { return a = a + b; }
  friend LanesFor& operator-=(LanesFor& a, const LanesFor& b) { return a = a - b; }
  /// The lesser of both in each lane.
  friend LanesFor lesser(const LanesFor& a, const LanesFor& b) {
    return {a.all < b.all ? a.all : b.all};
  }
  /// The greater of both in each lane.
  friend LanesFor greater(const LanesFor& a, const LanesFor& b) {
    return {a.all > b.all ? a.all : b.all};
  }
  /// x where a > least, else 0.
  friend LanesFor where_above(const LanesFor& a, const LanesFor& least, const LanesFor& x) {
    return {a.all > least.all ? x.all : Vector{}};
  }
  /// 1 / a where a > least, else 0.
  friend LanesFor inverse_above(const LanesFor& a, const LanesFor& least) {
    return where_above(a, least, {1 / a.all});
  }
};
/// The lane type of the including file.
using Lanes = LanesFor<JOINTS_PROCESSOR>;
/// A single number, compiled for the including file's instruction set.
using Single = LanesFor<JOINTS_PROCESSOR, true>;

/// \cond
// The number of lanes: 1 or lane_count.
template <class Number>
constexpr int width_of = int(sizeof(Number) / sizeof(real));

namespace {

// Transposes 8x8 numbers in three steps: pairs, quadruples, halves.
JOINTS_IN_REGISTERS inline void transpose(Floats* r) {
  Floats a[8], b[8];
  for (int k = 0; k < 8; k += 2) {
    a[k] = __builtin_shufflevector(r[k], r[k + 1], 0, 8, 1, 9, 4, 12, 5, 13);
    a[k + 1] = __builtin_shufflevector(r[k], r[k + 1], 2, 10, 3, 11, 6, 14, 7, 15);
  }
  for (int k = 0; k < 8; k += 4)
    for (int n = 0; n < 2; ++n) {
      const Floats &low = a[k + n], &high = a[k + n + 2];
      b[k + 2 * n] = __builtin_shufflevector(low, high, 0, 1, 8, 9, 4, 5, 12, 13);
      b[k + 2 * n + 1] = __builtin_shufflevector(low, high, 2, 3, 10, 11, 6, 7, 14, 15);
    }
  for (int k = 0; k < 4; ++k) {
    r[k] = __builtin_shufflevector(b[k], b[k + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    r[k + 4] = __builtin_shufflevector(b[k], b[k + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
}

// Transposes 4x4 numbers in two steps: pairs, halves.
JOINTS_IN_REGISTERS inline void transpose(Doubles* r) {
  Doubles a[4];
  for (int k = 0; k < 4; k += 2) {
    a[k] = __builtin_shufflevector(r[k], r[k + 1], 0, 4, 2, 6);
    a[k + 1] = __builtin_shufflevector(r[k], r[k + 1], 1, 5, 3, 7);
  }
  for (int k = 0; k < 2; ++k) {
    r[k] = __builtin_shufflevector(a[k], a[k + 2], 0, 1, 4, 5);
    r[k + 2] = __builtin_shufflevector(a[k], a[k + 2], 2, 3, 6, 7);
  }
}

// Gathers the records with these indices and transposes them to columns: v.x of all lanes, v.y of
// all, and so on. (Gather instructions are slower.)
JOINTS_IN_REGISTERS
inline void load(const Velocities<real>* records, const int* index, Velocities<Lanes>& out) {
  constexpr int parts = 8 / lane_count;  // registers per record of eight numbers
  Lanes::Vector* const column = reinterpret_cast<Lanes::Vector*>(&out);
  for (int k = 0; k < lane_count; ++k) {
    const auto* record = reinterpret_cast<const Lanes::Vector*>(&records[index[k]]);
    for (int part = 0; part < parts; ++part) column[part * lane_count + k] = record[part];
  }
  for (int part = 0; part < parts; ++part) transpose(column + part * lane_count);
}

// Transposes the columns back and scatters the records.
JOINTS_IN_REGISTERS
inline void store(Velocities<real>* records, const int* index, Velocities<Lanes>& in) {
  constexpr int parts = 8 / lane_count;
  Lanes::Vector* const column = reinterpret_cast<Lanes::Vector*>(&in);
  for (int part = 0; part < parts; ++part) transpose(column + part * lane_count);
  for (int k = 0; k < lane_count; ++k) {
    auto* record = reinterpret_cast<Lanes::Vector*>(&records[index[k]]);
    for (int part = 0; part < parts; ++part) record[part] = column[part * lane_count + k];
  }
}

// Calls f with the velocities of a group's bodies 1 and bodies 2; if its rows have one body only,
// with that in both places. Number is Single or Lanes.
template <class Number, int bodies = 2, class F>
JOINTS_INLINED inline void with_bodies(const BodyView& view, int group, const F& f) {
  constexpr int width = width_of<Number>;
  Velocities<real>* const records = view.records;
  if (width == 1 || view.columns) {
    const int* const ends = view.ends + 2 * group;
    auto* const all = reinterpret_cast<Velocities<Number>*>(records);
    f(all[ends[2 - bodies]], all[ends[1]]);
  } else if constexpr (width > 1) {
    const int* const ends = view.ends + 2 * width * group;
    Velocities<Number> body1, body2;
    if (bodies == 2) load(records, ends, body1);
    load(records, ends + width, body2);
    f(bodies == 2 ? body1 : body2, body2);
    if (bodies == 2) store(records, ends, body1);
    store(records, ends + width, body2);
  }
}

}  // namespace
/// \endcond
}  // namespace joints
