// Other orders in which the blocks can be solved. The library has none of them: their benefit is
// measured here.
#pragma once

#include <optional>
#include <random>
#include <vector>

#include "engine/steps/two_pass_impulses.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// The order in which an iteration solves the blocks.
enum class Order {
  forward,      ///< as the joints were added
  backward,     ///< the reverse order
  alternating,  ///< forward in every even iteration, backward in every odd one
  shuffled      ///< a new random order for every iteration, from OrderedImpulses::seed
};

/// Sequential Impulses in a chosen order.
class OrderedImpulses : public TwoPassImpulses {
 public:
  Order order = Order::forward;  ///< of the blocks in an iteration
  unsigned seed = 1;             ///< of the shuffled order

  void solve(Bodies& bodies) override;
  /// One iteration. \param number of the iteration, from 0; used by the alternating order only
  void iterate_in_order(Bodies& bodies, int number);

 private:
  void draw_order();
  std::vector<int> sequence_;
  std::mt19937 random_;
  std::optional<unsigned> seeded_with_;  // empty before the first draw
};

}  // namespace joints::bench
/// @}
