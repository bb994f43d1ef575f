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
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
      A[i * m + j] += dot(J[i].v, response[j].v) + dot(J[i].w, response[j].w);  // Eq. 9-2
  // end [exercise 9.1]
}

template <class Number>
void factor(JointMatrixOf<Number>& A, PivotInverse inverse) {
  Number* const number = A.numbers.data();
  const int* target = A.targets.data();
  // begin [exercise 9.2]
  // For each node k except the last entry: factor_block() factors its diagonal block. Then, for
  // each edge j of the node: divide_rows() writes L, computed from the block of edge j, to 36
  // separate numbers. For every edge i from j on, subtract_product() subtracts the product of the
  // block of edge i and of L at number[*target++] (Eq. 9-4). Finally copy L to the block of edge j.
  // The targets are stored in exactly this order.
  Number L[36];
  for (std::size_t k = 0; k + 1 < A.nodes.size(); ++k) {
    const Node& node = A.nodes[k];
    const int n = node.rows, end = A.nodes[k + 1].first_edge;
    Number* const D = number + node.diagonal;
    factor_block(D, n, &A.original[std::size_t(node.row)], inverse);
    for (int j = node.first_edge; j < end; ++j) {
      const int m = A.nodes[std::size_t(A.edges[j].to)].rows;
      Number* const block = number + A.edges[j].at;
      divide_rows(block, m, D, n, L);
      for (int i = j; i < end; ++i)
        subtract_product(number + A.edges[i].at, A.nodes[A.edges[i].to].rows, L, m, n,
                         number + *target++);  // Eq. 9-4
      std::copy(L, L + m * n, block);
    }
  }
  // end [exercise 9.2]
}

template <class Number>
void solve(const JointMatrixOf<Number>& A, Number* x) {
  const Number* const number = A.numbers.data();
  // begin [exercise 9.2]
  // Forward, for each node k: for each of its edges, subtract_times() subtracts the edge's block
  // times the numbers of node k from the numbers of the edge's other node. Then divide() divides
  // the numbers of node k by its diagonal block. Back, from the last node to the first: for each
  // edge, subtract_transposed_times() subtracts the transposed block times the numbers of the other
  // node from those of node k. Eq. 9-5.
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

// For both kinds of numbers.
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
  // Keep the remaining neighbours of each node in a std::set<int>, and the nodes in a std::set of
  // pairs (number of neighbours, node): its first element is the next node. When a node is
  // eliminated, remove it from the sets of its neighbours, and make these neighbours of each other:
  // that is the fill-in.
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
  // Compare the pivot with dependent_share of its original entry. Both may be zero.
  return pivot > dependent_share * original ? 1 / pivot : 0;
  // end [exercise 9.4]
}

// ---- time ---------------------------------------------------------------------------------------

void second_order_step(World& world, Solver& solver, real h) {
  // begin [exercise 9.5]
  // kick() the bodies for the mean of world.last_h and h, which is then the new world.last_h. Clear
  // world.blocks; let each joint begin_step() and append() its blocks; prepare(), warm_start() with
  // 0 and solve(). Then turn() the bodies for h/2, integrate_poses(), and turn() again: Eq. 9-9.
  kick(world.bodies, world.gravity, (world.last_h + h) / 2);
  world.last_h = h;
  world.blocks.clear();
  for (const auto& joint : world.joints()) joint->begin_step(world.bodies, h);
  for (const auto& joint : world.joints()) joint->append(world.bodies, world.blocks);
  solver.prepare(world.bodies, world.blocks, 0, h);
  solver.warm_start(world.bodies, 0);
  solver.solve(world.bodies);
  turn(world.bodies, h / 2);
  integrate_poses(world.bodies, h);
  turn(world.bodies, h / 2);  // Eq. 9-9
  // end [exercise 9.5]
}

bool move_onto_constraints(Bodies& bodies, double h, int iterations, Corrector& corrector,
                           std::vector<Body>& start) {
  // begin [exercise 9.6]
  // Store the bodies in `start`. In each iteration: integrate_poses() for real(h), and find the
  // largest of the errors() there. If it is at most negligible h^2, return true. If it is more than
  // poor_contraction times the one before, stop: return whether it is at most stalled_share times
  // the first. Otherwise change_rates() by -C/h (Eq. 9-10), and restore x and q of every slot from
  // `start`. After the last iteration integrate_poses() once more and return true.
  start.assign(bodies.data(), bodies.data() + bodies.slots());
  double first = 0, last = std::numeric_limits<double>::infinity();
  for (int n = 0; n < iterations; ++n) {
    integrate_poses(bodies, real(h));
    std::vector<double>& rates = corrector.errors();
    double largest = 0;
    for (double& C : rates) {
      largest = std::max(largest, std::abs(C));
      C /= -h;  // Eq. 9-10
    }
    if (n == 0) first = largest;
    if (largest <= negligible * h * h) return true;
    if (!(largest <= poor_contraction * last)) return largest <= stalled_share * first;
    last = largest;
    corrector.change_rates(rates);
    for (int slot = 0; slot < bodies.slots(); ++slot)
      bodies.at(slot).x = start[slot].x, bodies.at(slot).q = start[slot].q;
  }
  integrate_poses(bodies, real(h));
  return true;
  // end [exercise 9.6]
}

// ---- bounds -------------------------------------------------------------------------------------

Side next_side(Side now, double impulse, double lower, double upper, double rate) {
  // begin [exercise 9.7]
  // A free impulse must be between its bounds. At the lower bound the rate must not be negative, or
  // a larger impulse would help; at the upper bound it must not be positive. Eq. 9-12.
  if (now == Side::free)
    return impulse < lower ? Side::lower : impulse > upper ? Side::upper : Side::free;
  if (now == Side::lower) return rate < 0 ? Side::free : now;
  return rate > 0 ? Side::free : now;  // Eq. 9-12
  // end [exercise 9.7]
}

// ---- inertia ------------------------------------------------------------------------------------

Slowed slowed(const Body& body, real force_lever, real before, real kappa, real h) {
  Slowed out;
  // begin [exercise 9.8]
  // Compute the moments, 1 / body.inverse_inertia_local. Raise each to at least kappa h^2 |F||r|,
  // so that the step can follow the motion; in the last step each was at least `before`. About a
  // principal axis whose moment is larger than in the last step the energy is kept: multiply the
  // angular velocity by the root of the ratio of the moments. About the others keep the angular
  // velocity (Eq. 9-14). to_local() and to_world() rotate it; min(), max(), sqrt(), products and
  // quotients of two vec3 act component by component.
  const vec3 moments = real(1) / body.inverse_inertia_local;
  const vec3 now = max(moments, vec3(kappa * h * h * force_lever));
  const vec3 ratio = min(vec3(1), max(moments, vec3(before)) / now);
  out.inverse_inertia_local = real(1) / now;
  out.w = to_world(body, sqrt(ratio) * to_local(body, body.w));  // Eq. 9-14
  // end [exercise 9.8]
  return out;
}

}  // namespace joints
