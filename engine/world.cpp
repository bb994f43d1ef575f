// Adds and removes joints and bodies.
#include "engine/world.h"

#include <algorithm>
#include <atomic>

namespace joints {

void World::adopt(std::unique_ptr<Joint> joint) {
  joint->check_input(bodies);
  static std::atomic<std::uint64_t> count{0};  // of all worlds
  joint->number_ = ++count;
  joint->place_ = joints_.size();
  joints_.push_back(std::move(joint));
}

// The joints are in the order of their numbers.
Joint* World::find(std::uint64_t number) const {
  const auto at = std::lower_bound(
      joints_.begin(), joints_.end(), number,
      [](const auto& joint, std::uint64_t wanted) { return joint->number_ < wanted; });
  const bool there = at != joints_.end() && (*at)->number_ == number && !(*at)->removed_;
  return there ? at->get() : nullptr;
}

// Removed joints stay in their places until joints() is called again, so that a loop over all of
// them may remove some. Then all their places are closed together, and the others keep their order.
void World::remove(const Joint& joint) {
  const std::size_t place = joint.place_;
  require(place < joints_.size() && joints_[place].get() == &joint && !joint.removed_,
          no_such_joint);
  joints_[place]->removed_ = holes_ = true;
  blocks.clear();  // some may have been its own
}

void World::remove(BodyId body) {
  bodies.remove(body);
  for (const auto& joint : joints_)
    if (joint->body1 == body || joint->body2 == body) joint->removed_ = holes_ = true;
  blocks.clear();
}

void World::set_beta(real beta) {
  check_beta(beta);
  for (const auto& joint : joints()) joint->beta = beta;
}

}  // namespace joints
