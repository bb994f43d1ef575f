// Chapter 9: all joints at once. The functions of direct.cpp. Read README.md beside it first.
// There is nothing to edit here.
#pragma once

#include <vector>

#include "engine/steps/step.h"

/// \defgroup chapter9 Chapter 9: the direct solver
/// \brief All joints solved at once: the sparse matrix of the joints, its factor, and a motion of
/// second order in time.
/// @{
namespace joints {

// ---- the matrix of the joints -------------------------------------------------------------------

/// The half of a row that belongs to one body: the factors of its velocities.
struct HalfRow {
  glm::dvec3 v;  ///< linear
  glm::dvec3 w;  ///< angular
};

/// What a body opposes to impulses; zeros for a static body.
struct InverseMass {
  double linear = 0;        ///< inverse mass [1/kg]
  glm::dmat3 angular{0.0};  ///< inverse inertia [1/(kg m^2)], world axes
};

#ifndef JOINTS_LIBRARY  // exercises, which programs that link the library do not see
/// Exercise 9.1: the coupling of two blocks through a common body, Eq. 9-2. Adds to A[i][j] the
/// rate of row i of the first block per unit impulse along row j of the second one.
/// \param J the half-rows of the first block at the common body, n of them
/// \param other the half-rows of the second block at that body, m of them
/// \param mass of that body \param A n x m numbers, row by row
void add_coupling(const HalfRow* J, int n, const HalfRow* other, int m, const InverseMass& mass,
                  double* A);
#endif

/// A block of rows as a node of the joint graph, in the order of elimination.
struct Node {
  int rows;        ///< number of its rows, 1 to 6
  int row;         ///< where its numbers begin in the right-hand side
  int diagonal;    ///< where its rows x rows numbers begin in JointMatrix::numbers
  int first_edge;  ///< its first edge; they end before the first edge of the next node
};

/// The block of the matrix between a node and a neighbour that is eliminated later.
struct Edge {
  int to;  ///< the neighbour
  int at;  ///< where its numbers begin: rows of the neighbour x rows of the node, row by row
};

/// A = J M^-1 J^T of all joints (Eq. 9-2, eliminated by Eq. 9-4). It is symmetric, and zero
/// wherever two blocks have no moving body in common. Stored are the diagonal blocks, the nonzero
/// blocks below them, and the blocks that elimination fills in.
struct JointMatrix {
  std::vector<Node> nodes;       ///< in the order of elimination, and one more after the last
  std::vector<Edge> edges;       ///< of all nodes; those of a node in the order of elimination
  std::vector<int> targets;      ///< where elimination subtracts its products, in sequence
  std::vector<double> numbers;   ///< of all blocks
  std::vector<double> original;  ///< the original diagonal; that of a node begins at node.row
};

/// Returns 1 / pivot, or 0. \param original the diagonal entry before any elimination
using PivotInverse = double (*)(double pivot, double original);

#ifndef JOINTS_LIBRARY  // exercises, which programs that link the library do not see
/// Exercise 9.2, first half: factors A = L D L^T in place, node after node, Eq. 9-4. After it, each
/// diagonal block contains its own factor (factor_block), and each edge contains its block of L.
void factor(JointMatrix& A, PivotInverse inverse);

/// Exercise 9.2, second half: solves A x = b with the factor, Eq. 9-5. \param x b, then x
void solve(const JointMatrix& A, double* x);

/// Exercise 9.3: an order of elimination with little fill-in, such as that of the rule: the next
/// node is always one with the fewest remaining neighbours.
/// \param neighbours of each node, without itself; each pair is in both lists
/// \return the nodes in the order of elimination
std::vector<int> elimination_order(std::vector<std::vector<int>> neighbours);
#endif

/// Exercise 9.4: 1 / pivot, or 0 for a row that depends on the rows before it, whose pivot is only
/// a rounding error. Such a row gets no impulse. The tests draw rows of any unit and
/// mass. The first 12 digits of a dependent row cancel (`float`: 9), and at most 8 digits of a row
/// that is needed (`float`: 5).
/// \param pivot the diagonal entry after elimination, 0 or more but for rounding errors
/// \param original the entry before elimination, 0 or more
double inverse_pivot(double pivot, double original);

// ---- time ---------------------------------------------------------------------------------------

#ifndef JOINTS_LIBRARY  // exercises, which programs that link the library do not see
/// Exercise 9.5: one step of second order, Eq. 9-9: step() with StepOptions::leapfrog, for a world
/// of hard joints in which no row is at a bound. \param solver its blocks are solved once
/// \param h [s]
void second_order_step(World& world, Solver& solver, real h);
#endif

/// The operations that Newton's method on the positions uses.
class Corrector {
 public:
  virtual ~Corrector() = default;
  /// C of all rows at the present poses, 0 for rows without a position error. You may change it.
  virtual std::vector<double>& errors() = 0;
  /// Changes the velocities so that J V changes by `rates`, with the present factor.
  /// \param rates one for each row; overwritten
  virtual void change_rates(std::vector<double>& rates) = 0;
};

/// If a Newton iteration multiplies the error by more than this, the method stops.
constexpr double poor_contraction = 0.7;

#ifndef JOINTS_LIBRARY  // exercises, which programs that link the library do not see
/// Exercise 9.6: moves the bodies by their velocities, and changes the velocities until C is at
/// most `tolerance` at the new poses, Eq. 9-10.
/// \param iterations how often the velocities are changed at most
/// \param tolerance the largest error that is accepted [m or rad]
/// \param start receives the bodies before the last move; its former contents do not matter
/// \param corrector its errors are numbers: none is undefined
/// \return true if every error at the new poses is at most `tolerance`; false if the iterations
/// were used up, or if one of them multiplied the error by more than poor_contraction
bool move_onto_constraints(Bodies& bodies, double h, int iterations, double tolerance,
                           Corrector& corrector, std::vector<Body>& start);
#endif

// ---- bounds -------------------------------------------------------------------------------------

/// The side of a bounded row.
enum class Side : signed char {
  lower = -1,  ///< at its lower bound
  free = 0,    ///< between the bounds: its row is an equation
  upper = 1    ///< at its upper bound
};

#ifndef JOINTS_LIBRARY  // exercises, which programs that link the library do not see
/// Exercise 9.7: the side on which a row should be in the next pass, Eq. 9-12.
/// \param now its side in this pass \param impulse its accumulated impulse after this pass
/// \param rate J V + bias after this pass; a larger impulse makes it larger
Side next_side(Side now, double impulse, double lower, double upper, double rate);
#endif

// ---- inertia ------------------------------------------------------------------------------------

/// The inertia and angular velocity of a body with added inertia for one step, Eq. 9-14.
struct Slowed {
  vec3 inverse_inertia_local{0};  ///< inverse principal moments [1/(kg m^2)], body space
  vec3 w{0};                      ///< angular velocity [rad/s], world
};

#ifndef JOINTS_LIBRARY  // exercises, which programs that link the library do not see
/// Exercise 9.8: enough inertia for the step to follow the zigzag of a body: about each principal
/// axis h nu is at most 1 / sqrt(kappa), Eq. 9-13. Where a moment is larger than in the last step,
/// the energy of the rotation is kept; where it is smaller, the angular velocity.
/// \param body a moving body; it has its own moments, however often they were raised
/// \param force_lever about each principal axis i, the sum of |F| (|r|^2 - r_i^2) / |r| over the
/// joints that pull at it [N m, body space]
/// \param before the least moments that the last step could follow [kg m^2]; 0 if there was none
/// \param kappa about 8 [1]
Slowed slowed(const Body& body, const vec3& force_lever, const vec3& before, real kappa, real h);
#endif

}  // namespace joints
/// @}
