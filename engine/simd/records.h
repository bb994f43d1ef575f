// What the lanes read and write, as plain numbers in memory.
#pragma once

#include "engine/simd/triple.h"

/// \addtogroup world
/// @{
namespace joints {

constexpr int lane_count = 32 / int(sizeof(real));  ///< 8 in float, 4 in double

/// Blocks that are solved side by side, a lane each. What a group does not need is not there: the
/// switches say which numbers it has.
struct LaneGroup {
  int rows = 0;        ///< of each block, 1 to 6
  bool point = false;  ///< the first three rows hold two points together, the others only turn
  bool hard = false;   ///< neither soft nor bounded: no scales, no bounds
  bool isotropic = false;  ///< point: no body's inertia has a direction, one number says it
  bool follows = false;  ///< one row whose bounds are multiples of other sums, not fixed
  int first = 0;       ///< where its numbers begin, counted in single numbers
  int first_end = 0;   ///< where its lanes' bodies 1, then its lanes' bodies 2 begin
};

/// All that an iteration works on.
struct LaneIteration {
  const LaneGroup* groups;   ///< in the order in which they are solved
  int count;                 ///< how many
  real* numbers;             ///< of the groups, at an address that 32 divides
  const int* ends;           ///< which records the groups' bodies have
  const int* sums;           ///< of each group's lanes, which of `numbers` its bounds follow
  Velocities<real>* bodies;  ///< a record a body; or, in columns, lane_count bodies' side by side
  bool columns;              ///< bodies stand as the lanes want them
};

/// One iteration, one block at a time.
void iterate_single(const LaneIteration& iteration);
/// One iteration on lanes, with the best instructions of the processor that runs it.
void iterate_lanes(const LaneIteration& iteration);

}  // namespace joints
/// @}
