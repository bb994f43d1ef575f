// An independent oracle for the tests: bodies and blocks as dense Eigen matrices, in double.
#pragma once

#include <Eigen/Dense>

#include "engine/sequential_impulses.h"
#include "tests/numeric.h"

namespace joints::testing {

using Dense = Eigen::MatrixXd;
using Column = Eigen::VectorXd;

/// One tolerance for double, one for float.
constexpr double tolerance(double in_double, double in_float) {
  return is_float ? in_float : in_double;
}

inline Eigen::Vector3d eigen(const vec3& a) { return {double(a.x), double(a.y), double(a.z)}; }

inline Eigen::Matrix3d rotation_matrix(const Body& body) {
  const quat& q = body.q;
  return Eigen::Quaterniond(double(q.w), double(q.x), double(q.y), double(q.z))
      .normalized()
      .toRotationMatrix();
}

/// M^-1 of a list of bodies, six numbers a body: velocity, then angular velocity.
inline Dense inverse_masses(const std::vector<Body>& bodies) {
  Dense W = Dense::Zero(6 * long(bodies.size()), 6 * long(bodies.size()));
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const Eigen::Matrix3d R = rotation_matrix(bodies[k]);
    const long at = 6 * long(k);
    W.block<3, 3>(at, at) = double(bodies[k].inverse_mass) * Eigen::Matrix3d::Identity();
    W.block<3, 3>(at + 3, at + 3) =
        R * eigen(bodies[k].inverse_inertia_local).asDiagonal() * R.transpose();
  }
  return W;
}

/// V of a list of bodies.
inline Column velocities(const std::vector<Body>& bodies) {
  Column V(6 * long(bodies.size()));
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    V.segment<3>(6 * long(k)) = eigen(bodies[k].v);
    V.segment<3>(6 * long(k) + 3) = eigen(bodies[k].w);
  }
  return V;
}

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
inline System system_of(const Blocks& blocks, int bodies) {
  const long rows = long(blocks.J.size());
  System out{Dense::Zero(rows, 6 * bodies), Column(rows), {}};
  for (std::size_t k = 0; k < blocks.list.size(); ++k)
    for (int i = 0; i < blocks.list[k].rows; ++i) {
      const Block& b = blocks.list[k];
      const long row = b.first + i;
      const Row& J = blocks.J[std::size_t(row)];
      out.J.block<1, 3>(row, 6 * b.body1) += eigen(J.v1).transpose();
      out.J.block<1, 3>(row, 6 * b.body1 + 3) += eigen(J.w1).transpose();
      out.J.block<1, 3>(row, 6 * b.body2) += eigen(J.v2).transpose();
      out.J.block<1, 3>(row, 6 * b.body2 + 3) += eigen(J.w2).transpose();
      out.C[row] = double(blocks.C[std::size_t(row)]);
      out.block.push_back(int(k));
    }
  return out;
}

/// All accumulated impulses, row by row.
inline Column impulses(const Blocks& blocks) {
  Column out(long(blocks.J.size()));
  for (const Block& block : blocks.list)
    for (int i = 0; i < block.rows; ++i) out[block.first + i] = double(block.impulse[i]);
  return out;
}

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

/// The largest difference of two columns over the largest number of the second (at least 1).
inline double difference(const Column& yours, const Column& expected) {
  return (yours - expected).cwiseAbs().maxCoeff() /
         std::max(1.0, expected.cwiseAbs().maxCoeff());
}

}  // namespace joints::testing
