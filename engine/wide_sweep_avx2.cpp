// The sweep on lanes once more, compiled for x86 processors that have AVX2. Called only on those.
#include "engine/wide_sweep.h"

namespace joints {

void sweep_lanes_avx2(const LaneGroup* groups, int count, LaneNumber* numbers, LaneBody* bodies);
void sweep_lanes_avx2(const LaneGroup* groups, int count, LaneNumber* numbers, LaneBody* bodies) {
  sweep_all(groups, count, numbers, bodies);
}

}  // namespace joints
