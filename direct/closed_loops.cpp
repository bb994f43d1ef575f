// Closed loops: the biconnected components of the graph of bodies and joints.
#include "direct/closed_loops.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "engine/simd/body_pair.h"

namespace joints {

// For each joint the number of the closed loop that contains it, or -1 if it is in no loop. Loops
// that share more than one body count as one loop (the biconnected components of the graph). Each
// joint outside a spanning tree closes a loop with the joints of the tree between its two bodies.
static std::vector<int> loops_of(const std::vector<BodyPair>& joints, int bodies) {
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

ClosedLoops::ClosedLoops(const std::vector<ShapeBlock>& shape) : of(shape.size(), -1) {
  int still = 0;  // one number for all static bodies
  for (const ShapeBlock& block : shape)
    still = std::max({still, block.columns[0] + 1, block.columns[1] + 1});
  std::vector<BodyPair> joints;
  std::vector<int> of_joint;
  for (int k = 0; k < int(shape.size()); ++k) {
    const ShapeBlock& block = shape[k];
    if (block.rows == 0) continue;
    of_joint.push_back(k);
    joints.push_back({block.moves[0] ? block.columns[0] : still,
                      block.moves[1] ? block.columns[1] : still});
  }
  const std::vector<int> found = loops_of(joints, still + 1);
  std::vector<std::set<int>> members;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (found[j] < 0) continue;
    of[of_joint[j]] = found[j];
    list.resize(std::max(list.size(), std::size_t(found[j]) + 1));
    members.resize(list.size());
    list[found[j]].rows += shape[of_joint[j]].rows;
    members[found[j]].insert({joints[j].body1, joints[j].body2});
  }
  for (std::size_t k = 0; k < list.size(); ++k) {
    list[k].held = members[k].count(still) > 0;
    list[k].bodies = int(members[k].size()) - list[k].held;
  }
}

}  // namespace joints
