// Sequential Impulses: the iterations, and solve_block(), which solves one block.
#include "engine/sequential_impulses.h"

#include <algorithm>

namespace joints {

void SequentialImpulses::solve(Bodies& bodies) {
  for (int i = 0; i < iterations; ++i) iterate(bodies);
}

void SequentialImpulses::iterate(Bodies& bodies) { iterate(bodies, 0, prepared_count()); }

void SequentialImpulses::iterate(Bodies& bodies, int from, int to) {
  const Blocks& blocks = blocks_of(bodies);
  require(from >= 0 && to <= prepared_count(), "from, to: there are not so many prepared blocks");
  Body* const array = bodies.data();
  const Row* const J = blocks.J.data();
  for (int k = from; k < to; ++k) {  // one predictable switch per block
    const PreparedBlock& block = prepared_.blocks[k];
    switch (block.rows) {
      case 1: solve_rows<1>(array, J, block); break;
      case 2: solve_rows<2>(array, J, block); break;
      case 3: solve_rows<3>(array, J, block); break;
      case 4: solve_rows<4>(array, J, block); break;
      case 5: solve_rows<5>(array, J, block); break;
      case 6: solve_rows<6>(array, J, block); break;
    }
  }
}

template <int N>
void SequentialImpulses::solve_rows(Body* bodies, const Row* J, const PreparedBlock& block) {
  switch (block.touches) {
    case Touches::linear: return solve_block<N, true, false>(bodies, J, block);
    case Touches::angular: return solve_block<N, false, true>(bodies, J, block);
    case Touches::both: return solve_block<N, true, true>(bodies, J, block);
  }
}

// One solve of a block, for hard, soft, one-sided and bounded rows alike.
template <int N, bool linear, bool angular>
void SequentialImpulses::solve_block(Body* bodies, const Row* J, const PreparedBlock& block) {
  Body &body1 = bodies[block.body1], &body2 = bodies[block.body2];
  J += block.first;
  const PreparedRow* row = &prepared_.rows[block.first];
  const real* inverse_K = &prepared_.inverse_K[block.first_K];

  real e[N];  // velocity error of each row: J V + bias
  for (int i = 0; i < N; ++i) {
    e[i] = row[i].bias;
    if constexpr (linear) e[i] += dot(J[i].v1, body1.v) + dot(J[i].v2, body2.v);
    if constexpr (angular) e[i] += dot(J[i].w1, body1.w) + dot(J[i].w2, body2.w);
  }

  real dlambda[N];  // -mass_scale K^-1 e - impulse_scale lambda
  for (int i = 0; i < N; ++i) {
    real sum = 0;
    for (int j = 0; j < N; ++j) sum += inverse_K[i * N + j] * e[j];
    dlambda[i] = -block.mass_scale * sum - block.impulse_scale * block.impulse[i];
  }

  // Clamp the accumulated impulse of the last row, and solve the other rows again for the clamped
  // value: each changes by clamp_response per unit of the cut.
  const real wanted = block.impulse[N - 1] + dlambda[N - 1];
  real lower = block.lower, upper = block.upper;
  if (N == 1 && block.follows != 0) {  // bounds are -+upper * impulse[follows]
    upper *= block.impulse[block.follows];
    lower = -upper;
  }
  const real kept = std::clamp(wanted, lower, upper), cut = kept - wanted;
  for (int i = 0; i < N; ++i) dlambda[i] += row[i].clamp_response * cut;
  if (cut != 0) dlambda[N - 1] = kept - block.impulse[N - 1];  // exactly at the bound

  vec3 P1(0), P2(0), dw1(0), dw2(0);  // linear impulses; changes of angular velocity
  for (int i = 0; i < N; ++i) {
    block.impulse[i] += dlambda[i];
    if constexpr (linear) {
      P1 += dlambda[i] * J[i].v1;
      P2 += dlambda[i] * J[i].v2;
    }
    if constexpr (angular) {
      dw1 += dlambda[i] * row[i].response_w1;
      dw2 += dlambda[i] * row[i].response_w2;
    }
  }
  if constexpr (linear) {
    body1.v += body1.inverse_mass * P1;
    body2.v += body2.inverse_mass * P2;
  }
  if constexpr (angular) {
    body1.w += dw1;
    body2.w += dw2;
  }
}

}  // namespace joints
