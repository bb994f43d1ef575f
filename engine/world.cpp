// Adds and removes joints and bodies.
#include "engine/world.h"

#include <algorithm>

namespace joints {

void World::adopt(std::unique_ptr<Joint> joint) {
  joint->check_input(bodies);
  joints_.push_back(std::move(joint));
}

void World::remove(const Joint& joint) {
  const auto place = std::find_if(joints_.begin(), joints_.end(),
                                  [&](const auto& mine) { return mine.get() == &joint; });
  require(place != joints_.end(), "joint: this world has no such joint");
  joints_.erase(place);
  blocks.clear();  // some may have belonged to it
}

void World::remove(BodyId body) {
  bodies.remove(body);
  std::erase_if(joints_, [&](const auto& joint) {
    return joint->body1 == body || joint->body2 == body;
  });
  blocks.clear();
}

void World::set_beta(real beta) {
  check_beta(beta);
  for (const auto& joint : joints_) joint->beta = beta;
}

}  // namespace joints
