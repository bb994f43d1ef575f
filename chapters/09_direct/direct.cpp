// Chapter 9: the direct solver. Replace each todo(...) by your own code; the text is in README.md.
#include "chapters/09_direct/direct.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "chapters/09_direct/block_kernels.h"
#include "engine/todo.h"

namespace joints {

// ---- the matrix of the joints -------------------------------------------------------------------

template <class Number>
void add_coupling(const HalfRowOf<Number>* J, int n, const HalfRowOf<Number>* response, int m,
                  Number* A) {
  // begin [exercise 9.1]
  // Eq. 9-2: entry (i, j) grows by dot(J[i].v, response[j].v) + dot(J[i].w, response[j].w). Entry
  // (i, j) stands at A[i * m + j].
  todo("9.1");
  // end [exercise 9.1]
}

template <class Number>
void factor(JointMatrixOf<Number>& A, PivotInverse inverse) {
  Number* const number = A.numbers.data();
  const int* target = A.targets.data();
  // begin [exercise 9.2]
  // For each node k but the one behind the last: factor_block() its diagonal block. Then, for each
  // of its edges j in turn: L = divide_rows() of the edge's block, in 36 numbers of its own;
  // subtract_product() of the block of every edge i, from j on, and of L, at number[*target++]
  // (Eq. 9-4); at last the edge's block becomes L. Where each target lies has been worked out
  // before, in just this order.
  todo("9.2");
  // end [exercise 9.2]
}

template <class Number>
void solve(const JointMatrixOf<Number>& A, Number* x) {
  const Number* const number = A.numbers.data();
  // begin [exercise 9.2]
  // Forward, for each node k: subtract_times() of its edges' blocks and of its own numbers from the
  // numbers of the edge's other node; then divide() its own by the diagonal block. Back, from the
  // last node to the first: subtract_transposed_times() of its edges' blocks and of the other
  // node's numbers from its own. Eq. 9-5.
  todo("9.2");
  // end [exercise 9.2]
}

// Numbers of both kinds.
template void add_coupling(const HalfRow*, int, const HalfRow*, int, double*);
template void add_coupling(const HalfRowOf<TwoLanes>*, int, const HalfRowOf<TwoLanes>*, int,
                           TwoLanes*);
template void factor(JointMatrix&, PivotInverse);
template void factor(JointMatrixOf<TwoLanes>&, PivotInverse);
template void solve(const JointMatrix&, double*);
template void solve(const JointMatrixOf<TwoLanes>&, TwoLanes*);

std::vector<int> elimination_order(std::vector<std::vector<int>> neighbours) {
  std::vector<int> order;
  // begin [exercise 9.3]
  // Keep the neighbours that are left of each node in a std::set<int>, and the nodes themselves in
  // a std::set of pairs (number of neighbours, node), whose first one is next. A node
  // that is eliminated leaves the sets of its neighbours, and these become neighbours of each
  // other: the fill-in.
  todo("9.3");
  // end [exercise 9.3]
  return order;
}

double inverse_pivot(double pivot, double original) {
  // begin [exercise 9.4]
  // Compare the pivot with dependent_share of its original entry. Both may be zero.
  todo("9.4");
  // end [exercise 9.4]
}

// ---- time ---------------------------------------------------------------------------------------

void second_order_step(World& world, Solver& solver, real h) {
  // begin [exercise 9.5]
  // kick() the bodies for the mean of world.last_h and h, which is then the new world.last_h. Clear
  // world.blocks; let each joint begin_step() and append() its blocks; prepare(), warm_start() with
  // 0 and solve(). Then turn() the bodies for h/2, integrate_poses(), and turn() again: Eq. 9-9.
  todo("9.5");
  // end [exercise 9.5]
}

bool move_onto_constraints(Bodies& bodies, double h, int iterations, Corrector& corrector,
                           std::vector<Body>& start) {
  // begin [exercise 9.6]
  // Keep the bodies in `start`. In each iteration: integrate_poses() for real(h); ask for the
  // errors() there and find the largest. If it is at most negligible h^2, all is done. If it is
  // more than poor_contraction of the one before, stop: the answer is true if it is at most
  // stalled_share of the first. Else change_rates() by -C/h (Eq. 9-10), and put back x and q of
  // every slot from `start`. After the last iteration integrate_poses() for good: true.
  todo("9.6");
  // end [exercise 9.6]
}

// ---- bounds -------------------------------------------------------------------------------------

Side next_side(Side now, double impulse, double lower, double upper, double rate) {
  // begin [exercise 9.7]
  // A free impulse must be between its bounds. At the lower bound the rate must not be negative, or
  // a larger impulse would help; at the upper bound it must not be positive. Eq. 9-12.
  todo("9.7");
  // end [exercise 9.7]
}

// ---- inertia ------------------------------------------------------------------------------------

Slowed slowed(const Body& body, real force_lever, real before, real kappa, real h) {
  Slowed out;
  // begin [exercise 9.8]
  // Find the moments, 1 / body.inverse_inertia_local. Each becomes at least what the step can
  // follow, kappa h^2 |F||r|; in the last step each was at least `before`. About an axis of the
  // body's own whose moment is larger than in the last step the energy stays: the angular velocity
  // takes the root of their ratio. Elsewhere the angular velocity stays (Eq. 9-14). to_local() and
  // to_world() turn it; min(), max(), sqrt(), products and quotients of two vec3 go component by
  // component.
  todo("9.8");
  // end [exercise 9.8]
  return out;
}

}  // namespace joints
