// The units of chapter 6's exercises.
#include "chapters/06_baumgarte/baumgarte.h"
#include "tests/checker/units.h"

using namespace joints;
using namespace joints::testing;

namespace {
const Jacobian<3> J = point_by_rates(lever1, lever2);

constexpr const char* moves_are_ways =
    "a velocity has got among the moves: nothing here is multiplied or divided by h";
constexpr const char* velocities_stay =
    "a move has got among the velocities: they stay as they are";
constexpr OfTime no_step{moves_are_ways, moves_are_ways};
constexpr OfTime once{"divided by h once too often"};  // of too many the list knows enough

// Ways to places, angles to turns, and no velocity anywhere.
void keeps_poses(const Body& body) {
  expect_unit("the place x", body.x, m, no_step);
  expect_unit("the orientation q", body.q, pure, no_step);
  expect_unit("the velocity v", body.v, m / s, {velocities_stay, velocities_stay});
  expect_unit("the angular velocity w", body.w, 1 / s, {velocities_stay, velocities_stay});
}
}  // namespace

TEST_CASE("6.1 an error over a step is a velocity", "[6.1]") {
  has_unit("the bias", m / s, [] { return bias(real(0.02) * m, real(0.15) * pure, h); },
           once);
  has_unit("the bias of an angle", 1 / s,
           [] { return bias(real(0.02) * pure, real(0.15) * pure, h); }, once);
  for (const real C : {real(-0.02), real(0.02)})
    has_unit("the bias of a limit", m / s,
             [&] { return limit_bias(C * m, real(0.15) * pure, h); }, once);
}

TEST_CASE("6.1 beta is a pure number", "[6.1]") {
  has_unit("beta", pure, [] { return beta_for(real(0.5) * s, h); });
}

TEST_CASE("6.2 a warm start gives impulses and keeps impulses", "[6.2]") {
  vec3 lambda = direction1 * (kg * m / s);
  keeps_velocities("the warm start", [&](Body& a, Body& b) {
    warm_start(J, real(0.5) * pure, lambda, a, b);
  });
  expect_unit("lambda", lambda, kg * m / s);
  in("warm_start_is_safe", [] { return warm_start_is_safe(real(0.5) * pure, 4, pure / 5); });
}

TEST_CASE("6.3 projection adds displacements to positions and angles to orientations", "[6.3]") {
  Body a = body1, b = body2;
  in("the projection of a point", [&] { project(Point{lever1, lever2}, a, b); }, no_step);
  keeps_poses(a);
  keeps_poses(b);
  in("the projection of a rope", [&] { project(Rope<Distance>{{lever1, lever2, m}}, a, b); },
     no_step);
  keeps_poses(a);
  keeps_poses(b);
  Chain chain{{body1, body2}, {{lever1, lever2}}};
  in("the iteration", [&] { projection_iteration(chain); }, no_step);
  keeps_poses(chain.bodies[1]);
}

TEST_CASE("6.4 a soft row has a rate and a pure number", "[6.4]") {
  const auto row = [] { return soft_row(real(60) / s, real(2) * pure, h); };
  expect_unit("the rate", in("soft_row", row).rate, 1 / s);
  expect_unit("the softness", in("soft_row", row).softness, pure);
}

TEST_CASE("6.4 a soft iteration adds impulses to impulses", "[6.4]") {
  vec3 lambda = direction1 * (kg * m / s);
  const JointRows rows{J, mat3(1) * (1 / kg), direction2 * m};
  keeps_velocities("the soft iteration", [&](Body& a, Body& b) {
    soft_iteration(rows, {real(20) / s, pure / 3}, lambda, a, b);
  });
  expect_unit("lambda", lambda, kg * m / s);
}

TEST_CASE("6.4 a soft step moves bodies and keeps impulses", "[6.4]") {
  Chain chain{{body1, body2}, {{lever1, lever2}}};
  std::vector<vec3> impulses{direction1 * (kg * m / s)};
  in("the soft step", [&] {
    soft_step(chain, impulses, {real(60) / s, real(2) * pure, 2, 1}, direction2 * (m / (s * s)), h);
  });
  expect_unit("the place x", chain.bodies[1].x, m);
  expect_unit("the velocity v", chain.bodies[1].v, m / s);
  expect_unit("the angular velocity w", chain.bodies[1].w, 1 / s);
  expect_unit("the impulse", impulses[0], kg * m / s);
}
