// The warm start of blocks side by side, compiled for any processor. A file of its own: it takes
// the compiler as long as all of iterate.cpp.
#include "engine/simd/iterate.h"

namespace joints {

template void warm_all<Lanes>(const LaneWork& work, real ratio);

}  // namespace joints
