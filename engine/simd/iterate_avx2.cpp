// The passes compiled for AVX2. Called only on processors that have it.
#include "engine/simd/iterate.h"

namespace joints {

void run_single_avx2(const LaneWork& work, Pass pass, real parameter);
void run_single_avx2(const LaneWork& work, Pass pass, real parameter) {
  run_all<Single>(work, pass, parameter);
}

void run_lanes_avx2(const LaneWork& work, Pass pass, real parameter);
void run_lanes_avx2(const LaneWork& work, Pass pass, real parameter) {
  run_all<Lanes>(work, pass, parameter);
}

}  // namespace joints
