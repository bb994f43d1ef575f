// Adding, removing and counting.
#include "engine/world.h"

#include <algorithm>

namespace joints {

void Joint::begin_step(const Bodies&, real) {}
void Joint::second_look(const Bodies&, real, Blocks&) {}
Joint::Extras Joint::extras() const { return {}; }

void World::keep(std::unique_ptr<Joint> joint) {
  bodies.index(joint->body1);  // refuses ids that name no body
  bodies.index(joint->body2);
  const int rows = joint->most_rows();
  joints_.push_back(std::move(joint));
  most_rows_ += rows;
}

void World::remove(const Joint& joint) {
  const auto place = std::find_if(joints_.begin(), joints_.end(),
                                  [&](const auto& mine) { return mine.get() == &joint; });
  require(place != joints_.end(), "joint: this world has no such joint");
  most_rows_ -= (*place)->most_rows();
  joints_.erase(place);
}

void World::remove(BodyId body) {
  bodies.index(body);
  std::erase_if(joints_, [&](const auto& joint) {
    const bool held = joint->body1 == body || joint->body2 == body;
    if (held) most_rows_ -= joint->most_rows();
    return held;
  });
  bodies.remove(body);
}

Plan plan(const World& world, bool warm_start) {
  Plan plan;
  Blocks blocks;
  for (int slot = 0; slot < world.bodies.slots(); ++slot) {
    if (!world.bodies.used(slot)) continue;
    ++plan.bodies;
    if (world.bodies.at(slot).is_static()) ++plan.static_bodies;
  }
  for (const auto& joint : world.joints()) {
    joint->append(world.bodies, blocks);
    const Joint::Extras extras = joint->extras();
    plan.limits += extras.limits;
    plan.live_limits += extras.live_limits;
    plan.motors += extras.motors;
  }
  plan.blocks = int(blocks.list.size());
  plan.rows = int(blocks.J.size());
  plan.warm_start = warm_start;
  return plan;
}

std::string Plan::line() const {
  const auto text = [](int number) { return std::to_string(number); };
  return "bodies " + text(bodies) + " (" + text(static_bodies) + " static)  blocks " +
         text(blocks) + "  rows " + text(rows) + "  limits live " + text(live_limits) + " of " +
         text(limits) + "  motors " + text(motors) + "  warm start " + (warm_start ? "on" : "off");
}

}  // namespace joints
