// The direct solver once per step: prepares bodies and blocks, and decides which blocks are in A.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "chapters/09_direct/direct_solver.h"

namespace joints {

void DirectSolver::check() const {
  require(newton >= 0, "newton: must not be negative");
  require(tolerance > 0, "tolerance: must be positive");
  require(finite(added_inertia) && added_inertia >= 0,
          "added_inertia: must be finite and not negative");
  require(softening >= 0 && softening < 1, "softening: must be at least 0 and below 1");
  require(alternations > 0, "alternations: there must be at least one");
  require(passes > 0, "passes: there must be at least one");
  require(most_work >= 0, "most_work: must not be negative");
  instead.check();
}

void DirectSolver::prepare(const Bodies& bodies, const Blocks& blocks, int first, real h) {
  prepared_for(bodies, blocks, first);
  blocks_ = &blocks;
  rows_of_J_ = blocks.J.data();
  h_ = h;
  if (first == 0) {
    report_ = {};
    before_.clear();
  }
  collect_blocks(bodies, h);
  factored_ = false;
  const bool iterated = report_.iterated;  // before late limits came
  report_.iterated = iterated || is_hub();
  if (!report_.iterated) {
    know_again(blocks.memory);
    if (maker_.follow(pattern_)) {
      J_.assign(std::size_t(2 * maker_.rows()), HalfRowOf<TwoLanes>{});
      on_lanes_.assign(std::size_t(maker_.rows()), TwoLanes{});
    }
    report_.multiplications = maker_.multiplications();
    report_.fill = maker_.fill();
    report_.iterated = report_.multiplications > most_work * double(blocks.C.size());
  }
  if (report_.iterated) return instead.prepare(bodies, blocks, iterated ? first : 0, h);
  if (first == 0) {
    pulls_.assign(std::size_t(bodies.slots()), Pull{});
    collect_masses(bodies);
    if (added_inertia > 0) {
      find_tight_loops();
      find_pulls(blocks.acted, pulls_);
      collect_masses(bodies);
    }
  }
  place_rows();
  prepare_outside(bodies, h);
}

// The rates corrected in the last step can be used only if the rows are the same.
void DirectSolver::know_again(SolverMemory& memory) const {
  std::uint32_t sum = 2166136261u;
  for (const BlockPattern& block : pattern_)
    for (const int number : {block.rows, block.body1, block.body2, int(block.bounded)})
      sum = (sum ^ std::uint32_t(number)) * 16777619u;
  const int pattern = int(sum >> 1);
  if (newton == 0 || memory.pattern != pattern || memory.rates.size() != blocks_->C.size())
    memory.rates.assign(blocks_->C.size(), 0);
  memory.pattern = pattern;
}

// Rows outside A need the same masses as the rows in it. Otherwise alternating between the two
// would add energy.
void DirectSolver::prepare_outside(const Bodies& bodies, real h) {
  contacts_.iterations = 1;
  if (outside_.list.empty() || added_inertia == 0) return contacts_.prepare(bodies, outside_, 0, h);
  slow_bodies_ = bodies;
  for (int slot = 0; slot < bodies.slots(); ++slot)
    if (pulls_[slot].force_lever > 0)
      slow_bodies_.at(slot).inverse_inertia_local = pulls_[slot].slowed.inverse_inertia_local;
  contacts_.prepare_as(slow_bodies_, bodies, outside_, h);
}

// True if the blocks of a single body, which are all neighbours of each other, already make the
// factor too expensive. Then no order of elimination is computed.
bool DirectSolver::is_hub() const {
  double most = 0;  // rows
  for (const int rows : rows_) most = std::max(most, double(rows));
  return most * most * most / 6 > most_work * double(bias_.size());
}

void DirectSolver::warm_start(Bodies& bodies, real ratio) {
  blocks_of(bodies);  // rejects other bodies
  if (report_.iterated) return instead.warm_start(bodies, 0);
  warm_ = ratio > 0;
  if (added_inertia > 0) before_.assign(bodies.data(), bodies.data() + bodies.slots());
  for (int slot = 0; slot < bodies.slots(); ++slot)
    if (pulls_[slot].force_lever > 0) bodies.at(slot).w = pulls_[slot].slowed.w;
  contacts_.warm_start(bodies, ratio);
  for (const Inside& one : inside_) {
    const Block& block = *one.block;
    double start[6];
    for (int i = 0; i < block.rows; ++i) start[i] = double(ratio) * double(block.impulse[i]);
    std::fill_n(block.impulse, block.rows, real(0));
    if (ratio != 0) change_impulses(bodies, block, start);
  }
}

// ---- bodies -------------------------------------------------------------------------------------

void DirectSolver::collect_masses(const Bodies& bodies) {
  masses_.assign(std::size_t(bodies.slots()), BodyMass{});
  std::vector<real>& then = blocks_->memory.inertia;
  then.resize(masses_.size());
  for (int slot = 0; slot < bodies.slots(); ++slot) {
    if (bodies.at(slot).is_static()) {
      pulls_[slot].force_lever = 0;
      continue;
    }
    Body body = bodies.at(slot);
    Pull& pull = pulls_[slot];
    if (pull.force_lever > 0) {
      pull.slowed = slowed(body, pull.force_lever, then[slot], added_inertia, h_);
      body.inverse_inertia_local = pull.slowed.inverse_inertia_local;
    }
    const mat3 I = inverse_inertia(body);
    masses_[slot].linear = body.inverse_mass;
    masses_[slot].angular = {I[0][0], I[1][1], I[2][2], I[1][0], I[2][0], I[2][1]};
  }
}

// Finds the loops with at most one degree of freedom: their links cannot zigzag. Only if the number
// of rows does not decide this, a factor of A is computed to find the dependent rows.
void DirectSolver::find_tight_loops() {
  const std::vector<ClosedLoop>& loops = maker_.loops();
  tight_.assign(loops.size(), false);
  dependent_.assign(loops.size(), 0);
  const auto may_be = [&](std::size_t k) { return loops[k].motions(dependent_[k]) <= 1; };
  bool unclear = false;
  for (std::size_t k = 0; k < loops.size(); ++k) unclear = unclear || may_be(k);
  if (!unclear) return;
  for (int k = 0; k < int(inside_.size()); ++k)
    for (int i = 0; i < inside_[k].block->rows; ++i) place_row(k, i, true);
  for (const BoundedRow& row : bounded_)
    place_row(row.inside, inside_[row.inside].block->rows - 1, false);
  maker_.assemble(J_, masses_);
  note_diagonal();
  factor(maker_.A, inverse_pivot);
  for (int k = 0; k < int(pattern_.size()); ++k)
    if (const int loop = maker_.loop(k); loop >= 0)
      dependent_[loop] += rows_below(0, k) - pattern_[k].bounded;
  for (std::size_t k = 0; k < loops.size(); ++k) tight_[k] = may_be(k);
}

// |F||r| of each body, from impulses that acted for the time `acted`. The length of a lever follows
// from the rows of its block: the squares of the three rows of a point add up to 2 |r|^2.
void DirectSolver::find_pulls(real acted, std::vector<Pull>& pulls) const {
  if (acted == 0) return;  // there was no step yet
  for (int k = 0; k < int(inside_.size()); ++k) {
    if (maker_.loop(k) >= 0 && tight_[maker_.loop(k)]) continue;
    const Block& block = *inside_[k].block;
    vec3 F(0);
    real square1 = 0, square2 = 0;
    for (int i = 0; i < block.rows; ++i) {
      const Row& J = blocks_->J[block.first + i];
      if (J.v2 == vec3(0)) continue;
      F += block.impulse[i] / acted * J.v2;
      square1 += dot(J.w1, J.w1) / 2;
      square2 += dot(J.w2, J.w2) / 2;
    }
    const real force = length(F);
    for (const auto& [slot, square] : {std::pair{block.body1, square1}, {block.body2, square2}})
      pulls[slot].force_lever += force * std::sqrt(square);
  }
}

// True if the new impulses require more than twice the present inertia of a body. This happens
// after a blow and in the first step, which has no earlier forces.
bool DirectSolver::forces_jumped(const Bodies& bodies) {
  next_pulls_.assign(pulls_.size(), Pull{});
  find_pulls(blocks_->acting, next_pulls_);
  for (int slot = 0; slot < bodies.slots(); ++slot) {
    if (bodies.at(slot).is_static()) continue;
    const vec3 moments = real(1) / bodies.at(slot).inverse_inertia_local;
    const real least = std::min({moments.x, moments.y, moments.z});
    const real follows = added_inertia * h_ * h_;
    if (follows * next_pulls_[slot].force_lever >
        2 * std::max(follows * pulls_[slot].force_lever, least))
      return true;
  }
  return false;
}

// ---- blocks -------------------------------------------------------------------------------------

void DirectSolver::collect_blocks(const Bodies& bodies, real h) {
  const std::size_t rows = blocks_->C.size();
  bias_.resize(rows);
  x_.resize(rows);
  rows_.assign(std::size_t(bodies.slots()), 0);
  inside_.clear();
  pattern_.clear();
  bounded_.clear();
  outside_.clear();
  outside_.J.clear();
  outside_.acting = blocks_->acting;
  followed_.clear();
  for (const Block& block : blocks_->list)
    if (block.target.follows != 0) followed_.push_back(block.impulse + block.target.follows);
  std::sort(followed_.begin(), followed_.end());
  for (const Block& block : blocks_->list) collect_block(bodies, block, h);
}

void DirectSolver::collect_block(const Bodies& bodies, const Block& block, real h) {
  if (is_outside(block)) {
    outside_.list.push_back(block);
    outside_.list.back().first = int(outside_.C.size());
    for (int r = block.first; r < block.first + block.rows; ++r) {
      outside_.J.push_back(blocks_->J[r]);
      outside_.C.push_back(blocks_->C[r]);
    }
    return;
  }
  const auto [rate, softness] = feedback(block.target, h, blocks_->acts(h));
  const auto moving = [&](int slot) { return bodies.at(slot).is_static() ? -1 : slot; };
  inside_.push_back({&block, double(softness)});
  const bool bounded = block.target.lower > -unbounded || block.target.upper < unbounded;
  pattern_.push_back(
      {block.rows, block.first, moving(block.body1), moving(block.body2), bounded});
  for (const int body : {pattern_.back().body1, pattern_.back().body2})
    if (body >= 0) rows_[body] += block.rows;
  for (int i = 0; i < block.rows; ++i)
    bias_[block.first + i] = bias(block, i, blocks_->C[block.first + i], rate, h);
  if (bounded) {
    const real acting = blocks_->acts(h);
    BoundedRow row{int(inside_.size()) - 1, double(acting * block.target.lower),
                   double(acting * block.target.upper)};
    const double impulse = double(block.impulse[block.rows - 1]);  // of the last step
    row.side = impulse <= row.lower ? Side::lower : impulse >= row.upper ? Side::upper : Side::free;
    bounded_.push_back(row);
  }
}

// True for rows whose bound depends on another impulse, and for the rows of these impulses.
bool DirectSolver::is_outside(const Block& block) const {
  if (block.target.follows != 0) return true;
  const auto next = std::lower_bound(followed_.begin(), followed_.end(), block.impulse);
  return next != followed_.end() && *next < block.impulse + block.rows;
}

// Places all rows in the matrix; rows at their bounds become zero.
void DirectSolver::place_rows() {
  for (int k = 0; k < int(inside_.size()); ++k)
    for (int i = 0; i < inside_[k].block->rows; ++i) place_row(k, i, true);
  for (const BoundedRow& row : bounded_)
    if (row.side != Side::free) place_row(row.inside, inside_[row.inside].block->rows - 1, false);
}

// Places row i of a block in the matrix, or zeros if it is not live.
void DirectSolver::place_row(int inside, int i, bool live) {
  const Block& block = *inside_[inside].block;
  const Row J = live ? rows_of_J_[block.first + i] : Row{};
  HalfRowOf<TwoLanes>* const place = &J_[2 * maker_.row(inside) + i];
  const auto put = [lane = maker_.lane(inside)](Triple<TwoLanes>& to, const vec3& a) {
    to.x[lane] = double(a.x), to.y[lane] = double(a.y), to.z[lane] = double(a.z);
  };
  put(place[0].v, J.v1), put(place[0].w, J.w1);
  put(place[block.rows].v, J.v2), put(place[block.rows].w, J.w2);
}

}  // namespace joints
