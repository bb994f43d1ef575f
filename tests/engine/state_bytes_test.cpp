// A state becomes bytes and comes back; what is not the same library's, or not whole, is refused.
#include "engine/kept/state.h"
#include "tests/oracle/test.h"

namespace {

const std::size_t version_at = std::string_view("joints::State\n").size(),
                  kind_at = version_at + sizeof(int);

// A door with a limit.
World door(bool limited = true) {
  World world;
  const BodyId frame = world.add(static_body(vec3(0)));
  auto& hinge = world.add<HingeJoint>(frame, world.add(box(20, vec3(1), vec3(1, 0, 0))), vec3(0),
                                      vec3(0, 1, 0));
  if (limited) hinge.set_limits(0, 1);
  return world;
}

// The sentence with which bytes are refused, or "accepted".
std::string refused(const std::string& bytes) {
  return refusal([&] { from_bytes(bytes); });
}

}  // namespace

TEST_CASE("a state comes back from its bytes, infinite limits and all") {
  World world = door(), free = door(false);
  SequentialImpulses solver;
  for (int n = 0; n < 5; ++n) step(world, solver, real(0.01), {.warm_start = true});
  const State state = save(world);
  World other = door();
  restore(other, from_bytes(to_bytes(state)));
  CHECK(save(other) == state);
  CHECK(from_bytes(to_bytes(save(free))) == save(free));
  CHECK(from_bytes(to_bytes(State{})) == State{});
}

TEST_CASE("bytes of another version, structure or kind of number are refused with a sentence") {
  const std::string bytes = to_bytes(save(door()));
  std::string newer = bytes, narrow = bytes;
  newer[version_at] = 2;
  narrow[kind_at] = sizeof(real) == 4 ? 8 : 4;
  CHECK_THAT(refused(newer), ContainsSubstring("version 2; this library reads version 1"));
  CHECK_THAT(refused(narrow), ContainsSubstring("state: its numbers are ") &&
                                  ContainsSubstring("; this library's are "));
  narrow[kind_at] = 16;
  CHECK_THAT(refused(narrow), ContainsSubstring("of no known kind"));
  World other;
  CHECK_THAT(refusal([&] { restore(other, from_bytes(bytes)); }),
             ContainsSubstring("state: has 2 bodies; this world has 0"));
  CHECK_THAT(refused("a picture"), ContainsSubstring("no State"));
  CHECK_THAT(refused(""), ContainsSubstring("no State"));
  CHECK_THAT(refused(bytes + "x"), ContainsSubstring("go on behind its end"));
  for (std::size_t size = version_at; size < bytes.size(); ++size)
    CHECK_THAT(refused(bytes.substr(0, size)), ContainsSubstring("end too early"));
}

TEST_CASE("bytes that were changed anywhere are refused or restored, never more") {
  const std::string bytes = to_bytes(save(door()));
  World world = door();
  for (std::size_t at = 0; at < bytes.size(); ++at)
    for (const char bits : {'\x01', '\x80', '\xff'}) {
      std::string changed = bytes;
      changed[at] = char(changed[at] ^ bits);
      const std::string said = refusal([&] { restore(world, from_bytes(changed)); });
      CHECK((said == "accepted" || said.find(' ') != std::string::npos));
    }
}

TEST_CASE("what a state holds has not changed without another version") {
  const State state = save(door());
  CHECK(state.bodies.size() == 2 * 19);
  CHECK(state.shapes.at(0) == std::array{0, 1, 44});
}
