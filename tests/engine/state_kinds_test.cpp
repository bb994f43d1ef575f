// A state belongs to a world of the same kinds of joints and bodies.
#include "engine/kept/state.h"
#include "tests/oracle/test.h"

using Catch::Matchers::StartsWith;

TEST_CASE("the state of a world with other kinds of joints or bodies is refused") {
  const auto with = [](auto add, bool kinematic = false, bool free = false) {
    World world;
    Body wall = static_body(vec3(0));
    wall.kinematic = kinematic;
    const BodyId a = world.add(free ? box(1, vec3(1), vec3(0)) : wall);
    add(world, a, world.add(box(1, vec3(1), vec3(0, -1, 0))));
    return world;
  };
  const auto rod = [](World& w, BodyId a, BodyId b) {
    w.add<DistanceJoint>(a, b, vec3(0), vec3(0, -1, 0));
  };
  const auto rope = [](World& w, BodyId a, BodyId b) {
    w.add<RopeJoint>(a, b, vec3(0), vec3(0, -1, 0));
  };
  World one = with(rod), other = with(rope), lift = with(rod, true), loose = with(rod, false, true);
  const State before = save(other);
  CHECK_THAT(refusal([&] { restore(other, save(one)); }),
             StartsWith("state: joint 0 is of another kind"));
  CHECK(save(other) == before);
  for (World* world : {&lift, &loose})
    CHECK_THAT(refusal([&] { restore(*world, save(one)); }),
               StartsWith("state: the body in slot 0 is static, kinematic or moving"));
  World same = with(rod);
  CHECK(refusal([&] { restore(same, save(one)); }) == "accepted");
}
