// Contacts at supplied points: kept impulses, pairs that come and go, saving and restoring.
#include "contacts/contacts.h"
#include "engine/kept/state.h"
#include "tests/ground/rigs.h"
#include "tests/oracle/test.h"

using Catch::Matchers::StartsWith;

namespace {

const real h = real(1) / 60;

// The corners of a box over a level ground through the origin, at a pose.
std::vector<ContactPlace> corners_over_ground(const Body& ground, const Body& body) {
  std::vector<ContactPlace> out;
  const Outline outline = box_outline(brick);
  for (int k = 0; k < 8; ++k) {
    const vec3 corner = outline.corners[std::size_t(k)], p = world_point(body, corner);
    const vec3 below = to_local(ground, vec3(p.x, 0, p.z) - ground.x);
    if (p.y < real(0.01)) out.push_back({below, corner, vec3(0, 1, 0), k});
  }
  return out;
}

struct Falling {
  World world;
  BodyId ground = world.add(static_body(vec3(0)));
  BodyId body;
  Contacts contacts{world, h};
  SequentialImpulses solver;
  explicit Falling(const Body& made) : body(world.add(made)) { solver.iterations = 8; }
  void one_step() {
    contacts.begin();
    const auto places = corners_over_ground(world.bodies[ground], contacts.ahead(body));
    if (!places.empty()) contacts.touch(ground, body, places);
    contacts.end();
    step(world, solver, h, {.warm_start = true, .substeps = 4});
  }
};

}  // namespace

TEST_CASE("a box on supplied points lands, sinks in by no more than 2 cm and comes to rest") {
  Random random(84);
  for (int draw = 0; draw < 10; ++draw) {
    Falling one(lowered(real(0.5), random.turn()));
    double deepest = 0;
    for (int n = 0; n < 300; ++n) {
      one.one_step();
      for (const vec3& corner : box_outline(brick).corners)
        deepest = std::max(deepest, -double(world_point(one.world.bodies[one.body], corner).y));
    }
    CAPTURE(draw);
    CHECK(one.contacts.count() == 1);
    CHECK(double(length(one.world.bodies[one.body].v)) < 1e-2);
    CHECK(deepest < 0.02);
  }
}

TEST_CASE("impulses are kept by id or by place, and new points take over those that vanish") {
  World world;
  const BodyId a = world.add(static_body(vec3(0)));
  const BodyId b = world.add(box(10, vec3(1), vec3(0, real(0.5), 0)));
  auto& joint = world.add<ContactJoint>(a, b);
  const auto force = [&] {  // the cached impulses, before a step changes them
    Blocks blocks;
    joint.begin_step(world.bodies, h);
    joint.append(world.bodies, blocks);
    double sum = 0;
    for (const Block& block : blocks.list)
      if (block.settings.follows == 0) sum += double(*block.impulse);
    return sum;
  };
  for (const int id : {7, -1}) {
    const auto at = [id](real x, int which) {
      return ContactPlace{vec3(x, 0, 0), vec3(x, real(-0.5), 0), vec3(0, 1, 0),
                          id < 0 ? -1 : which};
    };
    joint.set_places(std::vector{at(0, 7)});
    SequentialImpulses solver;
    step(world, solver, h, {.warm_start = true});
    const double before = force();
    REQUIRE(before > 0.5);
    joint.set_places(std::vector{at(real(0.3), 8), at(real(0.001), 7)});
    CHECK(force() == Approx(before));  // the other one begins with none
    joint.set_places(std::vector{at(real(0.5), 9), at(real(0.7), 10)});
    CHECK(force() == Approx(before));  // half of it each
    joint.set_places({});
    CHECK(joint.touching() == 0);
    CHECK(joint.gap(world.bodies) == unbounded);
  }
  CHECK_THAT(refusal([&] { joint.set_places(std::vector{ContactPlace{}}); }), StartsWith("normal"));
}

TEST_CASE("pairs come and go and are skipped and forget bodies that were removed") {
  World world;
  const BodyId a = world.add(static_body(vec3(0))), b = world.add(box(1, vec3(1), vec3(0, 1, 0)));
  const BodyId c = world.add(box(1, vec3(1), vec3(0, 2, 0)));
  world.add<BallJoint>(b, c, Point{});
  Contacts contacts(world, h);
  contacts.skip_joined();
  CHECK(contacts.skips(b, c));
  CHECK(contacts.skips(c, b));
  CHECK_FALSE(contacts.skips(a, b));
  const std::vector one{ContactPlace{vec3(0), vec3(0), vec3(0, 1, 0)}};
  contacts.begin();
  ContactJoint& joint = contacts.touch(a, b, one);
  contacts.touch(a, c, one);
  contacts.end();
  CHECK(world.joints().size() == 3);
  CHECK(double(joint.frequency) == Approx(60));
  contacts.begin();
  CHECK(&contacts.touch(a, b, one) == &joint);
  contacts.end();
  CHECK(world.joints().size() == 2);
  world.remove(b);
  contacts.begin();
  contacts.end();
  CHECK(contacts.count() == 0);
  CHECK(world.joints().empty());
}

TEST_CASE("a world is restored across contacts that came or went, to the bit") {
  Random random(85);
  Falling one(lowered(real(0.3), random.turn()));
  for (int n = 0; n < 40; ++n) {
    const State state = save(one.world);
    const Contacts::Saved saved = one.contacts.save();
    const auto run = [&] {
      for (int k = 0; k < 30; ++k) one.one_step();
      return save(one.world);
    };
    const State first = run();
    restore(one.world, state);
    one.contacts.restore(saved);
    CHECK(run() == first);
    restore(one.world, state);
    one.contacts.restore(saved);
    one.one_step();
  }
  CHECK(one.contacts.count() == 1);
}

TEST_CASE("many joints are removed in any order, and the others keep theirs") {
  World world;
  const BodyId a = world.add(static_body(vec3(0))), b = world.add(box(1, vec3(1), vec3(0)));
  std::vector<const Joint*> all;
  for (int k = 0; k < 100; ++k) all.push_back(&world.add<BallJoint>(a, b, Point{}));
  for (int k = 0; k < 100; k += 3) world.remove(*all[std::size_t(k)]);
  std::vector<const Joint*> left;
  for (int k = 0; k < 100; ++k)
    if (k % 3 != 0) left.push_back(all[std::size_t(k)]);
  REQUIRE(world.joints().size() == left.size());
  for (std::size_t k = 0; k < left.size(); ++k) CHECK(world.joints()[k].get() == left[k]);
  World other;
  CHECK_THROWS_AS(other.remove(*left[0]), std::invalid_argument);
  world.remove(*left[5]);
  world.add<BallJoint>(a, b, Point{});
  CHECK(world.joints().size() == left.size());
}
