// Sequential Impulses. Reads like Algorithm 1: step() is the algorithm, solve_block() its heart.
#include "engine/sequential_impulses.h"

#include <algorithm>
#include <numbers>

namespace joints {

void SequentialImpulses::step(World& world, real h) {
  begin(world, h);
  for (int i = 0; i < iterations; ++i) sweep(world.bodies, i);
  for (;;) {  // a limit that lies ahead may have been reached during the sweeps
    const int known = int(blocks_.list.size());
    for (const auto& joint : world.joints()) joint->second_look(world.bodies, h, blocks_);
    if (int(blocks_.list.size()) == known) break;
    prepare(world.bodies, known, h);
    for (int i = 0; i < iterations; ++i) sweep(world.bodies, i);
  }
  finish(world, h);
}

void SequentialImpulses::begin(World& world, real h) {
  require(finite(h) && h > 0, "h: the step must be positive and finite [s]");
  require(iterations > 0, "iterations: there must be at least one");
  require(projections >= 0, "projections: must not be negative");
  for (int slot = 0; slot < world.bodies.slots(); ++slot)
    integrate_forces(world.bodies.at(slot), world.gravity, h);

  blocks_.clear();
  blocks_.reserve(world.most_rows());
  for (const auto& joint : world.joints()) joint->begin_step(world.bodies, h);
  for (const auto& joint : world.joints()) joint->append(world.bodies, blocks_);

  prepared_.clear();
  rows_.clear();
  inverse_K_.clear();
  prepared_.reserve(world.most_rows());
  rows_.reserve(world.most_rows());
  inverse_K_.reserve(6 * world.most_rows());
  sequence_.reserve(world.most_rows());
  prepare(world.bodies, 0, h);
  apply_stored_impulses(world.bodies, warm_start && last_h_ > 0 ? h / last_h_ : 1);
  last_h_ = h;
}

void SequentialImpulses::finish(World& world, real h) {
  for (int slot = 0; slot < world.bodies.slots(); ++slot)
    integrate_pose(world.bodies.at(slot), h);
  for (int i = 0; i < projections; ++i) projection_.sweep(world);
}

void SequentialImpulses::prepare(const Bodies& bodies, int first_block, real h) {
  for (std::size_t k = first_block; k < blocks_.list.size(); ++k) {
    const Block& block = blocks_.list[k];
    if (row_by_row)
      for (int i = 0; i < block.rows; ++i) prepare_rows(bodies, block, i, i + 1, h);
    else
      prepare_rows(bodies, block, 0, block.rows, h);
  }
}

// Turns the rows [from, to) of a block, with this step's h, into what the inner loop reads.
void SequentialImpulses::prepare_rows(const Bodies& bodies, const Block& block, int from, int to,
                                      real h) {
  const Demand& demand = block.demand;
  const int n = to - from;
  const bool has_last = to == block.rows;  // the row to which target and bounds belong
  Prepared out{block.body1, block.body2, n, int(rows_.size()), int(inverse_K_.size()),
               block.touches, 1, 0, -unbounded, unbounded, block.impulse + from};

  real rate = demand.beta / h;  // share of C that is removed each second
  if (demand.frequency > 0) {   // a spring and damper, implicit in time (Catto 2011)
    const real omega = 2 * std::numbers::pi_v<real> * demand.frequency;
    const real a1 = 2 * demand.damping + h * omega, a2 = h * omega * a1;
    rate = omega / a1;
    out.mass_scale = a2 / (1 + a2);
    out.impulse_scale = 1 / (1 + a2);
  }
  if (has_last) {
    out.lower = h * demand.lower;
    out.upper = h * demand.upper;
  }

  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      inverse_K_.push_back(blocks_.K[block.first_K + (from + i) * block.rows + from + j]);
  real* inverse_K = inverse_K_.data() + out.first_K;
  invert_symmetric(inverse_K, n);

  const mat3 I1 = inverse_inertia(bodies.at(block.body1));
  const mat3 I2 = inverse_inertia(bodies.at(block.body2));
  const real last = inverse_K[n * n - 1];
  for (int i = 0; i < n; ++i) {
    const Row& J = blocks_.J[block.first + from + i];
    const real C = blocks_.C[block.first + from + i];
    real bias = rate * C;
    if (has_last && i == n - 1) {
      const bool one_sided = demand.lower == 0 && demand.upper == unbounded;
      if (one_sided && C > 0) bias = C / h;  // still room: it may be used up, no more
      bias -= demand.target;
    }
    const real answer = last > 0 ? inverse_K[i * n + n - 1] / last : real(0);
    rows_.push_back({J, I1 * J.w1, I2 * J.w2, bias, answer});
  }
  prepared_.push_back(out);
}

// Warm: apply what the joints remember of the last step. Cold: make them forget it. A row that can
// do nothing now (no direction, or dependent on others) forgets it too.
void SequentialImpulses::apply_stored_impulses(Bodies& bodies, real scale) {
  for (const Prepared& block : prepared_) {
    Body &body1 = bodies.at(block.body1), &body2 = bodies.at(block.body2);
    for (int i = 0; i < block.rows; ++i) {
      real& lambda = block.impulse[i];
      const bool live = inverse_K_[block.first_K + i * block.rows + i] > 0;
      lambda = warm_start && live ? scale * lambda : 0;
      const PreparedRow& row = rows_[block.first + i];
      body1.v += body1.inverse_mass * lambda * row.J.v1;
      body1.w += lambda * row.turn1;
      body2.v += body2.inverse_mass * lambda * row.J.v2;
      body2.w += lambda * row.turn2;
    }
  }
}

void SequentialImpulses::sweep(Bodies& bodies, int number) {
  Body* array = bodies.data();
  const int n = int(prepared_.size());
  const bool back =
      order == Order::backward || (order == Order::alternating && number % 2 == 1);
  if (order == Order::shuffled) {
    draw_order(n);
    for (int k : sequence_) solve(array, prepared_[k]);
  } else if (back) {
    for (int k = n - 1; k >= 0; --k) solve(array, prepared_[k]);
  } else {
    for (int k = 0; k < n; ++k) solve(array, prepared_[k]);
  }
}

// Fisher and Yates, written out because std::shuffle differs from library to library.
void SequentialImpulses::draw_order(int n) {
  if (seeded_with_ != seed) random_.seed(seed);
  seeded_with_ = seed;
  sequence_.resize(n);
  for (int k = 0; k < n; ++k) sequence_[k] = k;
  for (int k = n - 1; k > 0; --k) std::swap(sequence_[k], sequence_[random_() % (k + 1)]);
}

// One predictable switch a block; from here on the number of rows is known to the compiler.
void SequentialImpulses::solve(Body* bodies, const Prepared& block) {
  switch (block.rows) {
    case 1: return solve_rows<1>(bodies, block);
    case 2: return solve_rows<2>(bodies, block);
    case 3: return solve_rows<3>(bodies, block);
    case 4: return solve_rows<4>(bodies, block);
    case 5: return solve_rows<5>(bodies, block);
    case 6: return solve_rows<6>(bodies, block);
  }
}

template <int N>
void SequentialImpulses::solve_rows(Body* bodies, const Prepared& block) {
  switch (block.touches) {
    case Touches::linear: return solve_block<N, true, false>(bodies, block);
    case Touches::angular: return solve_block<N, false, true>(bodies, block);
    case Touches::both: return solve_block<N, true, true>(bodies, block);
  }
}

// The whole inner step, for hard, Baumgarte, soft, one-sided and motor rows alike.
template <int N, bool linear, bool angular>
void SequentialImpulses::solve_block(Body* bodies, const Prepared& block) {
  Body &body1 = bodies[block.body1], &body2 = bodies[block.body2];
  const PreparedRow* row = &rows_[block.first];
  const real* inverse_K = &inverse_K_[block.first_K];

  real e[N];  // how far the rate of each row is from what is wanted: bias + J V
  for (int i = 0; i < N; ++i) {
    e[i] = row[i].bias;
    if constexpr (linear) e[i] += dot(row[i].J.v1, body1.v) + dot(row[i].J.v2, body2.v);
    if constexpr (angular) e[i] += dot(row[i].J.w1, body1.w) + dot(row[i].J.w2, body2.w);
  }

  real dlambda[N];  // the impulse that takes it away
  for (int i = 0; i < N; ++i) {
    real sum = 0;
    for (int j = 0; j < N; ++j) sum += inverse_K[i * N + j] * e[j];
    dlambda[i] = -block.mass_scale * sum - block.impulse_scale * block.impulse[i];
  }

  // The last row's sum must stay within its bounds; the others answer to what is cut off.
  const real wanted = block.impulse[N - 1] + dlambda[N - 1];
  const real kept = std::clamp(wanted, block.lower, block.upper), cut = kept - wanted;
  for (int i = 0; i < N; ++i) dlambda[i] += row[i].answer * cut;
  if (cut != 0) dlambda[N - 1] = kept - block.impulse[N - 1];  // at the bound to the last digit

  vec3 push1(0), turn1(0), push2(0), turn2(0);
  for (int i = 0; i < N; ++i) {
    block.impulse[i] += dlambda[i];
    if constexpr (linear) {
      push1 += dlambda[i] * row[i].J.v1;
      push2 += dlambda[i] * row[i].J.v2;
    }
    if constexpr (angular) {
      turn1 += dlambda[i] * row[i].turn1;
      turn2 += dlambda[i] * row[i].turn2;
    }
  }
  if constexpr (linear) {
    body1.v += body1.inverse_mass * push1;
    body2.v += body2.inverse_mass * push2;
  }
  if constexpr (angular) {
    body1.w += turn1;
    body2.w += turn2;
  }
}

}  // namespace joints
