// XPBD: predicted poses, rows solved on positions, velocities from the displacements.
#include "bench/next_door/xpbd.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace joints::bench {

namespace {

// The rotation vector of a unit quaternion, at most pi long [rad].
vec3 rotation_vector(quat q) {
  if (q.w < 0) q = -q;
  const vec3 v(q.x, q.y, q.z);
  const real sine = length(v);
  return sine == 0 ? vec3(0) : 2 * std::atan2(sine, q.w) / sine * v;
}

}  // namespace

void Xpbd::check() const { require(iterations > 0, "iterations: there must be at least one"); }

void Xpbd::prepare(const Bodies& bodies, const Blocks& blocks, int first, real h) {
  prepared_for(bodies, blocks, first);
  acting_ = blocks.duration_or(h);
}

void Xpbd::advance(Bodies& bodies, real h, const Append& append) {
  const std::size_t count = std::size_t(bodies.slots());
  d_.assign(count, {});
  done_.assign(count, {});
  begin_.resize(count);
  for (std::size_t slot = 0; slot < count; ++slot) {
    Body& body = bodies.at(int(slot));
    begin_[slot] = body.q;
    if (body.is_static()) continue;
    clamp_speed(body);
    d_[slot] = {h * body.v, h * body.w};
  }
  move(bodies);
  for (int i = 0; i < iterations; ++i) {
    blocks_.clear();
    append(blocks_, nullptr);
    start_impulses(i == 0);
    iterate(bodies, h);
    move(bodies);
  }
  for (std::size_t slot = 0; slot < count; ++slot) {
    Body& body = bodies.at(int(slot));
    if (body.is_static()) continue;
    body.v = d_[slot].x / h;
    body.w = rotation_vector(body.q * conjugate(begin_[slot])) / h;
  }
}

// Sets the impulses of blocks to zero that are new in this step.
void Xpbd::start_impulses(bool first) {
  if (first) known_.clear();
  for (std::size_t k = 0; k < blocks_.list.size(); ++k) {
    const Block& block = blocks_.list[k];
    if (!first && ((k < known_.size() && known_[k] == block.impulse) ||
                   std::find(known_.begin(), known_.end(), block.impulse) != known_.end()))
      continue;
    std::fill_n(block.impulse, block.rows, real(0));
    known_.push_back(block.impulse);
  }
}

void Xpbd::iterate(Bodies& bodies, real h) {
  for (const Block& block : blocks_.list) {
    const RowSettings& target = block.settings;
    const real omega_h = 2 * std::numbers::pi_v<real> * target.frequency * h;
    const real compliance = omega_h > 0 ? 1 / (omega_h * omega_h) : 0;  // alpha/(h^2 K)
    const real damper = omega_h > 0 ? 2 * target.damping / omega_h : 0;  // alpha c/h
    Displacement &d1 = d_[std::size_t(block.body1)], &d2 = d_[std::size_t(block.body2)];
    const Displacement &done1 = done_[std::size_t(block.body1)],
                       &done2 = done_[std::size_t(block.body2)];
    Row response[6];
    form_responses(&blocks_.J[std::size_t(block.first)], block.rows, bodies.at(block.body1),
                   bodies.at(block.body2), response);
    for (int i = 0; i < block.rows; ++i) {
      const Row &J = blocks_.J[std::size_t(block.first + i)], &M = response[i];
      const real K = dot(J.v1, M.v1) + dot(J.w1, M.w1) + dot(J.v2, M.v2) + dot(J.w2, M.w2);
      if (!(K > 0)) continue;
      const auto along = [&J](const Displacement& a, const Displacement& b) {
        return dot(J.v1, a.x) + dot(J.w1, a.phi) + dot(J.v2, b.x) + dot(J.w2, b.phi);
      };
      const bool last = i == block.rows - 1;
      const real moved = along(d1, d2);
      real error = last ? -h * target.rate : real(0);
      error += target.holds_position
                   ? blocks_.C[std::size_t(block.first + i)] + moved - along(done1, done2)
                   : moved;

      real& lambda = block.impulse[i];
      const real wanted = lambda - ((error + damper * moved) / h + compliance * K * lambda) /
                                       ((1 + damper + compliance) * K);
      real lower = -unbounded, upper = unbounded;
      if (last && target.follows != 0) {
        upper = target.upper * block.impulse[target.follows];
        lower = -upper;
      } else if (last) {
        lower = acting_ * target.lower;
        upper = acting_ * target.upper;
      }
      const real change = h * (std::clamp(wanted, lower, upper) - lambda);
      lambda += change / h;
      d1.x += change * M.v1;
      d1.phi += change * M.w1;
      d2.x += change * M.v2;
      d2.phi += change * M.w2;
    }
  }
}

// Moves the poses by the change of d_ since the last call.
void Xpbd::move(Bodies& bodies) {
  for (std::size_t slot = 0; slot < d_.size(); ++slot) {
    Body& body = bodies.at(int(slot));
    if (body.is_static()) continue;
    body.x += d_[slot].x - done_[slot].x;
    body.q = normalize(rotation(d_[slot].phi - done_[slot].phi) * body.q);
    done_[slot] = d_[slot];
  }
}

}  // namespace joints::bench
