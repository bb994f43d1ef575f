// Exercise 9.3: the graphs.
#pragma once

#include <string>
#include <vector>

#include "checker/numeric.h"

namespace joints::testing {

using Graph = std::vector<std::vector<int>>;
struct GraphCase {
  std::string words;
  Graph neighbours;
  bool exactly = false;  ///< no pair may be filled in beyond the rule
};

inline Graph graph_of(int nodes, const std::vector<std::pair<int, int>>& edges) {
  Graph out(static_cast<std::size_t>(nodes));
  for (const auto& [a, b] : edges) {
    out[std::size_t(a)].push_back(b);
    out[std::size_t(b)].push_back(a);
  }
  return out;
}
/// A node in the middle and arms around it.
inline Graph star(int arms, int hub) {
  std::vector<std::pair<int, int>> edges;
  for (int k = 0; k <= arms; ++k)
    if (k != hub) edges.push_back({hub, k});
  return graph_of(arms + 1, edges);
}
inline Graph ring(int nodes) {
  std::vector<std::pair<int, int>> edges;
  for (int k = 0; k < nodes; ++k) edges.push_back({k, (k + 1) % nodes});
  return graph_of(nodes, edges);
}
/// Knots of a square net.
inline Graph net(int side) {
  std::vector<std::pair<int, int>> edges;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const int k = row * side + column;
      if (column + 1 < side) edges.push_back({k, k + 1});
      if (row + 1 < side) edges.push_back({k, k + side});
    }
  return graph_of(side * side, edges);
}
/// The same graph with its lists in another order.
inline Graph shuffled(Graph graph, unsigned seed) {
  Random random(seed);
  for (std::vector<int>& of : graph)
    for (std::size_t k = of.size(); k > 1; --k)
      std::swap(of[k - 1], of[std::size_t(random.uniform(0, real(k) - real(0.01)))]);
  return graph;
}

inline std::vector<GraphCase> graph_cases() {
  Graph random_graph;
  {
    Random random(93);
    std::vector<std::pair<int, int>> edges;
    for (int a = 0; a < 14; ++a)
      for (int b = a + 1; b < 14; ++b)
        if (random.uniform(0, 1) < real(0.22)) edges.push_back({a, b});
    random_graph = graph_of(14, edges);
  }
  std::vector<GraphCase> out{
      {"a star of four arms, hub 0", star(4, 0)},
      {"a path of five nodes", graph_of(5, {{0, 1}, {1, 2}, {2, 3}, {3, 4}})},
      {"a path of six nodes in another order", graph_of(6, {{3, 0}, {0, 5}, {5, 2}, {2, 4},
                                                            {4, 1}})},
      {"a star of six arms, hub 3", star(6, 3)},
      {"a ring of five nodes", ring(5)},
      {"a ring of eight nodes", ring(8)},
      {"a ring of four nodes and an arm of two", graph_of(6, {{0, 1}, {1, 2}, {2, 3}, {3, 0},
                                                              {0, 4}, {4, 5}})},
      {"two stars that share nothing", graph_of(7, {{6, 0}, {6, 2}, {6, 4}, {5, 1}, {5, 3}})},
      {"nodes without neighbours", graph_of(4, {{1, 3}})},
      {"all are neighbours", graph_of(5, {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {1, 2}, {1, 3}, {1, 4},
                                          {2, 3}, {2, 4}, {3, 4}})},
      {"a wheel: a hub and a ring around it", graph_of(7, {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5},
                                                           {0, 6}, {1, 2}, {2, 3}, {3, 4}, {4, 5},
                                                           {5, 6}, {6, 1}})},
      {"a net of three by three", net(3)},
      {"a net of six by six", net(6)},
      {"fourteen nodes, neighbours by chance", random_graph}};
  for (const std::size_t k : {0, 1, 2, 3, 4, 5, 7, 8}) out[k].exactly = true;
  for (std::size_t k : {std::size_t(3), std::size_t(10), std::size_t(12), std::size_t(13)})
    out.push_back({out[k].words + ", its lists in another order",
                   shuffled(out[k].neighbours, unsigned(k))});
  out.push_back({"one node", graph_of(1, {})});
  out.push_back({"no nodes", {}});
  return out;
}

}  // namespace joints::testing
