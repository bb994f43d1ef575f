// An independent oracle for the tests: bodies and blocks as dense Eigen matrices, in double.
#pragma once

#include <Eigen/Dense>

#include "engine/sequential_impulses.h"
#include "tests/checker/numeric.h"

namespace joints::testing {

using Dense = Eigen::MatrixXd;
using Column = Eigen::VectorXd;

/// One tolerance for double, one for float.
constexpr double tolerance(double in_double, double in_float) {
  return is_float ? in_float : in_double;
}

inline Eigen::Vector3d eigen(const vec3& a) { return {double(a.x), double(a.y), double(a.z)}; }

Eigen::Matrix3d rotation_matrix(const Body& body);

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
  Demand demand;
  mutable Vector<N> impulse{};

  using Joint::Joint;
  void append(const Bodies& bodies, Blocks& blocks) const override {
    const int slot1 = bodies.index(body1), slot2 = bodies.index(body2);
    const Matrix<N> K = dense_K(J, bodies.at(slot1), bodies.at(slot2));
    blocks.append(slot1, slot2, J, C, K, demand, impulse.data());
  }
  int most_rows() const override { return N; }
};

inline Row random_row(Random& random, bool linear = true, bool angular = true) {
  Row row;
  if (linear) row.v1 = random.vector(1), row.v2 = random.vector(1);
  if (angular) row.w1 = random.vector(1), row.w2 = random.vector(1);
  return row;
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

// What takes the compiler long, compiled once.

Column magnitudes(const Dense& A);                 ///< of the eigenvalues of any matrix
Column symmetric_eigenvalues(const Dense& A);      ///< in increasing order
Dense inverse_of(const Dense& A);                  ///< of a matrix that has one
Column solved(const Dense& A, const Column& b);    ///< A^-1 b of a symmetric, positive A
long rank_of(const Dense& A, double threshold);    ///< pivots below it count as zero [1]
Eigen::Matrix3d inertia_of(const Body& body);      ///< in world axes [kg m^2]

/// The largest difference of two columns over the largest number of the second (at least 1).
double difference(const Column& yours, const Column& expected);

}  // namespace joints::testing
