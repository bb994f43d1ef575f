// Appends to and cuts the flat arrays of the blocks.
#include "engine/block.h"

#include <algorithm>
#include <numbers>

namespace joints {

Feedback feedback(const RowTarget& target, real h) {
  if (target.frequency == 0) return {target.beta / h, 0};
  const real omega = 2 * std::numbers::pi_v<real> * target.frequency;
  const real a1 = 2 * target.damping + h * omega;
  return {omega / a1, 1 / (h * omega * a1)};
}

real bias(const Block& block, int i, real C, real rate, real h) {
  if (i < block.rows - 1) return rate * C;
  // speculative: the gap may be closed, no more
  return (block.target.one_sided() && C > 0 ? C / h : rate * C) - block.target.rate;
}

void Blocks::truncate(int count) {
  if (count >= int(list.size())) return;
  const std::size_t rows = std::size_t(list[count].first);
  list.resize(std::size_t(count));
  if (!errors_only) J.resize(rows);
  C.resize(rows);
}

void Blocks::reserve(int rows) {
  list.reserve(rows);
  J.reserve(rows);
  C.reserve(rows);
}

void Blocks::append_errors(int slot1, int slot2, int rows, const real* rows_C,
                           const RowTarget& target, real* impulse) {
  list.push_back({slot1, slot2, rows, int(C.size()), Touches::both, target, impulse});
  C.insert(C.end(), rows_C, rows_C + rows);
}

void Blocks::append(const Bodies& bodies, int slot1, int slot2, int rows, const Row* rows_J,
                    const real* rows_C, const RowTarget& target, real* impulse) {
  if (errors_only) return append_errors(slot1, slot2, rows, rows_C, target, impulse);
  if (bodies.at(slot1).is_static() && bodies.at(slot2).is_static()) {
    std::fill_n(impulse, rows, real(0));
    return;
  }
  const int first = int(C.size());
  J.insert(J.end(), rows_J, rows_J + rows);
  C.insert(C.end(), rows_C, rows_C + rows);
  bool linear = false, angular = false;
  for (int i = 0; i < rows; ++i) {
    linear = linear || rows_J[i].v1 != vec3(0) || rows_J[i].v2 != vec3(0);
    angular = angular || rows_J[i].w1 != vec3(0) || rows_J[i].w2 != vec3(0);
  }
  const Touches touches = !angular ? Touches::linear : linear ? Touches::both : Touches::angular;
  list.push_back({slot1, slot2, rows, first, touches, target, impulse});
}

}  // namespace joints
