// What the lanes read and write, as plain numbers in memory.
#pragma once

#include "engine/real.h"

/// \addtogroup world
/// @{
namespace joints {

constexpr int lane_count = 32 / int(sizeof(real));  ///< 8 in float, 4 in double

/// A number of each lane.
struct alignas(32) LaneNumber {
  real lane[lane_count];  ///< side by side
};

/// What a sweep reads and writes of a body: a record of eight numbers.
struct alignas(32) LaneBody {
  real v[3];          ///< velocity [m/s]
  real inverse_mass;  ///< [1/kg]
  real w[3];          ///< angular velocity [rad/s]
  real unused;        ///< fills the record
};

/// Blocks that are solved side by side, a lane each.
struct LaneGroup {
  int rows = 0;        ///< of each block, 1 to 6
  bool point = false;  ///< the first three rows hold two points together, the others only turn
  int first = 0;       ///< where its numbers begin
  int body1[lane_count], body2[lane_count];  ///< records of its bodies
  int block[lane_count];  ///< which prepared block, -1 in a lane that is not used
};

/// One sweep over the groups, with the best instructions of the processor that runs it.
void sweep_lanes(const LaneGroup* groups, int count, LaneNumber* numbers, LaneBody* bodies);

}  // namespace joints
/// @}
