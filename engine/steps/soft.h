// Feedback changed by a way to step: springs in the place of Baumgarte's beta, or none.
#pragma once

#include "engine/block.h"

/// \addtogroup world
/// @{
namespace joints {

/// The same target without feedback: hard rows with the same bounds and target rate.
inline RowSettings without_feedback(RowSettings target) {
  target.beta = target.frequency = 0;
  return target;
}

/// Makes springs of the blocks from number `first` on that hold a position and are hard.
/// \param frequency natural frequency [Hz] \param damping damping ratio [1]
/// Source: Catto, "Soft Constraints", GDC 2011.
inline void soften(Blocks& blocks, int first, real frequency, real damping) {
  for (std::size_t k = std::size_t(first); k < blocks.list.size(); ++k)
    if (Block& block = blocks.list[k]; block.corrects)
      block.settings.frequency = frequency, block.settings.damping = damping;
}

/// Validates the numbers of such springs for a step of length h [s]; frequency 0 is none.
/// \throws std::invalid_argument unless both are finite and not negative, and the step can have
/// such a spring
inline void check_softness(real frequency, real damping, real h) {
  require(finite(frequency) && frequency >= 0, "frequency", frequency,
          "must be finite and not negative [Hz]");
  require(finite(damping) && damping >= 0, "damping", damping,
          "must be finite and not negative [1]");
  const SoftCoefficients spring =
      soft_coefficients({.beta = 1, .frequency = frequency, .damping = damping}, h, h);
  require(finite(spring.bias_rate) && finite(spring.softness), "frequency", frequency,
          "a spring of this frequency and damping must be possible in a step of this length [Hz]");
}

}  // namespace joints
/// @}
