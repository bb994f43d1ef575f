// The matrix of a pair of islands: fill, targets, couplings, and its numbers.
#include "chapters/09_direct/joint_matrix.h"

#include <algorithm>

namespace joints {

// Places nodes and edges, including the edges of fill-in.
void IslandMatrix::lay_out() {
  const int count = int(blocks.size());
  first_.assign(plan->links.size() + 1, count);
  for (int k = count - 1; k >= 0; --k) first_[blocks[k].place] = k;
  const auto coupled = [&](const LaneBlock& a, const LaneBlock& b) {
    for (const int one : a.columns)
      for (const int other : b.columns)
        if (one == other && moves[one]) return true;
    return false;
  };
  A.nodes.clear();
  A.edges.clear();
  int row = 0, numbers = 0;
  multiplications_ = 0;
  fill_ = rows_ = 0;
  for (int k = 0; k < count; ++k) {
    const int n = blocks[k].rows, lanes = blocks[k].lanes();
    A.nodes.push_back({n, row, numbers, int(A.edges.size())});
    row += n;
    rows_ += blocks[k].own[0] + blocks[k].own[1];
    numbers += n * n;
    int below = 0;
    const auto add_edges = [&](int from, int end) {
      for (int to = from; to < end; ++to) {
        const int m = blocks[to].rows;
        A.edges.push_back({to, numbers});
        numbers += m * n;
        below += m;
        if (!coupled(blocks[k], blocks[to])) fill_ += lanes * m * n;
      }
    };
    const int place = blocks[k].place;
    add_edges(k + 1, first_[place + 1]);
    for (const int later : plan->later[place]) add_edges(first_[later], first_[later + 1]);
    multiplications_ += lanes * n * (n + below) * (n + below) / 2.0;
  }
  A.nodes.push_back({0, row, numbers, int(A.edges.size())});
  zeros(A.numbers, std::size_t(numbers));
  zeros(A.original, std::size_t(row));
  zeros(J, std::size_t(2 * row));
  zeros(masses, moves.size());
  A.targets.clear();
  for (int k = 0; k < count; ++k)
    for (int j = A.nodes[k].first_edge; j < A.nodes[k + 1].first_edge; ++j)
      for (int i = j; i < A.nodes[k + 1].first_edge; ++i)
        A.targets.push_back(at(A.edges[i].to, A.edges[j].to));
  place_couplings();
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
  for (int k = 0; k < int(blocks.size()); ++k)
    for (const int column : blocks[k].columns) {
      for (int j = A.nodes[k].first_edge; moves[column] && j < A.nodes[k + 1].first_edge; ++j) {
        const auto& [to, at] = A.edges[j];
        for (const int of : {0, 1})
          if (blocks[to].columns[of] == column)
            couplings_.push_back({2 * A.nodes[to].row + of * blocks[to].rows, blocks[to].rows, at});
      }
      couplings_end_.push_back(int(couplings_.size()));
    }
}

void IslandMatrix::assemble() {
  const Coupling* coupling = couplings_.data();
  for (int k = 0; k < int(blocks.size()); ++k) {
    TwoLanes* const diagonal = &A.numbers[A.nodes[k].diagonal];
    std::fill(diagonal, A.numbers.data() + A.nodes[k + 1].diagonal, TwoLanes{});
    const int n = blocks[k].rows;
    for (const int of : {0, 1}) {
      if (!moves[blocks[k].columns[of]]) continue;
      const HalfRowOf<TwoLanes>* const half = &J[2 * A.nodes[k].row + of * n];
      const auto& [linear, angular] = masses[blocks[k].columns[of]];
      HalfRowOf<TwoLanes> response[6];
      for (int r = 0; r < n; ++r) response[r] = {linear * half[r].v, angular * half[r].w};
      for (int r = 0; r < n; ++r)  // with itself: only the lower triangle is needed
        add_coupling(half + r, 1, response, r + 1, diagonal + r * n);
      for (; coupling != couplings_.data() + couplings_end_[2 * k + of]; ++coupling)
        add_coupling(&J[coupling->J], coupling->rows, response, n, &A.numbers[coupling->at]);
    }
  }
}

}  // namespace joints
