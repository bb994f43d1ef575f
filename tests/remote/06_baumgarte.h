// What ./wb grade sends of chapter 6's chain.
#pragma once

#include <tuple>

#include "chapters/06_baumgarte/baumgarte.h"

namespace joints {

inline auto members(Chain& chain) { return std::tie(chain.bodies, chain.joints); }

}  // namespace joints
