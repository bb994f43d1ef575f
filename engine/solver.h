// The interface of every solver: it finds the impulses of a step's blocks. It sees no joints.
#pragma once

#include <functional>
#include <string>

#include "engine/block.h"

/// \addtogroup world
/// @{
namespace joints {

/// Finds impulses such that each row reaches its target rate or one of its bounds, and applies them
/// to the bodies. The step calls check, prepare, warm_start and solve in this order, then prepare
/// and solve again for as long as late limits add blocks. A new solver is one class in one file.
class Solver {
 public:
  virtual ~Solver() = default;
  /// \throws std::invalid_argument for invalid settings, before anything has moved
  virtual void check() const = 0;
  /// Computes all that solve() needs of the blocks from number `first` on; those before it are
  /// prepared already. \param h step [s]
  virtual void prepare(const Bodies& bodies, const Blocks& blocks, int first, real h) = 0;
  /// Multiplies the accumulated impulses of the last step by `ratio` and applies them to bodies.
  /// \param ratio h over the last step's h [1]; 0 for a cold start, which sets them to zero
  virtual void warm_start(Bodies& bodies, real ratio) = 0;
  /// Changes velocities and accumulated impulses towards the solution.
  virtual void solve(Bodies& bodies) = 0;
  /// How it solves such blocks, in words, for those that report it; "" if there is no choice.
  virtual std::string plan(const Bodies&, const Blocks&) const { return {}; }
  /// Appends the blocks of the step once more, at the bodies' present poses.
  using Append = std::function<void(Blocks&)>;
  /// Moves the bodies by their velocities. A solver that corrects errors by more than impulses does
  /// it here, before or after. \param h step [s]
  virtual void advance(Bodies& bodies, real h, [[maybe_unused]] const Append& append) {
    integrate_poses(bodies, h);
  }

 protected:
  /// Called by prepare(), with what it was called with.
  void prepared_for(const Bodies& bodies, const Blocks& blocks, int first);
  /// The blocks of the last prepare(). \throws std::logic_error if it was called with other bodies,
  /// or if rows or bodies have come or gone since
  const Blocks& blocks_of(const Bodies& bodies) const;

 private:
  const Bodies* bodies_ = nullptr;
  const Blocks* blocks_ = nullptr;
  int slots_ = 0;         // of the bodies
  std::size_t rows_ = 0;  // of all blocks that were prepared
};

}  // namespace joints
/// @}
