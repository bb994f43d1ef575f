// Exercise 9.3: the order of elimination that is right, and the report on yours.
#pragma once

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>

#include "chapters/09_direct/direct.h"
#include "checker/report.h"
#include "tests/09_direct/counted_memory.h"
#include "tests/09_direct/drawn_cases.h"
#include "tests/09_direct/graph_cases.h"
#include "tests/checker/thrown.h"

namespace joints::testing {

// ---- what is right -----------------------------------------------------------------------------

/// By the text's rule; of equals the node with the least number.
inline std::vector<int> right_order(const Graph& graph) {
  std::vector<std::set<int>> left;
  for (const auto& of : graph) left.push_back({of.begin(), of.end()});
  std::vector<int> remaining(graph.size()), out;
  std::iota(remaining.begin(), remaining.end(), 0);
  while (!remaining.empty()) {
    const auto best = std::min_element(remaining.begin(), remaining.end(), [&](int a, int b) {
      return left[std::size_t(a)].size() < left[std::size_t(b)].size();
    });
    const std::set<int> around = left[std::size_t(*best)];
    for (const int a : around) {
      left[std::size_t(a)].insert(around.begin(), around.end());
      left[std::size_t(a)].erase(a);
      left[std::size_t(a)].erase(*best);
    }
    out.push_back(*best);
    remaining.erase(best);
  }
  return out;
}

/// What elimination costs by an order that has each node once: pairs that become neighbours, and
/// multiplications where each node has one row.
struct Cost {
  int fill = 0, most = 0;  ///< pairs, and neighbours of an eliminated node
  long multiplications = 0;
};
inline Cost cost_of(const Graph& graph, const std::vector<int>& order) {
  std::vector<std::set<int>> left;
  for (const auto& of : graph) left.push_back({of.begin(), of.end()});
  Cost out;
  for (const int node : order) {
    const std::set<int> around = left[std::size_t(node)];
    const long n = long(around.size());
    out.most = std::max(out.most, int(n));
    out.multiplications += n + n * (n + 1) / 2;
    for (const int a : around) {
      left[std::size_t(a)].erase(node);
      for (const int b : around)
        if (a < b && left[std::size_t(a)].insert(b).second) {
          left[std::size_t(b)].insert(a);
          ++out.fill;
        }
    }
  }
  return out;
}
/// Any order will do that leaves hardly more blocks in the factor than the rule: a tenth, and one.
inline bool enough(const Graph& graph, int fill, int by_the_rule, bool exactly = false) {
  if (exactly) return fill <= by_the_rule;
  int edges = 0;
  for (const auto& of : graph) edges += int(of.size());
  return 10 * (edges / 2 + fill) <= 11 * (edges / 2 + by_the_rule) + 10;
}
inline bool each_once(const Graph& graph, std::vector<int> order) {
  std::sort(order.begin(), order.end());
  std::vector<int> all(graph.size());
  std::iota(all.begin(), all.end(), 0);
  return order == all;
}

/// True if the nodes, backwards, are as a search finds them that looks at all neighbours of a node
/// before it goes on: from any node, with the neighbours of each in any order.
inline bool breadth_first_backwards(const Graph& graph, std::vector<int> order) {
  std::reverse(order.begin(), order.end());
  std::vector<bool> met(graph.size(), false);
  std::size_t at = 0;  // the first node that may have neighbours that are not met
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto open = [&](int node) {
      return std::any_of(graph[std::size_t(node)].begin(), graph[std::size_t(node)].end(),
                         [&](int other) { return !met[std::size_t(other)]; });
    };
    while (at < k && !open(order[at])) ++at;
    if (at < k) {
      const std::vector<int>& of = graph[std::size_t(order[at])];
      if (std::find(of.begin(), of.end(), order[k]) == of.end()) return false;
    }
    met[std::size_t(order[k])] = true;
  }
  return true;
}
// ---- the report ---------------------------------------------------------------------------------

inline constexpr Subject order_subject{"9.3", "the order of elimination"};

/// Your order. Fails where it does not end.
inline std::vector<int> your_order(const GraphCase& c) {
  struct Counted {
    // the right order of the largest graph needs a few thousand
    explicit Counted(std::size_t nodes) { allocations_left = 200000 + 1000 * long(nodes); }
    ~Counted() { allocations_left = -1; }
  };
  std::vector<int> out;
  const auto endless = thrown_by<Endless>([&] {
    const Counted counted(c.neighbours.size());
    out = elimination_order(c.neighbours);
  });
  if (endless)
    fail(order_subject,
         "Graph: " + c.words + ".\n\nIt does not end.\n\n" +
             likely(c.neighbours.size() > 100
                        ? "#small-type with few nodes it ends: a type that is too small for the "
                          "numbers of the nodes, such as a char?"
                        : "#doubled-neighbours an eliminated node comes back into the queue. It "
                          "must leave the sets of all its neighbours, each of two neighbours must "
                          "know the other, and know it once, and a pair is erased from the queue "
                          "before the set changes whose size it holds"));
  return out;
}

inline std::string numbers_in_words(const std::vector<int>& numbers) {
  std::string out;
  for (std::size_t k = 0; k < numbers.size() && k < 40; ++k)
    out += (k ? " " : "") + std::to_string(numbers[k]);
  return numbers.empty() ? "nothing" : out + (numbers.size() > 40 ? " ..." : "");
}

/// What is wrong with the nodes themselves, in words; "" where each stands there once.
inline std::string explain_nodes(const Graph& graph, const std::vector<int>& yours) {
  if (yours.empty()) return "#nothing-returned nothing is returned: push_back() each node as it "
                            "is eliminated";
  if (yours.size() < graph.size())
    return "only " + std::to_string(yours.size()) + " of " + std::to_string(graph.size()) +
           " nodes: go on until none remains, also where a node has no neighbours";
  if (yours.size() > graph.size())
    return std::to_string(yours.size()) + " nodes where there are " +
           std::to_string(graph.size()) + ": an eliminated node must not come back into the queue. "
                                          "Is a node made a neighbour of itself, because b != a is "
                                          "missing?";
  if (std::find(yours.begin(), yours.end(), int(graph.size())) != yours.end())
    return "there is no node " + std::to_string(graph.size()) + ": they are counted from 0";
  return "a node stands there twice, or is none: an eliminated node must not come back";
}

/// In how many graphs it holds, and the mistake that gives your order in all of them.
inline std::string explain_order() {
  const std::vector<GraphCase> cases = graph_cases();
  std::vector<std::vector<int>> yours;
  std::vector<std::string> holds;
  std::string nodes;
  for (const GraphCase& c : cases) {
    yours.push_back(your_order(c));
    if (!each_once(c.neighbours, yours.back())) {
      if (nodes.empty()) nodes = explain_nodes(c.neighbours, yours.back());
    } else if (enough(c.neighbours, cost_of(c.neighbours, yours.back()).fill,
                      cost_of(c.neighbours, right_order(c.neighbours)).fill, c.exactly)) {
      holds.push_back(c.words);
    }
  }
  const std::string out = "Holds in " + std::to_string(holds.size()) + " of " +
                          std::to_string(cases.size()) + " graphs" +
                          (holds.empty() ? "" : ", such as " + holds.back()) + ".\n";
  if (!nodes.empty()) return out + likely(nodes);
  for (const auto& [words, wrong] : known_mistakes<std::vector<int>(Graph)>("9.3", 1)) {
    bool fits = true;
    for (std::size_t k = 0; fits && k < cases.size(); ++k)
      fits = wrong(cases[k].neighbours) == yours[k];
    if (fits) return out + likely(words);
  }
  bool breadth_first = true;
  for (std::size_t k = 0; k < cases.size(); ++k)
    breadth_first = breadth_first && breadth_first_backwards(cases[k].neighbours, yours[k]);
  if (breadth_first)
    return out + likely("#farthest-first the farthest node from a first one comes first: without "
                        "loops that fills in nothing, but a net becomes a band, which fills in "
                        "more than the rule does");
  return out + "Each node stands there once, so the solver would find the same impulses in your "
               "order. The order is used for nothing but the cost, which is compared here: at most "
               "a tenth more blocks than by the rule. None of the usual mistakes explains yours.\n";
}

/// The pairs of neighbours of a graph that can be drawn on paper.
inline std::string edges_in_words(const Graph& graph) {
  std::string out;
  for (std::size_t a = 0; graph.size() <= 9 && a < graph.size(); ++a)
    for (const int b : graph[a])
      if (int(a) < b) out += " " + std::to_string(a) + "-" + std::to_string(b);
  return out.empty() ? "" : "\nNeighbours:" + out;
}

inline void check_order(const GraphCase& c) {
  const std::vector<int> yours = your_order(c), rule = right_order(c.neighbours);
  const bool once = each_once(c.neighbours, yours);
  const Cost best = cost_of(c.neighbours, rule);
  const Cost cost = once ? cost_of(c.neighbours, yours) : Cost{};
  if (once && enough(c.neighbours, cost.fill, best.fill, c.exactly))
    return check(order_subject, "");
  std::string words = "Graph: " + c.words + "." + edges_in_words(c.neighbours) +
                      "\n\n  yours:    " + numbers_in_words(yours) +
                      "\n  the rule: " + numbers_in_words(rule) + "\n\n";
  if (once)
    words += "Filled in: " + std::to_string(cost.fill) + " pairs, by the rule " +
             std::to_string(best.fill) + ". Multiplications: " +
             std::to_string(cost.multiplications) + ", by the rule " +
             std::to_string(best.multiplications) + ".\n";
  if (once && c.exactly && enough(c.neighbours, cost.fill, best.fill))
    words += "A tenth of so few blocks is less than one: no pair may be filled in beyond the "
             "rule.\n";
  check(order_subject, words + "\n" + explain_order());
}

/// A graph whose nodes are numbered anyhow.
inline Drawn drawn_order(Draw& d) {
  int nodes = d.whole(1, 300);
  if (nodes > 270) nodes += 100;  // few: a right answer may take the cube of their number
  d.count("nodes", nodes);
  std::vector<std::pair<int, int>> edges = drawn_edges(d, nodes, 200, 200);
  std::vector<int> names(static_cast<std::size_t>(nodes));
  std::iota(names.begin(), names.end(), 0);
  Random random = d.many();
  for (std::size_t k = names.size(); k > 1; --k)
    std::swap(names[k - 1], names[std::size_t(random.uniform(0, real(k) - real(0.01)))]);
  for (auto& [a, b] : edges) a = names[std::size_t(a)], b = names[std::size_t(b)];
  const Graph graph = graph_of(nodes, edges);
  const std::vector<int> yours = your_order({std::to_string(nodes) + " nodes", graph});
  const Cost best = cost_of(graph, right_order(graph));
  const int rule = best.fill;
  d.count("neighbours of an eliminated node", best.most);
  const bool once = each_once(graph, yours);
  const int fill = once ? cost_of(graph, yours).fill : rule;
  return {{"nodes, each once", "pairs filled in"},
          {once ? nodes : double(yours.size()) - 0.5 * (int(yours.size()) == nodes),
           enough(graph, fill, rule) ? rule : double(fill)},
          {double(nodes), double(rule)}, {1}};
}

}  // namespace joints::testing
