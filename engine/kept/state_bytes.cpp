// A state as bytes: what they are, the version, the size of a number, then the lists.
#include "engine/kept/bytes.h"
#include "engine/kept/state.h"

namespace joints {

namespace {

constexpr std::string_view beginning = "joints::State\n";
constexpr int version = 1;  // to be raised when a State holds something else, or in another order

std::string said(std::size_t size) {
  return size == sizeof(float) ? "float" : size == sizeof(double) ? "double" : "of no known kind";
}

}  // namespace

static auto members(State& state) {
  return std::tie(state.last_h, state.impulse_duration, state.memory, state.slots, state.bodies,
                  state.shapes, state.kinds, state.joints);
}

std::string to_bytes(const State& state) {
  Bytes out{std::string(beginning)};
  put(out, version);
  put(out, sizeof(real));
  put(out, state);
  return out.data;
}

State from_bytes(std::string_view bytes) {
  if (!bytes.starts_with(beginning)) refuse("state: these bytes are no State");
  Bytes in{std::string(bytes), beginning.size()};
  if (const int theirs = got<int>(in); theirs != version)
    refuse("state: the bytes are of version " + std::to_string(theirs) +
           "; this library reads version " + std::to_string(version));
  if (const auto theirs = got<std::size_t>(in); theirs != sizeof(real))
    refuse("state: its numbers are " + said(theirs) + "; this library's are " +
           said(sizeof(real)));
  State state;
  get(in, state);
  if (in.at != bytes.size()) refuse("state: the bytes go on behind its end");
  return state;
}

}  // namespace joints
