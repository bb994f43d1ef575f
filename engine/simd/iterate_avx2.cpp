// The iteration on lanes once more, compiled for x86 processors that have AVX2. Called only on
// those.
#include "engine/simd/iterate.h"

namespace joints {

void iterate_lanes_avx2(const LaneIteration& iteration);
void iterate_lanes_avx2(const LaneIteration& iteration) { iterate_all<Lanes>(iteration); }

}  // namespace joints
