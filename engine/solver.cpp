// Common code of the solvers: the blocks for which they were prepared, and settings.
#include "engine/solver.h"

#include <stdexcept>

namespace joints {

void Solver::prepared_for(const Bodies& bodies, const Blocks& blocks, int first_block) {
  const std::size_t k = std::size_t(first_block), rows = blocks.C.size();
  const std::size_t known = k < blocks.list.size() ? std::size_t(blocks.list[k].first) : rows;
  bodies_ = &bodies;
  slots_ = bodies.slots();
  blocks_ = &blocks;
  if (first_block == 0 || rows_ == known) rows_ = rows;  // else blocks_of() will throw
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

void IterativeSolver::check() const {
  require(iterations > 0, "iterations: there must be at least one");
  require(relaxation > 0 && relaxation < 2, "relaxation", relaxation,
          "must be above 0 and below 2 [1]");
}

}  // namespace joints
