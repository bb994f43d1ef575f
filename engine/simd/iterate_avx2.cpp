// The passes compiled for AVX2. Called only on processors that have it.
#include "engine/simd/iterate.h"

namespace joints {

void run_pass_avx2(const LaneWork& work, Pass pass, real parameter);
void run_pass_avx2(const LaneWork& work, Pass pass, real parameter) {
  run<Single, Lanes>(work, pass, parameter);
}

}  // namespace joints
