// The pattern of the matrix of the joints: order, fill, targets, couplings.
#include "chapters/09_direct/joint_matrix.h"

#include <algorithm>
#include <set>

namespace joints {

bool JointMatrixMaker::follow(const std::vector<BlockPattern>& blocks, int rows) {
  if (blocks == blocks_ && rows == int(A.original.size())) return false;
  blocks_ = blocks;
  A.original.assign(std::size_t(rows), 0);
  blocks_of_.clear();
  for (int k = 0; k < int(blocks_.size()); ++k)
    for (const int body : {blocks_[k].body1, blocks_[k].body2}) {
      if (body < 0) continue;
      if (int(blocks_of_.size()) <= body) blocks_of_.resize(std::size_t(body) + 1);
      blocks_of_[body].push_back(k);
    }
  place_blocks(elimination_order(neighbours_of()));
  place_targets();
  place_couplings();
  return true;
}

std::vector<std::vector<int>> JointMatrixMaker::neighbours_of() const {
  std::vector<std::vector<int>> out(blocks_.size());
  for (const std::vector<int>& together : blocks_of_)
    for (const int a : together)
      for (const int b : together)
        if (a != b) out[a].push_back(b);
  for (std::vector<int>& of_one : out) {
    std::sort(of_one.begin(), of_one.end());
    of_one.erase(std::unique(of_one.begin(), of_one.end()), of_one.end());
  }
  return out;
}

// Nodes and edges, the filled ones included: who is eliminated makes its later neighbours
// neighbours of each other.
void JointMatrixMaker::place_blocks(const std::vector<int>& order) {
  place_.assign(blocks_.size(), 0);
  for (int k = 0; k < int(order.size()); ++k) place_[order[k]] = k;
  std::vector<std::set<int>> later(order.size());
  const auto neighbours = neighbours_of();
  for (int k = 0; k < int(order.size()); ++k)
    for (const int other : neighbours[order[k]])
      if (place_[other] > k) later[k].insert(place_[other]);

  A.nodes.clear();
  A.edges.clear();
  int numbers = 0;
  multiplications_ = 0;
  fill_ = 0;
  for (int k = 0; k < int(order.size()); ++k) {
    const BlockPattern& block = blocks_[order[k]];
    const int n = block.rows;
    A.nodes.push_back({n, block.row, numbers, int(A.edges.size())});
    numbers += n * n;
    int below = 0;
    for (const int to : later[k]) {
      const int m = blocks_[order[to]].rows;
      if (!std::binary_search(neighbours[order[k]].begin(), neighbours[order[k]].end(), order[to]))
        fill_ += m * n;
      A.edges.push_back({to, numbers});
      numbers += m * n;
      below += m;
      for (const int other : later[k])
        if (other > to) later[to].insert(other);
    }
    multiplications_ += n * (n + below) * (n + below) / 2.0;
  }
  A.nodes.push_back({0, int(A.original.size()), numbers, int(A.edges.size())});
  A.numbers.assign(std::size_t(numbers), 0);
}

// Where the block between two nodes stands. \param later, earlier places in the order
int JointMatrixMaker::at(int later, int earlier) const {
  if (later == earlier) return A.nodes[earlier].diagonal;
  const auto begin = A.edges.begin() + A.nodes[earlier].first_edge;
  const auto end = A.edges.begin() + A.nodes[earlier + 1].first_edge;
  return std::lower_bound(begin, end, later, [](const Edge& edge, int to) {
           return edge.to < to;
         })->at;
}

void JointMatrixMaker::place_targets() {
  A.targets.clear();
  for (std::size_t k = 0; k + 1 < A.nodes.size(); ++k) {
    const int end = A.nodes[k + 1].first_edge;
    for (int j = A.nodes[k].first_edge; j < end; ++j)
      for (int i = j; i < end; ++i) A.targets.push_back(at(A.edges[i].to, A.edges[j].to));
  }
}

void JointMatrixMaker::place_couplings() {
  couplings_.clear();
  const auto half_rows = [&](int k, int body) {
    return 2 * blocks_[k].row + (body == blocks_[k].body1 ? 0 : blocks_[k].rows);
  };
  for (int body = 0; body < int(blocks_of_.size()); ++body)
    for (const int a : blocks_of_[body])
      for (const int b : blocks_of_[body]) {
        if (place_[a] < place_[b]) continue;
        couplings_.push_back({half_rows(a, body), half_rows(b, body), blocks_[a].rows,
                              blocks_[b].rows, at(place_[a], place_[b])});
      }
}

void JointMatrixMaker::assemble(const std::vector<HalfRow>& J,
                                const std::vector<HalfRow>& response) {
  std::fill(A.numbers.begin(), A.numbers.end(), 0.0);
  for (const Coupling& c : couplings_)
    add_coupling(&J[c.later], c.rows_later, &response[c.earlier], c.rows_earlier,
                 &A.numbers[c.at]);
}

}  // namespace joints
