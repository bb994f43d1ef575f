// The pattern of the matrix of the joints: order, fill, targets, couplings.
#include "chapters/09_direct/joint_matrix.h"

#include <algorithm>
#include <set>

#include "chapters/09_direct/closed_loops.h"
#include "engine/simd/arrange.h"

namespace joints {

bool JointMatrixMaker::follow(const std::vector<BlockPattern>& blocks) {
  if (blocks == listed_ && !A.nodes.empty()) return false;
  listed_ = blocks;
  find_loops();
  place_islands();
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

void JointMatrixMaker::find_loops() {
  int bodies = 0;
  for (const BlockPattern& block : listed_) bodies = std::max({bodies, block.body1, block.body2});
  const int still = ++bodies;  // one number for all static bodies
  std::vector<BodyPair> joints;
  std::vector<int> listed;
  for (int k = 0; k < int(listed_.size()); ++k) {
    const BlockPattern& block = listed_[k];
    if (block.rows == 1 && block.bounded) continue;
    joints.push_back(
        {block.body1 < 0 ? still : block.body1, block.body2 < 0 ? still : block.body2});
    listed.push_back(k);
  }
  loop_.assign(listed_.size(), -1);
  loops_.clear();
  std::vector<std::set<int>> members;
  const std::vector<int> found = closed_loops(joints, bodies + 1);
  for (int j = 0; j < int(joints.size()); ++j) {
    if (found[j] < 0) continue;
    loop_[listed[j]] = found[j];
    loops_.resize(std::max(loops_.size(), std::size_t(found[j]) + 1));
    members.resize(loops_.size());
    const BlockPattern& block = listed_[listed[j]];
    loops_[found[j]].rows += block.rows - block.bounded;
    members[found[j]].insert({joints[j].body1, joints[j].body2});
  }
  for (std::size_t k = 0; k < loops_.size(); ++k) {
    loops_[k].held = members[k].count(still) > 0;
    loops_[k].bodies = int(members[k].size()) - loops_[k].held;
  }
}

// Islands with the same pattern share it, one on each of its lanes.
void JointMatrixMaker::place_islands() {
  int bodies = 0;
  for (const BlockPattern& block : listed_) bodies = std::max({bodies, block.body1, block.body2});
  const int still = ++bodies;  // one number for all static bodies
  std::vector<bool> moves(std::size_t(still), true);
  moves.push_back(false);
  std::vector<BodyPair> pairs;
  std::vector<int> kinds;
  for (const BlockPattern& block : listed_) {
    const bool still1 = block.body1 < 0, still2 = block.body2 < 0;
    pairs.push_back({still1 ? still : block.body1, still2 ? still : block.body2});
    kinds.push_back(4 * block.rows + 2 * still1 + still2);
  }
  lanes_.clear();
  for (const Islands& same : alike(islands_of(pairs, moves), pairs, kinds))
    for (std::size_t k = 0; k < same.size(); k += 2)
      for (std::size_t n = 0; n < same[k].size(); ++n)
        lanes_.push_back({same[k][n], k + 1 < same.size() ? same[k + 1][n] : -1});
  std::sort(lanes_.begin(), lanes_.end());  // in the order of the list
  blocks_.clear();
  at_.resize(listed_.size());
  int rows = 0;
  for (const auto& of_lanes : lanes_) {
    for (int lane = 0; lane < 2; ++lane)
      if (of_lanes[lane] >= 0) at_[of_lanes[lane]] = {int(blocks_.size()), lane};
    blocks_.push_back(listed_[of_lanes[0]]);
    blocks_.back().row = rows;
    rows += blocks_.back().rows;
  }
  A.original.assign(std::size_t(rows), TwoLanes{});
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

// Places nodes and edges, including the edges of fill-in: the elimination of a node makes its later
// neighbours neighbours of each other.
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
    const int n = block.rows, lanes = lanes_[order[k]][1] < 0 ? 1 : 2;
    A.nodes.push_back({n, block.row, numbers, int(A.edges.size())});
    numbers += n * n;
    int below = 0;
    for (const int to : later[k]) {
      const int m = blocks_[order[to]].rows;
      if (!std::binary_search(neighbours[order[k]].begin(), neighbours[order[k]].end(), order[to]))
        fill_ += lanes * m * n;
      A.edges.push_back({to, numbers});
      numbers += m * n;
      below += m;
      for (const int other : later[k])
        if (other > to) later[to].insert(other);
    }
    multiplications_ += lanes * n * (n + below) * (n + below) / 2.0;
  }
  A.nodes.push_back({0, int(A.original.size()), numbers, int(A.edges.size())});
  A.numbers.assign(std::size_t(numbers), TwoLanes{});
}

// Where the block between two nodes begins. \param later, earlier places in the order
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
  halves_.clear();
  couplings_.clear();
  const auto half_rows = [&](int k, int body) {
    return 2 * blocks_[k].row + (body == blocks_[k].body1 ? 0 : blocks_[k].rows);
  };
  for (int body = 0; body < int(blocks_of_.size()); ++body)
    for (const int b : blocks_of_[body]) {
      const auto slot = [&](int k) {
        if (k < 0) return -1;
        return body == blocks_[b].body1 ? listed_[k].body1 : listed_[k].body2;
      };
      const std::size_t before = couplings_.size();
      for (const int a : blocks_of_[body])
        if (place_[a] > place_[b])
          couplings_.push_back({half_rows(a, body), blocks_[a].rows, at(place_[a], place_[b])});
      halves_.push_back({half_rows(b, body), blocks_[b].rows, at(place_[b], place_[b]),
                         {slot(lanes_[b][0]), slot(lanes_[b][1])},
                         int(couplings_.size() - before)});
    }
}

void JointMatrixMaker::assemble(const std::vector<HalfRowOf<TwoLanes>>& J,
                                const std::vector<BodyMass>& masses) {
  std::fill(A.numbers.begin(), A.numbers.end(), TwoLanes{});
  const BodyMass idle{};
  const Coupling* coupling = couplings_.data();
  for (const Half& half : halves_) {
    const BodyMass& a = masses[half.body[0]];
    const BodyMass& b = half.body[1] < 0 ? idle : masses[half.body[1]];
    const TwoLanes linear{a.linear, b.linear};
    const Symmetric<TwoLanes> angular{
        {a.angular.xx, b.angular.xx}, {a.angular.yy, b.angular.yy}, {a.angular.zz, b.angular.zz},
        {a.angular.xy, b.angular.xy}, {a.angular.xz, b.angular.xz}, {a.angular.yz, b.angular.yz}};
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
