// The plan of a step: what there is to do, counted. The engine does not include it.
#pragma once

#include "engine/solver.h"
#include "engine/world.h"

/// \addtogroup measuring
/// @{
namespace joints {

/// What a step has to do, counted: the line that every program prints before it runs.
struct Plan {
  int bodies = 0, static_bodies = 0;             ///< all of them, and those that never move
  int blocks = 0, rows = 0;                      ///< live ones
  int limits = 0, live_limits = 0, motors = 0;   ///< of all joints
  bool warm_start = false;                       ///< as Stepping says
  std::string solver{};                          ///< Solver::plan()
  std::string line() const;  ///< "bodies 12 (2 static), blocks 19, rows 34, ..."
};

/// Counts the blocks that the joints append at the present poses, with the rows that their last
/// begin_step() chose. \param solver the one that will solve them, if it is to say how
Plan plan(const World& world, bool warm_start, const Solver* solver = nullptr);

}  // namespace joints
/// @}
