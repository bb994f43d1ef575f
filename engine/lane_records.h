// What the lanes read and write, as plain numbers in memory.
#pragma once

#include "engine/triple.h"

/// \addtogroup world
/// @{
namespace joints {

constexpr int lane_count = 32 / int(sizeof(real));  ///< 8 in float, 4 in double

/// Blocks that are solved side by side, a lane each. What a group does not need is not there: the
/// switches say which numbers it has.
struct LaneGroup {
  signed char rows = 0;  ///< of each block, 1 to 6
  signed char loop = 0;  ///< as rows; 0 where bounds follow other sums
  bool point = false;  ///< the first three rows hold two points together, the others only turn
  bool hard = false;   ///< neither soft nor bounded: no scales, no bounds
  bool round = false;  ///< point: no body's inertia has a direction, one number says it
  int first = 0;       ///< where its numbers begin, counted in single numbers
  int first_end = 0;   ///< where its lanes' bodies 1, then its lanes' bodies 2 begin
  int first_sum = -1;  ///< its bounds follow other sums: where the places of these begin
};

/// All that a sweep works on.
struct LaneSweep {
  const LaneGroup* groups;   ///< in the order in which they are solved
  int count;                 ///< how many
  real* numbers;             ///< of the groups, at an address that 32 divides
  const int* ends;           ///< which records the groups' bodies have
  const int* sums;           ///< where among `numbers` the sums stand that bounds follow
  Velocities<real>* bodies;  ///< a record a body; or, in columns, lane_count bodies' side by side
  bool columns;              ///< bodies stand as the lanes want them
};

/// One sweep, one block at a time.
void sweep_single(const LaneSweep& sweep);
/// One sweep on lanes, with the best instructions of the processor that runs it.
void sweep_lanes(const LaneSweep& sweep);

}  // namespace joints
/// @}
