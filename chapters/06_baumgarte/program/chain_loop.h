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
        const JointRows& rows = rows_[k];
        const vec3 lambda = block_impulse(rows.J, rows.K, biases_[k], bodies[k], bodies[k + 1]);
        apply_impulse(rows.J, lambda, bodies[k], bodies[k + 1]);
        impulses_[k] += lambda;
        change = glm::max(change, length(lambda));
        sum = glm::max(sum, length(impulses_[k]));
      }
      done = change <= settings.enough * sum;
    }
    move(chain, h);
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
  void prepare(real h) {
    rows_ = rows_of(chain);
    biases_.resize(rows_.size());
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const vec3 C = rows_[k].C;
      for (int i = 0; i < 3; ++i) biases_[k][i] = bias(C[i], settings.beta, h);  // Eq. 6-2
    }
  }

  std::vector<JointRows> rows_;
  std::vector<vec3> biases_;
  int iterated_ = 0;
  std::vector<vec3> impulses_;  // impulse of each joint in the last step [N s]
  real h_before_ = 0;           // the last step [s]
};

}  // namespace joints
/// @}
