// The same start for every method: velocities that belong to the middle of the steps.
#pragma once

#include "bench/runner.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// A setting that begins its first step with forces that have acted backwards for Setting::lag of
/// it. A step that changes velocities first and moves the bodies with the new ones is of second
/// order if the velocities belong to the middle of the steps (Eq. 9-9). Begun with those of the
/// start, it is ahead of the motion by half a step of all forces: g h t/2 in a free fall.
Setting with_same_start(Setting setting);
/// Changes velocities as little as the masses permit, so that rows without bounds have J V = 0.
void satisfy_rows(World& world);

}  // namespace joints::bench
/// @}
