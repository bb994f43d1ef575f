// The blocks of a step packed for the SIMD loop: eight (float) or four (double) blocks of one kind
// that share no moving body are solved side by side, one per lane.
#pragma once

#include "engine/simd/body_records.h"
#include "engine/iterative_solver.h"

/// \addtogroup world
/// @{
namespace joints {

/// How blocks are grouped and ordered.
enum class Packing {
  automatic,  ///< the first of these that uses at least half of the lanes: islands of one pattern
              ///< side by side, one per lane (the first block of every island, then the second of
              ///< every one), colours, and if neither does, list. Without lanes: islands by turns
  colours,    ///< graph colouring, one colour after the other
  list        ///< the order of the list, without lanes
};

/// The blocks of a step in groups that are solved side by side. The grouping is cached until the
/// topology changes (the kinds of the blocks or their bodies); a step with a cached grouping does
/// not allocate.
class PackedBlocks {
 public:
  std::vector<LaneGroup> groups;  ///< in the order in which they are solved
  std::vector<int> blocks;        ///< the block of each lane of each group; -1: unused lane

  /// Fills the records from the blocks of a step and prepares them for its iterations.
  /// \param h step [s] \param relaxation of the solver [1]
  /// \param lanes false: every group is one block
  void pack(const Bodies& bodies, const Blocks& list, real h, real relaxation, Packing packing,
            bool lanes);
  void take(const Bodies& bodies);       ///< copies the bodies' velocities into the records
  void give_back(Bodies& bodies) const;  ///< copies them back to the bodies that can move
  /// A pass over all groups, with the best instruction set of this processor.
  void run(Pass pass, real parameter = 0);
  /// Copies the accumulated impulses back into the joints. \param list as given to pack()
  void unpack(const Blocks& list) const;

  int width() const { return width_; }  ///< lanes of a group: 1 or lane_count
  std::string words() const;  ///< the grouping in words, as "8 lanes, an island in each"
  const BodyRecords& records() const { return records_; }  ///< body indices are slots
  int groupings() const { return groupings_; }  ///< how often the grouping was computed

 private:
  // What the grouping depends on: compared in every step.
  struct Signature {
    BlockKind kind;
    bool static1, static2;
    BodyPair bodies;
    int followed;  // followed_row()
    bool operator==(const Signature&) const = default;
  };
  bool sign(const Bodies& bodies, const Blocks& list);
  void arrange(const Bodies& bodies);
  void add_group(const std::vector<int>& members);
  void find_followed();
  // Calls f with the record of a group, of one block or of lane_count.
  template <class F>
  void in_record(const LaneGroup& group, real* numbers, const F& f) const {
    if (width_ == 1)
      use_record<real>(group, numbers, f);
    else
      use_record<LaneNumber>(group, numbers, f);
  }
  // The index in numbers() of a row's accumulated impulse.
  int lambda_index(const LaneGroup& group, int row, int lane) const {
    return group.first_lambda + row * width_ + lane;
  }
  real* numbers() { return reinterpret_cast<real*>(numbers_.data()); }
  const real* numbers() const { return reinterpret_cast<const real*>(numbers_.data()); }

  LaneWork work() { return {groups.data(), int(groups.size()), numbers(), followed_.data(),
                            records_.view()}; }

  std::vector<Signature> signatures_;
  std::vector<LaneNumber> numbers_;
  std::vector<int> followed_;  // LaneWork::followed
  BodyRecords records_;
  Packing packing_ = Packing::automatic;  // as wanted
  bool lanes_ = true;                     // as wanted
  int width_ = 0, groupings_ = 0;
};

/// Sequential Impulses over packed blocks: the same solve of each block, in another order. By
/// islands each island keeps the order of the list; by colours it does not. The joints' accumulated
/// impulses are written when solve() ends. It has neither relax iterations nor split impulses.
class PackedImpulses : public IterativeSolver {
 public:
  Packing packing = Packing::automatic;  ///< how blocks are grouped and ordered
  bool lanes = true;                   ///< false: one block at a time

  /// \throws std::invalid_argument if a bound follows an impulse that no row has
  void prepare(const Bodies& bodies, const Blocks& blocks, int first, real h) override;
  /// Zeroes the impulse of a row whose Jacobian is zero or that depends on others of its block.
  void warm_start(Bodies& bodies, real ratio) override;
  void solve(Bodies& bodies) override;
  std::string plan(const Bodies& bodies, const Blocks& blocks) const override;
  const PackedBlocks& packed() const { return packed_; }  ///< of the last step

 private:
  PackedBlocks packed_;
};

}  // namespace joints
/// @}
