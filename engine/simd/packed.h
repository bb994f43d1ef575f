// The blocks of a step packed for the fastest loop: one after the other, or in lanes, where eight
// (float) or four (double) that are alike and share no body that moves are solved side by side.
#pragma once

#include "engine/simd/records.h"
#include "engine/solver.h"

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
  std::vector<int> ends;          ///< of each group, its bodies: LaneGroup::first_end

  /// \param lanes false: every group is one block
  void pack(const Bodies& bodies, const Blocks& list, const Preparation& prepared,
            Packing packing, bool lanes);
  /// One iteration over all groups, with the best instructions that this processor has.
  void iterate();
  /// Gives velocities and sums of impulses back. \param prepared whose blocks were packed
  void end(Bodies& bodies, const Preparation& prepared) const;

  int width() const { return width_; }  ///< lanes of a group: 1 or lane_count
  /// The slots of bodies that the records belong to, -1: to none.
  const std::vector<int>& slots() const { return slots_; }
  int packed() const { return packed_; }  ///< how often the groups had to be worked out anew

 private:
  // What a block is like, and between which bodies: while these stay, so do the groups.
  struct Sign {
    int kind, body1, body2;
    int followed;  // 8 * block + row of the sum that its bounds follow, or -1
    bool operator==(const Sign&) const = default;
  };
  // So many numbers begin where 32 bytes begin.
  struct alignas(32) LaneNumber {
    real lane[lane_count];
  };

  void arrange(const Bodies& bodies, Packing packing);
  using Islands = std::vector<std::vector<int>>;  // of each, its blocks
  Islands find_islands(const Bodies& bodies) const;
  void interleave(const Islands& islands);
  bool arrange_islands(const Bodies& bodies, const Islands& islands);
  void arrange_colours(const Bodies& bodies);
  void add_group(const int* list, int count);
  static int find_sum(const Preparation& prepared, int k);
  void place_sums();
  static int size_of(const LaneGroup& group);
  real* record(int number);
  const real* record(int number) const;
  void fill(const Bodies& bodies, const Blocks& list, const Preparation& prepared,
            const LaneGroup& group, int first);

  std::vector<Sign> signs_, now_;
  std::vector<LaneNumber> numbers_;
  std::vector<Velocities<real>> records_;
  std::vector<int> slots_, sums_;
  Packing packing_ = Packing::islands;
  int width_ = 0, packed_ = 0;
  bool columns_ = false;
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
