// The closed loops of an island, in which rows may depend on others.
#pragma once

#include "chapters/09_direct/elimination_plan.h"

/// \addtogroup chapter9
/// @{
namespace joints {

/// The bodies and joints of a closed loop.
struct ClosedLoop {
  int bodies = 0;     ///< number of its moving bodies
  int rows = 0;       ///< number of the rows of its joints, without bounded rows
  bool held = false;  ///< whether one of its joints is attached to a static body
  /// Its degrees of freedom in the present pose, without those of the loop as a whole.
  /// \param dependent number of its rows that depend on others
  int motions(int dependent) const { return 6 * (bodies - !held) - rows + dependent; }
};

/// All closed loops of a shape.
struct ClosedLoops {
  std::vector<int> of;           ///< for each block of the shape its loop, or -1
  std::vector<ClosedLoop> list;  ///< the loops

  /// Finds them. \param shape blocks of an island
  explicit ClosedLoops(const std::vector<ShapeBlock>& shape);
};

}  // namespace joints
/// @}
