// The contraction rate: what an iteration of the solver leaves in the long run.
#pragma once

#include <functional>

#include "engine/sequential_impulses.h"
#include "engine/step.h"

/// \addtogroup measuring
/// @{
namespace joints {

/// The share that an iteration leaves in the long run [1]: the mean over the last tenth of the
/// iterations. Where rounding is not reached it is a lower bound.
/// \param iterate does one iteration; returns the size of what it changed, or of what is left, and
/// 0 once that is rounding \param most how many iterations at the most
double contraction_rate(const std::function<double()>& iterate, int most);

/// The same of the next step of a world as it stands, by what Sequential Impulses change of the
/// impulses. The world is left as it was, but for World::blocks, which are empty.
/// \param h length of that step [s] \param solver with its settings, of which `iterations` is not
/// used \param how warm or cold, hard or soft
double contraction_rate(World& world, int most, real h = real(1) / 60,
                        SequentialImpulses solver = {}, const Stepping& how = {});

}  // namespace joints
/// @}
