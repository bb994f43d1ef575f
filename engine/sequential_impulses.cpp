// Sequential Impulses: the preparation of the blocks, once per step, and the iterations.
#include "engine/sequential_impulses.h"

#include <algorithm>

#include "engine/kernels.h"  // Twelve: the numbers of a row, or of two bodies' velocities

namespace joints {

namespace {

// The velocities of both bodies as twelve numbers side by side.
Twelve velocities(const Body& body1, const Body& body2) {
  const vec3 &v1 = body1.v, &w1 = body1.w, &v2 = body2.v, &w2 = body2.w;
  const real V[12] = {v1.x, v1.y, v1.z, w1.x, w1.y, w1.z, v2.x, v2.y, v2.z, w2.x, w2.y, w2.z};
  return reinterpret_cast<const Twelve&>(V);
}

// A static body keeps its velocities, even if an impulse is not finite.
void set_velocities(Body& body1, Body& body2, const Twelve& twelve) {
  const real* const V = reinterpret_cast<const real*>(&twelve);
  const auto set = [](Body& body, const real* six) {
    if (body.is_static()) return;
    body.v = vec3(six[0], six[1], six[2]);
    body.w = vec3(six[3], six[4], six[5]);
  };
  set(body1, V);
  set(body2, V + 6);
}

// V += lambda M^-1 J^T.
void apply_impulse(Twelve& V, real lambda, const Row& response) {
  for (int k = 0; k < 12 / register_size; ++k) V.part[k] += lambda * twelve(response).part[k];
}

}  // namespace

// ---- once per step ------------------------------------------------------------------------------

void SequentialImpulses::prepare(const Bodies& bodies, const Blocks& blocks, int first_block,
                                 real h) {
  prepared_for(bodies, blocks, first_block);
  if (first_block == 0) {
    prepared_.blocks.clear();
    prepared_.rows.clear();
    prepared_.scaled_inverse_K.clear();
  }
  for (int k = first_block; k < int(blocks.list.size()); ++k) {
    const Block& block = blocks.list[std::size_t(k)];
    if (block.settings.follows != 0) followed_row(blocks, k);  // rejects one that follows no row
    add(bodies, blocks, block, h);
  }
}

void SequentialImpulses::add(const Bodies& bodies, const Blocks& blocks, const Block& block,
                             real h) {
  auto& [list, rows, inverses] = prepared_;
  const PreparedBlock out{block, int(inverses.size()),
                          soft_coefficients(block.settings, h, blocks.duration_or(h), relaxation)};
  list.push_back(out);

  const int n = block.rows;
  const Row* const J = &blocks.J[std::size_t(block.first)];
  Row response[6];
  form_responses(J, n, bodies.at(block.body1), bodies.at(block.body2), response);
  inverses.resize(inverses.size() + std::size_t(n * n));
  real* const inverse = inverses.data() + out.first_K;
  form_K(J, response, n, inverse);
  invert_symmetric(inverse, n);

  const real over_last = inverse_above(inverse[n * n - 1], 0);
  for (int i = 0; i < n; ++i)
    rows.push_back({response[i], bias(block, i, blocks.C[std::size_t(block.first + i)],
                                      out.coefficients.bias_rate, h),
                    inverse[i * n + n - 1] * over_last});
  for (int i = 0; i < n * n; ++i) inverse[i] *= out.coefficients.mass_scale;
}

void SequentialImpulses::warm_start(Bodies& bodies, real ratio) {
  blocks_of(bodies);  // rejects other bodies
  for (const PreparedBlock& block : prepared_.blocks) {
    if (ratio == 0) {
      std::fill_n(block.impulse, block.rows, real(0));
      continue;
    }
    Body &body1 = bodies.at(block.body1), &body2 = bodies.at(block.body2);
    Twelve V = velocities(body1, body2);
    for (int i = 0; i < block.rows; ++i) {
      real& lambda = block.impulse[i];
      const bool independent =
          prepared_.scaled_inverse_K[block.first_K + i * block.rows + i] > 0;
      lambda = independent ? ratio * lambda : 0;
      apply_impulse(V, lambda, prepared_.rows[std::size_t(block.first + i)].response);
    }
    set_velocities(body1, body2, V);
  }
}

// ---- the iterations -----------------------------------------------------------------------------

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
    const PreparedBlock& block = prepared_.blocks[std::size_t(k)];
    with_size(block.rows, [&](auto n) { solve_block<n>(array, J, block); });
  }
}

// One solve of a block, for hard, soft, one-sided and bounded rows alike.
template <int N>
void SequentialImpulses::solve_block(Body* bodies, const Row* J, const PreparedBlock& block) {
  Body &body1 = bodies[block.body1], &body2 = bodies[block.body2];
  J += block.first;
  const PreparedRow* row = &prepared_.rows[std::size_t(block.first)];
  const real* scaled_inverse_K = &prepared_.scaled_inverse_K[std::size_t(block.first_K)];
  const SoftCoefficients& by = block.coefficients;
  Twelve V = velocities(body1, body2);

  real e[N];  // velocity error of each row: J V + bias
  for (int i = 0; i < N; ++i) e[i] = dot(twelve(J[i]), V) + row[i].bias;

  real dlambda[N];  // -mass_scale K^-1 e - impulse_scale lambda
  for (int i = 0; i < N; ++i) dlambda[i] = -(scaled_inverse_K[i] * e[0]);
  for (int j = 1; j < N; ++j)
    for (int i = 0; i < N; ++i) dlambda[i] -= scaled_inverse_K[j * N + i] * e[j];
  if (by.impulse_scale != 0)
    for (int i = 0; i < N; ++i) dlambda[i] -= by.impulse_scale * block.impulse[i];

  // Clamp the accumulated impulse of the last row, and solve the other rows again for the clamped
  // value: each changes by clamp_response per unit of the cut.
  const real wanted = block.impulse[N - 1] + dlambda[N - 1];
  real lower = by.lower, upper = by.upper;
  if (N == 1 && block.settings.follows != 0) {  // bounds are -+upper * impulse[follows]
    upper *= block.impulse[block.settings.follows];
    lower = -upper;
  }
  const real kept = std::clamp(wanted, lower, upper), cut = kept - wanted;
  if (cut != 0) {
    for (int i = 0; i < N; ++i) dlambda[i] += row[i].clamp_response * cut;
    dlambda[N - 1] = kept - block.impulse[N - 1];  // exactly at the bound
  }

  for (int i = 0; i < N; ++i) {
    block.impulse[i] += dlambda[i];
    apply_impulse(V, dlambda[i], row[i].response);  // V += M^-1 J^T dlambda
  }
  set_velocities(body1, body2, V);
}

}  // namespace joints
