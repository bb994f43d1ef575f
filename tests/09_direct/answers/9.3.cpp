// Known answers of exercise 9.3, each put in the place of the solution's.

// ---- wrong: ties to the greatest number
// expects: Likely mistake: of equals the greatest number: the least
  std::vector<std::set<int>> left;
  std::set<std::pair<std::size_t, int>> queue;
  for (const std::vector<int>& of_one : neighbours) {
    left.emplace_back(of_one.begin(), of_one.end());
    queue.insert({left.back().size(), int(left.size()) - 1});
  }
  while (!queue.empty()) {
  auto best = queue.begin(); for (auto q = best; q != queue.end();
      ++q) if (q->first == queue.begin()->first) best = q; const int node = best->second;
      queue.erase(best);
    order.push_back(node);
    for (const int a : left[node]) {
      queue.erase({left[a].size(), a});
      left[a].erase(node);
      for (const int b : left[node])
        if (b != a) left[a].insert(b);
      queue.insert({left[a].size(), a});
    }
  }

// ---- wrong: the most neighbours first
// expects: Likely mistake: the node with the most neighbours comes first: the fewest make little
// change: queue.begin() ==> std::prev(queue.end())
// change: (queue.begin()) ==> (std::prev(queue.end()))

// ---- wrong: no fill
// expects: Likely mistake: nothing is filled in: who is eliminated makes its neighbours
// change: if (b != a) left[a].insert(b); ==> (void)b;

// ---- wrong: does not leave
// expects: Likely mistake: who is eliminated comes back into the queue. It must leave the sets of
// change: left[a].erase(node); ==>

// ---- wrong: number of neighbours at first
// expects: Likely mistake: the neighbours at first are counted: those that are left count, the
// change: queue.erase({left[a].size(), a}); ==>
// change: queue.insert({left[a].size(), a}); ==>

// ---- wrong: not back into the queue
// expects: Likely mistake: only 4 of 5 nodes: go on until none is left, also where a node has no
// change: queue.insert({left[a].size(), a}); ==>

// ---- wrong: own order
// expects: Likely mistake: the nodes in their own order: the one with the fewest neighbours left
  for (int k = 0; k < int(neighbours.size()); ++k) order.push_back(k);

// ---- wrong: backwards
// expects: Likely mistake: the right order backwards: the node with the fewest neighbours comes
// change: order.push_back(node); ==> order.insert(order.begin(), node);

// ---- wrong: sorted once by the number of neighbours
// expects: Likely mistake: the neighbours at first are counted: those that are left count, the
  for (int k = 0; k < int(neighbours.size()); ++k) order.push_back(k);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return neighbours[std::size_t(a)].size() < neighbours[std::size_t(b)].size();
  });

// ---- wrong: sorted once, not stably from behind
// expects: Likely mistake: the neighbours at first are counted, and of equals the greatest number
  for (int k = int(neighbours.size()); k-- > 0;) order.push_back(k);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return neighbours[std::size_t(a)].size() < neighbours[std::size_t(b)].size();
  });

// ---- wrong: places returned
// expects: Likely mistake: the place of each node in the order is returned: asked for are the
// change: while (!queue.empty()) { ==>
//         order.resize(left.size()); int place = 0; while (!queue.empty()) {
// change: order.push_back(node); ==> order[std::size_t(node)] = place++;

// ---- wrong: pair the other way round
// expects: Likely mistake: the nodes in their own order: the one with the fewest neighbours left
// change: std::set<std::pair<std::size_t, int>> queue; ==>
//         std::set<std::pair<int, std::size_t>> queue;
// change: queue.insert({left.back().size(), int(left.size()) - 1}); ==>
//         queue.insert({int(left.size()) - 1, left.back().size()});
// change: const int node = queue.begin()->second; ==> const int node = queue.begin()->first;
// change: queue.erase({left[a].size(), a}); ==> queue.erase({a, left[a].size()});
// change: queue.insert({left[a].size(), a}); ==> queue.insert({a, left[a].size()});

// ---- wrong: least fill
// expects: Likely mistake: the least fill comes first: asked for is the least number of
  std::vector<std::set<int>> left;
  std::set<int> nodes;
  for (const std::vector<int>& of_one : neighbours) {
    left.emplace_back(of_one.begin(), of_one.end());
    nodes.insert(int(left.size()) - 1);
  }
  while (!nodes.empty()) {
    int best = -1, least = 0;
    for (const int node : nodes) {
      int fill = 0;
      for (const int a : left[node])
        for (const int b : left[node]) fill += a < b && left[a].count(b) == 0;
      if (best < 0 || fill < least) best = node, least = fill;
    }
    nodes.erase(best);
    order.push_back(best);
    for (const int a : left[best]) {
      left[a].erase(best);
      for (const int b : left[best])
        if (a != b) left[a].insert(b);
    }
  }

// ---- wrong: of equals the first in a loop with <=
// expects: Likely mistake: of equals the greatest number: the least
  while (order.size() < neighbours.size()) {
    int best = -1;
    for (int k = 0; k < int(neighbours.size()); ++k)
      if (std::find(order.begin(), order.end(), k) == order.end() &&
          (best < 0 || neighbours[k].size() <= neighbours[best].size()))
        best = k;
    order.push_back(best);
    for (const int a : neighbours[best]) {
      std::erase(neighbours[a], best);
      for (const int b : neighbours[best])
        if (b != a && std::find(neighbours[a].begin(), neighbours[a].end(), b) ==
            neighbours[a].end())
          neighbours[a].push_back(b);
    }
  }

// ---- wrong: stops where nobody has neighbours
// expects: Likely mistake: only 4 of 5 nodes: go on until none is left, also where a node has no
// change: while (!queue.empty()) ==> while (!queue.empty() && std::prev(queue.end())->first > 0)

// ---- wrong: one node too few
// expects: Likely mistake: only 4 of 5 nodes: go on until none is left, also where a node has no
// change: while (!queue.empty()) ==> while (queue.size() > 1)

// ---- wrong: nothing returned
// expects: Likely mistake: nothing is returned: push_back() each node as it is eliminated
// change: order.push_back(node); ==>

// ---- wrong: numbers from 1
// expects: Likely mistake: there is no node 5: they are counted from 0
// change: order.push_back(node) ==> order.push_back(node + 1)

// ---- wrong: the list's first neighbour follows
// expects: Exercise 9.3: the order of elimination Graph: a path of six nodes in a
  std::vector<std::set<int>> left;
  std::set<std::pair<std::size_t, int>> queue;
  for (const std::vector<int>& of_one : neighbours) {
    left.emplace_back(of_one.begin(), of_one.end());
    queue.insert({left.back().size(), int(left.size()) - 1});
  }
  while (!queue.empty()) {
  const int before = order.empty() ? -1 : order.back(); auto best = queue.begin();
      for (auto q = best; before >= 0 && q != queue.end() && q->first == best->first;
      ++q) if (!neighbours[before].empty() && neighbours[before][0] == q->second) best = q;
      const int node = best->second; queue.erase(best);
    order.push_back(node);
    for (const int a : left[node]) {
      queue.erase({left[a].size(), a});
      left[a].erase(node);
      for (const int b : left[node])
        if (b != a) left[a].insert(b);
      queue.insert({left[a].size(), a});
    }
  }

// ---- wrong: only one way filled
// expects: Likely mistake: who is eliminated comes back into the queue. It must leave the sets of
// change: if (b != a) ==> if (b > a)

// ---- wrong: old entries stay in the queue
// expects: Likely mistake: who is eliminated comes back into the queue. It must leave the sets of
// change: queue.erase({left[a].size(), a}); ==>

// ---- wrong: queue not erased before the change
// expects: Likely mistake: who is eliminated comes back into the queue. It must leave the sets of
  std::vector<std::set<int>> left;
  std::set<std::pair<std::size_t, int>> queue;
  for (const std::vector<int>& of_one : neighbours) {
    left.emplace_back(of_one.begin(), of_one.end());
    queue.insert({left.back().size(), int(left.size()) - 1});
  }
  while (!queue.empty()) {
    const int node = queue.begin()->second;
    queue.erase(queue.begin());
    order.push_back(node);
    for (const int a : left[node]) {
  left[a].erase(node); queue.erase({left[a].size(), a});
      for (const int b : left[node])
        if (b != a) left[a].insert(b);
      queue.insert({left[a].size(), a});
    }
  }

// ---- wrong: the first neighbour only
// expects: Likely mistake: who is eliminated comes back into the queue. It must leave the sets of
// change: if (b != a) left[a].insert(b); ==>
//         if (b != a && b == *left[node].begin()) left[a].insert(b);

// ---- wrong: doubled neighbours
// expects: Likely mistake: who is eliminated comes back into the queue. It must leave the sets of
  while (!neighbours.empty() && order.size() < neighbours.size()) {
    int best = -1;
    for (int k = 0; k < int(neighbours.size()); ++k)
      if (std::find(order.begin(), order.end(), k) == order.end() &&
          (best < 0 || neighbours[k].size() < neighbours[best].size()))
        best = k;
    order.push_back(best);
    const std::vector<int> around = neighbours[best];
    for (const int a : around) {
      std::erase(neighbours[a], best);
      for (const int b : around)
        if (b != a) neighbours[a].push_back(b);
    }
  }

// ---- right: without a queue
  std::vector<std::set<int>> left;
  std::set<int> nodes;
  for (const std::vector<int>& of_one : neighbours) {
    left.emplace_back(of_one.begin(), of_one.end());
    nodes.insert(int(left.size()) - 1);
  }
  while (!nodes.empty()) {
    int best = *nodes.begin();
    for (const int node : nodes)
      if (left[node].size() < left[best].size()) best = node;
    nodes.erase(best);
    order.push_back(best);
    for (const int a : left[best]) {
      left[a].insert(left[best].begin(), left[best].end());
      left[a].erase(a);
      left[a].erase(best);
    }
  }

// ---- right: a matrix of yes and no
  const std::size_t n = neighbours.size();
  std::vector<std::vector<char>> are(n, std::vector<char>(n, 0));
  for (std::size_t a = 0; a < n; ++a)
    for (const int b : neighbours[a]) are[a][std::size_t(b)] = 1;
  std::vector<char> gone(n, 0);
  while (order.size() < n) {
    std::size_t best = n;
    long least = 0;
    for (std::size_t a = 0; a < n; ++a) {
      if (gone[a]) continue;
      const long count = std::count(are[a].begin(), are[a].end(), 1);
      if (best == n || count < least) best = a, least = count;
    }
    gone[best] = 1;
    order.push_back(int(best));
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < n; ++b)
        if (a != b && are[best][a] && are[best][b]) are[a][b] = 1;
    for (std::size_t a = 0; a < n; ++a) are[a][best] = are[best][a] = 0;
  }
