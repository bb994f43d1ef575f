// A user-defined solver: Sequential Impulses, alternately forwards and backwards.
#pragma once

#include <joints.h>

namespace joints {

/// Symmetric block Gauss-Seidel: every second iteration begins with the last block.
class SymmetricImpulses : public SequentialImpulses {
 public:
  void solve(Bodies& bodies) override {
    for (int i = 0; i < iterations; ++i)
      if (i % 2 == 0)
        iterate(bodies);
      else
        for (int k = prepared_count() - 1; k >= 0; --k) iterate(bodies, k, k + 1);
  }
};

}  // namespace joints
