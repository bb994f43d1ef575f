// The sweep on lanes for any processor, and the choice among those that there are.
#include "engine/wide_sweep.h"

namespace joints {

#if defined(__x86_64__) && defined(JOINTS_AVX2)
// The same code compiled for processors with 32 byte registers: engine/wide_sweep_avx2.cpp.
void sweep_lanes_avx2(const LaneGroup* groups, int count, LaneNumber* numbers, LaneBody* bodies);
#endif

void sweep_lanes(const LaneGroup* groups, int count, LaneNumber* numbers, LaneBody* bodies) {
#if defined(__x86_64__) && defined(JOINTS_AVX2)
  static const bool has_avx2 = __builtin_cpu_supports("avx2");
  if (has_avx2) return sweep_lanes_avx2(groups, count, numbers, bodies);
#endif
  sweep_all(groups, count, numbers, bodies);
}

}  // namespace joints
