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
  fill_ = 0;
  for (int k = 0; k < count; ++k) {
    const int n = blocks[k].rows, lanes = blocks[k].lanes();
    A.nodes.push_back({n, row, numbers, int(A.edges.size())});
    row += n;
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
  at_body_.clear();  // pairs of a column and a block
  for (int k = 0; k < int(blocks.size()); ++k)
    for (const int column : blocks[k].columns)
      if (moves[column]) at_body_.push_back({column, k});
  std::sort(at_body_.begin(), at_body_.end());
  const auto half_rows = [&](int column, int k) {
    return 2 * A.nodes[k].row + (blocks[k].columns[0] == column ? 0 : blocks[k].rows);
  };
  halves_.clear();
  couplings_.clear();
  for (auto b = at_body_.begin(); b != at_body_.end(); ++b) {
    const auto [column, k] = *b;
    auto a = b + 1;
    for (; a != at_body_.end() && a->first == column; ++a)
      couplings_.push_back({half_rows(column, a->second), blocks[a->second].rows,
                            at(a->second, k)});
    halves_.push_back({half_rows(column, k), blocks[k].rows, A.nodes[k].diagonal, column,
                       int(a - b) - 1});
  }
}

void IslandMatrix::assemble() {
  std::fill(A.numbers.begin(), A.numbers.end(), TwoLanes{});
  const Coupling* coupling = couplings_.data();
  for (const Half& half : halves_) {
    const auto& [linear, angular] = masses[half.column];
    HalfRowOf<TwoLanes> response[6];
    for (int i = 0; i < half.rows; ++i)
      response[i] = {linear * J[half.J + i].v, angular * J[half.J + i].w};
    for (int i = 0; i < half.rows; ++i)  // with itself: only the lower triangle is needed
      add_coupling(&J[half.J + i], 1, response, i + 1, &A.numbers[half.at + i * half.rows]);
    for (const Coupling* const end = coupling + half.couplings; coupling != end; ++coupling)
      add_coupling(&J[coupling->J], coupling->rows, response, half.rows, &A.numbers[coupling->at]);
  }
}

}  // namespace joints
