// A pair of islands of the direct solver, side by side on two lanes: velocities, impulses, and
// bounds by an active set. Given, there is nothing to edit here.
#pragma once

#include <limits>

#include "chapters/09_direct/joint_matrix.h"
#include "engine/block.h"

/// \addtogroup chapter9
/// @{
namespace joints {

/// A row with bounds; it is the last one of its block.
struct BoundedRow {
  int block = 0, lane = 0;        ///< its block in IslandPair::blocks
  double lower = 0, upper = 0;    ///< of its impulse [N s or N m s]
  double bias = 0;                ///< minus the required J V
  double softness = 0;            ///< in the present factor; J V + bias + softness lambda = 0
  Side side = Side::free;         ///< its side
  double bound(Side of) const { return of == Side::lower ? lower : upper; }  ///< on a side
};

/// J V of a row, of its half at one body.
inline TwoLanes dot(const HalfRowOf<TwoLanes>& a, const HalfRowOf<TwoLanes>& b) {
  return dot(a.v, b.v) + dot(a.w, b.w);
}

/// Up to two islands with the same shape. An idle lane contains zeros.
class IslandPair : public IslandMatrix {
 public:
  static constexpr double infinite = std::numeric_limits<double>::infinity();  ///< infinity
  std::array<int, 2> islands{-1, -1};      ///< their numbers; -1: the lane is idle
  std::vector<std::array<int, 2>> bodies;  ///< slots of each column; -1: the lane is idle
  bool is_new = true;                      ///< `blocks` has changed in this step
  bool has_room = false;                   ///< for a bounded row at every link
  bool active = false;                     ///< it is solved now
  bool alternates = false;                 ///< rows outside A act on it: it is solved repeatedly
  bool factored = false;                   ///< A contains the factor of the present rows
  double softening = 0;                    ///< DirectSolver::softening
  PivotInverse inverse = inverse_pivot;    ///< DirectSolver::inverse
  int passes = 0;                          ///< factorisations of this step
  int wrong = 0;                           ///< bounded rows on the wrong side
  std::vector<TwoLanes> x;                 ///< for each row a change of J V; overwritten
  std::vector<TwoLanes> impulse;           ///< accumulated impulses, by rows
  std::vector<BoundedRow> bounded;         ///< rows with bounds

  /// Prepares all blocks. \param corrections those that are expected (SolverMemory), or null
  /// \param h step [s]
  void prepare(const Blocks& given, const Correction* corrections, real h);
  void make_room();  ///< IslandMatrix::make_room(), also for its own lists
  /// Sets the rows of a block on one lane.
  void set_rows(int block, int lane, const Row* rows);
  /// Sets the mass of a body on one lane.
  void set_mass(int column, int lane, const Body& body);
  void load(const Bodies& all);  ///< reads the velocities of its bodies
  void store(Bodies& all) const;  ///< writes the velocities of its bodies
  void store_impulses(const Blocks& given) const;  ///< writes them to the joints
  void keep_impulses();  ///< stores those of both lanes
  void restore_impulses(int lane);  ///< that were stored last
  /// Stores the velocities and impulses of one lane, for go_back().
  void keep(const Bodies& all, int lane);
  void go_back(Bodies& all, int lane);  ///< restores them
  /// Multiplies the impulses by `ratio` and applies them. \param ratio 0 or above
  void start(double ratio);
  /// Factors A.
  void factor_now();
  /// Changes impulses and velocities so that J V of all free rows changes by `x`.
  void change();
  /// DirectSolver::reach() for its rows. Mostly it takes more than one solution: A is softened, and
  /// belongs to other poses than `at`.
  void reach(const Blocks& at, const std::vector<real>& wanted, double enough);
  /// Solves until all rows are satisfied. \param most_passes of the active set \param refine false
  /// if it will be called again in this step
  void solve(int most_passes, bool refine);
  /// True if the spring of a block has this softness, so that its error is no error of a pose.
  bool is_spring(int block, int lane) const { return softness_[block][lane] > 0; }
  /// Number of rows of a block whose pivot is 0 or less than this fraction of the original entry.
  int rows_below(double fraction, int block, int lane) const;
  /// Number of rows that depend on others, without those at a bound.
  int dependent() const;
  /// Finds the loops with at most one degree of freedom: their links cannot zigzag.
  void find_tight_loops();
  /// True if a block is in such a loop.
  bool is_tight(int block, int lane) const {
    const int loop = blocks[block].loop;
    return loop >= 0 && plan->loops[loop].motions(dependent_[loop][lane]) <= 1;
  }

 private:
  struct Progress {  // of the active set of an island
    int fewest, in_vain;  // wrong rows; passes without fewer of them
  };
  void note_diagonal();
  void push(int node, const TwoLanes* by);
  void rates_of(int node, const std::vector<HalfRowOf<TwoLanes>>& of, TwoLanes* out) const;
  void correct();
  void go_to_bounds();
  void stay_inside();
  bool bounds_depend() const;
  int flip_wrong_ones(std::array<Progress, 2>& progress);
  bool is_below(double fraction, const LaneBlock& block, int i, int lane) const;
  TwoLanes& diagonal_of(const BoundedRow& row);
  int last_row(const BoundedRow& row) const {
    return row_of(blocks[row.block]) + blocks[row.block].rows - 1;
  }
  // Only so many rows of a node, the first ones, have linear parts.
  int linear_rows(int node) const {
    const Form form = nodes[node].form;
    return form == Form::any ? A.nodes[node].rows : form == Form::point ? 3 : 0;
  }

  std::vector<HalfRowOf<TwoLanes>> J_at_;        // of other poses
  std::vector<TwoLanes> wanted_;                 // required J V, by rows
  std::vector<TwoLanes> softness_;               // StepTarget::softness of each block
  std::vector<HalfRowOf<TwoLanes>> velocities_, kept_velocities_;  // of each column
  std::vector<TwoLanes> kept_impulses_;
  bool springs_ = false;                         // there are some
  std::array<bool, 2> inside_{};                 // the impulses of a lane stay in their bounds
  std::array<int, 2> left_{};                    // rows that have come to a bound in this pass
  std::vector<std::array<int, 2>> dependent_;    // rows of each closed loop
};

}  // namespace joints
/// @}
