// The analysis of an island's shape.
#include "chapters/09_direct/elimination_plan.h"

#include <algorithm>
#include <set>

#include "chapters/09_direct/closed_loops.h"
#include "chapters/09_direct/direct.h"

namespace joints {

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

  std::vector<int> place(links.size());
  for (int k = 0; k < count; ++k) place[links[k]] = k;
  std::vector<std::set<int>> after(links.size());
  for (int k = 0; k < count; ++k) {
    for (const int other : neighbours[links[k]])
      if (place[other] > k) after[k].insert(place[other]);
    if (!after[k].empty())  // they become neighbours of each other
      after[*after[k].begin()].insert(std::next(after[k].begin()), after[k].end());
    later.emplace_back(after[k].begin(), after[k].end());
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
