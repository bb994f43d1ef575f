// The blocks of a step packed into lanes: eight (float) or four (double) that are alike and share
// no body that moves are solved side by side.
#pragma once

#include "engine/lane_records.h"
#include "engine/preparation.h"
#include "engine/projection.h"

/// \addtogroup world
/// @{
namespace joints {

/// Which blocks come together.
enum class Packing {
  trees,   ///< a tree of joints a lane, where so many are alike that most lanes are used; else:
  colours  ///< neighbours get different colours, and one colour comes after the other
};

/// All blocks of a step in groups of lanes.
class WideBlocks {
 public:
  std::vector<LaneGroup> groups;  ///< in the order in which they are solved
  std::vector<LaneNumber> numbers;  ///< what the sweeps read, group by group
  std::vector<LaneBody> bodies;   ///< the velocities; the last record belongs to unused lanes

  /// Forgets all groups and takes over the bodies' velocities.
  void begin(const Bodies& bodies);
  /// Packs the prepared blocks from number `first` on.
  void add(const Bodies& bodies, const Preparation& prepared, int first, Packing packing);
  /// One sweep over all groups, with the best instructions that this processor has.
  void sweep();
  /// Gives velocities and sums of impulses back. \param prepared whose blocks were packed
  void end(Bodies& bodies, const Preparation& prepared) const;

 private:
  bool add_trees(const Bodies& bodies, const Preparation& prepared, int first);
  void add_group(const Bodies& bodies, const Preparation& prepared, const int* blocks, int count);
};

/// Sequential Impulses on lanes: the same rows, the same order within a colour, other blocks first.
/// The blocks are packed anew in every step, which takes memory from the heap.
class WideImpulses {
 public:
  int iterations = 30;      ///< sweeps a step
  bool warm_start = false;  ///< begin with the impulses of the last step
  int projections = 0;      ///< sweeps of position projection after a step
  Packing packing = Packing::trees;  ///< which blocks come together

  /// Moves the world on by one step. \param h step [s]
  /// \throws std::invalid_argument unless h and the iterations are positive and the projections not
  /// negative
  void step(World& world, real h);
  const WideBlocks& lanes() const { return lanes_; }  ///< of the last step

 private:
  Blocks blocks_;
  Preparation prepared_;
  WideBlocks lanes_;
  Projection projection_;
  real last_h_ = 0;
};

}  // namespace joints
/// @}
