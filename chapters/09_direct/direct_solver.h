// The direct solver: finds the impulses of all joints at once. Given, there is nothing to edit.
#pragma once

#include <array>

#include "chapters/09_direct/joint_matrix.h"
#include "chapters/09_direct/secants.h"
#include "engine/sequential_impulses.h"

/// \addtogroup chapter9
/// @{
namespace joints {

/// Solves A lambda = -(J V + bias) by factoring A = J M^-1 J^T. The velocities, their refinement
/// and the positions are corrected with one factor. Bounds are satisfied by an active-set method.
/// Rows whose bound depends on another impulse (friction), and the rows of these impulses, stay
/// outside A: iterations over them alternate with a solve of all others. The solver always
/// calculates in double. It solves two islands with the same pattern side by side on lanes
/// (JointMatrixMaker). Give every joint beta = 1. Source: Baraff 1996 for the idea; Davis 2006 for
/// sparse factors; Judice and Pires 1994 for the passes of the active set.
class DirectSolver : public Solver {
 public:
  /// Largest number of iterations on the positions (SHAKE) before secants take over, and after them
  /// the full method with the factors of the new poses; 0: no such iterations.
  int newton = 0;
  /// Errors of positions of at most this times h^2 are not corrected [m/s^2 or rad/s^2], nor those
  /// that are only rounding: a smaller correction changes no acceleration by more than this.
  double tolerance = 3e-4;
  /// kappa of Eq. 9-14: 8 for added inertia, 0 for none. Forces of joints in closed loops with at
  /// most one degree of freedom add none.
  real added_inertia = 0;
  /// Rows in closed loops are softened by this fraction of their K, and the solution is refined
  /// once, so that rows that nearly depend on others get no large impulses.
  double softening = sizeof(real) == 4 ? 1e-5 : 1e-8;
  int alternations = 10;  ///< solves outside A and in it per step, if rows are outside
  int passes = 200;       ///< largest number of passes of the active set
  /// If a factorisation takes more multiplications per row than this, `instead` is used. A body
  /// with 44 balls or more is such a hub.
  double most_work = 3000;
  /// The solver for such scenes. It starts cold in every step and uses a split impulse, because
  /// with beta = 1 a light hub gains energy from warm starting and from feedback in the velocities.
  SequentialImpulses instead;
  PivotInverse inverse = inverse_pivot;  ///< how dependent rows are treated

  DirectSolver() { instead.split_iterations = instead.iterations; }

  /// Counts of the last step.
  struct Report {
    int passes = 0;              ///< factorisations for the active set
    int wrong = 0;               ///< bounded rows still on the wrong side at the end
    double multiplications = 0;  ///< of a factorisation, approximately
    int fill = 0;                ///< entries that elimination filled in
    int corrections = 0;         ///< of the positions, number of them
    bool moved_exactly = false;  ///< the errors of the positions are at most `tolerance` times h^2
    int halved = 0;  ///< how often velocities at open joints were halved to reach this
    bool iterated = false;       ///< `instead` was used
  };
  const Report& report() const { return report_; }  ///< of the last step
  int dependent() const;  ///< number of rows of the last factor that depend on others
  /// The largest error before each iteration on the positions in the last step [m or rad].
  const std::vector<double>& errors_met() const { return errors_met_; }

  void check() const override;
  void prepare(const Bodies& bodies, const Blocks& blocks, int first, real h) override;
  void warm_start(Bodies& bodies, real ratio) override;
  void solve(Bodies& bodies) override;
  /// With `newton`, the errors at the new poses become zero as well (move_onto_constraints).
  void advance(Bodies& bodies, real h, const Append& append) override;

  /// Factors A of the prepared blocks. \throws std::invalid_argument if there are none, or if
  /// `instead` solves them
  void factor_now();
  /// Changes the impulses and velocities so that J V of all free rows changes by `rates`. It can
  /// also be used to compute accelerations. \param rates one for each row of the blocks;
  /// overwritten
  /// \throws std::invalid_argument if their number is wrong, or without a factor
  void change_rates(Bodies& bodies, std::vector<double>& rates);

 private:
  struct Pull {  // of the joints at a body
    real force_lever = 0;  // the sum of |F||r| in the last step [N m]
    Slowed slowed{};       // the body with added inertia
  };
  struct Inside {  // a block inside A
    const Block* block;
    double spring = 0;  // Feedback::softness
  };
  struct BoundedRow {
    int inside = 0;  // index of its block, of which it is the last row
    double lower = 0, upper = 0, softness = 0;
    Side side = Side::free;
  };
  class Poses;  // the corrector of positions
  // Iterations with masses other than those of the bodies that they move.
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
  double largest_error(const Bodies& bodies, real h) const;
  void back_to_start(Bodies& bodies) const;
  double move_by_secants(Bodies& bodies, real h, double most, Poses& poses);
  bool halve(Bodies& bodies, double most, const Append& append);
  bool project(Bodies& bodies, real h, double most, const Append& append);
  void keep_best(Bodies& bodies);
  void back_to_best(Bodies& bodies) const;
  void know_again(SolverMemory& memory) const;
  void factor_at(const Bodies& bodies, const std::vector<Row>& J);
  void correct_velocities(Bodies& bodies);
  int flip_wrong_ones(Bodies& bodies, bool only_last);
  void go_to_bounds(Bodies& bodies);
  double rate_left(const Bodies& bodies, const Block& block, int i) const;
  // M^-1 J^T times impulses of a block: the changes of the velocities of its bodies.
  std::array<HalfRow, 2> changes(const Block& block, const double* impulse) const;
  void change_impulses(Bodies& bodies, const Block& block, const double* change) const;

  const Blocks* blocks_ = nullptr;
  std::vector<BodyMass> masses_;
  std::vector<bool> tight_;        // of each closed loop: it has at most one motion
  std::vector<int> dependent_;     // of each closed loop: number of its dependent rows
  real h_ = 0;
  bool warm_ = false;              // the impulses of the last step were applied
  std::vector<Pull> pulls_, next_pulls_;
  std::vector<Body> before_;       // velocities before the warm start
  const Row* rows_of_J_ = nullptr;  // the rows from which A is made
  std::vector<Row> new_J_;
  std::vector<int> rows_;  // for each body the number of rows of all its blocks
  std::vector<HalfRowOf<TwoLanes>> J_;  // for JointMatrixMaker::assemble()
  std::vector<double> bias_;           // minus the required J V, by rows
  std::vector<Inside> inside_;
  std::vector<BlockPattern> pattern_;  // of the blocks inside A
  std::vector<BoundedRow> bounded_;
  std::vector<const real*> followed_;  // impulses on which bounds depend
  Blocks outside_;                     // the other blocks
  Bodies slow_bodies_;                 // with added inertia, for the blocks outside
  Outside contacts_;                   // solves the blocks outside
  JointMatrixMaker maker_;
  bool factored_ = false;
  std::vector<double> x_;              // the right-hand side, then the change of the impulses
  std::vector<TwoLanes> on_lanes_;     // the same on lanes
  Blocks poses_;                       // errors at the new poses
  std::vector<double> in_vain_;
  Secants secants_;
  std::vector<double> rates_;          // their corrections
  std::vector<double> errors_met_;
  std::vector<Body> start_, best_;
  std::vector<bool> at_open_;          // of each body: one of its joints is open
  std::vector<BodyMass> at_start_;
  std::vector<real> impulses_;
  Report report_;
};

}  // namespace joints
/// @}
