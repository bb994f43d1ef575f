// The memory layout of packed blocks. A record has the numbers of one block: rows, accumulated
// impulses, K^-1, bounds. A group is up to lane_count blocks of one kind, one per lane; its record
// has the same members, each with the numbers of all lanes side by side. Four hinges in double:
//
//                  lane 0    lane 1    lane 2    lane 3
//   rows.r1.x      block 0   block 5   block 9   0        32 bytes, one register
//   rows.r1.y      block 0   block 5   block 9   0
//   ...                                                   a lane without a block has zeros
//   lambda[0]      block 0   block 5   block 9   0        the accumulated impulses
//   ...
//
// One instruction reads or changes a line, so the formulas are written as for one block. A pass
// reads the records from the first group to the last, each from its first line to its last one:
//
//   numbers     | group 0: rows lambda inverse_K bounds | group 1: rows lambda ... | ...
//
// Bodies have the same layout if they keep their lanes (BodyView::columns). Otherwise each body has
// a record of its own, and load() and store() transpose those of a group (lanes.h).
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
  constexpr int ends() const { return lone ? 1 : 2; }  ///< bodies of a row
};

// ---- records of blocks -------------------------------------------------------------------------

/// Three rows that hold two points together, and N - 3 angular rows.
template <BlockKind kind, class Number>
struct PointRows {
  static constexpr int N = kind.rows;  ///< rows
  /// One number for an isotropic body.
  using Inertia = std::conditional_t<kind.isotropic, Number, Symmetric<Number>>;
  Triple<Number> r1, r2;  ///< levers [m], world
  Inertia I1, I2;         ///< inverse inertia [1/(kg m^2)], world
  Number bias[N];         ///< minus the required J V [unit of C per s]
  [[no_unique_address]] std::array<Triple<Number>, N - 3> axis;  ///< w2 of J, equal to -w1 [1]
};

/// Rows of any kind.
template <BlockKind kind, class Number>
struct AnyRows {
  static constexpr int N = kind.rows;  ///< rows
  /// The numbers of one body: its half of J, and the angular part of its half of M^-1 J^T.
  struct Half {
    Triple<Number> v, w, response_w;  ///< factors of the velocities
  };
  Number bias[N];            ///< minus the required J V [unit of C per s]
  Half row[N][kind.ends()];  ///< the rows, from the first
};

/// Rows of any kind of a single block. The numbers of a body have the layout of its velocities.
template <BlockKind kind, class Number>
struct SingleRows {
  static constexpr int N = kind.rows;  ///< rows
  /// The halves of J and of M^-1 J^T. The numbers beside v and w are 0.
  struct Half {
    Velocities<Number> J, response;  ///< factors of the velocities, and their change
  };
  Number bias[N];            ///< minus the required J V [unit of C per s]
  Half row[N][kind.ends()];  ///< the rows, from the first
};

/// Only for a block that is soft or bounded.
template <BlockKind kind, class Number>
struct Bounds {
  Number impulse_scale, lower, upper;  ///< as in SoftCoefficients
  /// Kinv[i][last] / Kinv[last][last]: the change of an impulse per unit cut off the last one.
  Number clamp_response[kind.rows];
};
/// For a hard block.
struct Unbounded {};

/// All numbers of a block. \tparam Number one number, or one per lane
template <BlockKind kind, class Number>
struct Record {
  static constexpr int N = kind.rows;       ///< rows
  static constexpr int ends = kind.ends();  ///< bodies of each row
  /// Rows that are not those of a point.
  using Other = std::conditional_t<sizeof(Number) == sizeof(real), SingleRows<kind, Number>,
                                   AnyRows<kind, Number>>;
  std::conditional_t<kind.point, PointRows<kind, Number>, Other> rows;  ///< geometry and bias
  Number lambda[N];                   ///< accumulated impulses [N s or N m s]
  Number inverse_K[N * (N + 1) / 2];  ///< lower triangle of mass_scale K^-1, by lower_index()
  /// Scales and bounds, if there are any.
  [[no_unique_address]] std::conditional_t<kind.hard, Unbounded, Bounds<kind, Number>> bounds;
};

/// A kind as a compile-time constant.
template <BlockKind kind>
using ConstantKind = std::integral_constant<BlockKind, kind>;
/// Calls f with the record of this kind that begins at `numbers`: one switch per group, and its
/// type tells the compiler the number of rows.
template <class Number, class F>
JOINTS_INLINED inline void use_record(const BlockKind& kind, real* numbers, const F& f) {
  const auto use = [&]<BlockKind known>(ConstantKind<known>) JOINTS_INLINED {
    f(*reinterpret_cast<Record<known, Number>*>(numbers));
  };
  const auto use_rows = [&](auto N, auto hard) JOINTS_INLINED {
    constexpr unsigned char rows = N;
    if constexpr (N >= 3)
      if (kind.point)
        return kind.isotropic ? use(ConstantKind<BlockKind{rows, true, hard, true}>{})
                              : use(ConstantKind<BlockKind{rows, true, hard}>{});
    if constexpr (N == 1 && !hard)
      if (kind.follows)
        return kind.lone ? use(ConstantKind<BlockKind{.rows = 1, .follows = true, .lone = true}>{})
                         : use(ConstantKind<BlockKind{.rows = 1, .follows = true}>{});
    if constexpr (N == 1)
      if (kind.lone) return use(ConstantKind<BlockKind{.rows = 1, .hard = hard, .lone = true}>{});
    use(ConstantKind<BlockKind{.rows = rows, .hard = hard}>{});
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
