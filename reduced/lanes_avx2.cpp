// The Runge-Kutta step on lanes, compiled for AVX2. Called only on processors that have it.
#include "reduced/lanes.inl"

namespace joints {

void runge_kutta_avx2(void* links, int count, void* states, real h);
void runge_kutta_avx2(void* links, int count, void* states, real h) {
  auto* const base = static_cast<StateOf<on_lanes::TreeLink>*>(states);
  on_lanes::runge_kutta(static_cast<on_lanes::TreeLink*>(links), count, base, base + count, h);
}

}  // namespace joints
