// Second order in time: velocities belong to the middle of a step.
#pragma once

#include "engine/step.h"

/// \addtogroup world
/// @{
namespace joints {

/// Leapfrog (Eq. 9-9). Forces act for the mean of the lengths of the last step and this one, so for
/// h/2 in the first step.
class Leapfrog : public StepMethod {
 public:
  real integrate_forces(World& world, real h) const override;
};

/// The bodies with velocities at the time of their poses. After a step with leapfrog, velocities
/// lag by half a step, and so do energies that are computed from them. This function lets forces
/// and joints act for the other half, without feedback. The world is not changed, except that
/// World::blocks are empty afterwards. Source: Andersen, "Rattle", 1983.
/// \param solver a separate solver, which is not used for the steps
/// \param warm_start whether the steps start from the impulses of the last one
Bodies velocities_at_pose_time(World& world, Solver& solver, bool warm_start);

}  // namespace joints
/// @}
