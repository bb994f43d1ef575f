// Sequential Impulses (Catto 2006; Algorithm 1 of the thesis): the engine's own solver.
#pragma once

#include <optional>
#include <random>

#include "engine/preparation.h"
#include "engine/projection.h"

/// \addtogroup world
/// @{
namespace joints {

/// In which order the blocks are solved in an iteration.
enum class Order {
  forward,      ///< as the joints were added
  backward,     ///< the other way round
  alternating,  ///< forward in every even iteration, backward in every odd one
  shuffled      ///< drawn anew for every iteration from Settings::seed
};

/// Sequential Impulses: forces, then iterations over all blocks, each solved exactly while the
/// others wait, then the new velocities move the bodies. One object serves one world.
/// Source: Catto, "Fast and Simple Physics using Sequential Impulses", GDC 2006.
class SequentialImpulses {
 public:
  int iterations = 30;         ///< iterations a step
  bool warm_start = false;     ///< begin with the impulses of the last step
  int projections = 0;         ///< iterations of position projection after a step (chapter 6)
  real relaxation = 1;         ///< over-relaxation: a factor of every impulse [1], below 2
  Order order = Order::forward;  ///< of the blocks in an iteration
  unsigned seed = 1;           ///< of the shuffled order
  bool row_by_row = false;     ///< solve every row as a block of its own (chapter 2)

  /// Moves the world on by one step. Allocates only when the world has grown since the last step.
  /// \param h step [s] \throws std::invalid_argument unless h, iterations and relaxation are
  /// positive and the projections not negative
  void step(World& world, real h);

  // The pieces of a step, for those who measure between the iterations (chapter 2, tests).

  /// Forces, begin_step, the blocks, their preparation and the warm start.
  void begin(World& world, real h);
  /// One iteration over all blocks. \param number counts from 0; only the alternating order asks
  void iterate(Bodies& bodies, int number);
  /// The blocks from number `from` up to `to`, in the order of the list: for those who solve some
  /// of them before others (chapter 8).
  void iterate(Bodies& bodies, int from, int to);
  /// The poses from the velocities, and the projection if it is on.
  void finish(World& world, real h);
  /// The blocks of the present step.
  const Blocks& blocks() const { return blocks_; }

 private:
  void draw_order(int number);
  void solve(Body* bodies, const PreparedBlock& block);
  template <int N>
  void solve_rows(Body* bodies, const PreparedBlock& block);
  template <int N, bool linear, bool angular>
  void solve_block(Body* bodies, const PreparedBlock& block);

  Blocks blocks_;
  Projection projection_;
  Preparation prepared_;
  std::vector<int> sequence_;
  std::mt19937 random_;
  std::optional<unsigned> seeded_with_;  // empty before the first draw
  real last_h_ = 0;
};

}  // namespace joints
/// @}
