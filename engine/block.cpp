// The flat arrays of the blocks.
#include "engine/block.h"

namespace joints {

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
                    const real* rows_K, const Demand& demand, real* impulse) {
  bool linear = false, angular = false;
  for (int i = 0; i < rows; ++i) {
    linear = linear || rows_J[i].v1 != vec3(0) || rows_J[i].v2 != vec3(0);
    angular = angular || rows_J[i].w1 != vec3(0) || rows_J[i].w2 != vec3(0);
  }
  const Touches touches = !angular ? Touches::linear : linear ? Touches::both : Touches::angular;
  list.push_back({slot1, slot2, rows, int(J.size()), int(K.size()), touches, demand, impulse});
  J.insert(J.end(), rows_J, rows_J + rows);
  C.insert(C.end(), rows_C, rows_C + rows);
  K.insert(K.end(), rows_K, rows_K + rows * rows);
  for (int i = 0; i < rows; ++i) {  // a row without a direction: nothing answers to it
    const Row& row = rows_J[i];
    if (row.v1 != vec3(0) || row.w1 != vec3(0) || row.v2 != vec3(0) || row.w2 != vec3(0)) continue;
    real* K_block = &K[list.back().first_K];
    for (int j = 0; j < rows; ++j) K_block[i * rows + j] = K_block[j * rows + i] = 0;
  }
}

}  // namespace joints
