// The passes compiled for any processor, and the choice of the best ones at run time.
#include "engine/simd/iterate.h"

namespace joints {

#if defined(__x86_64__) && defined(JOINTS_AVX2)
void run_pass_avx2(const LaneWork& work, Pass pass, real parameter);  // iterate_avx2.cpp
#endif

void run_pass(const LaneWork& work, Pass pass, real parameter) {
#if defined(__x86_64__) && defined(JOINTS_AVX2)
  static const bool has_avx2 = __builtin_cpu_supports("avx2");
  if (has_avx2) return run_pass_avx2(work, pass, parameter);
#endif
  run<Single, Lanes>(work, pass, parameter);
}

}  // namespace joints
