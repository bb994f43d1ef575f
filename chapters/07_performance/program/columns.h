// A chain a lane: no body has to leave its lane, so the velocities can stand in memory as the lanes
// want them. Given, there is nothing to edit here.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "chapters/07_performance/performance.h"

/// \addtogroup chapter7
/// @{
namespace joints {

/// Joints that are solved side by side, in groups that come one after the other.
using Groups = std::vector<std::vector<int>>;

/// Where the bodies stand: `width` of them side by side in a column, each in the lane that it has
/// in all of its groups. A static body has a copy in every lane that needs it.
struct Columns {
  std::vector<int> body;  ///< of each column, lane by lane; -1 where a lane has none
  std::vector<int> end1;  ///< of each group, the column of its bodies 1
  std::vector<int> end2;  ///< and of its bodies 2
};

/// The columns of some groups, or nothing where a body would have to change its lane.
inline std::optional<Columns> columns_of(const Groups& groups, const std::vector<BodyPair>& links,
                                         const std::vector<Body>& bodies, int width) {
  Columns out;
  std::map<std::pair<int, int>, int> place;  // lane and body -> its column
  std::vector<int> lane_of(bodies.size(), -1);
  for (const auto& group : groups)
    for (const bool first : {true, false}) {
      const auto body_in = [&](int lane) {
        const BodyPair& link = links[std::size_t(group[std::size_t(lane)])];
        return first ? link.body1 : link.body2;
      };
      int column = -1;  // the same in all lanes: one that a body has already, or a new one
      for (int lane = 0; lane < int(group.size()); ++lane)
        if (const auto at = place.find({lane, body_in(lane)}); at != place.end())
          column = at->second;
      if (column < 0) {
        column = int(out.body.size()) / width;
        out.body.resize(out.body.size() + std::size_t(width), -1);
      }
      for (int lane = 0; lane < int(group.size()); ++lane) {
        const int body = body_in(lane);
        if (!bodies[std::size_t(body)].is_static()) {
          int& its_lane = lane_of[std::size_t(body)];
          if (its_lane >= 0 && its_lane != lane) return {};
          its_lane = lane;
        }
        if (place.try_emplace({lane, body}, column).first->second != column) return {};
        int& tenant = out.body[std::size_t(column * width + lane)];
        if (tenant >= 0 && tenant != body) return {};
        tenant = body;
      }
      (first ? out.end1 : out.end2).push_back(column);
    }
  return out;
}

}  // namespace joints
/// @}
