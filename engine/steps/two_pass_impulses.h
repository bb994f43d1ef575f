// Sequential Impulses with a second kind of iterations at the end of a step, so that feedback
// leaves no velocity behind: relax iterations or a split impulse (chapter 6).
#pragma once

#include "engine/sequential_impulses.h"

/// \addtogroup world
/// @{
namespace joints {

/// Sequential Impulses whose feedback moves the bodies without changing their velocities.
class TwoPassImpulses : public SequentialImpulses {
 public:
  /// The number of relax iterations. They are done after the bodies have moved, with the J of the
  /// step's beginning and without feedback (without_feedback()), and they remove the velocity that
  /// the feedback has added. The accumulated impulses and their bounds include both kinds of
  /// iterations. Springs that a joint itself has set are not changed. Source: Catto, "Solver2D",
  /// 2024 (soft step).
  int relax_iterations = 0;
  /// The number of iterations of the split impulse. With split impulse the velocities are solved
  /// without feedback. These iterations solve for a second velocity per body with feedback, which
  /// starts from zero in every step. Both velocities move the bodies, and then the second one and
  /// its impulses are discarded. It cannot be combined with relax iterations.
  /// Source: Bullet, btSequentialImpulseConstraintSolver (m_splitImpulse).
  int split_iterations = 0;

  void check() const override;
  /// With a split impulse, the velocities have no feedback.
  void prepare(const Bodies& bodies, const Blocks& blocks, int first, real h) override;
  /// Moves the bodies. Split impulses are solved before that, and relax iterations are done after
  /// it.
  void advance(Bodies& bodies, real h, const Append& append) override;

 private:
  void retarget(PreparedBlock& block, const Blocks& blocks, const RowSettings& target, real h);
  void relax(Bodies& bodies, real h);
  void advance_split(Bodies& bodies, real h);

  std::vector<Body> start_;  // the bodies before the move, for the relax iterations
  // For the split impulses: the blocks, an impulse per row, v and w of each body.
  std::vector<PreparedBlock> split_blocks_;
  std::vector<real> split_impulses_;
  std::vector<std::pair<vec3, vec3>> velocities_;
};

}  // namespace joints
/// @}
