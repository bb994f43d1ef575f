// Adds and removes joints and bodies.
#include "engine/world.h"

#include <algorithm>

namespace joints {

void World::adopt(std::unique_ptr<Joint> joint) {
  joint->check_input(bodies);
  const int rows = joint->most_rows();
  joints_.push_back(std::move(joint));
  most_rows_ += rows;
  most_rows_of_one_ = std::max(most_rows_of_one_, rows);
}

void World::remove(const Joint& joint) {
  const auto place = std::find_if(joints_.begin(), joints_.end(),
                                  [&](const auto& mine) { return mine.get() == &joint; });
  require(place != joints_.end(), "joint: this world has no such joint");
  most_rows_ -= (*place)->most_rows();
  joints_.erase(place);
  blocks.clear();  // some may have been its own
}

void World::remove(BodyId body) {
  bodies.index(body);
  std::erase_if(joints_, [&](const auto& joint) {
    const bool held = joint->body1 == body || joint->body2 == body;
    if (held) most_rows_ -= joint->most_rows();
    return held;
  });
  bodies.remove(body);
  blocks.clear();
}

}  // namespace joints
