// The contraction rate: the factor by which an iteration reduces the error in the long run.
#pragma once

#include <functional>

#include "engine/sequential_impulses.h"
#include "engine/steps/step.h"

/// \addtogroup measuring
/// @{
namespace joints {

/// The factor by which an iteration multiplies the error in the long run [1]: the mean over the
/// last tenth of the iterations. It is a lower bound unless the error reaches rounding.
/// \param iterate performs one iteration; returns the magnitude of its change, or of the remaining
/// error, and 0 once that is rounding \param most maximum number of iterations, at least 2
/// \throws std::invalid_argument for fewer
double contraction_rate(const std::function<double()>& iterate, int most);

/// The same for the next step of a world in its present state, from the changes of the impulses by
/// Sequential Impulses. The world is not changed, except that World::blocks is emptied.
/// \param h length of that step [s] \param solver with its settings, of which `iterations` is not
/// used \param how warm or cold, hard or soft
double contraction_rate(World& world, int most, real h = real(1) / 60,
                        SequentialImpulses solver = {}, const StepOptions& how = {});

}  // namespace joints
/// @}
