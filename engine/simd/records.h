// What the lanes read and write: records of plain numbers, once for a single block (Number is real)
// and once for a group, where every number is one of each lane.
#pragma once

#include <array>
#include <compare>
#include <type_traits>

#include "engine/simd/triple.h"

/// \addtogroup world
/// @{
namespace joints {

constexpr int lane_count = 32 / int(sizeof(real));  ///< 8 in float, 4 in double

/// What a block is like. Only blocks of one kind are solved side by side.
struct Kind {
  signed char rows = 0;  ///< 1 to 6
  bool point = false;    ///< the first three rows hold two points together, the others only turn
  bool hard = false;     ///< neither soft nor bounded: no scales, no bounds
  bool isotropic = false;  ///< point: no body's inertia has a direction, one number says it
  bool follows = false;  ///< one row whose bounds are multiples of another sum, not fixed
  auto operator<=>(const Kind&) const = default;  ///< the order of groups within a colour
};

// ---- records of blocks -------------------------------------------------------------------------

/// Three rows that hold two points together, and N - 3 rows that only turn.
template <int N, bool isotropic, class Number>
struct PointRows {
  using Inertia = std::conditional_t<isotropic, Number, Symmetric<Number>>;
  Triple<Number> r1, r2;  ///< levers [m], world
  Inertia I1, I2;         ///< inverse inertia [1/(kg m^2)], world
  Number bias[N];         ///< PreparedRow::bias
  [[no_unique_address]] std::array<Triple<Number>, N - 3> axis;  ///< w2 of J, and less w1 [1]
};

/// Rows of any kind.
template <int N, class Number>
struct AnyRows {
  /// J, and what an impulse does to the two angular velocities.
  struct Row {
    Triple<Number> v1, w1, v2, w2, turn1, turn2;
  };
  Number bias[N];  ///< PreparedRow::bias
  Row row[N];
};

/// From errors to impulses.
template <int N, class Number>
struct Impulses {
  Number sum[N];                      ///< accumulated impulses [N s or N m s]
  Number inverse_K[N * (N + 1) / 2];  ///< upper half of K^-1 times the mass scale, line by line

  /// The entry of row i and column j.
  const Number& entry(int i, int j) const {
    const int low = i < j ? i : j, high = i < j ? j : i;
    return inverse_K[N * low - low * (low - 1) / 2 + high - low];
  }
};

/// What only a block has that is soft or bounded.
template <int N, class Number>
struct Bounds {
  Number impulse_scale, lower, upper;  ///< as in PreparedBlock
  Number answer[N];                    ///< PreparedRow::answer
};
/// And one that is neither.
struct Unbounded {};

/// All numbers of a block.
template <class Rows, int N, bool hard, class Number>
struct Record {
  Rows rows;
  Impulses<N, Number> impulses;
  [[no_unique_address]] std::conditional_t<hard, Unbounded, Bounds<N, Number>> bounds;
};
template <int N, bool hard, bool isotropic, class Number>
using PointRecord = Record<PointRows<N, isotropic, Number>, N, hard, Number>;
template <int N, bool hard, class Number>
using AnyRecord = Record<AnyRows<N, Number>, N, hard, Number>;
/// One row that follows another sum.
template <class Number>
struct FollowingRecord : AnyRecord<1, false, Number> {
  Number factor;  ///< its bounds are -+ this times that sum [1]
};

/// \cond
#define JOINTS_INLINED __attribute__((always_inline))
template <class Record, class F>
JOINTS_INLINED inline void use(real* numbers, const F& f) {
  f(*reinterpret_cast<Record*>(numbers));
}
template <int N, class Number, class F>
JOINTS_INLINED inline void use_rows(const Kind& kind, real* numbers, const F& f) {
  if constexpr (N >= 3) {
    if (kind.point) {
      if (kind.hard && kind.isotropic) return use<PointRecord<N, true, true, Number>>(numbers, f);
      if (kind.hard) return use<PointRecord<N, true, false, Number>>(numbers, f);
      if (kind.isotropic) return use<PointRecord<N, false, true, Number>>(numbers, f);
      return use<PointRecord<N, false, false, Number>>(numbers, f);
    }
  }
  if (kind.hard) return use<AnyRecord<N, true, Number>>(numbers, f);
  return use<AnyRecord<N, false, Number>>(numbers, f);
}
/// \endcond

/// Calls f with the record of this kind that begins at these numbers: one switch a block, and from
/// there on the compiler knows how many rows there are.
template <class Number, class F>
JOINTS_INLINED inline void use_record(const Kind& kind, real* numbers, const F& f) {
  switch (kind.rows) {
    case 1:
      if (kind.follows) return use<FollowingRecord<Number>>(numbers, f);
      return use_rows<1, Number>(kind, numbers, f);
    case 2: return use_rows<2, Number>(kind, numbers, f);
    case 3: return use_rows<3, Number>(kind, numbers, f);
    case 4: return use_rows<4, Number>(kind, numbers, f);
    case 5: return use_rows<5, Number>(kind, numbers, f);
    case 6: return use_rows<6, Number>(kind, numbers, f);
  }
}

// ---- records and lanes -------------------------------------------------------------------------

/// So many numbers side by side, for what stands in memory: engine/simd/lanes.h computes with them.
struct alignas(32) LaneNumber {
  real lane[lane_count];  ///< one of each
};

/// Puts a single record into its lane of the record of all, which may be of one lane only.
template <class One, class All>
inline void scatter(const One& one, All& all, int lane) {
  constexpr std::size_t width = sizeof all / sizeof one;
  const real* const from = reinterpret_cast<const real*>(&one);
  real* const to = reinterpret_cast<real*>(&all) + lane;
  for (std::size_t n = 0; n < sizeof one / sizeof(real); ++n) to[n * width] = from[n];
}
/// And takes it out again.
template <class One, class All>
inline One gather(const All& all, int lane) {
  constexpr std::size_t width = sizeof all / sizeof(One);
  One one;
  const real* const from = reinterpret_cast<const real*>(&all) + lane;
  real* const to = reinterpret_cast<real*>(&one);
  for (std::size_t n = 0; n < sizeof one / sizeof(real); ++n) to[n] = from[n * width];
  return one;
}

/// Blocks that are solved side by side, a lane each.
struct LaneGroup : Kind {
  int first = 0;      ///< where its record begins, counted in single numbers
  int first_sum = 0;  ///< where in it the sums of impulses begin, counted likewise
};

/// The velocities of bodies, and which of them a group's have.
struct BodyView {
  Velocities<real>* records;  ///< a record a body; or, in columns, lane_count bodies' side by side
  const int* ends;  ///< of each group, the records of its lanes' bodies 1, then of their bodies 2;
                    ///< or in columns two numbers, which columns
  bool columns;     ///< bodies stand as the lanes want them
};

/// All that an iteration works on.
struct LaneIteration {
  const LaneGroup* groups;   ///< in the order in which they are solved
  int count;                 ///< how many
  real* numbers;             ///< of the groups, at an address that 32 divides
  const int* sums;           ///< of each group's lanes, which of `numbers` its bounds follow
  BodyView bodies;           ///< their velocities
};

/// One iteration, one block at a time.
void iterate_single(const LaneIteration& iteration);
/// One iteration on lanes, with the best instructions of the processor that runs it.
void iterate_lanes(const LaneIteration& iteration);

}  // namespace joints
/// @}
