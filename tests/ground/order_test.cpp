// Joints and contacts in one loop, or one after the other: chapter 8's chain that falls onto the
// ground, and its hinge that nothing corrects.
#include "chapters/08_ground/program/order.h"
#include "tests/oracle/test.h"

using namespace joints::chapter8;

namespace {

// The widest gap so far and the deepest corner so far, step by step [m], and the gaps' RMS.
struct Course {
  std::vector<double> widest, deepest;
  double rms = 0;
};
Course course(Turns turns, int iterations, int steps = 240) {
  LandingChain chain(turns, 8, iterations, real(0.2));
  Course out;
  GapMeter gaps;
  double deepest = 0;
  for (int n = 0; n < steps; ++n) {
    chain.step(turns);
    gaps.look(chain.scene.marks, poses(chain.scene.world.bodies));
    deepest = std::max(deepest, penetration(chain.scene.world));
    out.widest.push_back(gaps.maximum());
    out.deepest.push_back(deepest);
  }
  out.rms = gaps.rms();
  return out;
}

}  // namespace

TEST_CASE("contacts in the joints' loop at no time more than double the widest gap so far") {
  for (const int iterations : {5, 10, 30}) {
    const Course with = course(Turns::interleaved, iterations);
    const Course without = course(Turns::no_ground, iterations);
    for (std::size_t n = 0; n < with.widest.size(); ++n)
      CHECK(with.widest[n] <= 2 * without.widest[n]);
    CHECK(with.rms <= 2 * without.rms);
    CHECK(with.widest.back() != without.widest.back());  // the ground was struck
  }
}

TEST_CASE("contacts solved after the joints pull joints open and solved before them sink in") {
  const Course one_loop = course(Turns::interleaved, 30);
  const Course joints_first = course(Turns::joints_first, 30);
  const Course contacts_first = course(Turns::contacts_first, 30);
  CHECK(joints_first.rms > 5 * one_loop.rms);
  CHECK(joints_first.deepest.back() < 1e-3);
  CHECK(contacts_first.rms < 5 * one_loop.rms);
  CHECK(contacts_first.deepest.back() > 0.01);
  CHECK(one_loop.deepest.back() < 1e-3);
}

TEST_CASE("more iterations help one loop and not joints whose contacts are solved after them") {
  CHECK(course(Turns::interleaved, 50).rms < 0.5 * course(Turns::interleaved, 5).rms);
  CHECK(course(Turns::joints_first, 50).rms > 0.5 * course(Turns::joints_first, 5).rms);
}

TEST_CASE("taking turns in one loop is the solver's own step to the last bit") {
  LandingChain turns(Turns::interleaved, 8, 10, real(0.2));
  LandingChain plain(Turns::interleaved, 8, 10, real(0.2));
  for (int n = 0; n < 120; ++n) {
    turns.step(Turns::interleaved);
    step(plain.scene.world, plain.scene.solver, h, plain.scene.stepping);
  }
  CHECK(penetration(turns.scene.world) > 0);  // it has landed
  for (std::size_t k = 0; k < turns.ids.size(); ++k)
    CHECK(turns.scene.world.bodies[turns.ids[k]].x == plain.scene.world.bodies[plain.ids[k]].x);
}

TEST_CASE("a hit opens an uncorrected hinge no more than speed does unless contacts come last") {
  // Eq. 6-1: the gap is the sum of the steps' vectors w^2 h^2/2 r, in a step with a hit as well.
  for (const Turns order : {Turns::interleaved, Turns::joints_first}) {
    Scene scene;
    World& world = scene.world;
    const BodyId wall = scene.box(0, vec3(real(0.4)), vec3(0));
    const BodyId id = scene.box(100, vec3(1), vec3(2, 0, 0));
    const BodyId ground = scene.box(0, vec3(8, real(0.2), 8), vec3(0, real(-2.1), 0));
    auto& joint = world.add<HingeJoint>(wall, id, vec3(0), vec3(0, 0, 1));
    joint.beta = 0;
    const vec3 size(1);
    const auto& contact = stand(scene, ground, id, size, 0);
    real most = 0;
    vec3 before(0);
    int hits = 0;
    for (int n = 0; n < 60; ++n) {
      step_in_turns(scene, 1, order);
      const Body& cube = world.bodies[id];
      const vec3 C = joint.first.error(world.bodies[wall], cube);
      const vec3 r = -to_world(cube, joint.first.anchor2_local);
      const vec3 growth = dot(cube.w, cube.w) * h * h / real(2) * r;  // Eq. 6-1
      if (contact.touching() > 0) {
        ++hits;
        most = std::max(most, length(C - before - growth));
      }
      before = C;
    }
    REQUIRE(hits > 0);
    if (order == Turns::interleaved)
      CHECK(double(most) < 1e-4);
    else
      CHECK(double(most) > 1e-2);
  }
}
