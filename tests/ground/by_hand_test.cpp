// The loop by hand of chapter 8: one box on the ground, by the functions of the exercises, and
// its reference in the engine.
#include "bench/chapters/08_ground/own_ground.h"
#include "contacts/ground_contact.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;

// A box on its four lower corners, on a slab that may be turned, in both kinds of loop.
struct BothLoops {
  OwnGround own;
  World world;
  BodyId ground, box_id;
  GroundContact* contact;
  SequentialImpulses solver;
  StepOptions stepping{};
  vec3 size{1, real(0.4), real(0.8)};

  explicit BothLoops(const vec3& v, const vec3& w, const vec3& slope = vec3(0), real drop = 0) {
    const quat turn = rotation(slope);
    ground = world.add(static_body(vec3(0), turn));
    Body body = box(10, size, turn * vec3(0, size.y / 2 + drop, 0), turn);
    body.v = v;
    body.w = w;
    box_id = world.add(body);
    Outline lower{.count = 4};
    for (std::size_t k = 0; k < 4; ++k)
      lower.corners[k] = real(0.5) * size * vec3(k & 1 ? 1 : -1, -1, k & 2 ? 1 : -1);
    contact = &world.add<GroundContact>(ground, box_id, Top{}, lower);
    own.ground = world.bodies[ground];
    own.body = body;
    own.friction = contact->friction;
    own.beta = contact->beta;
    for (std::size_t k = 0; k < 4; ++k) own.corners.push_back({lower.corners[k], 0, 0});
    own.iterations = solver.iterations;
  }
  void step() {
    own.step(h);
    joints::step(world, solver, h, stepping);
  }
  const Body& body() const { return world.bodies[box_id]; }
  // How far apart the two boxes are, their corners compared [m].
  double off() const {
    double most = 0;
    for (const Corner& corner : own.corners)
      most = std::max(most, double(length(world_point(own.body, corner.corner_local) -
                                          world_point(body(), corner.corner_local))));
    return most;
  }
};

}  // namespace

TEST_CASE("a sliding and turning box moves in the loop by hand as in the engine in every step") {
  const struct {
    vec3 v, w, slope;
    real drop;
  } starts[] = {{vec3(3, 0, 1), vec3(0), vec3(0), 0},
                {vec3(2, 0, -1), vec3(0, 3, 0), vec3(0), 0},
                {vec3(0), vec3(0), vec3(real(0.3), 0, real(0.5)), 0},
                {vec3(1, 0, 1), vec3(0, 1, 0), vec3(0), real(0.3)}};
  for (const auto& start : starts) {
    BothLoops both(start.v, start.w, start.slope, start.drop);
    const vec3 from = both.own.body.x;
    for (int n = 0; n < 60; ++n) {
      both.step();
      CHECK(both.off() < tolerance(1e-12, 2e-4));
    }
    CHECK(double(length(both.own.body.x - from)) > 0.2);  // it did move
  }
}

TEST_CASE("while a box slides the friction of all corners is mu times their normal impulses") {
  BothLoops both(vec3(3, 0, 1), vec3(0));
  const double weight = 10 * 9.81 * double(h);  // [N s] a step
  int sliding = 0;
  while (double(length(both.own.body.v)) > 0.2) {
    const vec3 before = both.own.body.v;
    both.own.step(h);
    const vec3 friction = both.own.sideways();
    CHECK(double(both.own.normal()) == Approx(weight).epsilon(tolerance(1e-9, 1e-3)));
    CHECK(double(length(friction)) ==
          Approx(0.5 * double(both.own.normal())).epsilon(tolerance(1e-6, 1e-3)));
    CHECK(double(dot(friction, normalize(before))) ==
          Approx(-double(length(friction))).epsilon(tolerance(1e-9, 1e-4)));
    REQUIRE(++sliding < 60);
  }
  CHECK(sliding > 20);
  for (int n = 0; n < 10; ++n) both.own.step(h);
  CHECK(double(length(both.own.sideways())) < tolerance(1e-9, 1e-3) * weight);  // at rest
}

TEST_CASE("the loop by hand leaves the engine's box as soon as its friction is another one") {
  BothLoops both(vec3(3, 0, 1), vec3(0));
  both.own.friction = real(0.49);
  for (int n = 0; n < 30; ++n) both.step();
  CHECK(both.off() > 1e-3);
}
