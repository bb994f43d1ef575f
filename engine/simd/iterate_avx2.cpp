// The sweep on lanes once more, compiled for x86 processors that have AVX2. Called only on those.
#include "engine/simd/iterate.h"

namespace joints {

void sweep_lanes_avx2(const LaneSweep& sweep);
void sweep_lanes_avx2(const LaneSweep& sweep) { sweep_all<Lanes>(sweep); }

}  // namespace joints
