// Several numbers that are computed with at once: the compiler's own vector type behind a small one
// of ours, and how records of bodies are turned into columns and back. The same code serves every
// processor; what it becomes is decided by the options of the file that includes it.
#pragma once

#include "engine/simd/records.h"

namespace joints {

/// \cond
#ifdef __AVX2__  // the kind of processor that this file is compiled for
#define JOINTS_PROCESSOR 2
#else
#define JOINTS_PROCESSOR 0
#endif
typedef float Floats __attribute__((vector_size(32), may_alias));
typedef double Doubles __attribute__((vector_size(32), may_alias));
template <class Number>
struct VectorOf;
template <>
struct VectorOf<float> { typedef Floats type; };
template <>
struct VectorOf<double> { typedef Doubles type; };
/// \endcond

/// So many numbers side by side, one of each joint: + - * work on each by itself. What is compiled
/// for one kind of processor has another type, and so another name, than what is compiled for
/// another: the linker cannot mix them up.
template <int processor>
struct LanesFor {
  typedef VectorOf<real>::type Vector;  ///< the compiler's
  Vector all;                           ///< all of them

  friend LanesFor operator+(const LanesFor& a, const LanesFor& b) { return {a.all + b.all}; }
  friend LanesFor operator-(const LanesFor& a, const LanesFor& b) { return {a.all - b.all}; }
  friend LanesFor operator*(const LanesFor& a, const LanesFor& b) { return {a.all * b.all}; }
  friend LanesFor operator-(const LanesFor& a) { return {-a.all}; }
  friend LanesFor& operator+=(LanesFor& a, const LanesFor& b) { return a = a + b; }
  friend LanesFor& operator-=(LanesFor& a, const LanesFor& b) { return a = a - b; }
};
/// Those of this file.
using Lanes = LanesFor<JOINTS_PROCESSOR>;

/// \cond
namespace {

// Eight rows of eight become eight columns: pairs, then fours, then halves change places.
inline void transpose(Floats* r) {
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

// Four rows of four become four columns.
inline void transpose(Doubles* r) {
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

// Loads the records with these numbers and turns them into columns: v.x of all, v.y of all, and so
// on. (Not by gather instructions: those take longer.)
inline void load(const Velocities<real>* records, const int* index, Velocities<Lanes>& out) {
  constexpr int parts = 8 / lane_count;  // of a record
  Lanes::Vector* const column = reinterpret_cast<Lanes::Vector*>(&out);
  for (int k = 0; k < lane_count; ++k) {
    const auto* record = reinterpret_cast<const Lanes::Vector*>(&records[index[k]]);
    for (int part = 0; part < parts; ++part) column[part * lane_count + k] = record[part];
  }
  for (int part = 0; part < parts; ++part) transpose(column + part * lane_count);
}

// The way back.
inline void store(Velocities<real>* records, const int* index, Velocities<Lanes>& in) {
  constexpr int parts = 8 / lane_count;
  Lanes::Vector* const column = reinterpret_cast<Lanes::Vector*>(&in);
  for (int part = 0; part < parts; ++part) transpose(column + part * lane_count);
  for (int k = 0; k < lane_count; ++k) {
    auto* record = reinterpret_cast<Lanes::Vector*>(&records[index[k]]);
    for (int part = 0; part < parts; ++part) record[part] = column[part * lane_count + k];
  }
}

// Calls f with the velocities of a group's two bodies, or of two in each lane. Number is real or
// Lanes.
template <class Number, class F>
JOINTS_INLINED inline void with_bodies(const BodyView& view, int group, const F& f) {
  constexpr int width = int(sizeof(Number) / sizeof(real));
  const int* const ends = view.ends + group * (width == 1 || view.columns ? 2 : 2 * width);
  Velocities<real>* const records = view.records;
  if constexpr (width == 1) {
    f(records[ends[0]], records[ends[1]]);
  } else if (view.columns) {
    auto* const all = reinterpret_cast<Velocities<Number>*>(records);
    f(all[ends[0]], all[ends[1]]);
  } else {
    Velocities<Number> body1, body2;
    load(records, ends, body1);
    load(records, ends + lane_count, body2);
    f(body1, body2);
    store(records, ends, body1);
    store(records, ends + lane_count, body2);
  }
}

}  // namespace
/// \endcond
}  // namespace joints
