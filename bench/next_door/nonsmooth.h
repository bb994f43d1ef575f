// The nonsmooth nonlinear conjugate gradient method. For comparison only: the library does not
// contain it.
#pragma once

#include "engine/sequential_impulses.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// NNCG (Silcowitz-Hansen, Niebe, Erleben 2010): conjugate gradients for rows with bounds, around
/// an iteration of projected Gauss-Seidel. The iteration lambda -> G(lambda) ends where G(lambda) =
/// lambda. Its change g = G(lambda) - lambda is used as minus the gradient of a function whose
/// lowest point is that end, and the formula of Fletcher and Reeves makes a direction of it:
///
///     g_k = G(lambda_k) - lambda_k,   f = |g_k|^2 / |g_(k-1)|^2
///     f <= 1:  lambda_(k+1) = G(lambda_k) + f p_(k-1),   p_k = g_k + f p_(k-1)
///     f > 1:   lambda_(k+1) = G(lambda_k),               p_k = g_k
///
/// The second line is a restart: the change has grown, so the direction is forgotten. One iteration
/// costs one of Gauss-Seidel and a pass over rows and bodies for f p.
///
/// It departs from the paper in three ways. The norm weights each row with its K, so that impulses
/// and angular impulses can be added. A row whose bounds are known is clamped after its step along
/// p, too; a bound that follows another impulse holds from the next iteration on. And the last
/// iteration takes no step along p, so that the impulses end within all bounds.
class NonsmoothGradients : public SequentialImpulses {
 public:
  int restarts = 0;  ///< of the last solve()
  void solve(Bodies& bodies) override;

 private:
  void step_along(Bodies& bodies, real factor);
  std::vector<real> before_, p_, K_;  // a number for each row
};

}  // namespace joints::bench
/// @}
