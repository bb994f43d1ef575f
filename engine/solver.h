// The interface of every solver, which computes the impulses of a step's blocks.
#pragma once

#include <functional>
#include <string>

#include "engine/block.h"

/// \addtogroup world
/// @{
namespace joints {

/// Computes impulses such that each row reaches its target rate or one of its bounds, and applies
/// them to the bodies. The step calls prepare, warm_start and solve in this order. Then it calls
/// solve again if impulses have changed the mean rate of a fast rotation, and prepare and solve as
/// long as missed limits add blocks. A new solver is one class in one file.
class Solver {
 public:
  virtual ~Solver() = default;
  /// Validates the settings, before anything has moved.
  /// \throws std::invalid_argument for an invalid setting
  virtual void check() const = 0;
  /// Computes all data that solve() needs for the blocks from this one on. \param h step [s]
  virtual void prepare(const Bodies& bodies, const Blocks& blocks, int first_block, real h) = 0;
  /// Multiplies the accumulated impulses of the last step by `ratio` and applies them.
  /// \param ratio duration of this step's impulses over that of the last step's [1]; 0 for a cold
  /// start, which sets the impulses to zero
  virtual void warm_start(Bodies& bodies, real ratio) = 0;
  /// Changes velocities and accumulated impulses so that they approach the solution.
  virtual void solve(Bodies& bodies) = 0;
  /// For reports: which method the solver chooses for these blocks; "" if it has no choice.
  virtual std::string description(const Bodies&, const Blocks&) const { return {}; }
  /// Appends the blocks of the step again, at the bodies' present poses.
  /// \param of for each slot: only the blocks of joints of these bodies; null: of all joints
  using Append = std::function<void(Blocks&, const std::vector<bool>* of)>;
  /// Moves the bodies by their velocities. Here a solver may correct errors by other means than
  /// impulses. \param h step [s]
  virtual void advance(Bodies& bodies, real h, [[maybe_unused]] const Append& append) {
    integrate_poses(bodies, h);
  }

 protected:
  /// To be called by prepare(), with the same arguments.
  void prepared_for(const Bodies& bodies, const Blocks& blocks, int first_block);
  /// The blocks of the last prepare(). \throws std::logic_error if that call had other bodies, or
  /// if there are now more or fewer rows or slots than were prepared
  const Blocks& blocks_of(const Bodies& bodies) const;

 private:
  const Bodies* bodies_ = nullptr;
  const Blocks* blocks_ = nullptr;
  int slots_ = 0;         // Bodies::slots()
  std::size_t rows_ = 0;  // of all blocks that were prepared
};

/// A solver that solves one block after the other, in several iterations. For every block it
/// 1. adds dlambda of SoftCoefficients to the accumulated impulses;
/// 2. clamps the last one to its bounds (-+upper times the impulse that it follows, if it does);
/// 3. changes those of the other rows as far as the clamp requires (PreparedRow::clamp_response);
/// 4. changes the velocities. SequentialImpulses::solve_block is the reference.
class IterativeSolver : public Solver {
 public:
  int iterations = 30;  ///< iterations over all blocks per solve()
  real relaxation = 1;  ///< over-relaxation: factor of every impulse change [1]; stable below 2
  void check() const override;
};

}  // namespace joints
/// @}
