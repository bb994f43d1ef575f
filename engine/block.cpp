// The flat arrays of the blocks.
#include "engine/block.h"

namespace joints {

static bool is_zero(const vec3& a) { return a.x == 0 && a.y == 0 && a.z == 0; }

void Blocks::clear() {
  list.clear();
  J.clear();
  C.clear();
  K.clear();
}

void Blocks::reserve(int rows) {
  list.reserve(rows);
  J.reserve(rows);
  C.reserve(rows);
  K.reserve(6 * rows);  // most numbers of K a row: in a block of six
}

void Blocks::append(int slot1, int slot2, int rows, const Row* rows_J, const real* rows_C,
                    const real* rows_K, const RowTarget& target, real* impulse) {
  const int first = int(J.size()), first_K = int(K.size());
  J.insert(J.end(), rows_J, rows_J + rows);
  C.insert(C.end(), rows_C, rows_C + rows);
  K.insert(K.end(), rows_K, rows_K + rows * rows);
  bool linear = false, angular = false;
  for (int i = 0; i < rows; ++i) {
    const Row& row = rows_J[i];
    const bool row_linear = !is_zero(row.v1) || !is_zero(row.v2);
    const bool row_angular = !is_zero(row.w1) || !is_zero(row.w2);
    linear = linear || row_linear;
    angular = angular || row_angular;
    if (row_linear || row_angular) continue;
    real* K_block = &K[first_K];  // a row without a direction: nothing answers to it
    for (int j = 0; j < rows; ++j) K_block[i * rows + j] = K_block[j * rows + i] = 0;
  }
  const Touches touches = !angular ? Touches::linear : linear ? Touches::both : Touches::angular;
  list.push_back({slot1, slot2, rows, first, first_K, touches, target, impulse});
}

}  // namespace joints
