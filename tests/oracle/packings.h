// Every way in which PackedImpulses groups blocks, for the tests that hold for all of them.
#pragma once

#include "engine/simd/packed.h"

namespace joints {

inline constexpr Packing packings[] = {Packing::automatic, Packing::colours, Packing::list,
                                       Packing::interleaved};
/// True if it solves several blocks side by side where a scene has enough of them.
inline bool on_lanes(Packing packing) {
  return packing == Packing::automatic || packing == Packing::colours;
}

}  // namespace joints
