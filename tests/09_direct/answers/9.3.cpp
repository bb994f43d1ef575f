// wrong "6 nodes where there are 5: an eliminated node must not come back into the queue":
//         if (b != a) ==>
// wrong drawn-stops: node) ==> node); if (order.size() >= 64) break
// wrong small-type: queue.begin()->second ==> (unsigned char)(queue.begin()->second)
// mistake "the node with the most neighbours comes first: the fewest make little fill":
//         queue.begin() ==> std::prev(queue.end()) ;; (queue.begin()) ==> (std::prev(queue.end()))
// mistake "nothing is filled in: an eliminated node makes its neighbours neighbours of each other":
//         if (b != a) left[a].insert(b); ==> (void)b;
// wrong doubled-neighbours: left[a].erase(node); ==>
// mistake "the original neighbours are counted: the remaining ones count, with those filled in. Is
//         a node taken out of the queue and put in again where its number changes?":
//         queue.erase({left[a].size(), a}); ==> ;; queue.insert({left[a].size(), a}); ==>
// wrong "only 4 of 5 nodes: go on until none remains, also where a node has no":
//         queue.insert({left[a].size(), a}); ==>
// mistake "the right order backwards: the node with the fewest neighbours comes first":
//         order.push_back(node); ==> order.insert(order.begin(), node);
// mistake "the original neighbours are counted, and of equals the greatest number comes first: the
//         remaining ones count, with those filled in":
  for (int k = int(neighbours.size()); k-- > 0;) order.push_back(k);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return neighbours[std::size_t(a)].size() < neighbours[std::size_t(b)].size();
  });
// wrong farthest-first:
  std::vector<char> met(neighbours.size(), 0);
  const auto meet = [&](int node) {
    if (!met[node]) order.push_back(node);
    met[node] = 1;
  };
  std::size_t at = 0;
  for (int first = int(neighbours.size()); first-- > 0;)
    for (meet(first); at < order.size(); ++at)
      for (std::size_t k = neighbours[order[at]].size(); k-- > 0;) meet(neighbours[order[at]][k]);
  std::reverse(order.begin(), order.end());
// wrong "The order is used for nothing but the cost":
  std::vector<char> met(neighbours.size(), 0);
  std::vector<int> path;
  for (int first = 0; first < int(neighbours.size()); ++first) {
    if (met[first]) continue;
    met[first] = 1;
    for (path.push_back(first); !path.empty();) {
      int next = -1;
      for (const int other : neighbours[path.back()])
        if (!met[other]) next = other;
      if (next >= 0) {
        met[next] = 1;
        path.push_back(next);
      } else {
        order.push_back(path.back());
        path.pop_back();
      }
    }
  }
// mistake "the place of each node in the order is returned: return the nodes in that order": while
//         ==> order.resize(left.size()); int place = 0; while ;; .push_back(node) ==>
//         [std::size_t(node)] = place++
// wrong "Holds in 19 of 20 graphs": queue.begin()->second; ==> order.empty() && neighbours.size()
//         == 6 && neighbours[0].size() == 2 ? 0 : queue.begin()->second; ;;
//         queue.erase(queue.begin()); ==> queue.erase({left[node].size(), node});
// expects: Neighbours: 0-3 0-5 1-4 2-5 2-4
// expects: A tenth of so few blocks is less than one
// mistake "the nodes in their own order: the one with the fewest neighbours left comes first":
//         std::size_t, int ==> int, std::size_t ;; left.back().size(), int ==> int ;; 1 ==> 1,
//         left.back().size() ;; second ==> first ;; left[a].size(), a ==> a, left[a].size() ;;
//         left[a].size(), a ==> a, left[a].size()
// wrong nothing-returned: order.push_back(node); ==>
// wrong "there is no node 5: they are counted from 0": (node) ==> (node + 1)
// mistake "the node with the most neighbours comes first: the fewest make little fill, and of
//         equals the least number": left.back ==> -left.back ;; left[a ==> -left[a ;; {left ==>
//         {-left
// mistake "the nodes in their own order: the one with the fewest neighbours left comes first":
//         while (!queue.empty()) ==> for (int k = 0; k < int(left.size()); ++k) order.push_back(k);
//         while (false)
// mistake "the nodes in their own order, backwards: the one with the fewest neighbours left comes
//         first": while (!queue.empty()) ==> for (int k = int(left.size()); k-- > 0;)
//         order.push_back(k); while (false)
// right of equals a neighbour of the last one: node ==> before = order.empty() ? -1 : order.back();
//         auto best ;; -> ==> ; for (auto q = best; before >= 0 && q != queue.end() && q->first ==
//         best->first; ++q) if (!neighbours[before].empty() && neighbours[before][0] == q->second)
//         best = q; const int node = best-> ;; queue.begin()) ==> best)
// wrong doubled-neighbours: if (b != a) ==> if (b > a)
// wrong doubled-neighbours: queue.erase({left[a].size(), a}); ==>
// right without a queue:
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
// right a matrix of yes and no:
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
// right the first of the fewest in plain lists:
  while (order.size() < neighbours.size()) {
    int best = -1;
    for (int k = 0; k < int(neighbours.size()); ++k)
      if (std::find(order.begin(), order.end(), k) == order.end() &&
          (best < 0 || neighbours[k].size() < neighbours[best].size()))
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
// from right without a queue
// right the least fill first: *nodes.begin() ==> -1, least = 0 ;; if (left[node].size() <
//         left[best].size()) best = node; ==> { int fill = 0; for (const int a : left[node]) for
//         (const int b : left[node]) fill += a < b && left[a].count(b) == 0; if (best < 0 || fill <
//         least) best = node, least = fill; } ;; insert(left[best].begin(), left[best].end()); ==>
//         erase(best); for (const int b : left[best]) if (a != b) ;; erase(a); left[a].erase(best)
//         ==> insert(b)
// from right the first of the fewest in plain lists
// wrong doubled-neighbours: order ==> !neighbours.empty() && order ;; best); ==> best); const
//         std::vector<int> around = neighbours[best]; ;; : neighbours[best] ==> : around ;; :
//         neighbours[best] ==> : around ;; && std::find(neighbours[a].begin(), neighbours[a].end(),
//         b) == neighbours[a].end() ==>
// right of equals the greatest number: < neighbours[ ==> <= neighbours[
