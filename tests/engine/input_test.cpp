// Bad input is refused with the argument named, and the world stays as it was (case X16).
#include "engine/instruments/options.h"
#include "tests/oracle/test.h"

using Catch::Matchers::StartsWith;

namespace {

const real h = real(1) / 60;
const real no_number = std::numeric_limits<real>::quiet_NaN();
const real bad_numbers[] = {0, -1, no_number, unbounded, -unbounded};  // where a size is wanted

// A good body with one field spoilt.
template <class Spoil>
Body spoilt(Spoil spoil) {
  Body body = box(2, vec3(1, 2, 3), vec3(0));
  spoil(body);
  return body;
}

// A ceiling with a weight under it, moving.
struct Small {
  World world;
  BodyId ceiling, weight;
  Small() {
    ceiling = world.add(static_body(vec3(0)));
    weight = world.add(ball(2, 1, vec3(0, -1, 0)));
    world.bodies[weight].v = vec3(1, 2, 3);
    world.add<CentreDistanceJoint>(ceiling, weight, CentreDistance{1});
  }
  // Nothing was added and nothing has moved.
  bool unchanged() const {
    const Body& body = world.bodies[weight];
    return world.bodies.size() == 2 && world.bodies.slots() == 2 && world.joints().size() == 1 &&
           world.joints().size() == 1 && body.x == vec3(0, -1, 0) && body.v == vec3(1, 2, 3);
  }
};

}  // namespace

TEST_CASE("X16 a box or ball without a proper mass or size is refused") {
  for (real bad : bad_numbers) {
    CAPTURE(bad);
    CHECK_THAT(refusal([&] { box(bad, vec3(1), vec3(0)); }), StartsWith("mass:"));
    CHECK_THAT(refusal([&] { ball(bad, 1, vec3(0)); }), StartsWith("mass:"));
    CHECK_THAT(refusal([&] { body_with(bad, vec3(1), vec3(0)); }), StartsWith("mass:"));
    CHECK_THAT(refusal([&] { ball(1, bad, vec3(0)); }), StartsWith("radius:"));
    for (int k = 0; k < 3; ++k) {
      vec3 triple(1);
      triple[k] = bad;
      CHECK_THAT(refusal([&] { box(1, triple, vec3(0)); }), StartsWith("size:"));
      CHECK_THAT(refusal([&] { body_with(1, triple, vec3(0)); }), StartsWith("inertia:"));
    }
  }
}

TEST_CASE("X16 a body without a place or an orientation is refused") {
  for (const vec3& bad : {vec3(no_number, 0, 0), vec3(0, unbounded, 0), vec3(0, 0, -unbounded)}) {
    CHECK_THAT(refusal([&] { static_body(bad); }), StartsWith("x:"));
    CHECK_THAT(refusal([&] { box(1, vec3(1), bad); }), StartsWith("x:"));
    CHECK_THAT(refusal([&] { ball(1, 1, bad); }), StartsWith("x:"));
    CHECK_THAT(refusal([&] { body_with(1, vec3(1), bad); }), StartsWith("x:"));
  }
  for (const quat& bad : {quat(0, 0, 0, 0), quat(no_number, 0, 0, 1), quat(1, 0, unbounded, 0)}) {
    CHECK_THAT(refusal([&] { static_body(vec3(0), bad); }), StartsWith("q:"));
    CHECK_THAT(refusal([&] { box(1, vec3(1), vec3(0), bad); }), StartsWith("q:"));
  }
  const Body scaled = static_body(vec3(0), quat(0, 0, 0, 4));  // a length can be mended
  CHECK(scaled.q == quat(0, 0, 0, 1));
}

TEST_CASE("X16 a world takes no body that is not finite and none that is half static") {
  Small small;
  const struct {
    const char* member;
    Body body;
  } bad[] = {
      {"x", spoilt([](Body& b) { b.x.y = no_number; })},
      {"v", spoilt([](Body& b) { b.v.x = unbounded; })},
      {"w", spoilt([](Body& b) { b.w.z = no_number; })},
      {"force", spoilt([](Body& b) { b.force.x = no_number; })},
      {"torque", spoilt([](Body& b) { b.torque.x = no_number; })},
      {"q", spoilt([](Body& b) { b.q.w = no_number; })},
      {"q", spoilt([](Body& b) { b.q = quat(2, 0, 0, 0); })},
      {"q", spoilt([](Body& b) { b.q = quat(0, 0, 0, 0); })},
      {"inverse_mass", spoilt([](Body& b) { b.inverse_mass = no_number; })},
      {"inverse_mass", spoilt([](Body& b) { b.inverse_mass = -1; })},
      {"inverse_mass", spoilt([](Body& b) { b.inverse_mass = unbounded; })},
      {"inverse_inertia_local", spoilt([](Body& b) { b.inverse_inertia_local.x = -1; })},
      {"inverse_inertia_local", spoilt([](Body& b) { b.inverse_inertia_local.y = no_number; })},
      {"inverse_inertia_local", spoilt([](Body& b) { b.inverse_mass = 0; })},  // turns, falls not
      {"inverse_inertia_local", spoilt([](Body& b) { b.inverse_inertia_local = vec3(0); })},
      {"inverse_inertia_local", spoilt([](Body& b) { b.inverse_inertia_local.z = 0; })},
      {"inverse_inertia_local",  // moments 1, 1 and 100
       spoilt([](Body& b) { b.inverse_inertia_local = vec3(1, 1, real(0.01)); })},
      {"inverse_mass",  // 1/m overflows
       body_with(std::numeric_limits<real>::denorm_min(), vec3(1), vec3(0))}};
  for (const auto& [member, body] : bad) {
    const auto add = [&, &body = body] { small.world.add(body); };
    CHECK_THAT(refusal(add), StartsWith(member + std::string(" is ")));
    CHECK(small.unchanged());
  }
}

TEST_CASE("X16 a moment of inertia larger than the sum of the other two is refused") {
  for (int k = 0; k < 3; ++k) {
    vec3 moments(1);
    World world;
    const auto add = [&] { world.add(body_with(1, moments, vec3(0))); };
    for (const real moment : {real(2.02), real(100)}) {
      moments[k] = moment;
      CHECK_THAT(refusal(add), StartsWith("inverse_inertia_local is ("));
    }
    moments[k] = 2;  // a disc without thickness
    CHECK(refusal(add) == "accepted");
  }
}

TEST_CASE("X16 an orientation that is nearly of length 1 is normalised: no gap comes of it") {
  World world;
  Body body = box(1, vec3(1), vec3(0));
  body.q = real(1.0004) * rotation(vec3(1, 2, 3));
  const BodyId id = world.add(body);
  CHECK(double(length(world.bodies[id].q)) == Approx(1).epsilon(4 * double(epsilon)));
  const vec3 lever(10, 0, 0);
  CHECK(double(length(world_point(world.bodies[id], lever))) == Approx(10).epsilon(1e-14));
  const quat exact = rotation(vec3(real(0.1), 2, 1));
  body.q = exact;
  CHECK(world.bodies[world.add(body)].q == exact);  // to the last bit
  body.q = real(1.002) * exact;
  CHECK_THAT(refusal([&] { world.add(body); }), StartsWith("q is ("));
}

TEST_CASE("X16 a joint needs two different bodies that live in its world") {
  Small small;
  const BodyId a = small.ceiling, b = small.weight;
  CHECK_THAT(refusal([&] { small.world.add<BallJoint>(b, b, Point{}); }), StartsWith("body2:"));
  CHECK_THAT(refusal([&] { BallJoint(a, a, Point{}); }), StartsWith("body2:"));
  for (const BodyId& bad : {BodyId{}, BodyId{0, 2}, BodyId{1, 3}, BodyId{7, 1}, BodyId{~0u, 1}}) {
    CHECK_THAT(refusal([&] { small.world.add<BallJoint>(a, bad, Point{}); }), StartsWith("body2:"));
    CHECK_THAT(refusal([&] { small.world.add<BallJoint>(bad, b, Point{}); }), StartsWith("body1:"));
    CHECK_THAT(refusal([&] { small.world.remove(bad); }), StartsWith("body:"));
    CHECK_THAT(refusal([&] { small.world.bodies[bad]; }), StartsWith("body:"));
    CHECK(small.unchanged());
  }
}

TEST_CASE("X16 a rod needs a length and a rope may have none") {
  Small small;
  const BodyId a = small.ceiling, b = small.weight;
  for (real bad : bad_numbers) {
    CAPTURE(bad);
    const CentreDistance centre{bad};
    const Distance rod{vec3(0), vec3(0), bad};
    const auto add = [&](auto part) {
      return refusal([&] { small.world.add<PartJoint<decltype(part)>>(a, b, part); });
    };
    CHECK_THAT(add(centre), StartsWith("length is"));
    CHECK_THAT(add(rod), StartsWith("length is"));
    if (bad == 0) continue;
    CHECK_THAT(add(Rope<CentreDistance>{centre}), StartsWith("length is"));
    CHECK_THAT(add(Rope<Distance>{rod}), StartsWith("length is"));
  }
  CHECK(small.unchanged());
  CHECK(refusal([&] { small.world.add<CentreRopeJoint>(a, b, Rope<CentreDistance>{{0}}); }) ==
        "accepted");
}

TEST_CASE("X16 an anchor must be finite") {
  Small small;
  const BodyId a = small.ceiling, b = small.weight;
  for (const vec3& bad : {vec3(no_number, 0, 0), vec3(0, unbounded, 0)}) {
    const Distance first{bad, vec3(0), 1}, second{vec3(0), bad, 1};
    const auto add = [&](auto part) {
      return refusal([&] { small.world.add<PartJoint<decltype(part)>>(a, b, part); });
    };
    CHECK_THAT(add(first), StartsWith("anchor1_local is"));
    CHECK_THAT(add(second), StartsWith("anchor2_local is"));
    CHECK_THAT(add(Rope<Distance>{first}), StartsWith("anchor1_local is"));
    CHECK_THAT(add(Point{bad, vec3(0)}), StartsWith("anchor1_local is"));
    CHECK_THAT(add(Point{vec3(0), bad}), StartsWith("anchor2_local is"));
  }
  CHECK(small.unchanged());
}

TEST_CASE("X16 a step without a proper length or without iterations is refused and nothing moves") {
  Small small;
  SequentialImpulses solver;
  StepOptions stepping;
  for (real bad : bad_numbers) {
    CAPTURE(bad);
    CHECK_THAT(refusal([&] { step(small.world, solver, bad, stepping); }), StartsWith("h is"));
    CHECK(small.unchanged());
  }
  for (int bad : {0, -1}) {
    solver.iterations = bad;
    CHECK_THAT(refusal([&] { step(small.world, solver, h, stepping); }), StartsWith("iterations:"));
    solver.iterations = 1;
    stepping.projections = std::min(bad, -1);
    CHECK_THAT(refusal([&] { step(small.world, solver, h, stepping); }),
               StartsWith("projections:"));
    stepping.projections = 0;
    CHECK(small.unchanged());
  }
}

TEST_CASE("X16 an option that a program does not know or cannot read is refused by its name") {
  const auto options = [] {
    return Options("a program", {{"links", "20", "how many"}, {"mass", "1.5", "of each [kg]"},
                                 {"quick", "0", "1: fewer"}});
  };
  const auto read = [&](std::vector<const char*> words, auto use) {
    words.insert(words.begin(), "program");
    Options o = options();
    return refusal([&] {
      const bool go_on = o.read(int(words.size()), words.data());
      CHECK(go_on);
      use(o);
    });
  };
  const auto links = [](Options& o) { o.count("links", 1); };
  const auto mass = [](Options& o) { o.number("mass", 0); };
  CHECK_THAT(read({"--linsk", "3"}, links), StartsWith("--linsk:"));
  CHECK_THAT(read({"3"}, links), StartsWith("3:"));
  CHECK_THAT(read({"-links", "3"}, links), StartsWith("-links:"));
  CHECK_THAT(read({"--links"}, links), StartsWith("--links:"));
  for (const char* bad : {"", "ten", "3x", "nan", "inf", "1e999", "-1"}) {
    CHECK_THAT(read({"--mass", bad}, mass), StartsWith(std::string("--mass ") + bad));
    CHECK_THAT(read({"--links", bad}, links), StartsWith(std::string("--links ") + bad));
  }
  for (const char* bad : {"0", "2.5", "1000001"})
    CHECK_THAT(read({"--links", bad}, links), StartsWith(std::string("--links ") + bad));
  CHECK_THAT(read({}, [](Options& o) { o.text("speed"); }), StartsWith("--speed:"));
  CHECK(read({"--links", "7", "--mass", "0", "--out", "there"}, [](Options& o) {
          CHECK(o.count("links", 1) == 7);
          CHECK(o.number("mass", 0) == 0);
          CHECK(o.text("out") == "there");
        }) == "accepted");
  CHECK(read({}, [](Options& o) { CHECK(o.number("mass", 0) == 1.5); }) == "accepted");
  CHECK_THAT(read({"--links", "--mass", "3"}, links), StartsWith("--links: needs a value"));
  for (const std::vector<const char*>& words : std::vector<std::vector<const char*>>{
           {"--quick"}, {"--quick", "--links", "7"}, {"--quick", "1"}})
    CHECK(read(words, [](Options& o) { CHECK(o.flag("quick")); }) == "accepted");
  CHECK(read({"--quick", "0"}, [](Options& o) { CHECK_FALSE(o.flag("quick")); }) == "accepted");
  CHECK_THAT(read({"--quick", "2"}, [](Options& o) { o.flag("quick"); }), StartsWith("--quick 2"));
}
