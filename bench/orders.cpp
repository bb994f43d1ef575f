// Orders of the blocks.
#include "bench/orders.h"

namespace joints::bench {

void OrderedImpulses::solve(Bodies& bodies) {
  for (int i = 0; i < iterations; ++i) iterate_in_order(bodies, i);
}

void OrderedImpulses::iterate_in_order(Bodies& bodies, int number) {
  const int n = prepared_count();
  if (order == Order::forward || (order == Order::alternating && number % 2 == 0))
    return iterate(bodies);
  if (order == Order::shuffled) {
    draw_order();
    for (const int k : sequence_) iterate(bodies, k, k + 1);
  } else {
    for (int k = n - 1; k >= 0; --k) iterate(bodies, k, k + 1);
  }
}

// Fisher and Yates, written out because std::shuffle differs from library to library.
void OrderedImpulses::draw_order() {
  if (seeded_with_ != seed) random_.seed(seed);
  seeded_with_ = seed;
  const int n = prepared_count();
  sequence_.reserve(prepared_.blocks.capacity());
  sequence_.resize(std::size_t(n));
  for (int k = 0; k < n; ++k) sequence_[k] = k;
  for (int k = n - 1; k > 0; --k) std::swap(sequence_[k], sequence_[random_() % (k + 1)]);
}

}  // namespace joints::bench
