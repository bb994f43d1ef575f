// The joint graph of a shape, the order of its elimination, and fill-in.
#include "chapters/09_direct/elimination_plan.h"

#include <algorithm>
#include <set>

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
}

}  // namespace joints
