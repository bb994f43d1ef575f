// Conjugate gradients on the rows of a step. For comparison only: the library does not contain it.
#pragma once

#include "engine/sequential_impulses.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// The method of conjugate gradients (Hestenes, Stiefel 1952; Saad 2003, algorithm 9.1) for rows
/// without bounds. With V = V1 + M^-1 J^T lambda the rows J V + b + gamma lambda = 0 are
///
///     A lambda = c,   A = J M^-1 J^T + gamma,   c = -(J V1 + b)
///
/// and A is symmetric and positive semidefinite. Its solution is the lowest point of F(lambda) =
/// (1/2) lambda^T A lambda - c^T lambda. Gauss-Seidel descends along one block after the other.
/// Conjugate gradients descend along directions p with p_i^T A p_j = 0: a descent along p_j then
/// undoes nothing that was gained along p_i, and after as many directions as A has different
/// eigenvalues nothing is left but rounding. The next direction needs only the residual
/// r = c - A lambda = -(J V + b + gamma lambda) and the last direction:
///
///     a = r^T z / p^T A p;   lambda += a p;   V += a M^-1 J^T p;   r -= a A p
///     z = P r;   p <- z + (r^T z, now over before) p
///
/// A is never formed: A p is J (M^-1 J^T p) + gamma p, a pass from rows to bodies and one back. P
/// holds the inverses of the blocks' K (1 + softness), which Gauss-Seidel uses as well.
class ConjugateGradients : public SequentialImpulses {
 public:
  /// Stop when r^T P r has fallen to the square of this fraction of its value at lambda = 0 [1].
  real tolerance = 0;
  int used = 0;  ///< iterations of the last solve()

  /// \throws std::invalid_argument for a row with bounds, or a relaxation other than 1
  void prepare(const Bodies& bodies, const Blocks& blocks, int first, real h) override;
  void solve(Bodies& bodies) override;

 private:
  struct Velocity {
    vec3 v{0}, w{0};
  };
  void precondition(const std::vector<real>& r, std::vector<real>& z) const;
  std::vector<Velocity> velocities_;          // M^-1 J^T p
  std::vector<real> residual_, z_, p_, A_p_;  // a number for each row
};

}  // namespace joints::bench
/// @}
