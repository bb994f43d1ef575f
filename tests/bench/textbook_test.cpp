// The textbook's hinge, against which the loops are measured, does what the engine's does.
#include "bench/scenes.h"
#include "bench/textbook.h"
#include "engine/sequential_impulses.h"
#include "engine/steps/step.h"
#include "joints/hinge_joint.h"
#include "tests/checker/catch.h"
#include "tests/oracle/oracle.h"

using namespace joints;
using namespace joints::testing;

TEST_CASE("the textbook's hinges hold a chain as the engine's do, recomputed or not") {
  const real h = real(1) / 60;
  for (const bool recompute : {false, true}) {
    bench::BenchScene ours = bench::cubes_on_hinges(2, 8), theirs = bench::cubes_on_hinges(2, 8);
    SequentialImpulses solver;
    bench::TextbookSolver textbook;
    textbook.recompute = recompute;
    solver.iterations = textbook.iterations = 30;
    for (const auto& joint : theirs.world.joints()) {
      Body &a = theirs.world.bodies[joint->body1], &b = theirs.world.bodies[joint->body2];
      textbook.joints.push_back(
          std::make_unique<bench::TextbookHinge>(a, b, a.x, vec3(1, 0, 0), joint->beta));
    }
    for (const auto& joint : ours.world.joints()) static_cast<HingeJoint&>(*joint).whole = false;
    for (int n = 0; n < 60; ++n) {
      step(ours.world, solver, h);
      textbook.step(theirs.world, h);
    }
    for (int slot = 0; slot < ours.world.bodies.slots(); ++slot)
      CHECK(double(length(ours.world.bodies.at(slot).x - theirs.world.bodies.at(slot).x)) <
            tolerance(1e-9, 1e-2));
  }
}

TEST_CASE("the textbook's hinges do the same to the last digit without virtual calls") {
  const real h = real(1) / 60;
  bench::BenchScene ours = bench::cubes_on_hinges(2, 8), theirs = bench::cubes_on_hinges(2, 8);
  bench::TextbookSolver textbook;
  bench::FlatSolver flat;
  textbook.iterations = flat.iterations = 10;
  for (std::size_t k = 0; k < ours.world.joints().size(); ++k) {
    const auto hinge = [&](World& world) {
      const Joint& joint = *world.joints()[k];
      Body &a = world.bodies[joint.body1], &b = world.bodies[joint.body2];
      return bench::TextbookHinge(a, b, a.x, vec3(1, 0, 0), joint.beta);
    };
    textbook.joints.push_back(std::make_unique<bench::TextbookHinge>(hinge(ours.world)));
    flat.hinges.push_back(hinge(theirs.world));
  }
  for (int n = 0; n < 60; ++n) {
    textbook.step(ours.world, h);
    flat.step(theirs.world, h);
  }
  for (int slot = 0; slot < ours.world.bodies.slots(); ++slot)
    CHECK(ours.world.bodies.at(slot).x == theirs.world.bodies.at(slot).x);
  CHECK(ours.world.bodies.at(7).x.y < -1);  // it has swung
}
