// The iterations compiled for any processor, and the choice of the best one at run time.
#include "engine/simd/iterate.h"

namespace joints {

#if defined(__x86_64__) && defined(JOINTS_AVX2)
// The same code compiled with 32 byte registers: engine/simd/iterate_avx2.cpp.
void iterate_lanes_avx2(const LaneIteration& iteration);
#endif

void iterate_single(const LaneIteration& iteration) { iterate_all<real>(iteration); }

void iterate_lanes(const LaneIteration& iteration) {
#if defined(__x86_64__) && defined(JOINTS_AVX2)
  static const bool has_avx2 = __builtin_cpu_supports("avx2");
  if (has_avx2) return iterate_lanes_avx2(iteration);
#endif
  iterate_all<Lanes>(iteration);
}

}  // namespace joints
