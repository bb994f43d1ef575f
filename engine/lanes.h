// Several numbers that are computed with at once: the compiler's own vector type, and how records
// of bodies are turned into columns and back. The same code serves every processor; what it becomes
// is decided by the options of the file that includes it.
#pragma once

#include "engine/lane_records.h"

namespace joints {

/// \cond
// So many numbers side by side; + - * / and comparisons work on each by itself.
typedef real Lanes __attribute__((vector_size(32), may_alias));
typedef float Floats __attribute__((vector_size(32), may_alias));
typedef double Doubles __attribute__((vector_size(32), may_alias));
/// \endcond

// Of each file its own: what was compiled for one processor must not be called on another.
namespace {

// The records of lane_count bodies as columns: v.x of all, v.y of all, and so on.
struct BodyLanes {
  Lanes column[8];
  Lanes* v() { return column; }
  Lanes& inverse_mass() { return column[3]; }
  Lanes* w() { return column + 4; }
};

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

// Loads the records with these numbers and turns them into columns. (Not by gather instructions:
// those take longer.)
inline void load(const LaneBody* records, const int* index, BodyLanes& out) {
  constexpr int parts = 8 / lane_count;  // of a record
  for (int k = 0; k < lane_count; ++k) {
    const Lanes* record = reinterpret_cast<const Lanes*>(&records[index[k]]);
    for (int part = 0; part < parts; ++part) out.column[part * lane_count + k] = record[part];
  }
  for (int part = 0; part < parts; ++part) transpose(out.column + part * lane_count);
}

// The way back.
inline void store(LaneBody* records, const int* index, BodyLanes& in) {
  constexpr int parts = 8 / lane_count;
  for (int part = 0; part < parts; ++part) transpose(in.column + part * lane_count);
  for (int k = 0; k < lane_count; ++k) {
    Lanes* record = reinterpret_cast<Lanes*>(&records[index[k]]);
    for (int part = 0; part < parts; ++part) record[part] = in.column[part * lane_count + k];
  }
}

}  // namespace
}  // namespace joints
