// Saves and restores the numbers of a world.
#include "engine/kept/state.h"

#include <cstdint>
#include <stdexcept>
#include <string>
#include <typeinfo>

#include "engine/kept/input.h"
#include "engine/kept/state_stream.h"

namespace joints {

namespace {

void exchange(Body& body, StateStream& stream) {
  stream(body.x, body.q, body.v, body.w, body.force, body.torque);
}

// 0 static, 1 kinematic, 2 moved by forces.
int kind(const Body& body) { return body.is_static() ? int(body.kinematic) : 2; }

// A number of the type, from its name.
int kind(const Joint& joint) {
  std::uint32_t sum = 2166136261u;  // FNV-1a
  for (const char* at = typeid(joint).name(); *at; ++at)
    sum = (sum ^ std::uint8_t(*at)) * 16777619u;
  return int(sum >> 1);
}

std::string text(const std::array<int, 3>& shape) {
  return "holds the bodies in slots " + std::to_string(shape[0]) + " and " +
         std::to_string(shape[1]) + " and has " + std::to_string(shape[2]) + " numbers";
}

void require_same(const char* what, std::size_t theirs, std::size_t ours) {
  if (theirs != ours)
    refuse("state: has " + std::to_string(theirs) + " " + what + "; this world has " +
           std::to_string(ours));
}

// Rejects a state with another structure than this world.
void require_shape(const State& state, const State& own) {
  require_same("bodies", state.slots.size(), own.slots.size());
  for (std::size_t k = 0; k < own.slots.size(); ++k)
    if (state.slots[k] != own.slots[k])
      refuse("state: has a body in slot " + std::to_string(state.slots[k]) +
             "; this world has it in slot " + std::to_string(own.slots[k]));
  require_same("joints", state.shapes.size(), own.shapes.size());
  for (std::size_t k = 0; k < own.shapes.size(); ++k)
    if (state.shapes[k] != own.shapes[k])
      refuse("state: joint " + std::to_string(k) + " " + text(state.shapes[k]) +
             "; this world's " + text(own.shapes[k]));
  require_same("kinds", state.kinds.size(), own.kinds.size());
  for (std::size_t k = 0; k < own.kinds.size(); ++k) {
    const std::size_t bodies = own.slots.size();
    if (state.kinds[k] == own.kinds[k]) continue;
    refuse(k < bodies ? "state: the body in slot " + std::to_string(own.slots[k]) +
                            " is static, kinematic or moving, unlike this world's"
                      : "state: joint " + std::to_string(k - bodies) +
                            " is of another kind than this world's");
  }
  require_same("numbers of bodies", state.bodies.size(), own.bodies.size());
  require_same("numbers of joints", state.joints.size(), own.joints.size());
}

// Sets a world to a state of the same structure.
void write(World& world, const State& state) {
  world.last_h = state.last_h;
  world.blocks.impulse_duration = state.impulse_duration;
  world.blocks.memory = state.memory;
  StateStream bodies(state.bodies.data()), numbers(state.joints.data());
  for (const int slot : state.slots) exchange(world.bodies.at(slot), bodies);
  for (const auto& joint : world.joints())
    if (!joint->transient()) serialize(*joint, numbers);
}

}  // namespace

State save(const World& world) {
  State out;
  out.last_h = world.last_h;
  out.impulse_duration = world.blocks.impulse_duration;
  out.memory = world.blocks.memory;
  StateStream bodies(out.bodies), numbers(out.joints);
  for (int slot = 0; slot < world.bodies.slots(); ++slot) {
    if (!world.bodies.used(slot)) continue;
    Body body = world.bodies.at(slot);
    exchange(body, bodies);
    out.slots.push_back(slot);
    out.kinds.push_back(kind(body));
  }
  for (const auto& joint : world.joints()) {
    if (joint->transient()) continue;
    const std::size_t before = out.joints.size();
    serialize(*joint, numbers);
    out.shapes.push_back({int(joint->body1.slot), int(joint->body2.slot),
                          int(out.joints.size() - before)});
    out.kinds.push_back(kind(*joint));
  }
  return out;
}

void restore(World& world, const State& state) {
  const State own = save(world);
  require_shape(state, own);
  try {
    write(world, state);
    require(finite(state.impulse_duration) && state.impulse_duration >= 0,
            "state: impulse_duration", state.impulse_duration,
            "must be finite and not negative [s]");
    for (const real number : state.memory)
      require(finite(number), "state: memory", number, "must be finite");
    check_input(world, longest_step);
  } catch (const std::invalid_argument&) {
    write(world, own);
    throw;
  }
  world.blocks.clear();  // of another step
  for (Body& body : world.bodies) body.w_is_mean = false;  // nor is it within a step
}

}  // namespace joints
