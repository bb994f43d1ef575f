// The blocks of a step packed for the fastest loop: one after the other, or in lanes, where eight
// (float) or four (double) that are alike and share no body that moves are solved side by side.
#pragma once

#include "engine/simd/body_records.h"
#include "engine/iterative_solver.h"

/// \addtogroup world
/// @{
namespace joints {

/// Which blocks come together, and in which order.
enum class Packing {
  islands,  ///< the first block of every island of joints, then the second of every one; on lanes a
            ///< island a lane, where so many are alike that most lanes are used, else colours
  colours,  ///< neighbours get different colours, and one colour comes after the other
  list      ///< one at a time, in the order of the list: no lanes
};

/// All blocks of a step in groups that are solved side by side. Who comes with whom is worked out
/// once and kept for as long as the next steps have blocks of the same kinds between the same
/// bodies; then a step takes no memory from the heap.
class PackedBlocks {
 public:
  std::vector<LaneGroup> groups;  ///< in the order in which they are solved
  std::vector<int> blocks;        ///< of each group's lanes, which prepared block; -1: lane unused

  /// \param lanes false: every group is one block
  void pack(const Bodies& bodies, const Blocks& list, const Prepared& prepared,
            Packing packing, bool lanes);
  /// One iteration over all groups, with the best instructions that this processor has.
  void iterate();
  /// Gives velocities and sums of impulses back. \param prepared whose blocks were packed
  void end(Bodies& bodies, const Prepared& prepared) const;

  int width() const { return width_; }  ///< lanes of a group: 1 or lane_count
  const BodyRecords& records() const { return records_; }  ///< of the bodies, by their slots
  int packed() const { return packed_; }  ///< how often the groups had to be worked out anew

 private:
  // What a block is like, and between which bodies: while these stay, so do the groups.
  struct Sign {
    Kind kind;
    bool static1, static2;
    BodyPair bodies;
    int followed;  // PreparedBlock::followed
    bool operator==(const Sign&) const = default;
  };
  void arrange(const Bodies& bodies, Packing packing);
  void add_group(const std::vector<int>& members);
  void place_sums();
  // Which number is the sum of a row in a lane.
  int place_of_sum(const LaneGroup& group, int row, int lane) const {
    return group.first_sum + row * width_ + lane;
  }
  real* numbers() { return reinterpret_cast<real*>(numbers_.data()); }
  const real* numbers() const { return reinterpret_cast<const real*>(numbers_.data()); }

  std::vector<Sign> signs_, now_;
  std::vector<LaneNumber> numbers_;
  std::vector<int> sums_;
  BodyRecords records_;
  Packing packing_ = Packing::islands;
  int width_ = 0, packed_ = 0;
};

/// Sequential Impulses over packed blocks: the same rows, the same order within an island or a
/// colour, other blocks first.
class PackedImpulses : public IterativeSolver {
 public:
  Packing packing = Packing::islands;  ///< which blocks come together
  bool lanes = true;                   ///< false: one block at a time

  void solve(Bodies& bodies) override;
  const PackedBlocks& packed() const { return packed_; }  ///< of the last step

 private:
  PackedBlocks packed_;
};

}  // namespace joints
/// @}
