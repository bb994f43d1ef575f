// How ./wb grade asks for an answer: the functions of a handed in file run in a process of their
// own, which gets arguments and gives numbers back. The tests and their report are in another one,
// which never runs that code.
#pragma once

#include <string>
#include <tuple>

#include "engine/body.h"
#include "engine/kept/bytes.h"

namespace joints {

/// All of a body but what a step keeps of it: no address is sent.
inline auto members(Body& body) {
  return std::tie(body.x, body.q, body.v, body.w, body.inverse_mass, body.inverse_inertia_local,
                  body.force, body.torque, body.kinematic, body.w_is_mean, body.precession,
                  body.mean);
}

}  // namespace joints

namespace joints::testing::remote {

/// What a message is. An answer asks when it needs something of the tests, such as a solver.
enum class Kind : char { call, asks, result, not_done, thrown };

void send(int to, Kind kind, const std::string& data);
/// False at the end of what is there.
bool receive(int from, Kind& kind, Bytes& bytes);

}  // namespace joints::testing::remote
