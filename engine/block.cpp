// Appends to and cuts the flat arrays of the blocks.
#include "engine/block.h"

namespace joints {

void Blocks::truncate(int count) {
  if (count == 0) after_move = nullptr;
  if (count >= int(list.size())) return;
  C.resize(std::size_t(list[count].first));
  list.resize(std::size_t(count));
}

void Blocks::shrink_to_fit() {
  list.shrink_to_fit();
  C.shrink_to_fit();
  J.shrink_to_fit();
}

bool Blocks::add(const Bodies& bodies, BodyId id1, BodyId id2, short rows, Form form,
                 const RowSettings& settings, real* impulse) {
  const int slot1 = bodies.index(id1), slot2 = bodies.index(id2);
  if (bodies.at(slot1).is_static() && bodies.at(slot2).is_static()) {
    std::fill_n(impulse, rows, real(0));
    return false;
  }
  const bool corrects =  // without branches
      settings.holds_position & (settings.follows == 0) & !(settings.frequency > 0);
  list.push_back({slot1, slot2, int(C.size()), rows, form, corrects, settings, impulse});
  for (int i = 0; i < rows; ++i) C.push_back(0);
  if (!errors_only && J.size() < C.size()) extend_J();
  return true;
}

[[gnu::noinline]] void Blocks::extend_J() {
  if (J.capacity() < C.size()) J.reserve(C.size() + C.size() / 4);  // the largest of all vectors
  J.resize(C.size());
}

std::pair<int, int> followed_row(const Blocks& blocks, int k) {
  const Block& block = blocks.list[std::size_t(k)];
  const int follows = block.settings.follows, row = block.first + follows;
  require(block.rows == 1, "follows: only a block of one row can follow another impulse");
  const int count = int(blocks.list.size()), direction = follows > 0 ? 1 : -1;
  for (int other = k + direction; other >= 0 && other < count; other += direction) {
    const Block& owner = blocks.list[std::size_t(other)];
    if (const int i = row - owner.first; i >= 0 && i < owner.rows)
      if (owner.impulse + i == block.impulse + follows) return {other, i};
  }
  refuse("follows: the impulse that bounds a row must have a row of its own");
}

}  // namespace joints
