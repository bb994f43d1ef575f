// The sweeps for any processor, and the choice among those that there are.
#include "engine/simd/iterate.h"

namespace joints {

#if defined(__x86_64__) && defined(JOINTS_AVX2)
// The same code compiled for processors with 32 byte registers: engine/simd/iterate_avx2.cpp.
void sweep_lanes_avx2(const LaneSweep& sweep);
#endif

void sweep_single(const LaneSweep& sweep) { sweep_all<real>(sweep); }

void sweep_lanes(const LaneSweep& sweep) {
#if defined(__x86_64__) && defined(JOINTS_AVX2)
  static const bool has_avx2 = __builtin_cpu_supports("avx2");
  if (has_avx2) return sweep_lanes_avx2(sweep);
#endif
  sweep_all<Lanes>(sweep);
}

}  // namespace joints
