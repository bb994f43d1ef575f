// Adds and removes joints and bodies.
#include "engine/world.h"

#include <algorithm>
#include <atomic>

namespace joints {

void World::adopt(std::unique_ptr<Joint> joint) {
  joint->check_input(bodies);
  static std::atomic<std::uint64_t> joints{0};  // of all worlds
  joint->number_ = ++joints;
  joint->place_ = joints_.size();
  joints_.push_back(std::move(joint));
}

// The joints are in the order of their numbers.
Joint* World::find(std::uint64_t number) const {
  const auto& all = joints();
  const auto at = std::lower_bound(
      all.begin(), all.end(), number,
      [](const auto& joint, std::uint64_t wanted) { return joint->number_ < wanted; });
  return at != all.end() && (*at)->number_ == number ? at->get() : nullptr;
}

// The others keep their order: places are closed for all removed joints together.
void World::remove(const Joint& joint) {
  const std::size_t place = joint.place_;
  require(place < joints_.size() && joints_[place].get() == &joint, no_such_joint);
  joints_[place].reset();
  holes_ = true;
  blocks.clear();  // some may have been its own
}

void World::remove(BodyId body) {
  bodies.remove(body);
  for (auto& joint : joints_)
    if (joint && (joint->body1 == body || joint->body2 == body)) joint.reset();
  holes_ = true;
  blocks.clear();
}

void World::set_beta(real beta) {
  check_beta(beta);
  for (const auto& joint : joints()) joint->beta = beta;
}

}  // namespace joints
