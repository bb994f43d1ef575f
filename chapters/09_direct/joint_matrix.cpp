// The matrix of a pair of islands: fill, targets, couplings, and its numbers.
#include "chapters/09_direct/joint_matrix.h"

#include <algorithm>

#include "chapters/09_direct/block_kernels_inline.h"

namespace joints {

#ifdef JOINTS_OF_READER  // the kernels of the reader's file
template void factor_block(double*, int, const double*, PivotInverse);
template void divide(const double*, int, double*);
template void divide_rows(const double*, int, const double*, int, double*);
template void subtract_product(const double*, int, const double*, int, int, double*);
template void subtract_times(const double*, int, int, const double*, double*);
template void subtract_transposed_times(const double*, int, int, const double*, double*);
template void factor_block(TwoLanes*, int, const TwoLanes*, PivotInverse);
template void divide(const TwoLanes*, int, TwoLanes*);
template void divide_rows(const TwoLanes*, int, const TwoLanes*, int, TwoLanes*);
template void subtract_product(const TwoLanes*, int, const TwoLanes*, int, int, TwoLanes*);
template void subtract_times(const TwoLanes*, int, int, const TwoLanes*, TwoLanes*);
template void subtract_transposed_times(const TwoLanes*, int, int, const TwoLanes*, TwoLanes*);
#endif

namespace {

// A += J response^T of the angular parts alone, for n and m half-rows at the same body.
void add_angular(const HalfRowOf<TwoLanes>* J, int n, const HalfRowOf<TwoLanes>* response, int m,
                 TwoLanes* A) {
  with_size(m, [&](auto M) {
    for (int i = 0; i < n; ++i)
      unrolled<M>([&](auto j) { A[i * M + j] += dot(J[i].w, response[j].w); });
  });
}
// The same in the lower triangle of a symmetric n x n block A.
void add_angular_square(const HalfRowOf<TwoLanes>* J, const HalfRowOf<TwoLanes>* response, int n,
                        TwoLanes* A) {
  with_size(n, [&](auto N) {
    unrolled<N>([&](auto i) {
      unrolled<i + 1>([&](auto j) { A[i * N + j] += dot(J[i].w, response[j].w); });
    });
  });
}

}  // namespace

// Finds the nodes of the blocks, and their rows.
void IslandMatrix::make_nodes() {
  A.nodes.clear();
  nodes.clear();
  first_.clear();
  int row = 0;
  rows_ = 0;
  for (const LaneBlock& block : blocks) {
    if (block.place == int(first_.size())) first_.push_back(block.node);
    if (block.first == 0) {
      A.nodes.push_back({0, row, 0, 0});
      nodes.push_back({block.columns, block.form, block.lanes()});
    } else if (block.form != Form::angular) {
      nodes.back().form = Form::any;
    }
    A.nodes.back().rows += block.rows;
    row += block.rows;
    rows_ += block.own[0] + block.own[1];
  }
  first_.push_back(int(nodes.size()));
}

// Places nodes and edges, including the edges of fill-in.
void IslandMatrix::lay_out() {
  make_nodes();
  const int count = int(nodes.size());
  const auto coupled = [&](const LaneNode& a, const LaneNode& b) {
    for (const int one : a.columns)
      for (const int other : b.columns)
        if (one == other && moves[one]) return true;
    return false;
  };
  A.edges.clear();
  int numbers = 0;
  multiplications_ = 0;
  fill_ = 0;
  for (int place = 0, k = 0; place + 1 < int(first_.size()); ++place)
    for (; k < first_[place + 1]; ++k) {
      Node& node = A.nodes[k];
      const int n = node.rows;
      node.diagonal = numbers, node.first_edge = int(A.edges.size());
      numbers += n * n;
      int below = 0;
      const auto add_edges = [&](int from, int end) {
        for (int to = from; to < end; ++to) {
          const int m = A.nodes[to].rows;
          A.edges.push_back({to, numbers});
          numbers += m * n;
          below += m;
          if (!coupled(nodes[k], nodes[to])) fill_ += nodes[k].lanes * m * n;
        }
      };
      add_edges(k + 1, first_[place + 1]);
      for (const int later : plan->later[place]) add_edges(first_[later], first_[later + 1]);
      multiplications_ += nodes[k].lanes * n * (n + below) * (n + below) / 2.0;
    }
  const int row = A.nodes.back().row + A.nodes.back().rows;
  A.nodes.push_back({0, row, numbers, int(A.edges.size())});
  zeros(A.numbers, std::size_t(numbers));
  zeros(A.original, std::size_t(row));
  zeros(J, std::size_t(2 * row));
  for (int k = 0; k < count; ++k)
    for (const int of : {0, 1}) {
      if (nodes[k].form != Form::point) continue;
      HalfRowOf<TwoLanes>* const half = &J[2 * A.nodes[k].row + of * A.nodes[k].rows];
      const TwoLanes one = TwoLanes{} + (of == 0 ? -1.0 : 1.0);
      half[0].v.x = half[1].v.y = half[2].v.z = one;
    }
  zeros(masses, moves.size());
  A.targets.clear();
  for (int k = 0; k < count; ++k)
    for (int j = A.nodes[k].first_edge; j < A.nodes[k + 1].first_edge; ++j)
      for (int i = j; i < A.nodes[k + 1].first_edge; ++i)
        A.targets.push_back(at(A.edges[i].to, A.edges[j].to));
  place_couplings();
}

void IslandMatrix::make_room() {
  const auto reserve = [](int times, auto&... lists) {
    (lists.reserve(std::size_t(times) * lists.size()), ...);
  };
  reserve(2, A.nodes, A.numbers, A.original, nodes, blocks, J, first_, couplings_end_);
  reserve(8, A.edges, A.targets, couplings_);  // between all nodes of neighbours
}

// Where the block between two nodes begins. \param later, earlier places in the order
int IslandMatrix::at(int later, int earlier) const {
  if (later == earlier) return A.nodes[earlier].diagonal;
  const auto begin = A.edges.begin() + A.nodes[earlier].first_edge;
  const auto end = A.edges.begin() + A.nodes[earlier + 1].first_edge;
  return std::lower_bound(begin, end, later, [](const Edge& edge, int to) {
           return edge.to < to;
         })->at;
}

void IslandMatrix::place_couplings() {
  couplings_.clear();
  couplings_end_.clear();
  for (int k = 0; k < int(nodes.size()); ++k)
    for (const int of : {0, 1}) {
      const int column = nodes[k].columns[of];
      const auto add = [&](int other, int half, int at) {
        const Form one = nodes[k].form, two = nodes[other].form;
        const auto& [rows, row, diagonal, edge] = A.nodes[other];
        const bool points = one == Form::point && two == Form::point;
        couplings_.push_back({2 * row + half * rows, rows, at,
                              one == Form::any || two == Form::any,
                              !points ? 0.0 : half == of ? 1.0 : -1.0});
      };
      if (moves[column]) add(k, of, A.nodes[k].diagonal);
      for (int j = A.nodes[k].first_edge; moves[column] && j < A.nodes[k + 1].first_edge; ++j)
        for (const int half : {0, 1}) {
          const auto& [to, at] = A.edges[j];
          if (nodes[to].columns[half] == column) add(to, half, at);
        }
      couplings_end_.push_back(int(couplings_.size()));
    }
}

void IslandMatrix::assemble() {
  const Coupling* coupling = couplings_.data();
  for (int k = 0; k < int(nodes.size()); ++k) {
    std::fill(&A.numbers[A.nodes[k].diagonal], A.numbers.data() + A.nodes[k + 1].diagonal,
              TwoLanes{});
    const int n = A.nodes[k].rows;
    for (const int of : {0, 1}) {
      const HalfRowOf<TwoLanes>* const half = &J[2 * A.nodes[k].row + of * n];
      const InverseMassOf<TwoLanes>& mass = masses[nodes[k].columns[of]];
      const Coupling* const end = couplings_.data() + couplings_end_[2 * k + of];
      HalfRowOf<TwoLanes> response[6];
      for (int r = 0; coupling != end && r < n; ++r) response[r].w = mass.angular * half[r].w;
      for (; coupling != end; ++coupling) {
        const auto& [other, m, at, any, units] = *coupling;
        TwoLanes* const to = &A.numbers[at];
        if (any) add_coupling(&J[other], m, half, n, mass, to);
        else if (&J[other] == half) add_angular_square(half, response, n, to);
        else add_angular(&J[other], m, response, n, to);
        const TwoLanes of_points = units * mass.linear;
        for (int i = 0; i < 3 && units != 0; ++i) to[i * (n + 1)] += of_points;
      }
    }
  }
}

}  // namespace joints
