// The direct solver: finds the impulses of all joints at once. Given, there is nothing to edit.
#pragma once

#include <array>

#include "chapters/09_direct/joint_matrix.h"
#include "engine/sequential_impulses.h"

/// \addtogroup chapter9
/// @{
namespace joints {

/// Solves A lambda = -(J V + bias) by factoring A = J M^-1 J^T. Everything is a correction: one
/// factor serves the velocities, their refinement and the positions. Bounds are kept by an active
/// set. Rows whose bound follows another impulse (friction), and those that they follow, stay
/// outside of A: iterations over them and corrections of all others alternate.
/// It works on numbers of type double, whatever `real` is, and on two islands that are alike side
/// by side (JointMatrixMaker). Best with beta = 1 in every joint.
/// Source: Baraff 1996 for the idea; Davis 2006 for sparse factors; Judice and Pires 1994 for the
/// passes of the active set.
class DirectSolver : public Solver {
 public:
  /// Iterations on the positions at most (SHAKE), before the factor of the new poses is taken; 0:
  /// velocities alone.
  int newton = 0;
  /// kappa of Eq. 9-14, 8 if it is wanted: no moment of inertia may be less than the step can
  /// follow. What closed loops of one motion pull adds none.
  real added_inertia = 0;
  /// Rows in closed loops are softer by this share of their K, and refined once: rows that nearly
  /// depend on others get no large impulses.
  double softening = sizeof(real) == 4 ? 1e-5 : 1e-8;
  int alternations = 10;  ///< how often the rows outside of A and those in it take turns
  int passes = 200;       ///< of the active set, at most
  /// If a factorisation takes more multiplications a row than this, `instead` solves. A body
  /// with 44 balls or more is such a hub.
  double most_work = 3000;
  /// What solves then, cold in every step and with a split impulse: beta is advised to be 1, and a
  /// light hub gains energy from warm impulses or from any feedback in the velocities.
  SequentialImpulses instead;
  PivotInverse inverse = inverse_pivot;  ///< what is done about dependent rows

  DirectSolver() { instead.split_iterations = instead.iterations; }

  /// What the last step did.
  struct Report {
    int passes = 0;              ///< factorisations for the active set
    int wrong = 0;               ///< bounded rows that were still on the wrong side
    double multiplications = 0;  ///< of a factorisation, about
    int fill = 0;                ///< numbers that elimination filled in
    int corrections = 0;         ///< of the positions
    bool moved_exactly = false;  ///< Newton's method on the positions converged
    bool iterated = false;       ///< `instead` solved
  };
  const Report& report() const { return report_; }  ///< of the last step
  int dependent() const;  ///< how many rows of the last factor depend on others
  /// The largest error that each iteration on the positions has met in the last step [m or rad].
  const std::vector<double>& errors_met() const { return errors_met_; }

  void check() const override;
  void prepare(const Bodies& bodies, const Blocks& blocks, int first, real h) override;
  void warm_start(Bodies& bodies, real ratio) override;
  void solve(Bodies& bodies) override;
  /// With `newton`, the errors at the new poses become zero as well (move_onto_constraints).
  void advance(Bodies& bodies, real h, const Append& append) override;

  /// Factors A of the blocks that were prepared. \throws std::invalid_argument if there are none,
  /// or if `instead` has them
  void factor_now();
  /// Changes the velocities so that J V changes by `rates`, as far as rows are free, and the
  /// impulses with them. Accelerations are found in the same way. \param rates one for each row of
  /// the blocks; used up \throws std::invalid_argument for another number of them, or without a
  /// factor
  void change_rates(Bodies& bodies, std::vector<double>& rates);

 private:
  struct Pull {  // at a body
    real force_lever = 0;  // the sum of |F||r| in the last step [N m]
    Slowed slowed{};       // with more inertia
  };
  struct Inside {  // a block that has a place in A
    const Block* block;
    double spring = 0;  // Feedback::softness
  };
  struct BoundedRow {
    int inside = 0;  // number of its block; it is the last row
    double lower = 0, upper = 0, softness = 0;
    Side side = Side::free;
  };
  class Poses;  // the corrector of positions
  // Iterations that see other masses than those of the bodies that they move.
  class Outside : public SequentialImpulses {
   public:
    void prepare_as(const Bodies& masses, const Bodies& bodies, const Blocks& blocks, real h) {
      prepare(masses, blocks, 0, h);
      prepared_for(bodies, blocks, 0);
    }
  };

  void collect_masses(const Bodies& bodies);
  void find_pulls(real acted, std::vector<Pull>& pulls) const;
  void find_tight_loops();
  void note_diagonal();
  int rows_below(double share, int block) const;
  bool forces_jumped(const Bodies& bodies);
  void look_again(Bodies& bodies);
  void collect_blocks(const Bodies& bodies, real h);
  void collect_block(const Bodies& bodies, const Block& block, real h);
  bool is_outside(const Block& block) const;
  bool is_hub() const;
  void prepare_outside(const Bodies& bodies, real h);
  void place_rows();
  void place_row(int inside, int i, bool live);
  void solve_all(Bodies& bodies);
  void solve_joints(Bodies& bodies);
  bool project(Bodies& bodies, real h, const Append& append);
  void keep_best(Bodies& bodies);
  void back_to_best(Bodies& bodies) const;
  void know_again(SolverMemory& memory) const;
  void factor_at(const Bodies& bodies, const std::vector<Row>& J);
  void correct_velocities(Bodies& bodies);
  int flip_wrong_ones(Bodies& bodies, bool only_last);
  void go_to_bounds(Bodies& bodies);
  double rate_left(const Bodies& bodies, const Block& block, int i) const;
  // M^-1 J^T times some impulses of a block: what they change of its bodies' velocities.
  std::array<HalfRow, 2> changes(const Block& block, const double* impulse) const;
  void change_impulses(Bodies& bodies, const Block& block, const double* change) const;

  const Blocks* blocks_ = nullptr;
  std::vector<BodyMass> masses_;
  std::vector<bool> tight_;        // of each closed loop: it moves in one way at most
  std::vector<int> dependent_;     // and how many of its rows depend on others
  real h_ = 0;
  bool warm_ = false;              // impulses of the last step were a first guess
  std::vector<Pull> pulls_, next_pulls_;
  std::vector<Body> before_;       // velocities before the warm start
  const Row* rows_of_J_ = nullptr;  // those of A
  std::vector<Row> new_J_;
  std::vector<int> rows_;  // of each body, those of all blocks that hold it
  std::vector<HalfRowOf<TwoLanes>> J_;  // as JointMatrixMaker::assemble() wants them
  std::vector<double> bias_;           // minus the wanted J V, by rows
  std::vector<Inside> inside_;
  std::vector<BlockPattern> pattern_;  // of those
  std::vector<BoundedRow> bounded_;
  std::vector<const real*> followed_;  // impulses that bounds follow
  Blocks outside_;                     // the other blocks
  Bodies slow_bodies_;                // with more inertia, for those
  Outside contacts_;                   // solves them
  JointMatrixMaker maker_;
  bool factored_ = false;
  std::vector<double> x_;              // the right-hand side, then the change of the impulses
  std::vector<TwoLanes> on_lanes_;     // the same on lanes
  Blocks poses_;                       // errors at the new poses
  std::vector<double> in_vain_;
  std::vector<double> errors_met_;
  std::vector<Body> start_, best_;
  std::vector<BodyMass> at_start_;
  std::vector<real> impulses_;
  Report report_;
};

}  // namespace joints
/// @}
