// Constants of the stability suite's scenes.
#pragma once

#include <numbers>

#include "bench/stability.h"

namespace joints::bench {

inline constexpr real h = real(1) / 60;                         ///< their step [s]
inline constexpr real degree = std::numbers::pi_v<real> / 180;  ///< [rad]

}  // namespace joints::bench
