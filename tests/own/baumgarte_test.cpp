// Baumgarte's feedback by number: the energy it brings in, the spin it leaves, and who keeps its
// speed.
#include "chapters/02_ball/ball_joint.h"
#include "chapters/03_hinge/hinge_joint.h"
#include "engine/measure.h"
#include "tests/catch.h"
#include "tests/own/oracle.h"

using namespace joints;
using namespace joints::testing;

namespace {

const real h = real(1) / 60;

// A cube of 100 kg without gravity, held at a ball joint two metres beside its centre; the joint
// starts with an open gap.
struct OpenJoint {
  World world;
  BodyId cube;
  BallJoint* joint;
  SequentialImpulses solver;
  OpenJoint(const vec3& gap, real beta) {
    world.gravity = vec3(0);
    const BodyId wall = world.add(static_body(vec3(0)));
    cube = world.add(box(100, vec3(1), vec3(2, 0, 0)));
    joint = &world.add<BallJoint>(
        wall, cube, point_at(world.bodies[wall], world.bodies[cube], vec3(0)));
    joint->beta = beta;
    world.bodies[cube].x += gap;
  }
  vec3 spin_in_the_end() {
    for (int n = 0; n < 900; ++n) solver.step(world, h);
    return world.bodies[cube].w;
  }
};

// What the second order predicts: m = 100 kg, i = 100/6 kg m^2, lever r = (-2, 0, 0), planar.
double predicted_spin(const vec3& gap, double beta) {
  const vec3 r(-2, 0, 0);
  const double G = 100 / (100 / 6.0 + 100 * 4.0);
  return G * G * (beta / double(h)) / (2 - beta) * double(cross(r, gap).z) * double(dot(r, gap));
}

}  // namespace

TEST_CASE("the first step of Baumgarte brings in half of beta/h squared times C K^-1 C", "[E13]") {
  for (const real beta : {real(0.15), real(1)}) {
    const vec3 gap(real(0.3), real(-0.4), real(0.2));
    OpenJoint scene(gap, beta);
    const Body before = scene.world.bodies[scene.cube];
    const mat3 K = scene.joint->part.K(scene.world.bodies[scene.joint->body1], before);
    const double expected =
        0.5 * std::pow(double(beta / h), 2) * double(dot(gap, inverse(K) * gap));
    scene.solver.step(scene.world, h);
    CHECK(kinetic_energy(scene.world.bodies[scene.cube]) ==
          Approx(expected).epsilon(tolerance(1e-11, 1e-4)));
  }
}

TEST_CASE("I12 the spin that Baumgarte leaves is of second order and as predicted", "[E13]") {
  for (const double size : {0.001, 0.01})
    for (const double beta : {0.05, 0.15, 0.5, 1.0})
      for (const vec3& way : {vec3(1, 1, 0), vec3(1, -2, 0), vec3(real(-0.5), 1, 0)}) {
        const vec3 gap = real(size) * normalize(way);
        const double left = double(OpenJoint(gap, real(beta)).spin_in_the_end().z);
        CHECK(left == Approx(predicted_spin(gap, beta)).epsilon(tolerance(1e-2, 0.1)));
      }
}

TEST_CASE("I12 no spin is left where the gap lies along the lever or across it", "[E13]") {
  for (const vec3& gap : {vec3(real(0.01), 0, 0), vec3(0, real(0.01), 0)})
    CHECK(double(length(OpenJoint(gap, real(0.15)).spin_in_the_end())) < tolerance(2e-4, 1e-3));
}

TEST_CASE("a limit keeps the speed that it gave and an equality takes it back", "[E13]") {
  for (const bool one_sided : {true, false}) {
    World world;
    world.gravity = vec3(0);
    const BodyId wall = world.add(static_body(vec3(0)));
    const BodyId rotor = world.add(body_with(1, vec3(1), vec3(0)));
    auto& hinge = world.add<HingeJoint>(world.bodies, wall, rotor, vec3(0), vec3(0, 0, 1));
    hinge.beta = real(0.2);
    hinge.set_limits(one_sided ? real(-1) : real(0), 0);
    world.bodies[rotor].q = rotation(vec3(0, 0, real(0.05)));  // 0.05 rad too far
    SequentialImpulses solver;
    for (int n = 0; n < 60; ++n) solver.step(world, h);
    const double first = -0.2 * 0.05 * 60;  // beta C/h
    CHECK(double(world.bodies[rotor].w.z) ==
          Approx(one_sided ? first : 0).margin(tolerance(1e-5, 1e-4)));
  }
}
