// Chapter 9: the direct solver. Replace each todo(...) by your own code; the text is in README.md.
#include "chapters/09_direct/direct.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "chapters/09_direct/block_kernels.h"
#include "engine/instruments/todo.h"

namespace joints {

// ---- the matrix of the joints -------------------------------------------------------------------

void add_coupling(const HalfRow* J, int n, const HalfRow* other, int m, const InverseMass& mass,
                  double* A) {
  // begin [exercise 9.1]
  // Add the contribution of one common body to the coupling of two blocks: by how much does the
  // rate of each row of the first block change if one unit impulse acts along a row of the second?
  todo("9.1");
  // end [exercise 9.1]
}

void factor(JointMatrix& A, PivotInverse inverse) {
  double* const number = A.numbers.data();
  const int* target = A.targets.data();
  // begin [exercise 9.2]
  // Factor A = L D L^T in place, Eq. 9-4. The kernels are in block_kernels.h; L has up to 6 x 6
  // numbers. A.targets lists where products are subtracted: node after node, edge j after edge j of
  // a node, one product for every edge i from j on.
  todo("9.2");
  // end [exercise 9.2]
}

void solve(const JointMatrix& A, double* x) {
  const double* const number = A.numbers.data();
  // begin [exercise 9.2]
  // Solve A x = b with the factor, Eq. 9-5; x holds b at first. The kernels are in block_kernels.h.
  todo("9.2");
  // end [exercise 9.2]
}

std::vector<int> elimination_order(std::vector<std::vector<int>> neighbours) {
  std::vector<int> order;
  // begin [exercise 9.3]
  // Return the nodes in an order with little fill-in: that of the text's rule, or any other one
  // that leaves at most a tenth more blocks in L.
  todo("9.3");
  // end [exercise 9.3]
  return order;
}

double inverse_pivot(double pivot, double original) {
  // begin [exercise 9.4]
  // Return 1 / pivot, or 0 if the pivot is only a rounding error. The rule that decides is yours.
  todo("9.4");
  // end [exercise 9.4]
}

// ---- time ---------------------------------------------------------------------------------------

void second_order_step(World& world, Solver& solver, real h) {
  // begin [exercise 9.5]
  // Advance the world by one step of second order with all its joints: Eq. 9-9, then all that the
  // poses need, symmetric in time. The solver starts cold. world.last_h is the length of the last
  // step, and 0 before the first one.
  todo("9.5");
  // end [exercise 9.5]
}

bool move_onto_constraints(Bodies& bodies, double h, int iterations, double tolerance,
                           Corrector& corrector, std::vector<Body>& start) {
  // begin [exercise 9.6]
  // Change the velocities until the bodies end where all errors are at most the tolerance, by
  // Eq. 9-10. Store the bodies in `start` before each move: it changes poses and angular
  // velocities. The condition for stopping and the result are stated in direct.h.
  todo("9.6");
  // end [exercise 9.6]
}

// ---- bounds -------------------------------------------------------------------------------------

Side next_side(Side now, double impulse, double lower, double upper, double rate) {
  // begin [exercise 9.7]
  // Return the side of the row in the next pass. A row that satisfies Eq. 9-12 on its side stays
  // there. Which of its two numbers shows that it does not, and where does it go then?
  todo("9.7");
  // end [exercise 9.7]
}

// ---- inertia ------------------------------------------------------------------------------------

Slowed slowed(const Body& body, const vec3& force_lever, const vec3& before, real kappa, real h) {
  Slowed out;
  // begin [exercise 9.8]
  // Raise the moments that this step cannot follow, Eq. 9-13, by as little as possible, and return
  // the inverses of all three and the angular velocity. `before` is what the last step could
  // follow. min(), max(), sqrt(), products and quotients of two vec3 act component by component.
  todo("9.8");
  // end [exercise 9.8]
  return out;
}

}  // namespace joints
