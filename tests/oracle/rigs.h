// Small machines that the tests of the joints share: a rotor on a hinge, the cube of scenes S4.
#pragma once

#include <cstddef>
#include <cstring>
#include <numbers>

#include "engine/steps/two_pass_impulses.h"
#include "joints/hinge_joint.h"
#include "tests/oracle/oracle.h"

namespace joints::testing {

inline constexpr real degree = std::numbers::pi_v<real> / 180;

inline bool all_finite(const World& world) {
  for (const Body& body : snapshot(world.bodies))
    if (!finite(body.x) || !finite(body.q) || !finite(body.v) || !finite(body.w)) return false;
  return true;
}

template <class T>
bool same_bits(const T& one, const T& other) {
  return std::memcmp(&one, &other, sizeof one) == 0;
}

/// Of a body, its numbers: in float, bytes without a meaning follow them.
inline bool same_bits(const Body& one, const Body& other) {
  return std::memcmp(&one, &other, offsetof(Body, torque) + sizeof one.torque) == 0;
}

/// Angle between two directions [rad].
inline double angle_between(const vec3& a, const vec3& b) {
  return std::atan2(double(length(cross(a, b))), double(dot(a, b)));
}

/// The largest impulse in the blocks of a world's last step [N s or N m s].
double largest_impulse(const World& world);

/// The rows of a world as it stands, found by beginning a step.
System rows_of(World& world);

/// J M^-1 J^T of all rows together.
Dense whole_K(const System& system, const World& world);

/// What an iteration of block Gauss-Seidel leaves of an error in the impulses: E - L^-1 A, L the
/// blocks on and below the diagonal.
Dense iteration_matrix(const Dense& A, const std::vector<int>& block);
/// The factor by which an iteration multiplies an error in the long run.
double iteration_rate(const World& world, const System& system);

/// A rotor of 1 kg and 1 kg m^2 on a hinge about z through the origin, its centre `lever` beside
/// it, no gravity, turning at `speed` [rad/s].
struct Rotor {
  World world;
  BodyId wall, body;
  HingeJoint* hinge;
  TwoPassImpulses solver;
  StepOptions stepping{};

  explicit Rotor(real lever = 0, real speed = 0) {
    world.gravity = vec3(0);
    wall = world.add(static_body(vec3(0)));
    body = world.add(body_with(1, vec3(1), vec3(lever, 0, 0)));
    hinge = &world.add<HingeJoint>(wall, body, vec3(0), vec3(0, 0, 1));
    rotor().w = vec3(0, 0, speed);
    rotor().v = vec3(0, speed * lever, 0);
  }
  Body& rotor() { return world.bodies[body]; }
  double angle() const { return double(hinge->position(world.bodies)); }           // [rad]
  double in_degrees() const { return angle() / double(degree); }
  void run(int steps, real h) {
    for (int k = 0; k < steps; ++k) step(world, solver, h, stepping);
  }
};

/// Scenes S4: a cube of 100 kg 1.5 m beside a static one, on a hinge through that one's centre.
struct Crane {
  World world;
  BodyId wall, cube;
  HingeJoint* hinge;
  SequentialImpulses solver;
  StepOptions stepping{};

  explicit Crane(const vec3& axis) {
    wall = world.add(static_body(vec3(0)));
    cube = world.add(box(100, vec3(1), vec3(0, 0, real(1.5))));
    hinge = &world.add<HingeJoint>(wall, cube, vec3(0), axis);
  }
  double in_degrees() const { return double(hinge->position(world.bodies) / degree); }
};

}  // namespace joints::testing
