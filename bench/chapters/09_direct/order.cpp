// The order of elimination: its fill-in and its multiplications.
#include <algorithm>
#include <cstdio>
#include <numeric>
#include <random>

#include "bench/chapters/09_direct/experiments.h"

namespace joints::chapter9 {

namespace {

// Joints with the same number of rows, each between two bodies; -1 is a static body.
struct Graph {
  std::string name;
  int rows;
  std::vector<std::pair<int, int>> joints;

  std::vector<std::vector<int>> neighbours() const {
    std::vector<std::vector<int>> out(joints.size());
    const auto share = [](int a, int b) { return a >= 0 && a == b; };
    for (std::size_t j = 0; j < joints.size(); ++j)
      for (std::size_t k = 0; k < joints.size(); ++k) {
        const auto [a1, a2] = joints[j];
        const auto [b1, b2] = joints[k];
        if (j != k && (share(a1, b1) || share(a1, b2) || share(a2, b1) || share(a2, b2)))
          out[j].push_back(int(k));
      }
    return out;
  }
};

// The joints of a scene, all of the same kind.
Graph joints_of(const std::string& name, Scene&& scene) {
  World& world = scene.world;
  for (const auto& joint : world.joints()) {
    joint->begin_step(world.bodies, scene.h);
    joint->append(world.bodies, world.blocks);
  }
  Graph out{name, world.blocks.list[0].rows, {}};
  const auto moving = [&](int slot) { return world.bodies.at(slot).is_static() ? -1 : slot; };
  for (const Block& block : world.blocks.list)
    out.joints.push_back({moving(block.body1), moving(block.body2)});
  return out;
}

Graph ring(int count) {
  Graph out{"ring", 5, {}};
  for (int k = 0; k < count; ++k) out.joints.push_back({k, (k + 1) % count});
  return out;
}

// A hub, body 0, and arms of several joints each; the joints at the hub come first in the list.
Graph star_graph(int arms, int length) {
  Graph out{"star", 5, {}};
  for (int k = 0; k < length; ++k)
    for (int arm = 0; arm < arms; ++arm)
      out.joints.push_back({k == 0 ? 0 : k * arms + arm - arms + 1, k * arms + arm + 1});
  return out;
}

struct Count {
  double fill = 0, multiplications = 0;
};

// Eliminates the nodes of the graph in an order: each eliminated node makes its neighbours
// neighbours of each other.
// \param pattern receives the places of all blocks below the diagonal, and whether they are fill-in
Count eliminate(const Graph& graph, const std::vector<int>& order,
                const std::function<void(int, int, bool)>& pattern) {
  const std::size_t size = order.size();
  std::vector<std::string> block(size, std::string(size, ' '));  // of the matrix
  const auto given = graph.neighbours();
  for (std::size_t k = 0; k < size; ++k)
    for (const int other : given[k]) block[k][other] = 'g';
  std::vector<int> place(size);
  for (std::size_t k = 0; k < size; ++k) place[order[k]] = int(k);
  Count count;
  const double n = graph.rows;
  for (const int node : order) {
    std::vector<int> later;  // its neighbours that are not eliminated yet
    for (std::size_t k = 0; k < size; ++k)
      if (block[node][k] != ' ' && place[k] > place[node]) later.push_back(int(k));
    const double below = n * double(later.size());
    count.multiplications += n * (n + below) * (n + below) / 2;  // Eq. 9-6
    for (const int a : later) {
      const bool filled = block[node][a] == 'f';
      if (filled) count.fill += n * n;
      pattern(place[a], place[node], filled);
      for (const int b : later)
        if (a != b && block[a][b] == ' ') block[a][b] = 'f';
    }
  }
  return count;
}

// A shuffle of our own, so that the order does not depend on the library.
std::vector<int> shuffled(std::vector<int> list) {
  std::mt19937 number(9);
  for (std::size_t k = list.size() - 1; k > 0; --k) std::swap(list[k], list[number() % (k + 1)]);
  return list;
}

// How far a hub is below its place at most in five seconds [m].
double sag(Scene&& scene) {
  DirectSolver direct = with_positions();
  const auto leap = leaps(scene, direct);
  double most = 0;
  for (int n = 0; n < 300; ++n) {
    leap();
    most = std::max(most, -double(scene.world.bodies.at(1).x.y));
  }
  return most;
}

// The most expensive graph: all joints at one body are neighbours of each other.
void hubs(const Choice& choice) {
  CsvFile table(choice.out + "/hub.csv", {"arms", "multiplications_per_row", "iterated", "sag_m"});
  int most = 0;
  for (const int arms : {1, 2, 5, 10, 20, 30, 40, 50, 60, 80, 100}) {
    Scene scene = star(arms);
    DirectSolver direct = DirectSolver::velocities_only();
    leaps(scene, direct)();
    Graph graph = star_graph(arms + 1, 1);  // one joint holds the hub
    graph.rows = 3;
    const Count count = eliminate(graph, elimination_order(graph.neighbours()),
                                  [](int, int, bool) {});
    table.row({double(arms), count.multiplications / (3 * (arms + 1)),
               double(direct.report().iterated), sag(star(arms, 1))});
    if (!direct.report().iterated) most = arms;
  }
  std::printf("a hub with %d arms is solved directly; with more of them, by iterations\n", most);
}

}  // namespace

void order(const Choice& choice) {
  CsvFile table(choice.out + "/order.csv",
                {"graph", "order", "joints", "rows", "fill", "multiplications"});
  CsvFile pattern(choice.out + "/pattern.csv", {"graph", "order", "row", "column", "filled"});
  for (const Graph& graph : {joints_of("chain", sideways_chains(1, 101)), ring(100),
                             star_graph(8, 5), joints_of("net", net(6))}) {
    std::vector<int> list(graph.joints.size());
    std::iota(list.begin(), list.end(), 0);
    const std::vector<int> found = elimination_order(graph.neighbours());
    std::vector<int> sorted = found;
    std::sort(sorted.begin(), sorted.end());
    require(sorted == list, "elimination_order: each node must be in it once");
    std::printf("%-8s of %3zu joints: multiplications", graph.name.c_str(), list.size());
    for (const auto& [name, by] : {std::pair{"as listed", list}, {"shuffled", shuffled(list)},
                                   {"fewest neighbours", found}}) {
      const Count count = eliminate(graph, by, [&, name = name](int i, int j, bool filled) {
        pattern.row({graph.name, name}, {double(i), double(j), double(filled)});
      });
      table.row({graph.name, name}, {double(list.size()), double(graph.rows) * double(list.size()),
                                     count.fill, count.multiplications});
      std::printf("  %s %.0f", name, count.multiplications);
    }
    std::printf("\n");
  }
  hubs(choice);
}

}  // namespace joints::chapter9
