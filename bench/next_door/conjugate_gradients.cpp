// Conjugate gradients, preconditioned by the blocks.
#include "bench/next_door/conjugate_gradients.h"

#include <utility>

#include "engine/kernels.h"

namespace joints::bench {

namespace {

// In double also where real is float: the sums run over all rows.
double product(const std::vector<real>& a, const std::vector<real>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += double(a[i]) * double(b[i]);
  return sum;
}

}  // namespace

void ConjugateGradients::prepare(const Bodies& bodies, const Blocks& blocks, int first, real h) {
  require(relaxation == 1, "conjugate gradients: no relaxation");
  for (const Block& block : blocks.list)
    require(block.settings.follows == 0 && block.settings.lower == -unbounded &&
                block.settings.upper == unbounded,
            "conjugate gradients: only rows without bounds");
  SequentialImpulses::prepare(bodies, blocks, first, h);
}

void ConjugateGradients::precondition(const std::vector<real>& r, std::vector<real>& z) const {
  for (const PreparedBlock& block : prepared_.blocks) {
    const real* const inverse = &prepared_.scaled_inverse_K[std::size_t(block.first_K)];
    for (int i = 0; i < block.rows; ++i) {
      real sum = 0;
      for (int j = 0; j < block.rows; ++j)
        sum += inverse[i * block.rows + j] * r[std::size_t(block.first + j)];
      z[std::size_t(block.first + i)] = sum;
    }
  }
}

void ConjugateGradients::solve(Bodies& bodies) {
  const std::vector<Row>& J = blocks_of(bodies).J;
  const std::size_t count = J.size();
  for (std::vector<real>* const numbers : {&residual_, &z_, &p_, &A_p_}) numbers->resize(count);
  // Calls f(row, gamma times these impulses) for the rows of a soft block: gamma = softness K,
  // mass_scale = 1/(1 + softness), impulse_scale = 1 - mass_scale.
  const auto gamma = [&](const PreparedBlock& block, const real* numbers, const auto& f) {
    if (block.coefficients.impulse_scale == 0) return;
    const real softness = block.coefficients.impulse_scale / block.coefficients.mass_scale;
    for (int i = 0; i < block.rows; ++i) {
      real sum = 0;
      for (int j = 0; j < block.rows; ++j)
        sum += numbers[j] * dot(twelve(J[std::size_t(block.first + i)]),
                                twelve(prepared_.rows[std::size_t(block.first + j)].response));
      f(std::size_t(block.first + i), softness * sum);
    }
  };

  for (const PreparedBlock& block : prepared_.blocks) {  // r = -(J V + b + gamma lambda)
    const Body &body1 = bodies.at(block.body1), &body2 = bodies.at(block.body2);
    for (int i = 0; i < block.rows; ++i) {
      const std::size_t row = std::size_t(block.first + i);
      residual_[row] = -row_velocity(J[row], body1, body2) - prepared_.rows[row].bias;
    }
    gamma(block, block.impulse, [&](std::size_t row, real part) { residual_[row] -= part; });
  }
  precondition(residual_, z_);
  p_ = z_;
  double rho = product(residual_, z_);
  const double enough = double(tolerance) * double(tolerance) * rho;
  for (used = 0; used < iterations && rho > enough; ++used) {
    velocities_.assign(std::size_t(bodies.slots()), {});
    for (const PreparedBlock& block : prepared_.blocks) {  // M^-1 J^T p
      Velocity &one = velocities_[std::size_t(block.body1)],
               &two = velocities_[std::size_t(block.body2)];
      for (int i = 0; i < block.rows; ++i) {
        const std::size_t row = std::size_t(block.first + i);
        const Row& response = prepared_.rows[row].response;
        one.v += p_[row] * response.v1;
        one.w += p_[row] * response.w1;
        two.v += p_[row] * response.v2;
        two.w += p_[row] * response.w2;
      }
    }
    for (const PreparedBlock& block : prepared_.blocks) {  // A p = J (M^-1 J^T p) + gamma p
      const Velocity &one = velocities_[std::size_t(block.body1)],
                     &two = velocities_[std::size_t(block.body2)];
      for (int i = 0; i < block.rows; ++i) {
        const Row& row = J[std::size_t(block.first + i)];
        A_p_[std::size_t(block.first + i)] =
            dot(row.v1, one.v) + dot(row.w1, one.w) + dot(row.v2, two.v) + dot(row.w2, two.w);
      }
      gamma(block, &p_[std::size_t(block.first)],
            [&](std::size_t row, real part) { A_p_[row] += part; });
    }
    const double curvature = product(p_, A_p_);
    if (!(curvature > 0)) break;  // rounding is all that is left
    const real a = real(rho / curvature);
    for (const PreparedBlock& block : prepared_.blocks)
      for (int i = 0; i < block.rows; ++i)
        block.impulse[i] += a * p_[std::size_t(block.first + i)];
    for (std::size_t row = 0; row < count; ++row) residual_[row] -= a * A_p_[row];
    for (int slot = 0; slot < bodies.slots(); ++slot) {
      Body& body = bodies.at(slot);
      if (body.is_static()) continue;
      body.v += a * velocities_[std::size_t(slot)].v;
      body.w += a * velocities_[std::size_t(slot)].w;
    }
    precondition(residual_, z_);
    const double before = std::exchange(rho, product(residual_, z_));
    for (std::size_t row = 0; row < count; ++row) p_[row] = z_[row] + real(rho / before) * p_[row];
  }
}

}  // namespace joints::bench
