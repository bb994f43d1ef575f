// Rows one by one, for comparison with blocks (chapter 2).
#pragma once

#include "engine/block.h"

/// \addtogroup world
/// @{
namespace joints {

/// Replaces each block from number `first` on by blocks of one row, which share its J, C and
/// impulses. Only the last row of a block has a target rate and bounds.
inline void split_into_rows(Blocks& blocks, int first) {
  std::vector<Block>& list = blocks.list;
  int from = int(list.size()), to = first;
  for (int k = first; k < from; ++k) to += list[std::size_t(k)].rows;
  list.resize(std::size_t(to));
  while (from-- > first) {  // from the last on: no block is overwritten before it is read
    const Block block = list[std::size_t(from)];
    for (int i = block.rows - 1; i >= 0; --i) {
      Block& row = list[std::size_t(--to)] = block;
      if (i < block.rows - 1)
        row.settings.rate = 0, row.settings.lower = -unbounded, row.settings.upper = unbounded;
      row.rows = 1;
      row.form = Form::any;
      row.first += i;
      row.impulse += i;
    }
  }
}

}  // namespace joints
/// @}
