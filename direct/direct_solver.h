// The direct solver: finds the impulses of all joints at once.
#pragma once

#include <string>
#include <vector>

#include "direct/positions.h"
#include "engine/steps/two_pass_impulses.h"

/// \addtogroup chapter9
/// @{
namespace joints {

/// Solves A lambda = -(J V + bias) by factoring A = J M^-1 J^T. The velocities, their refinement
/// and the positions are corrected with one factor. Bounds are satisfied by an active-set method.
/// Rows whose bound depends on another impulse (friction), and the rows of these impulses, stay
/// outside A: iterations over them alternate with a solve of all others. The solver always
/// calculates in double. It solves each island by itself (JointIslands). As it is constructed it is
/// the one to take if you are not sure; add the step's `leapfrog` where the energy matters.
/// Source: Baraff 1996 for the idea; Davis 2006 for sparse factors; Judice and Pires 1994, and
/// Stark and Parker 1995, for the passes of the active set.
class DirectSolver : public Solver {
 public:
  /// Largest number of iterations on the positions (SHAKE) before secants take over, and after them
  /// the full method with the factors of the new poses; 0: no such iterations.
  int newton = 8;
  /// Errors of positions of at most this times h^2 are not corrected [m/s^2 or rad/s^2], nor those
  /// that are only rounding: a smaller correction changes no acceleration by more than this.
  double tolerance = 3e-4;
  real added_inertia = 8;  ///< kappa of Eq. 9-14; 0: no added inertia (AddedInertia)
  /// Rows in closed loops are softened by this fraction of their K, and the solution is refined
  /// once, so that rows that nearly depend on others get no large impulses.
  double softening = sizeof(real) == 4 ? 1e-5 : 1e-8;
  int alternations = 10;  ///< solves outside A and in it per step, if rows are outside
  /// If the factorisation of an island takes more multiplications per row than this, without rows
  /// that have bounds, `fallback` solves it and all bodies in contact with it. A body with 44 balls
  /// or more is such a hub.
  double most_work = 3000;
  /// The solver for such islands. It starts cold in every step and uses a split impulse, because
  /// with beta = 1 a light hub gains energy from warm starting and from feedback in the velocities.
  TwoPassImpulses fallback;
  PivotInverse inverse = inverse_pivot;  ///< how dependent rows are treated

  DirectSolver() { fallback.split_iterations = fallback.iterations; }
  /// One that corrects velocities alone: without iterations on the positions and added inertia.
  /// Then give every joint beta = 1, or its error stays.
  static DirectSolver velocities_only();

  /// Counts of the last step.
  struct Report : Positions::Report {
    /// Factorisations for the active set in all solves of the step, the most of any island.
    int passes = 0;
    int wrong = 0;               ///< bounded rows still on the wrong side at the end
    double multiplications = 0;  ///< of the factorisations of all islands, approximately
    int fill = 0;                ///< entries that elimination filled in
    bool iterated = false;       ///< `fallback` was used for an island
    double turned = 0;           ///< the largest rotation of a body with joints in the step [rad]

    /// What the step could not hold, and what to do about it, a sentence each; none if it could.
    std::vector<std::string> sentences() const;
  };
  const Report& report() const { return report_; }  ///< of the last step
  int dependent() const;  ///< number of rows of the last factor that depend on others
  /// The largest error before each iteration on the positions in the last step [m or rad].
  const std::vector<double>& errors_met() const { return positions_.errors_met; }

  void check() const override;
  void prepare(const Bodies& bodies, const Blocks& blocks, int first, real h) override;
  void warm_start(Bodies& bodies, real ratio) override;
  void solve(Bodies& bodies) override;
  /// With `newton`, the errors at the new poses become zero as well (move_onto_constraints).
  void advance(Bodies& bodies, real h, const Append& append) override;

  /// Factors A of the prepared blocks. \throws std::invalid_argument if there are none, or if
  /// `fallback` solves them
  void factor_now();
  /// Changes the impulses and velocities by the factor until J V has the required values, or until
  /// only rounding errors remain. No row may be at a bound. It can also compute accelerations.
  /// \param at the prepared blocks, or the same ones at other poses \param wanted J V of each of
  /// their rows \param enough largest error that may remain
  /// \throws std::invalid_argument if their number is wrong, or without a factor
  void reach(Bodies& bodies, const Blocks& at, const std::vector<real>& wanted, double enough);

 private:
  // Iterations with masses other than those of the bodies that they move.
  class Outside : public SequentialImpulses {
   public:
    void prepare_as(const Bodies& masses, const Bodies& bodies, const Blocks& blocks, real h) {
      prepare(masses, blocks, 0, h);
      prepared_for(bodies, blocks, 0);
    }
  };

  bool collect_blocks(const Bodies& bodies);
  bool is_outside(const Block& block) const;
  void split_blocks();
  void recall_corrections();
  void prepare_outside(const Bodies& bodies);
  void solve_active(Bodies& bodies, bool outside);
  bool alternating() const;  // rows outside A act on an active island
  bool forces_jumped(const Bodies& bodies);
  void solve_again(Bodies& bodies);

  const Blocks* blocks_ = nullptr;
  real h_ = 0;
  JointIslands islands_;
  std::vector<const real*> followed_;   // impulses on which bounds depend
  Blocks outside_;                      // the other blocks
  Blocks left_;                         // all blocks of islands that `fallback` solves
  Outside contacts_;                    // solves the blocks outside
  Bodies slow_bodies_;                  // with added inertia, for the blocks outside
  AddedInertia inertia_;
  real ratio_ = 0;                      // of the warm start: 1, or 0 for a cold one
  bool again_ = false;                  // solve_again() calls warm_start()
  std::vector<Body> before_;            // velocities before the warm start
  SolverMemory memory_, recalled_;
  Positions::Memory positions_;
  Report report_;
};

}  // namespace joints
/// @}
