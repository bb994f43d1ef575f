// The passes compiled for any processor, and the choice of the best ones at run time.
#include "engine/simd/iterate.h"

namespace joints {

extern template void warm_all<Lanes>(const LaneWork& work, real ratio);  // warm_lanes.cpp

#if defined(__x86_64__) && defined(JOINTS_AVX2)
// The same code compiled for AVX2: engine/simd/iterate_avx2.cpp.
void run_single_avx2(const LaneWork& work, Pass pass, real parameter);
void run_lanes_avx2(const LaneWork& work, Pass pass, real parameter);
static bool has_avx2() {
  static const bool has = __builtin_cpu_supports("avx2");
  return has;
}
#endif

void run_single(const LaneWork& work, Pass pass, real parameter) {
#if defined(__x86_64__) && defined(JOINTS_AVX2)
  if (has_avx2()) return run_single_avx2(work, pass, parameter);
#endif
  run_all<Single>(work, pass, parameter);
}

void run_lanes(const LaneWork& work, Pass pass, real parameter) {
#if defined(__x86_64__) && defined(JOINTS_AVX2)
  if (has_avx2()) return run_lanes_avx2(work, pass, parameter);
#endif
  run_all<Lanes>(work, pass, parameter);
}

}  // namespace joints
