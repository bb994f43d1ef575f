// The dense matrices of the oracle.
#include "tests/oracle/oracle.h"

namespace joints::testing {

namespace {

Dense column(const vec3& a) { return {3, 1, {double(a.x), double(a.y), double(a.z)}}; }

Dense turned_by(const quat& q) {
  return rotation_of(double(q.w), double(q.x), double(q.y), double(q.z));
}

dmat3 three_by_three(const Dense& A) {
  return {three(A.columns_from(0, 1)), three(A.columns_from(1, 1)), three(A.columns_from(2, 1))};
}

}  // namespace

dmat3 rotation_matrix(const Body& body) { return three_by_three(turned_by(body.q)); }

dmat3 inertia_of(const Body& body) {
  return three_by_three(inverse_of(inverse_masses({body}).block(3, 3, 3, 3)));
}

Dense inverse_masses(const std::vector<Body>& bodies) {
  Dense W(6 * long(bodies.size()), 6 * long(bodies.size()));
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const Dense R = turned_by(bodies[k].q);
    Dense local(3, 3);
    for (int i = 0; i < 3; ++i) local(i, i) = double(bodies[k].inverse_inertia_local[i]);
    const long at = 6 * long(k);
    W.add(at, at, double(bodies[k].inverse_mass) * Dense::identity(3));
    W.add(at + 3, at + 3, R * local * R.transpose());
  }
  return W;
}

Column velocities(const std::vector<Body>& bodies) {
  Column V(6 * long(bodies.size()));
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    V.add(6 * long(k), 0, column(bodies[k].v));
    V.add(6 * long(k) + 3, 0, column(bodies[k].w));
  }
  return V;
}

System system_of(const Blocks& blocks, int bodies) {
  const long rows = long(blocks.rows());
  System out{Dense(rows, 6 * bodies), Column(rows), {}};
  for (std::size_t k = 0; k < blocks.list.size(); ++k)
    for (int i = 0; i < blocks.list[k].rows; ++i) {
      const Block& b = blocks.list[k];
      const long row = b.first + i;
      const Row& J = blocks.J[std::size_t(row)];
      for (int c = 0; c < 3; ++c) {
        out.J(row, 6 * b.body1 + c) += double(J.v1[c]);
        out.J(row, 6 * b.body1 + 3 + c) += double(J.w1[c]);
        out.J(row, 6 * b.body2 + c) += double(J.v2[c]);
        out.J(row, 6 * b.body2 + 3 + c) += double(J.w2[c]);
      }
      out.C[row] = double(blocks.C[std::size_t(row)]);
      out.block.push_back(int(k));
    }
  return out;
}

Column impulses(const Blocks& blocks) {
  Column out(long(blocks.rows()));
  for (const Block& block : blocks.list)
    for (int i = 0; i < block.rows; ++i) out[block.first + i] = double(block.impulse[i]);
  return out;
}

}  // namespace joints::testing
