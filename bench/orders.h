// Other orders in which the blocks can be solved. The library has none of them: what they are worth
// is measured here.
#pragma once

#include <optional>
#include <random>
#include <vector>

#include "engine/sequential_impulses.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// In which order the blocks are solved in an iteration.
enum class Order {
  forward,      ///< as the joints were added
  backward,     ///< the other way round
  alternating,  ///< forward in every even iteration, backward in every odd one
  shuffled      ///< drawn anew for every iteration from OrderedImpulses::seed
};

/// Sequential Impulses in an order of one's choice.
class OrderedImpulses : public SequentialImpulses {
 public:
  Order order = Order::forward;  ///< of the blocks in an iteration
  unsigned seed = 1;             ///< of the shuffled order

  void solve(Bodies& bodies) override;
  /// One iteration. \param number counts from 0; only the alternating order asks
  void iterate_in_order(Bodies& bodies, int number);

 private:
  void draw_order();
  std::vector<int> sequence_;
  std::mt19937 random_;
  std::optional<unsigned> seeded_with_;  // empty before the first draw
};

}  // namespace joints::bench
/// @}
