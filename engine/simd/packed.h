// The blocks of a step packed for the SIMD loop: eight (float) or four (double) blocks of one kind
// that share no moving body are solved side by side, one per lane.
#pragma once

#include "engine/solver.h"
#include "engine/simd/body_records.h"
#include "engine/simd/places.h"

/// \addtogroup world
/// @{
namespace joints {

/// How blocks are grouped and ordered.
enum class Packing {
  automatic,   ///< the first of these that uses at least half of the lanes: islands side by side,
               ///< one per lane (Places), colours, and if neither does, list
  colours,     ///< graph colouring, one colour after the other
  list,        ///< one block at a time, in the order of the list
  interleaved  ///< one block at a time: the first of every island, then the second of every one
};

/// The blocks of a step in groups that are solved side by side. The places of the bodies are kept
/// until islands are connected differently, and the groups until a block comes, goes or changes its
/// kind. Once its vectors have grown, a step does not allocate.
class PackedBlocks {
 public:
  /// Fills the records from the blocks of a step and prepares them for its iterations.
  /// \param first only blocks from this number on are new since the last call in this step: they
  /// become groups behind the others \param h step [s] \param relaxation of the solver [1]
  void pack(const Bodies& bodies, const Blocks& list, int first, real h, real relaxation,
            Packing packing);
  /// Copies the bodies' velocities into the records.
  void gather(const Bodies& bodies) { records_.gather(order_, bodies.data()); }
  /// Copies them back to the bodies that can move.
  void scatter(Bodies& bodies) { records_.scatter(order_, bodies.data()); }
  /// A pass over all groups, with the best instruction set of this processor.
  void run(Pass pass, real parameter = 0) { run(pass, parameter, 0); }
  /// Copies the accumulated impulses back into the joints. \param list as given to pack()
  void unpack(const Blocks& list) const;

  const LaneOrder& order() const { return order_; }  ///< the groups and their order
  const std::vector<LaneGroup>& groups() const { return groups_; }  ///< one per group of the order
  std::string description() const;  ///< the order in words, as "8 lanes, an island in each"
  int placings() const { return placings_; }    ///< how often the bodies got places
  int groupings() const { return groupings_; }  ///< how often blocks were put into groups

 private:
  bool sign(const Bodies& bodies, const Blocks& list, int first);
  bool place(const Bodies& bodies);
  void append(const Bodies& bodies, int first);
  void add_groups(const Blocks& list, int first);
  void run(Pass pass, real parameter, int first);
  // Calls f with the record of a kind, of one block or of lane_count.
  template <class F>
  void in_record(const BlockKind& kind, real* numbers, const F& f) const {
    if (order_.width == 1)
      use_record<real>(kind, numbers, f);
    else
      use_record<LaneNumber>(kind, numbers, f);
  }
  // Calls f(block, lane) for each block of a group.
  template <class F>
  void each_block(int group, const F& f) const {
    const int* const blocks = &order_.blocks[std::size_t(group * order_.width)];
    for (int lane = 0; lane < order_.width; ++lane)
      if (blocks[lane] >= 0) f(blocks[lane], lane);
  }
  real* numbers() { return reinterpret_cast<real*>(numbers_.data()); }
  const real* numbers() const { return reinterpret_cast<const real*>(numbers_.data()); }

  std::vector<Member> members_;  // of each block: the data on which the groups depend
  Places places_;
  GreedyColours colours_;
  std::vector<bool> moves_;  // of each body
  Packing wanted_ = Packing::automatic, chosen_ = Packing::automatic;
  bool fits_lanes_ = true;   // islands one per lane use at least half of the lanes
  bool late_ = false;        // the last groups were appended in the middle of a step
  int placings_ = 0, groupings_ = 0;

  LaneOrder order_;
  std::vector<LaneGroup> groups_;
  std::vector<LaneNumber> numbers_;  // the records of all groups; those of former steps follow
  std::size_t size_ = 0;             // numbers in use
  std::vector<int> first_lambda_;    // of each block: the index of its first accumulated impulse
  std::vector<int> followed_;        // LaneWork::followed
  BodyRecords records_;
};

/// Sequential Impulses over packed blocks: the same solve of each block, in another order. By
/// islands each island keeps the order of the list; by colours it does not. The joints' accumulated
/// impulses are written when solve() ends. It has neither relax iterations nor split impulses.
class PackedImpulses : public IterativeSolver {
 public:
  Packing packing = Packing::automatic;  ///< how blocks are grouped and ordered

  /// Once per step. \throws std::invalid_argument if a bound follows an impulse that no row has
  void prepare(const Bodies& bodies, const Blocks& blocks, int first, real h) override;
  /// Zeroes the impulse of a row whose Jacobian is zero or that depends on others of its block.
  void warm_start(Bodies& bodies, real ratio) override;
  void solve(Bodies& bodies) override;
  std::string description(const Bodies& bodies, const Blocks& blocks) const override;
  const PackedBlocks& packed() const { return packed_; }  ///< of the last step

 private:
  PackedBlocks packed_;
};

}  // namespace joints
/// @}
