// The iterations at the end of a step.
#include "engine/steps/two_pass_impulses.h"

#include "engine/rotation/free_rotation.h"
#include "engine/steps/soft.h"

namespace joints {

void TwoPassImpulses::check() const {
  IterativeSolver::check();
  require(relax_iterations >= 0, "relax_iterations: must not be negative");
  require(split_iterations >= 0, "split_iterations: must not be negative");
  require(relax_iterations == 0 || split_iterations == 0,
          "relax_iterations: a split impulse leaves nothing to relax; one of the two must be 0");
}

void TwoPassImpulses::prepare(const Bodies& bodies, const Blocks& blocks, int first, real h) {
  SequentialImpulses::prepare(bodies, blocks, first, h);
  if (split_iterations == 0) return;
  for (std::size_t k = std::size_t(first); k < prepared_.blocks.size(); ++k)
    if (PreparedBlock& block = prepared_.blocks[k]; block.corrects)
      retarget(block, blocks, without_feedback(block.settings), h);
}

void TwoPassImpulses::advance(Bodies& bodies, real h, const Append& append) {
  if (split_iterations > 0) return advance_split(bodies, h);
  if (relax_iterations > 0) start_.assign(bodies.data(), bodies.data() + bodies.slots());
  SequentialImpulses::advance(bodies, h, append);
  if (relax_iterations > 0) relax(bodies, h);
}

// Gives a block the scales and biases of another target with the same bounds.
void TwoPassImpulses::retarget(PreparedBlock& block, const Blocks& blocks,
                               const RowSettings& target, real h) {
  const SoftCoefficients now = soft_coefficients(target, h, blocks.duration_or(h), relaxation);
  const real scale = now.mass_scale / block.coefficients.mass_scale;
  for (int i = 0; i < block.rows * block.rows; ++i)
    prepared_.scaled_inverse_K[std::size_t(block.first_K + i)] *= scale;
  block.coefficients.mass_scale = now.mass_scale;
  block.coefficients.impulse_scale = now.impulse_scale;
  for (int i = 0; i < block.rows; ++i) {
    const std::size_t row = std::size_t(block.first + i);
    prepared_.rows[row].bias = bias(block, i, blocks.C[row], now.bias_rate, h);
  }
}

void TwoPassImpulses::relax(Bodies& bodies, real h) {
  const Blocks& blocks = blocks_of(bodies);
  for (PreparedBlock& block : prepared_.blocks)
    if (block.corrects) retarget(block, blocks, without_feedback(block.settings), h);
  // The rows are those of the old poses, and so are the velocities: there an impulse changes the
  // angular momenta of two bodies by opposite amounts. In the new poses w follows from them.
  std::swap_ranges(start_.begin(), start_.end(), bodies.data());
  for (int i = 0; i < relax_iterations; ++i) iterate(bodies);  // Eq. 6-17
  std::swap_ranges(start_.begin(), start_.end(), bodies.data());
  for (int slot = 0; slot < bodies.slots(); ++slot) {
    Body &body = bodies.at(slot), &before = start_[slot];
    if (body.is_static()) continue;
    use_own_rate(before);
    clamp_speed(before);
    body.v = before.v;
    if (body.is_isotropic()) body.w = before.w;
    else set_angular_momentum(body, angular_momentum(before));
  }
}

void TwoPassImpulses::advance_split(Bodies& bodies, real h) {
  const Blocks& blocks = blocks_of(bodies);
  split_impulses_.assign(blocks.C.size(), real(0));
  split_blocks_.clear();
  for (PreparedBlock& block : prepared_.blocks) {
    if (!block.corrects) continue;
    retarget(block, blocks, block.settings, h);
    split_blocks_.push_back(block);
    split_blocks_.back().impulse = &split_impulses_[std::size_t(block.first)];
    // a limit must see both velocities together, an equality only the correcting one
    const std::size_t last = std::size_t(block.first + block.rows - 1);
    prepared_.rows[last].bias +=
        block.settings.one_sided()
            ? row_velocity(blocks.J[last], bodies.at(block.body1), bodies.at(block.body2))
            : block.settings.rate;
  }

  const auto for_bodies = [&](const auto& f) {
    for (int slot = 0; slot < bodies.slots(); ++slot) f(bodies.at(slot), velocities_[slot]);
  };
  velocities_.resize(std::size_t(bodies.slots()));
  for_bodies([](Body& body, auto& kept) {
    if (!body.is_static()) clamp_speed(body);
    kept = {body.v, body.w};
    body.v = body.w = vec3(0);
  });
  prepared_.blocks.swap(split_blocks_);
  for (int i = 0; i < split_iterations; ++i) iterate(bodies);  // Eq. 6-13
  prepared_.blocks.swap(split_blocks_);
  for_bodies([h](Body& body, auto& kept) {
    std::swap(body.v, kept.first);
    std::swap(body.w, kept.second);
    integrate_pose(body, h);
    body.x += h * kept.first;  // Eq. 6-14
    if (kept.second != vec3(0)) body.q = normalize(rotation(h * kept.second) * body.q);
  });
}

}  // namespace joints
