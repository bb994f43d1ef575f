// The dense matrices of the oracle. In a file of its own: Eigen takes long to compile.
#include "tests/checker/oracle.h"

namespace joints::testing {

Eigen::Matrix3d rotation_matrix(const Body& body) {
  const quat& q = body.q;
  return Eigen::Quaterniond(double(q.w), double(q.x), double(q.y), double(q.z))
      .normalized()
      .toRotationMatrix();
}

Dense inverse_masses(const std::vector<Body>& bodies) {
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

Column velocities(const std::vector<Body>& bodies) {
  Column V(6 * long(bodies.size()));
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    V.segment<3>(6 * long(k)) = eigen(bodies[k].v);
    V.segment<3>(6 * long(k) + 3) = eigen(bodies[k].w);
  }
  return V;
}

System system_of(const Blocks& blocks, int bodies) {
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

Column impulses(const Blocks& blocks) {
  Column out(long(blocks.J.size()));
  for (const Block& block : blocks.list)
    for (int i = 0; i < block.rows; ++i) out[block.first + i] = double(block.impulse[i]);
  return out;
}

double difference(const Column& yours, const Column& expected) {
  return (yours - expected).cwiseAbs().maxCoeff() /
         std::max(1.0, expected.cwiseAbs().maxCoeff());
}

Column magnitudes(const Dense& A) { return A.eigenvalues().cwiseAbs(); }

Column symmetric_eigenvalues(const Dense& A) {
  return Eigen::SelfAdjointEigenSolver<Dense>(A).eigenvalues();
}

Dense inverse_of(const Dense& A) { return A.partialPivLu().inverse(); }

Column solved(const Dense& A, const Column& b) { return A.ldlt().solve(b); }

long rank_of(const Dense& A, double threshold) {
  Eigen::FullPivLU<Dense> lu(A);
  lu.setThreshold(threshold);
  return lu.rank();
}

Eigen::Matrix3d inertia_of(const Body& body) {
  const Eigen::Matrix3d inverse = inverse_masses({body}).bottomRightCorner<3, 3>();
  return inverse.inverse();
}

}  // namespace joints::testing
