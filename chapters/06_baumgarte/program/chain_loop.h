// The loop of chapter 6's program: a chain on ball joints, moved by your own bias, warm start and
// projection. Given, there is nothing to edit here.
#pragma once

#include "chapters/06_baumgarte/baumgarte.h"

/// \addtogroup chapter6
/// @{
namespace joints {

/// The settings that keep the joints of a chain closed.
struct Stabilisation {
  real beta = 0;        ///< fraction of the error fed back per step [1]
  bool warm = false;    ///< begin with the impulses of the last step
  int projections = 0;  ///< iterations of position projection after a step
  int iterations = 30;  ///< maximum number of iterations for the velocities
  /// The iterations stop when no impulse of an iteration exceeds this fraction of the largest
  /// accumulated impulse [1]; with 0 they stop when nothing changes any more.
  real enough = 0;
};

/// A chain, and its state from step to step.
class ChainLoop {
 public:
  Chain chain;             ///< bodies and joints
  Stabilisation settings;  ///< may be changed between steps
  vec3 gravity{0, real(-9.81), 0};  ///< [m/s^2]

  /// Forces, rows, warm start, iterations, positions, projection. \param h the step [s]
  void step(real h) {
    std::vector<Body>& bodies = chain.bodies;
    for (Body& body : bodies) integrate_forces(body, gravity, h);
    impulses_.resize(chain.joints.size());
    prepare(h);
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      if (settings.warm && h_before_ > 0)
        warm_start(rows_[k].J, h / h_before_, impulses_[k], bodies[k], bodies[k + 1]);
      else
        impulses_[k] = vec3(0);
    }
    bool done = false;
    for (iterated_ = 0; iterated_ < settings.iterations && !done; ++iterated_) {
      real change = 0, sum = 0;
      for (std::size_t k = 0; k < rows_.size(); ++k) {
        const Rows& rows = rows_[k];
        const vec3 lambda = block_impulse(rows.J, rows.K, rows.bias, bodies[k], bodies[k + 1]);
        apply_impulse(rows.J, lambda, bodies[k], bodies[k + 1]);
        impulses_[k] += lambda;
        change = glm::max(change, length(lambda));
        sum = glm::max(sum, length(impulses_[k]));
      }
      done = change <= settings.enough * sum;
    }
    for (Body& body : bodies) {
      if (body.is_static()) continue;
      body.x += h * body.v;
      body.q = turned(body.q, body.w, h);
    }
    for (int iteration = 0; iteration < settings.projections; ++iteration)
      projection_iteration(chain);
    h_before_ = h;
  }

  /// Iterations of the last step.
  int iterated() const { return iterated_; }
  /// Gap of a joint [m].
  real gap(std::size_t k) const {
    return length(chain.joints[k].error(chain.bodies[k], chain.bodies[k + 1]));
  }

 private:
  // One joint, prepared for the iterations of a step.
  struct Rows {
    Jacobian<3> J;
    mat3 K;
    vec3 bias;
  };
  void prepare(real h) {
    rows_.clear();
    for (std::size_t k = 0; k < chain.joints.size(); ++k) {
      const Body &body1 = chain.bodies[k], &body2 = chain.bodies[k + 1];
      const Point& joint = chain.joints[k];
      const vec3 C = joint.error(body1, body2);
      rows_.push_back({joint.jacobian(body1, body2), joint.K(body1, body2), vec3(0)});
      for (int i = 0; i < 3; ++i) rows_.back().bias[i] = bias(C[i], settings.beta, h);  // Eq. 6-2
    }
  }

  std::vector<Rows> rows_;
  int iterated_ = 0;
  std::vector<vec3> impulses_;  // impulse of each joint in the last step [N s]
  real h_before_ = 0;           // the last step [s]
};

}  // namespace joints
/// @}
