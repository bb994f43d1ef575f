// Closed loops of joints: Tarjan's depth-first search, with an explicit stack.
#include "chapters/09_direct/closed_loops.h"

#include <algorithm>

namespace joints {

namespace {

struct Search {
  const std::vector<BodyPair>& joints;
  std::vector<std::vector<int>> joints_of;  // of each body
  std::vector<int> number, lowest;  // of each body: its order of visit, the lowest one in reach
  std::vector<int> met;             // joints whose loop is not known yet
  std::vector<int> loop;            // of each joint
  int bodies_met = 0, loops = 0;

  struct Place {  // on the way from the first body
    int body, from;  // the joint by which it was reached
    std::size_t next = 0;  // of the body's joints
  };

  Search(const std::vector<BodyPair>& joints, int bodies)
      : joints(joints), joints_of(std::size_t(bodies)), number(std::size_t(bodies), -1),
        lowest(number), loop(joints.size(), -1) {
    for (int k = 0; k < int(joints.size()); ++k)
      for (const int body : {joints[k].body1, joints[k].body2}) joints_of[body].push_back(k);
    for (int body = 0; body < bodies; ++body)
      if (number[body] < 0) search(body);
  }
  void search(int first) {
    std::vector<Place> way;
    enter(way, first, -1);
    while (!way.empty()) {
      Place& here = way.back();
      if (here.next < joints_of[here.body].size()) follow(way, joints_of[here.body][here.next++]);
      else leave(way);
    }
  }
  void enter(std::vector<Place>& way, int body, int from) {
    number[body] = lowest[body] = bodies_met++;
    way.push_back({body, from});
  }
  void follow(std::vector<Place>& way, int joint) {
    const Place& here = way.back();
    if (joint == here.from) return;
    const int body = here.body, other = joints[joint].body1 + joints[joint].body2 - body;
    if (number[other] > number[body]) return;  // seen from there
    met.push_back(joint);
    if (number[other] < 0) enter(way, other, joint);
    else lowest[body] = std::min(lowest[body], number[other]);
  }
  // Joints met after the body's own joint are in its loop, unless an earlier body is in reach.
  void leave(std::vector<Place>& way) {
    const Place end = way.back();
    way.pop_back();
    if (way.empty()) return;
    const int before = way.back().body;
    lowest[before] = std::min(lowest[before], lowest[end.body]);
    if (lowest[end.body] < number[before]) return;
    if (met.back() != end.from) {
      for (; met.back() != end.from; met.pop_back()) loop[met.back()] = loops;
      loop[end.from] = loops++;
    }
    met.pop_back();
  }
};

}  // namespace

std::vector<int> closed_loops(const std::vector<BodyPair>& joints, int bodies) {
  return Search(joints, bodies).loop;
}

}  // namespace joints
