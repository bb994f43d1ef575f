// The warm start of blocks side by side, compiled for any processor. It is a separate file because
// compiling it takes as long as all of iterate.cpp.
#include "engine/simd/iterate.h"

namespace joints {

template void run<Pass::warm, Lanes>(const LaneWork& work, real ratio);

}  // namespace joints
