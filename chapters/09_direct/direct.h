// Chapter 9: all joints at once. What direct.cpp has to provide. Read README.md beside it first.
// There is nothing to edit here.
#pragma once

#include <functional>
#include <vector>

#include "engine/simd/triple.h"
#include "engine/step.h"

/// \defgroup chapter9 Chapter 9: the direct solver
/// \brief All joints solved at once: the sparse matrix of the joints, its factor, and a motion of
/// second order in time.
/// @{
namespace joints {

// ---- the matrix of the joints -------------------------------------------------------------------

/// Two numbers side by side (SIMD lanes), each of another island: + - * act lane by lane.
typedef double TwoLanes __attribute__((vector_size(2 * sizeof(double))));

/// The half of a row that belongs to one body: the factors of its velocities, or of M^-1 J^T the
/// changes of them. Number is double or TwoLanes.
template <class Number>
struct HalfRowOf {
  Triple<Number> v;  ///< linear
  Triple<Number> w;  ///< angular
};
/// Of plain numbers.
using HalfRow = HalfRowOf<double>;

/// Exercise 9.1: the coupling of two blocks through a body that both hold, Eq. 9-2. Adds to A[i][j]
/// the rate of row i of one block per unit impulse along row j of the other.
/// \param J the halves of the first block's n rows at that body
/// \param response the halves of M^-1 J^T at that body, of the second block's m rows
/// \param A n x m numbers, row by row
template <class Number>
void add_coupling(const HalfRowOf<Number>* J, int n, const HalfRowOf<Number>* response, int m,
                  Number* A);

/// A block of rows as a node of the joint graph, in the order of elimination.
struct Node {
  int rows;        ///< 1 to 6
  int row;         ///< where its numbers begin in the right-hand side
  int diagonal;    ///< where its rows x rows numbers begin in JointMatrix::numbers
  int first_edge;  ///< its edges go from here to the first of the next node
};

/// The block of the matrix between a node and another one, which is eliminated later.
struct Edge {
  int to;  ///< the other node
  int at;  ///< where its numbers begin: rows of the other x rows of this node, row by row
};

/// A = J M^-1 J^T of all joints: symmetric, and zero wherever two blocks share no body. It keeps
/// the diagonal blocks and the blocks below them, also those that are zero now and will be filled.
/// Number is double, or TwoLanes for the matrices of two alike sets of joints. Its blocks: Eq. 9-2;
/// their elimination: Eq. 9-4.
template <class Number>
struct JointMatrixOf {
  std::vector<Node> nodes;        ///< in the order of elimination, and one more behind the last
  std::vector<Edge> edges;        ///< of all nodes; those of a node by the order of elimination
  std::vector<int> targets;       ///< where elimination subtracts, in the order of doing so
  std::vector<Number> numbers;    ///< of all blocks
  std::vector<Number> original;   ///< the diagonal at first; a node's begins at original[node.row]
};
/// Of plain numbers.
using JointMatrix = JointMatrixOf<double>;

/// What 1 / pivot is. \param original the pivot's diagonal entry before any elimination
using PivotInverse = double (*)(double pivot, double original);

/// Exercise 9.2, first half: factors A = L D L^T in place, node after node, Eq. 9-4. What is left
/// in a diagonal block is its own factor (factor_block), and in an edge the block of L.
template <class Number>
void factor(JointMatrixOf<Number>& A, PivotInverse inverse);

/// Exercise 9.2, second half: solves A x = b with the factor, Eq. 9-5. \param x b, then x
template <class Number>
void solve(const JointMatrixOf<Number>& A, Number* x);

/// Exercise 9.3: an order of elimination with little fill-in: always the node with the fewest
/// neighbours left, and of those the one with the least number.
/// \param neighbours of each node, without itself; each pair is in both lists
/// \return the nodes in that order
std::vector<int> elimination_order(std::vector<std::vector<int>> neighbours);

/// Exercise 9.4: 1 / pivot, or 0 for a row that depends on those before it: what is left of its
/// diagonal entry is then rounding error. Such a row gets no impulse.
/// \param pivot what elimination has left of the diagonal entry \param original the entry at first
double inverse_pivot(double pivot, double original);

/// A pivot of at most this share of its original diagonal entry is rounding error.
constexpr double dependent_share = sizeof(real) == 4 ? 1e-7 : 1e-11;

// ---- time ---------------------------------------------------------------------------------------

/// Exercise 9.5: one step of second order, Eq. 9-9: step() with Stepping::leapfrog, for a world
/// in which no bound binds. \param solver its blocks are solved once \param h [s]
void second_order_step(World& world, Solver& solver, real h);

/// What Newton's method on the positions may ask for.
class Corrector {
 public:
  virtual ~Corrector() = default;
  /// C of all rows at the bodies' present poses; 0 where no position is held. Yours to change.
  virtual std::vector<double>& errors() = 0;
  /// Changes the velocities so that J V changes by `rates`, with the factor that is there.
  /// \param rates one for each row; used up
  virtual void change_rates(std::vector<double>& rates) = 0;
};

/// The largest share of the error that a Newton iteration may leave.
constexpr double poor_contraction = 0.7;
/// A Newton iteration that stalls with more than this share of the first error has found no pose:
/// what it has done to the velocities may be energy from nowhere.
constexpr double stalled_share = 0.2;
/// Errors of at most this times h^2 need no further iteration [m/s^2 or rad/s^2]: what they change
/// is an acceleration of this size.
constexpr double negligible = sizeof(real) == 4 ? 0.3 : 2e-6;

/// Exercise 9.6: moves the bodies from where they are by their velocities, and changes the
/// velocities until C is negligible at the new poses, Eq. 9-10.
/// \param iterations how often the velocities are changed at most
/// \param start memory for the bodies as they were; what it holds is no matter
/// \return false if it ended, by an iteration that left more than poor_contraction of the error,
/// with more than stalled_share of the first error: there is no such pose near by
bool move_onto_constraints(Bodies& bodies, double h, int iterations, Corrector& corrector,
                           std::vector<Body>& start);

// ---- bounds -------------------------------------------------------------------------------------

/// Where the impulse of a bounded row stands.
enum class Side : signed char {
  lower = -1,  ///< at its lower bound
  free = 0,    ///< between the bounds: its row is an equation
  upper = 1    ///< at its upper bound
};

/// Exercise 9.7: the side on which a row should be in the next pass, Eq. 9-12.
/// \param now its side in this pass \param impulse its accumulated impulse after this pass
/// \param rate J V + bias, the rate that is left of it: the impulse pushes it up
Side next_side(Side now, double impulse, double lower, double upper, double rate);

// ---- inertia ------------------------------------------------------------------------------------

/// A body that turns more slowly for one step: Eq. 9-14, where Eq. 9-13 requires it.
struct Slowed {
  vec3 inverse_inertia_local;  ///< inverse principal moments [1/(kg m^2)], body space
  vec3 w;                      ///< angular velocity [rad/s], world
};

/// Exercise 9.8: a body with as much inertia for one step as the step can follow, Eq. 9-14: no
/// principal moment is less than kappa h^2 |F||r|. Where a moment is larger than in the last step
/// the energy stays, where it is smaller the angular velocity. \param body one that moves
/// \param force_lever the sum of |F||r| over the joints that pull at it [N m]
/// \param before what no moment was less than in the last step [kg m^2]; 0 if there was none
/// \param kappa about 8 [1]
Slowed slowed(const Body& body, real force_lever, real before, real kappa, real h);

}  // namespace joints
/// @}
