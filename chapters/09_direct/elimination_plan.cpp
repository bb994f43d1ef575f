// The analysis of an island's shape.
#include "chapters/09_direct/elimination_plan.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "chapters/09_direct/direct.h"
#include "engine/simd/body_pair.h"

namespace joints {

// For each joint the number of the closed loop that contains it, or -1 if it is in no loop. Loops
// that share more than one body count as one loop (the biconnected components of the graph). Each
// joint outside a spanning tree closes a loop with the joints of the tree between its two bodies.
static std::vector<int> closed_loops(const std::vector<BodyPair>& joints, int bodies) {
  const auto other = [&](int joint, int body) {
    return joints[joint].body1 + joints[joint].body2 - body;
  };
  std::vector<std::vector<int>> joints_of(std::size_t(bodies), std::vector<int>{});
  for (int k = 0; k < int(joints.size()); ++k)
    for (const int body : {joints[k].body1, joints[k].body2}) joints_of[body].push_back(k);
  std::vector<int> depth(std::size_t(bodies), -1), up(depth), queue;  // up: the joint to the parent
  std::vector<int> loop(joints.size()), top(joints.size(), 0);  // top: its body of least depth
  std::iota(loop.begin(), loop.end(), 0);
  for (int root = 0; root < bodies; ++root) {
    if (depth[root] >= 0) continue;
    depth[root] = 0;
    queue.assign(1, root);
    for (std::size_t n = 0; n < queue.size(); ++n)
      for (const int joint : joints_of[queue[n]]) {
        const int next = other(joint, queue[n]);
        if (depth[next] >= 0) continue;
        depth[next] = depth[queue[n]] + 1;
        up[next] = joint;
        top[joint] = queue[n];
        queue.push_back(next);
      }
  }
  const auto loop_of = [&](int joint) {
    while (loop[joint] != joint) joint = loop[joint] = loop[loop[joint]];
    return joint;
  };
  for (int k = 0; k < int(joints.size()); ++k) {
    auto [a, b] = joints[k];
    if (up[a] == k || up[b] == k) continue;
    for (top[k] = a; a != b;) {
      int& lower = depth[a] > depth[b] ? a : b;
      const int above = loop_of(up[lower]);
      lower = top[above];
      if (depth[lower] < depth[top[k]]) top[k] = lower;
      loop[above] = k;
    }
  }
  std::vector<int> size(joints.size(), 0), number(joints.size(), -1), out(joints.size(), -1);
  for (int k = 0; k < int(joints.size()); ++k) ++size[loop_of(k)];
  int count = 0;
  for (int k = 0; k < int(joints.size()); ++k) {
    const int all = loop_of(k);
    if (size[all] > 1 && number[all] < 0) number[all] = count++;
    out[k] = number[all];
  }
  return out;
}

EliminationPlan::EliminationPlan(const std::vector<ShapeBlock>& shape) {
  const int count = shape.empty() ? 0 : shape.back().link + 1;
  int columns = 0;
  for (const ShapeBlock& block : shape)
    columns = std::max({columns, block.columns[0] + 1, block.columns[1] + 1});
  std::vector<std::set<int>> links_of(std::size_t(columns), std::set<int>{});
  for (const ShapeBlock& block : shape)
    for (const int k : {0, 1})
      if (block.moves[k]) links_of[block.columns[k]].insert(block.link);
  std::vector<std::set<int>> beside(std::size_t(count), std::set<int>{});
  for (const std::set<int>& together : links_of)
    for (const int a : together) beside[a].insert(together.begin(), together.end());
  std::vector<std::vector<int>> neighbours;
  for (int k = 0; k < count; ++k) {
    beside[k].erase(k);
    neighbours.emplace_back(beside[k].begin(), beside[k].end());
  }
  links = elimination_order(neighbours);
  std::vector<int> rows_of(std::size_t(count), 0);
  for (const ShapeBlock& block : shape) rows_of[block.link] += block.rows, rows += block.rows;

  std::vector<int> place(links.size());
  for (int k = 0; k < count; ++k) place[links[k]] = k;
  std::vector<std::set<int>> after(links.size());
  for (int k = 0; k < count; ++k) {
    for (const int other : neighbours[links[k]])
      if (place[other] > k) after[k].insert(place[other]);
    if (!after[k].empty())  // they become neighbours of each other
      after[*after[k].begin()].insert(std::next(after[k].begin()), after[k].end());
    later.emplace_back(after[k].begin(), after[k].end());
    const int own = rows_of[links[k]];
    double all = own;
    for (const int other : later.back()) all += rows_of[links[other]];
    multiplications += own * all * all / 2;  // Eq. 9-6
  }

  std::vector<BodyPair> joints;
  std::vector<int> of_joint;
  const int still = columns;  // one number for all static bodies
  for (int k = 0; k < int(shape.size()); ++k) {
    const ShapeBlock& block = shape[k];
    if (block.rows == 0) continue;
    of_joint.push_back(k);
    joints.push_back({block.moves[0] ? block.columns[0] : still,
                      block.moves[1] ? block.columns[1] : still});
  }
  loop.assign(shape.size(), -1);
  const std::vector<int> found = closed_loops(joints, columns + 1);
  std::vector<std::set<int>> members;
  for (int j = 0; j < int(joints.size()); ++j) {
    if (found[j] < 0) continue;
    const ShapeBlock& block = shape[of_joint[j]];
    loop[of_joint[j]] = found[j];
    loops.resize(std::max(loops.size(), std::size_t(found[j]) + 1));
    members.resize(loops.size());
    loops[found[j]].rows += block.rows;
    members[found[j]].insert({joints[j].body1, joints[j].body2});
  }
  for (std::size_t k = 0; k < loops.size(); ++k) {
    loops[k].held = members[k].count(still) > 0;
    loops[k].bodies = int(members[k].size()) - loops[k].held;
  }
}

}  // namespace joints
