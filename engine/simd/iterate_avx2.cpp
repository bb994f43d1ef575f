// The iteration on lanes compiled for AVX2. Called only on processors that have it.
#include "engine/simd/iterate.h"

namespace joints {

void iterate_lanes_avx2(const LaneIteration& iteration);
void iterate_lanes_avx2(const LaneIteration& iteration) { iterate_all<Lanes>(iteration); }

}  // namespace joints
