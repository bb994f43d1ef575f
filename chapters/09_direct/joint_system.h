// All joints of a system as one equation A lambda = -(J V + b): its matrix, velocities, impulses
// and bounds. Given, there is nothing to edit here.
#pragma once

#include <limits>

#include "chapters/09_direct/elimination_plan.h"
#include "chapters/09_direct/direct.h"
#include "engine/block.h"

/// \addtogroup chapter9
/// @{
namespace joints {

/// A block of a system.
struct SystemBlock {
  int place = 0;                 ///< that of its link in the order of elimination
  int loop = -1;                 ///< its closed loop, or -1
  std::array<int, 2> columns{};  ///< its bodies
  int rows = 0;                  ///< 1 to 6
  bool bounded = false;          ///< its last row has bounds
  int block = 0;                 ///< its number in Blocks::list
  int row = 0;                   ///< its first row, counted system after system
  int node = 0;                  ///< its node in the matrix
  int first = 0;                 ///< its first row in that node
  /// True if the matrix has the same pattern with the other block in its place.
  bool like(const SystemBlock& other) const {
    return place == other.place && loop == other.loop && columns == other.columns &&
           rows == other.rows && bounded == other.bounded;
  }
};

/// A row with bounds; it is the last one of its block.
struct BoundedRow {
  int block = 0;                ///< its block in JointSystem::blocks
  double lower = 0, upper = 0;  ///< of its impulse [N s or N m s]
  double bias = 0;              ///< minus the required J V
  double softness = 0;          ///< in the present factor; J V + bias + softness lambda = 0
  Side side = Side::free;       ///< its side
  double bound(Side of) const { return of == Side::lower ? lower : upper; }  ///< on a side
};

/// Largest number of rows of a node. While they are not more, the blocks of a link share a node, as
/// those of a hinge and its motor do.
constexpr int most_rows = 6;

/// Makes a vector of `count` zeros, with room for some more: rows of limits come and go.
template <class Number>
void zeros(std::vector<Number>& list, std::size_t count) {
  if (list.capacity() < count) list.reserve(2 * count);
  list.assign(count, Number{});
}

/// The joints that are solved together, and their bodies.
class JointSystem {
 public:
  static constexpr double infinite = std::numeric_limits<double>::infinity();  ///< infinity
  std::vector<SystemBlock> blocks;       ///< in the order of elimination
  std::vector<int> bodies;               ///< the slot of each column
  std::vector<bool> moves;               ///< whether they can move
  double softening = 0;                  ///< DirectSolver::softening, of rows in closed loops
  PivotInverse inverse = inverse_pivot;  ///< how dependent rows are treated
  JointMatrix A;                         ///< the matrix, or its factor
  bool factored = false;                 ///< A contains the factor of the present rows
  int passes = 0;                        ///< factorisations of this step
  int wrong = 0;                         ///< bounded rows on the wrong side
  std::vector<double> x;                 ///< for each row a change of J V; overwritten
  std::vector<double> impulse;           ///< accumulated impulses, by rows
  std::vector<BoundedRow> bounded;       ///< rows with bounds

  /// Computes nodes, edges and targets for the blocks.
  void lay_out(const EliminationPlan& plan);
  /// Prepares all blocks. \param expected for each row the change of J V that the poses will need,
  /// or null \param h step [s]
  void prepare(const Blocks& given, const real* expected, real h);
  void set_rows(const SystemBlock& block, const Row* rows);  ///< sets the rows of a block
  void set_mass(int column, const Body& body);               ///< sets the mass of a body
  void load(const Bodies& all);                              ///< reads the velocities of its bodies
  void store(Bodies& all) const;                             ///< writes them
  void store_impulses(const Blocks& given) const;            ///< writes them to the joints
  /// Multiplies the impulses by `ratio` and applies them. \param ratio 0 or above
  void start(double ratio);

  void assemble();    ///< computes the numbers of A from rows and masses
  void factor_now();  ///< assembles A and factors it, softened, without the rows at a bound
  /// Changes impulses and velocities so that J V of all free rows changes by `x`.
  void change();
  /// The same, but rows whose impulse would exceed one of two finite bounds, as those of motors do,
  /// end at this bound, and the others change as required without them.
  void change_within_bounds();
  /// Solves until all rows are satisfied. \param most_passes of the active set \param refine false
  /// if it will be called again in this step
  void solve(int most_passes, bool refine);

  /// J V of row i of a block, from this row at any poses.
  double rate(const SystemBlock& block, const Row& row) const;
  /// Where the numbers of a block begin in x and impulse.
  int row_of(const SystemBlock& block) const { return A.nodes[block.node].row + block.first; }
  /// The diagonal entry of row i of a block.
  double& diagonal(const SystemBlock& block, int i) {
    const Node& node = A.nodes[block.node];
    return A.numbers[node.diagonal + (block.first + i) * (node.rows + 1)];
  }
  /// The diagonal entry of a bounded row.
  double& diagonal_of(const BoundedRow& row) {
    return diagonal(blocks[row.block], blocks[row.block].rows - 1);
  }
  void note_diagonal();  ///< stores the diagonal before any elimination
  /// True if a block is a spring, so that its error is no error of a pose.
  bool is_spring(int block) const { return softness_[block] > 0; }
  /// Number of rows of a block whose pivot is 0 or less than this fraction of the original entry.
  int rows_below(double fraction, const SystemBlock& block) const;
  int dependent() const;  ///< number of rows that depend on others, without those at a bound
  double multiplications() const { return multiplications_; }  ///< of a factorisation (Eq. 9-6)
  int fill() const { return fill_; }  ///< number of entries that elimination fills in

 private:
  struct Progress {  // of the active set
    int fewest, in_vain;  // wrong rows; passes without fewer of them
  };
  void make_nodes();
  int at(int later, int earlier) const;
  bool coupled(int node, int other) const;
  bool is_below(double fraction, const SystemBlock& block, int i) const;
  HalfRow* half(int node, int of) { return &J_[2 * A.nodes[node].row + of * A.nodes[node].rows]; }
  void push(int node, const double* by);
  void rates_of(int node, double* out) const;
  void correct();
  void go_to_bounds();
  void stay_inside();
  bool bounds_depend() const;
  void flip_wrong_ones(Progress& progress);
  int last_row(const BoundedRow& row) const {
    return row_of(blocks[row.block]) + blocks[row.block].rows - 1;
  }

  std::vector<std::array<int, 2>> columns_;  // of each node
  std::vector<int> first_;                   // node of each link, in the order of elimination
  std::vector<HalfRow> J_;              // node after node: its halves at body 1, then at body 2
  std::vector<InverseMass> masses_;     // of each column
  std::vector<HalfRow> velocities_;     // of each column
  std::vector<double> wanted_;          // required J V, by rows
  std::vector<double> softness_;        // SoftCoefficients::softness of each block
  bool springs_ = false, loops_ = false;  // there are some
  bool inside_ = false;                 // the impulses stay in their bounds
  int left_ = 0;                        // rows that have come to a bound in this pass
  double multiplications_ = 0;
  int fill_ = 0;
};

}  // namespace joints
/// @}
