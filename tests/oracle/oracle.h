// An independent oracle for the tests: bodies and blocks as dense matrices, in double.
#pragma once

#include "checker/numeric.h"
#include "engine/sequential_impulses.h"
#include "engine/steps/step.h"
#include "tests/oracle/dense.h"

namespace joints::testing {

using dvec3 = glm::dvec3;
using dmat3 = glm::dmat3;

/// One tolerance for double, one for float.
constexpr double tolerance(double in_double, double in_float) {
  return is_float ? in_float : in_double;
}

/// Three numbers of a column, from there on.
inline dvec3 three(const Column& a, long first = 0) {
  return {a[first], a[first + 1], a[first + 2]};
}

dmat3 rotation_matrix(const Body& body);
dmat3 inertia_of(const Body& body);  ///< in world axes [kg m^2]

/// M^-1 of a list of bodies, six numbers a body: velocity, then angular velocity.
Dense inverse_masses(const std::vector<Body>& bodies);

/// V of a list of bodies.
Column velocities(const std::vector<Body>& bodies);

/// The bodies of a world, slot by slot.
inline std::vector<Body> snapshot(const Bodies& bodies) {
  std::vector<Body> out;
  for (int slot = 0; slot < bodies.slots(); ++slot) out.push_back(bodies.at(slot));
  return out;
}

/// The rows of all blocks under each other, and their errors. `block[i]` is the block of row i.
struct System {
  Dense J;
  Column C;
  std::vector<int> block;
};
System system_of(const Blocks& blocks, int bodies);

/// All accumulated impulses, row by row.
Column impulses(const Blocks& blocks);

/// A joint of any numbers: N rows whose J and C do not depend on the poses.
template <int N>
class AnyJoint : public Joint {
 public:
  Jacobian<N> J;
  Vector<N> C{};
  RowSettings target;
  Form form = Form::any;
  mutable Vector<N> impulse{};

  using Joint::Joint;
  void append(const Bodies& bodies, Blocks& blocks) const override {
    blocks.append(bodies, body1, body2, J, C, target, impulse.data(), form);
  }
};

inline Row random_row(Random& random, bool linear = true, bool angular = true) {
  Row row;
  if (linear) row.v1 = random.vector(1), row.v2 = random.vector(1);
  if (angular) row.w1 = random.vector(1), row.w2 = random.vector(1);
  return row;
}

inline World weightless() {
  World world;
  world.gravity = vec3(0);
  return world;
}

/// A step by a solver as it is when it has just been made.
inline void step_once(World& world, real h) {
  SequentialImpulses solver;
  step(world, solver, h);
}

/// Velocities for bodies that can move.
inline void push_at_random(Bodies& bodies, Random& random, real speed = 2) {
  for (int slot = 0; slot < bodies.slots(); ++slot) {
    const vec3 v = random.vector(speed), w = random.vector(speed);
    if (bodies.at(slot).is_static()) continue;
    bodies.at(slot).v = v;
    bodies.at(slot).w = w;
  }
}

}  // namespace joints::testing
