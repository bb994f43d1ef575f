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
  for (int j = 0; j < m; ++j) {
    const HalfRow response{mass.linear * other[j].v, mass.angular * other[j].w};
    for (int i = 0; i < n; ++i)
      A[i * m + j] += dot(J[i].v, response.v) + dot(J[i].w, response.w);  // Eq. 9-2
  }
  // end [exercise 9.1]
}

void factor(JointMatrix& A, PivotInverse inverse) {
  double* const number = A.numbers.data();
  const int* target = A.targets.data();
  // begin [exercise 9.2]
  // Factor A = L D L^T in place, Eq. 9-4. The kernels are in block_kernels.h; L has up to 6 x 6
  // numbers. A.targets lists where products are subtracted: node after node, edge j after edge j of
  // a node, one product for every edge i from j on.
  double L[36];
  for (std::size_t k = 0; k + 1 < A.nodes.size(); ++k) {
    const Node& node = A.nodes[k];
    const int n = node.rows, end = A.nodes[k + 1].first_edge;
    double* const D = number + node.diagonal;
    factor_block(D, n, &A.original[std::size_t(node.row)], inverse);
    for (int j = node.first_edge; j < end; ++j) {
      const int m = A.nodes[std::size_t(A.edges[j].to)].rows;
      double* const block = number + A.edges[j].at;
      divide_rows(block, m, D, n, L);
      for (int i = j; i < end; ++i)
        subtract_product(number + A.edges[i].at, A.nodes[A.edges[i].to].rows, L, m, n,
                         number + *target++);  // Eq. 9-4
      std::copy(L, L + m * n, block);
    }
  }
  // end [exercise 9.2]
}

void solve(const JointMatrix& A, double* x) {
  const double* const number = A.numbers.data();
  // begin [exercise 9.2]
  // Solve A x = b with the factor, Eq. 9-5; x holds b at first. The kernels are in block_kernels.h.
  const int count = int(A.nodes.size()) - 1;
  for (int k = 0; k < count; ++k) {
    const Node& node = A.nodes[k];
    for (int j = node.first_edge; j < A.nodes[k + 1].first_edge; ++j) {
      const Node& to = A.nodes[A.edges[j].to];
      subtract_times(number + A.edges[j].at, to.rows, node.rows, x + node.row, x + to.row);
    }
    divide(number + node.diagonal, node.rows, x + node.row);
  }
  for (int k = count - 1; k >= 0; --k) {
    const Node& node = A.nodes[k];
    for (int j = node.first_edge; j < A.nodes[k + 1].first_edge; ++j) {
      const Node& to = A.nodes[A.edges[j].to];
      subtract_transposed_times(number + A.edges[j].at, to.rows, node.rows, x + to.row,
                                x + node.row);  // Eq. 9-5
    }
  }
  // end [exercise 9.2]
}

std::vector<int> elimination_order(std::vector<std::vector<int>> neighbours) {
  std::vector<int> order;
  // begin [exercise 9.3]
  // Return the nodes in an order with little fill-in: that of the text's rule, or any other one
  // that leaves at most a tenth more blocks in L.
  std::vector<std::set<int>> left;
  std::set<std::pair<std::size_t, int>> queue;
  for (const std::vector<int>& of_one : neighbours) {
    left.emplace_back(of_one.begin(), of_one.end());
    queue.insert({left.back().size(), int(left.size()) - 1});
  }
  while (!queue.empty()) {
    const int node = queue.begin()->second;
    queue.erase(queue.begin());
    order.push_back(node);
    for (const int a : left[node]) {
      queue.erase({left[a].size(), a});
      left[a].erase(node);
      for (const int b : left[node])
        if (b != a) left[a].insert(b);
      queue.insert({left[a].size(), a});
    }
  }
  // end [exercise 9.3]
  return order;
}

double inverse_pivot(double pivot, double original) {
  // begin [exercise 9.4]
  // Return 1 / pivot, or 0 if the pivot is only a rounding error. The rule that decides is yours.
  const double fraction = sizeof(real) == 4 ? 1e-7 : 1e-11;
  return pivot > fraction * original ? 1 / pivot : 0;  // Eq. 9-8
  // end [exercise 9.4]
}

// ---- time ---------------------------------------------------------------------------------------

void second_order_step(World& world, Solver& solver, real h) {
  // begin [exercise 9.5]
  // Advance the world by one step of second order with all its joints: Eq. 9-9, then all that the
  // poses need, symmetric in time. The solver starts cold. world.last_h is the length of the last
  // step, and 0 before the first one.
  integrate_forces(world.bodies, world.gravity, (world.last_h + h) / 2);  // Eq. 9-9
  world.last_h = h;
  world.blocks.clear();
  for (const auto& joint : world.joints()) joint->begin_step(world.bodies, h);
  for (const auto& joint : world.joints()) joint->append(world.bodies, world.blocks);
  solver.prepare(world.bodies, world.blocks, 0, h);
  solver.warm_start(world.bodies, 0);
  solver.solve(world.bodies);
  integrate_poses(world.bodies, h);
  // end [exercise 9.5]
}

bool move_onto_constraints(Bodies& bodies, double h, int iterations, double tolerance,
                           Corrector& corrector, std::vector<Body>& start) {
  // begin [exercise 9.6]
  // Change the velocities until the bodies end where all errors are at most the tolerance, by
  // Eq. 9-10. Store the bodies in `start` before each move: it changes poses and angular
  // velocities. The condition for stopping and the result are stated in direct.h.
  double last = std::numeric_limits<double>::infinity();
  for (int n = 0;; ++n) {
    start.assign(bodies.data(), bodies.data() + bodies.slots());
    integrate_poses(bodies, real(h));
    std::vector<double>& rates = corrector.errors();
    double largest = 0;
    for (double& C : rates) {
      largest = std::max(largest, std::abs(C));
      C /= -h;  // Eq. 9-10
    }
    if (largest <= tolerance) return true;
    if (n == iterations || !(largest <= poor_contraction * last)) return false;
    last = largest;
    std::copy(start.begin(), start.end(), bodies.data());
    corrector.change_rates(rates);
  }
  // end [exercise 9.6]
}

// ---- bounds -------------------------------------------------------------------------------------

Side next_side(Side now, double impulse, double lower, double upper, double rate) {
  // begin [exercise 9.7]
  // Return the side of the row in the next pass. A row that satisfies Eq. 9-12 on its side stays
  // there. Which of its two numbers shows that it does not, and where does it go then?
  if (now == Side::free)
    return impulse < lower ? Side::lower : impulse > upper ? Side::upper : Side::free;
  if (now == Side::lower) return rate < 0 ? Side::free : now;
  return rate > 0 ? Side::free : now;  // Eq. 9-12
  // end [exercise 9.7]
}

// ---- inertia ------------------------------------------------------------------------------------

Slowed slowed(const Body& body, const vec3& force_lever, const vec3& before, real kappa, real h) {
  Slowed out;
  // begin [exercise 9.8]
  // Raise the moments that this step cannot follow, Eq. 9-13, by as little as possible, and return
  // the inverses of all three and the angular velocity. `before` is what the last step could
  // follow. min(), max(), sqrt(), products and quotients of two vec3 act component by component.
  const vec3 moments = real(1) / body.inverse_inertia_local;
  const vec3 now = max(moments, kappa * h * h * force_lever);
  const vec3 ratio = min(vec3(1), max(moments, before) / now);
  out.inverse_inertia_local = real(1) / now;
  out.w = to_world(body, sqrt(ratio) * to_local(body, body.w));  // Eq. 9-14
  // end [exercise 9.8]
  return out;
}

}  // namespace joints
