// The passes over blocks side by side, compiled for any processor. A file of its own: this takes
// the compiler as long as all else of the folder.
#include "engine/simd/iterate.h"

namespace joints {

template void run_all<Lanes>(const LaneWork& work, Pass pass, real parameter);

}  // namespace joints
