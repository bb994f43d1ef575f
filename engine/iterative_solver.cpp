// Common code of all solvers: the blocks for which they were prepared. Of the iterative ones also
// the settings and the bounds that follow an impulse.
#include "engine/iterative_solver.h"

#include <stdexcept>

namespace joints {

RowOfBlock followed_row(const Blocks& blocks, int k) {
  const Block& block = blocks.list[std::size_t(k)];
  const int follows = block.target.follows, row = block.first + follows;
  require(block.rows == 1, "follows: only a block of one row can follow another impulse");
  const int count = int(blocks.list.size()), direction = follows > 0 ? 1 : -1;
  for (int other = k + direction; other >= 0 && other < count; other += direction) {
    const Block& owner = blocks.list[std::size_t(other)];
    if (const int i = row - owner.first; i >= 0 && i < owner.rows)
      if (owner.impulse + i == block.impulse + follows) return {other, i};
  }
  refuse("follows: the impulse that bounds a row must have a row of its own");
}

void IterativeSolver::check() const {
  require(iterations > 0, "iterations: there must be at least one");
  require(relaxation > 0 && relaxation < 2, "relaxation", relaxation,
          "must be above 0 and below 2 [1]");
}

void Solver::prepared_for(const Bodies& bodies, const Blocks& blocks, int first) {
  const std::size_t k = std::size_t(first), rows = blocks.C.size();
  const std::size_t known = k < blocks.list.size() ? std::size_t(blocks.list[k].first) : rows;
  bodies_ = &bodies;
  slots_ = bodies.slots();
  blocks_ = &blocks;
  if (first == 0 || rows_ == known) rows_ = rows;  // else some were left out
}

const Blocks& Solver::blocks_of(const Bodies& bodies) const {
  if (bodies_ != &bodies)
    throw std::logic_error("solver: was prepared for the blocks of another world");
  if (rows_ != blocks_->C.size())
    throw std::logic_error("solver: blocks have come or gone since they were prepared");
  if (slots_ != bodies.slots())
    throw std::logic_error("solver: bodies have come since the blocks were prepared");
  return *blocks_;
}

}  // namespace joints
