// The check is quick: it forms one sum over all numbers of a body, which is not finite if one of
// them is not. Only then are the numbers checked one by one.
#include "engine/kept/input.h"

#include <stdexcept>
#include <string>

namespace joints {

namespace {

// Runs a check. If it throws, the message gets the name of the checked object, as in "joint 3: ".
template <class Check>
void named(const char* what, std::size_t number, const Check& check) {
  try {
    check();
  } catch (const std::invalid_argument& error) {
    refuse(what + (" " + std::to_string(number)) + ": " + error.what());
  }
}

// True if check() accepts this body, which can move. A static one is always checked in full.
bool is_good(const Body& body) {
  const vec3& inverse = body.inverse_inertia_local;
  return finite(sum(body.x + body.v + body.w + body.force + body.torque + inverse) +
                body.inverse_mass) &&
         is_unit(body.q) && body.inverse_mass > 0 && inverse.x > 0 && inverse.y > 0 &&
         inverse.z > 0;
}

bool is_step(real h) { return h >= shortest_step && h <= longest_step; }

}  // namespace

void check_input(const World& world, real h) {
  require(is_step(h), "h", h, "must be from 1e-9 to 1e9 [s]; 1 / 60 is 0, real(1) / 60 is not");
  require(world.last_h == 0 || is_step(world.last_h), "last_h", world.last_h,
          "must be 0 or the length of a step [s]");
  require(finite(world.gravity), "gravity", world.gravity, "must be finite [m/s^2]");
  require(world.max_displacement > 0, "max_displacement", world.max_displacement,
          "must be positive [m]");
  const Bodies& bodies = world.bodies;
  for (int slot = 0, end = bodies.slots(); slot < end; ++slot)
    if (const Body& body = bodies.at(slot); !is_good(body))
      named("body", std::size_t(slot), [&] { check(body); });
  std::size_t number = 0;
  for (const auto& joint : world.joints())
    named("joint", number++, [&] { joint->check_input(bodies); });
}

void check_input(const World& world, const Solver& solver, real h) {
  solver.check();
  check_input(world, h);
}

void check_motion(const Bodies& bodies) {
  for (int slot = 0, end = bodies.slots(); slot < end; ++slot) {
    const Body& body = bodies.at(slot);
    if (finite(sum(body.x + body.v + body.w) + sum(body.q))) continue;
    try {
      check(body);
    } catch (const std::invalid_argument& error) {
      throw std::overflow_error("body " + std::to_string(slot) + ": " + error.what() +
                                "; a number has overflowed in this step");
    }
  }
}

}  // namespace joints
