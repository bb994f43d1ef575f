// The memory layout of packed blocks. A record has the numbers of one block: rows, accumulated
// impulses, K^-1, bounds. A group is lane_count blocks of one kind; its record has the same
// members, each with the numbers of all lanes side by side. A group of four hinges in double:
//
//                  lane 0    lane 1    lane 2    lane 3
//   rows.r1.x      block 0   block 5   block 9   0        32 bytes, one register
//   rows.r1.y      block 0   block 5   block 9   0
//   ...                                                   the lane without a block holds zeros
//   lambda[0]      block 0   block 5   block 9   0        the accumulated impulses
//   ...
//
// One instruction reads or changes a line, so the formulas are written as for one block. scatter()
// writes the record of one block into the column of its lane, and gather() reads it. Bodies have
// the same layout if they keep their lanes (BodyView::columns); otherwise each has a record of its
// own, and load() and store() transpose those of a group to lines and back (lanes.h).
#pragma once

#include <array>
#include <compare>
#include <type_traits>

#include "engine/kernels.h"
#include "engine/simd/triple.h"

/// \addtogroup world
/// @{
namespace joints {

/// The kind of a block chooses its record. Only blocks of one kind are solved side by side.
struct BlockKind {
  unsigned char rows : 3 = 0;  ///< 1 to 6
  bool point : 1 = false;  ///< three rows hold two points together, the others are angular
  bool hard : 1 = false;   ///< neither soft nor bounded: no scales, no bounds
  bool isotropic : 1 = false;  ///< only for `point`: both inertias are isotropic, one number each
  bool follows : 1 = false;  ///< one row whose bounds are -+factor times another row's impulse
  bool lone : 1 = false;   ///< one row of one body: the other does not move
  auto operator<=>(const BlockKind&) const = default;  ///< by the members in turn
};

// ---- records of blocks -------------------------------------------------------------------------

/// Three rows that hold two points together, and N - 3 angular rows.
template <int N, bool isotropic, class Number>
struct PointRows {
  static constexpr int ends = 2;  ///< bodies of a row
  /// One number for an isotropic body.
  using Inertia = std::conditional_t<isotropic, Number, Symmetric<Number>>;
  Triple<Number> r1, r2;  ///< levers [m], world
  Inertia I1, I2;         ///< inverse inertia [1/(kg m^2)], world
  Number bias[N];         ///< minus the required J V [unit of C per s]
  [[no_unique_address]] std::array<Triple<Number>, N - 3> axis;  ///< w2 of J, equal to -w1 [1]
};

/// Rows of any kind. \tparam bodies that have a half of each row: 2, or 1 for a lone row
template <int N, int bodies, class Number>
struct AnyRows {
  static constexpr int ends = bodies;  ///< bodies of a row
  /// The numbers of one body: its half of J, and the angular part of its half of M^-1 J^T.
  struct Half {
    Triple<Number> v, w, response_w;  ///< factors of the velocities
  };
  Number bias[N];     ///< minus the required J V [unit of C per s]
  Half row[N][ends];  ///< the rows, from the first
};

/// Rows of any kind of a single block. The numbers of a body have the layout of its velocities.
template <int N, int bodies, class Number>
struct SingleRows {
  static constexpr int ends = bodies;  ///< bodies of a row
  /// The halves of J and of M^-1 J^T. The numbers beside v and w are 0.
  struct Half {
    Velocities<Number> J, response;  ///< factors of the velocities, and their change
  };
  Number bias[N];     ///< minus the required J V [unit of C per s]
  Half row[N][ends];  ///< the rows, from the first
};

/// Only for a block that is soft or bounded.
template <int N, class Number>
struct Bounds {
  Number impulse_scale, lower, upper;  ///< as in StepTarget
  /// Kinv[i][last] / Kinv[last][last]: the change of an impulse per unit cut off the last one.
  Number clamp_response[N];
};
/// For a hard block.
struct Unbounded {};

/// All numbers of a block.
template <class Rows, int N, bool hard, class Number>
struct Record {
  static constexpr int ends = Rows::ends;  ///< bodies of a row
  Rows rows;                          ///< geometry and bias
  Number lambda[N];                   ///< accumulated impulses [N s or N m s]
  Number inverse_K[N * (N + 1) / 2];  ///< lower triangle of mass_scale K^-1, by lower_index()
  /// Scales and bounds, if there are any.
  [[no_unique_address]] std::conditional_t<hard, Unbounded, Bounds<N, Number>> bounds;
};
/// The record of a block whose first three rows hold two points together.
template <int N, bool hard, bool isotropic, class Number>
using PointRecord = Record<PointRows<N, isotropic, Number>, N, hard, Number>;
/// The record of any other block.
template <int N, int ends, bool hard, class Number>
using AnyRecord =
    Record<std::conditional_t<sizeof(Number) == sizeof(real), SingleRows<N, ends, Number>,
                              AnyRows<N, ends, Number>>, N, hard, Number>;
/// One row whose bounds follow another row's impulse.
template <int ends, class Number>
struct FollowingRecord : AnyRecord<1, ends, false, Number> {
  Number factor;  ///< its bounds are -+factor times that impulse [1]
};

/// Calls f with the record of this kind that begins at `numbers`: one switch per group, and its
/// type tells the compiler the number of rows.
template <class Number, class F>
JOINTS_INLINED inline void use_record(const BlockKind& kind, real* numbers, const F& f) {
  const auto use = [&]<class Record>(std::type_identity<Record>) JOINTS_INLINED {
    f(*reinterpret_cast<Record*>(numbers));
  };
  const auto use_rows = [&](auto N, auto hard) JOINTS_INLINED {
    if constexpr (N >= 3)
      if (kind.point)
        return kind.isotropic ? use(std::type_identity<PointRecord<N, hard, true, Number>>{})
                              : use(std::type_identity<PointRecord<N, hard, false, Number>>{});
    if constexpr (N == 1 && !hard)
      if (kind.follows)
        return kind.lone ? use(std::type_identity<FollowingRecord<1, Number>>{})
                         : use(std::type_identity<FollowingRecord<2, Number>>{});
    if constexpr (N == 1)
      if (kind.lone) return use(std::type_identity<AnyRecord<1, 1, hard, Number>>{});
    use(std::type_identity<AnyRecord<N, 2, hard, Number>>{});
  };
  with_size(kind.rows, [&](auto N) JOINTS_INLINED {
    kind.hard ? use_rows(N, std::true_type{}) : use_rows(N, std::false_type{});
  });
}

// ---- records and lanes -------------------------------------------------------------------------

/// lane_count numbers side by side in memory; engine/simd/lanes.h has the type that computes.
struct alignas(32) LaneNumber {
  real lane[lane_count];  ///< one number per lane
};

/// Writes a scalar record into one lane of a group's record. `All` may itself be scalar.
template <class One, class All>
inline void scatter(const One& one, All& all, int lane) {
  constexpr std::size_t width = sizeof all / sizeof one;
  const real* const from = reinterpret_cast<const real*>(&one);
  real* const to = reinterpret_cast<real*>(&all) + lane;
  for (std::size_t n = 0; n < sizeof one / sizeof(real); ++n) to[n * width] = from[n];
}
/// Reads a scalar record from one lane of a group's record.
template <class One, class All>
inline One gather(const All& all, int lane) {
  constexpr std::size_t width = sizeof all / sizeof(One);
  One one;
  const real* const from = reinterpret_cast<const real*>(&all) + lane;
  real* const to = reinterpret_cast<real*>(&one);
  for (std::size_t n = 0; n < sizeof one / sizeof(real); ++n) to[n] = from[n * width];
  return one;
}

/// Blocks that are solved side by side, one per lane.
struct LaneGroup : BlockKind {
  int first = 0;         ///< index of its record's first number
  int alike = 1;         ///< number of groups of this kind in sequence from here on
};

/// The velocities of all bodies, and where those of each group are.
struct BodyView {
  Velocities<real>* records;  ///< one after the other, or columns of lane_count
  const int* ends;            ///< LaneOrder::ends
  bool columns;               ///< LaneOrder::columns: no transposition
};

/// The operation that a pass performs on every group.
enum class Pass {
  prepare,  ///< K^-1 and the clamp responses are computed; the parameter is the relaxation
  warm,     ///< the impulses of the last step, times the parameter, are applied
  iterate   ///< the blocks are solved once
};
/// The data that a pass reads and writes.
struct LaneWork {
  const LaneGroup* groups;   ///< in the order in which they are solved
  int count, width;          ///< number of groups; blocks of each, 1 or lane_count
  real* numbers;             ///< the records of all groups, aligned to 32 bytes
  const int* followed;       ///< for each lane of a group, the index of the impulse it follows
  BodyView bodies;           ///< their velocities
};

/// A pass over all groups. Chooses the instruction set at run time.
void run_pass(const LaneWork& work, Pass pass, real parameter);

}  // namespace joints
/// @}
