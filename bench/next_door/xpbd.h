// XPBD, extended position-based dynamics, on the rows of this workbook. For comparison only: the
// library does not contain it.
#pragma once

#include "engine/solver.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// XPBD (Macklin, Müller, Chentanez 2016; for rigid bodies Müller et al. 2020). The bodies first
/// move by h V without their joints. Each iteration then computes C and J at the present poses and
/// moves the bodies, one row after the other, until
///
///     C + alpha/h^2 Lambda + (alpha c/h) J d = 0
///
/// holds for that row, where d is the displacement since the beginning of the step, Lambda = h
/// lambda its accumulated impulse times h, alpha = 1/k its compliance and c its damper. The change
/// of a row's impulse follows from d += M^-1 J^T dLambda and K = J M^-1 J^T:
///
///     dLambda = -(C + alpha/h^2 Lambda + (alpha c/h) J d) / ((1 + alpha c/h) K + alpha/h^2)
///
/// At the end V = d/h. A block with a frequency has k = omega^2/K and c = 2 zeta omega/K for each
/// of its rows, so that alpha/h^2 = K/(omega h)^2 and alpha c/h = 2 zeta/(omega h). All other rows
/// have alpha = 0: they are hard, and there is no beta. A motor has J d - h rate in place of C.
///
/// Published implementations compute C and J anew for each constraint; here they are computed anew
/// once per iteration, and within the iteration C changes with J d. With one iteration per substep,
/// as Macklin et al. 2019 recommend, the two differ by terms of second order in the
/// correction. Springs that StepOptions::frequency would add are not added. Angular velocities must
/// stay below pi/h.
class Xpbd : public Solver {
 public:
  int iterations = 1;  ///< per substep

  void check() const override;
  void prepare(const Bodies& bodies, const Blocks& blocks, int first, real h) override;
  void warm_start(Bodies&, real) override {}  ///< every step starts cold
  void solve(Bodies&) override {}             ///< the work is done on positions, in advance()
  void advance(Bodies& bodies, real h, const Append& append) override;

 private:
  struct Displacement {
    vec3 x{0}, phi{0};  // [m] and [rad]
  };
  void start_impulses(bool first);
  void iterate(Bodies& bodies, real h);
  void move(Bodies& bodies);

  Blocks blocks_;                       // at the present poses
  real acting_ = 0;                     // Blocks::duration_or() of the step
  std::vector<Displacement> d_, done_;  // since the beginning of the step; as far as poses have it
  std::vector<quat> begin_;             // the orientations at the beginning of the step
  std::vector<real*> known_;            // the blocks' impulses, of all iterations of this step
};

}  // namespace joints::bench
/// @}
