// Orders of blocks by the list and by colours.
#include "engine/simd/lane_order.h"

#include <algorithm>
#include <numeric>

namespace joints {

void LaneOrder::clear(int lanes, int slots) {
  width = lanes;
  columns = false;
  blocks.clear();
  ends.clear();
  bodies.resize(std::size_t(slots));
  std::iota(bodies.begin(), bodies.end(), 0);
}

void LaneOrder::append(const int* lanes, const std::vector<Member>& members) {
  for (int BodyPair::*end : {&BodyPair::body1, &BodyPair::body2})
    for (int lane = 0; lane < width; ++lane) {
      int record = -1;
      if (lanes[lane] >= 0)
        record = members[std::size_t(lanes[lane])].bodies.*end;
      else if (end == &BodyPair::body2)  // the zeros of body 1 serve for both
        record = ends[ends.size() - std::size_t(width)];
      if (record < 0) {
        record = int(bodies.size());
        bodies.push_back(-1);
      }
      ends.push_back(record);
    }
  blocks.insert(blocks.end(), lanes, lanes + width);
}

void append_in_turn(LaneOrder& order, const std::vector<Member>& members, int first) {
  for (int k = first; k < int(members.size()); ++k) order.append(&k, members);
}

void GreedyColours::append(LaneOrder& order, const std::vector<Member>& members, int first) {
  const std::size_t bodies = order.bodies.size();
  for (auto& taken : taken_) taken.assign(bodies, false);
  sorted_.clear();
  sorted_.reserve(members.size());
  for (int k = first; k < int(members.size()); ++k) {
    const BodyPair& pair = members[std::size_t(k)].bodies;
    std::size_t colour = 0;
    const auto is_taken = [&](int body) { return body >= 0 && taken_[colour][body]; };
    while (colour < taken_.size() && (is_taken(pair.body1) || is_taken(pair.body2))) ++colour;
    if (colour == taken_.size()) taken_.emplace_back(bodies);
    for (const int body : {pair.body1, pair.body2})
      if (body >= 0) taken_[colour][body] = true;
    sorted_.push_back({int(colour) * 256 + members[std::size_t(k)].kind, k});
  }
  std::sort(sorted_.begin(), sorted_.end());
  lanes_.resize(std::size_t(order.width));
  for (std::size_t k = 0; k < sorted_.size();) {
    const int begin = sorted_[k][0];
    std::fill(lanes_.begin(), lanes_.end(), -1);
    for (int& lane : lanes_)
      if (k < sorted_.size() && sorted_[k][0] == begin) lane = sorted_[k++][1];
    order.append(lanes_.data(), members);
  }
}

}  // namespace joints
