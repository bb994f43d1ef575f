// What iterative solvers share: settings, preparation, the warm start.
#include "engine/solver.h"

#include <stdexcept>

namespace joints {

void IterativeSolver::check() const {
  require(iterations > 0, "iterations: there must be at least one");
  require(finite(relaxation) && relaxation > 0, "relaxation: must be positive and finite");
}

void IterativeSolver::prepare(const Bodies& bodies, const Blocks& blocks, int first, real h) {
  if (first == 0) prepared_.clear(int(blocks.J.capacity()));
  bodies_ = &bodies;
  blocks_ = &blocks;
  prepared_.relaxation = relaxation;
  prepared_.add(bodies, blocks, first, h, rows_apart());
}

void IterativeSolver::warm_start(Bodies& bodies, real ratio) {
  require_prepared(bodies);
  prepared_.start(bodies, *blocks_, ratio);
}

void IterativeSolver::require_prepared(const Bodies& bodies) const {
  if (bodies_ != &bodies)
    throw std::logic_error("solver: was prepared for the blocks of another world");
  if (prepared_.rows.size() != blocks_->J.size())
    throw std::logic_error("solver: blocks were added or removed after prepare()");
}

}  // namespace joints
