// The plan of a step: the numbers of its blocks and rows. The engine does not include this file.
#pragma once

#include "engine/solver.h"
#include "engine/world.h"

/// \addtogroup measuring
/// @{
namespace joints {

/// The amount of work in a step: the line that every program prints before it runs.
struct Plan {
  int bodies = 0, static_bodies = 0;             ///< all of them; of these the static ones
  int blocks = 0, rows = 0;                      ///< active ones
  int limits = 0, live_limits = 0, motors = 0;   ///< of all joints
  bool warm_start = false;                       ///< as in StepOptions
  std::string solver{};                          ///< Solver::description()
  std::string line() const;  ///< "bodies 12 (2 static), blocks 19, rows 34, ..."
};

/// Counts the blocks that the joints append at the present poses, with the rows that their last
/// begin_step() chose. \param solver the one that will solve them, for its description; may be null
Plan plan(const World& world, bool warm_start, const Solver* solver = nullptr);

}  // namespace joints
/// @}
