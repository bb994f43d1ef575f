// The contraction rate: what an iteration of the solver leaves in the long run.
#pragma once

#include <functional>

#include "engine/world.h"

/// \addtogroup measuring
/// @{
namespace joints {

/// The share that an iteration leaves in the long run [1]: the mean over the last tenth of the
/// iterations. Where rounding is not reached it is a lower bound.
/// \param iterate does one iteration; returns the size of what it changed, or of what is left, and
/// 0 once that is rounding \param most how many iterations at the most
double contraction_rate(const std::function<double()>& iterate, int most);

/// The same of the first step of a world, by what Sequential Impulses change of the impulses. The
/// bodies are left as they stand; impulses, blocks and last_h are not.
double contraction_rate(World& world, int most, real h = real(1) / 60);

}  // namespace joints
/// @}
