// The direct solver: which blocks are in A, alternation with the others, and added inertia.
#include "chapters/09_direct/direct_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace joints {

// At most this many times a step is solved again because its forces have jumped.
static constexpr int looks = 4;

// Calls f(slot) for all bodies of a pair that can move.
template <class F>
static void for_moving(const IslandPair& pair, const F& f) {
  for (std::size_t k = 0; k < pair.bodies.size(); ++k)
    for (const int slot : pair.bodies[k])
      if (pair.moves[k] && slot >= 0) f(slot);
}

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

// ---- once per step ------------------------------------------------------------------------------

void DirectSolver::prepare(const Bodies& bodies, const Blocks& blocks, int first, real h) {
  prepared_for(bodies, blocks, first);
  blocks_ = &blocks;
  h_ = h;
  const bool late = first > 0;
  if (!late) {
    report_ = {};
    before_.clear();
    pulls_.assign(std::size_t(bodies.slots()), Pull{});
  }
  islands_.group(collect_blocks(bodies), bodies.slots(), most_work);
  leave_to_iterations();
  recall_corrections();
  report_.multiplications = report_.fill = 0;
  for (IslandPair& pair : islands_.pairs) {
    report_.multiplications += pair.multiplications();
    report_.fill += pair.fill();
    pair.active = !pair.iterated;
    if (pair.iterated) continue;
    const auto is_late = [&](const LaneBlock& block) {
      return block.block[0] >= first || block.block[1] >= first;
    };
    if (late && !pair.is_new && std::none_of(pair.blocks.begin(), pair.blocks.end(), is_late))
      continue;
    pair.softening = softening;
    pair.inverse = inverse;
    pair.prepare(blocks, newton > 0 ? blocks.memory.corrections.data() : nullptr, h);
    set_masses(pair, bodies);
    if (!late && added_inertia > 0) pair.find_tight_loops();
  }
  if (!late && added_inertia > 0) {
    blocks.memory.inertia.resize(pulls_.size());
    find_pulls(blocks.acted, pulls_);
    for (int slot = 0; slot < bodies.slots(); ++slot) slow_down(bodies, slot);
    for (IslandPair& pair : islands_.pairs) set_masses(pair, bodies);
  }
  prepare_outside(bodies);
  if (report_.iterated) instead.prepare(bodies, iterated_, 0, h);
}

// Returns true if the pattern of the blocks has changed.
bool DirectSolver::collect_blocks(const Bodies& bodies) {
  followed_.clear();
  for (const Block& block : blocks_->list)
    if (block.target.follows != 0) followed_.push_back(block.impulse + block.target.follows);
  std::sort(followed_.begin(), followed_.end());
  bool changed = islands_.given.size() != blocks_->list.size();
  islands_.given.resize(blocks_->list.size());
  BlockPattern* known = islands_.given.data();
  for (const Block& block : blocks_->list) {
    const bool bounded = block.target.lower > -unbounded || block.target.upper < unbounded;
    const BlockPattern now{
        {block.body1, block.body2},
        {!bodies.at(block.body1).is_static(), !bodies.at(block.body2).is_static()},
        is_outside(block) ? 0 : block.rows, bounded, block.form};
    changed = changed || now != *known;
    *known++ = now;
  }
  return changed;
}

// True for rows whose bound depends on another impulse, and for the rows of these impulses.
bool DirectSolver::is_outside(const Block& block) const {
  if (block.target.follows != 0) return true;
  const auto next = std::lower_bound(followed_.begin(), followed_.end(), block.impulse);
  return next != followed_.end() && *next < block.impulse + block.rows;
}

// Islands that take too much work are left to iterations, and with them all islands that blocks
// outside A connect to them, and those beside them on the other lane. Otherwise only blocks outside
// A are iterated.
void DirectSolver::leave_to_iterations() {
  left_.assign(pulls_.size(), false);
  const auto left = [&](int body) { return left_[islands_.root_of(body)]; };
  const auto root = [&](int island) {
    const BlockPattern& block = islands_.given[islands_.order()[islands_.islands()[island].first]];
    return islands_.root_of(block.moves[0] ? block.bodies.body1 : block.bodies.body2);
  };
  report_.iterated = false;
  for (int k = 0; k < int(islands_.islands().size()); ++k)
    if (const IslandPair* const pair = islands_.pair_of(k);
        !pair || pair->multiplications() > most_work * pair->rows())
      left_[root(k)] = report_.iterated = true;
  for (bool more = report_.iterated; std::exchange(more, false);) {
    const auto spread = [&](int one, int other) {
      if (left_[one] != left_[other]) left_[one] = left_[other] = more = true;
    };
    for (const auto& [of, moves, rows, bounded, form] : islands_.given)
      if (moves[0] && moves[1]) spread(islands_.root_of(of.body1), islands_.root_of(of.body2));
    for (const IslandPair& pair : islands_.pairs)
      if (pair.islands[1] >= 0) spread(root(pair.islands[0]), root(pair.islands[1]));
  }
  for (IslandPair& pair : islands_.pairs) pair.iterated = left_[root(pair.islands[0])];
  beside_.assign(pulls_.size(), false);
  for (Blocks* list : {&outside_, &iterated_}) {
    list->clear();
    list->J.clear();
    list->acting = blocks_->acting;
  }
  for (std::size_t k = 0; k < islands_.given.size(); ++k) {
    const auto& [of, moves, rows, bounded, form] = islands_.given[k];
    if (!report_.iterated && rows > 0) continue;
    const bool to_iterate = (moves[0] && left(of.body1)) || (moves[1] && left(of.body2));
    if (!to_iterate && rows > 0) continue;
    Blocks& to = to_iterate ? iterated_ : outside_;
    for (const auto& [id, can_move] : {std::pair{of.body1, moves[0]}, {of.body2, moves[1]}})
      if (can_move && !to_iterate) beside_[islands_.root_of(id)] = true;
    const Block& block = blocks_->list[k];
    to.list.push_back(block);
    to.list.back().first = int(to.C.size());
    to.J.insert(to.J.end(), &blocks_->J[block.first], &blocks_->J[block.first] + block.rows);
    to.C.insert(to.C.end(), &blocks_->C[block.first], &blocks_->C[block.first] + block.rows);
  }
  for (IslandPair& pair : islands_.pairs)
    pair.alternates = beside_[root(pair.islands[0])] ||
                      (pair.islands[1] >= 0 && beside_[root(pair.islands[1])]);
}

// The corrections of the last step are used in islands whose rows are the same.
void DirectSolver::recall_corrections() {
  SolverMemory& memory = blocks_->memory;
  patterns_.clear();
  for (const JointIslands::Island& island : islands_.islands())
    patterns_.insert(patterns_.end(), {island.pattern, island.rows});
  if (newton == 0) memory.patterns.clear(), memory.corrections.clear();
  if (newton == 0 || memory.patterns == patterns_) return;
  zeros(recalled_, std::size_t(islands_.rows()));
  std::size_t from = 0, next = 0;  // of the old ones
  for (const JointIslands::Island& island : islands_.islands())
    for (std::size_t n = 0; n < memory.patterns.size(); n += 2) {
      if (next == memory.patterns.size()) next = from = 0;
      const int* const old = &memory.patterns[next];
      const bool same = old[0] == island.pattern && old[1] == island.rows;
      if (same) std::copy_n(&memory.corrections[from], island.rows, &recalled_[island.first_row]);
      next += 2, from += std::size_t(old[1]);
      if (same) break;
    }
  memory.corrections.swap(recalled_);
  memory.patterns = patterns_;
}

// Rows outside A need the same masses as the rows in it. Otherwise alternating between the two
// would add energy.
void DirectSolver::prepare_outside(const Bodies& bodies) {
  if (outside_.list.empty()) return;
  slow_bodies_ = bodies;
  for (int slot = 0; slot < bodies.slots(); ++slot)
    if (pulls_[slot].force_lever > 0)
      slow_bodies_.at(slot).inverse_inertia_local = pulls_[slot].slowed.inverse_inertia_local;
  contacts_.iterations = 1;
  contacts_.prepare_as(slow_bodies_, bodies, outside_, h_);
}

void DirectSolver::warm_start(Bodies& bodies, real ratio) {
  blocks_of(bodies);  // rejects other bodies
  const bool again = !before_.empty();
  if (report_.iterated && !again) instead.warm_start(bodies, 0);
  warm_ = ratio > 0;
  if (added_inertia > 0 && !again) before_.assign(bodies.begin(), bodies.end());
  for (IslandPair& pair : islands_.pairs)
    if (added_inertia > 0 && pair.active)
      for_moving(pair, [&](int slot) {
        if (pulls_[slot].force_lever > 0) bodies.at(slot).w = pulls_[slot].slowed.w;
      });
  if (again ? alternating() : !outside_.list.empty()) contacts_.warm_start(bodies, ratio);
  for (IslandPair& pair : islands_.pairs) {
    if (!pair.active) continue;
    if (ratio != 0) pair.load(bodies);
    pair.start(double(ratio));
    if (ratio != 0) pair.store(bodies), pair.store_impulses(*blocks_);  // else solve() does both
  }
}

// ---- the solution -------------------------------------------------------------------------------

void DirectSolver::solve(Bodies& bodies) {
  blocks_of(bodies);  // rejects other bodies
  if (report_.iterated) instead.solve(bodies);
  for (IslandPair& pair : islands_.pairs) pair.active = !pair.iterated;
  solve_active(bodies, !outside_.list.empty());
  if (!before_.empty()) {
    for (int k = 0; k < looks && forces_jumped(bodies); ++k) look_again(bodies);
    for (int slot = 0; slot < bodies.slots(); ++slot)
      blocks_->memory.inertia[slot] = added_inertia * h_ * h_ * pulls_[slot].force_lever;
  }
  report_.passes = report_.wrong = 0;
  for (const IslandPair& pair : islands_.pairs) {
    report_.passes = std::max(report_.passes, pair.passes);
    report_.wrong += pair.wrong;
  }
}

bool DirectSolver::alternating() const {
  return std::any_of(islands_.pairs.begin(), islands_.pairs.end(),
                     [](const IslandPair& pair) { return pair.active && pair.alternates; });
}

// Islands on which no row outside A acts are solved once. \param outside with the rows outside A
void DirectSolver::solve_active(Bodies& bodies, bool outside) {
  for (int n = 0; n < (outside ? alternations : 1); ++n) {
    if (outside) contacts_.solve(bodies);
    for (IslandPair& pair : islands_.pairs) {
      if (!pair.active || (n > 0 && !pair.alternates)) continue;
      pair.load(bodies);
      pair.solve(passes, !pair.alternates);  // the next alternation refines
      pair.store(bodies);
      pair.store_impulses(*blocks_);
    }
  }
}

void DirectSolver::factor_now() {
  require(blocks_ != nullptr && !report_.iterated,
          "solver: there is no matrix: nothing was prepared, or for iterations");
  for (IslandPair& pair : islands_.pairs) pair.factor_now();
}

int DirectSolver::dependent() const {
  int count = 0;
  for (const IslandPair& pair : islands_.pairs)
    if (!pair.iterated && pair.passes > 0) count += pair.dependent();
  return count;
}

void DirectSolver::reach(Bodies& bodies, const Blocks& at, const std::vector<real>& wanted,
                         double enough) {
  const Blocks& blocks = blocks_of(bodies);
  bool factored = true;
  for (const IslandPair& pair : islands_.pairs) factored = factored && pair.factored;
  require(wanted.size() == blocks.C.size() && at.list.size() == blocks.list.size() && factored,
          "rates: there must be one for each row, and a factor");
  for (IslandPair& pair : islands_.pairs) {
    pair.load(bodies);
    pair.reach(at, wanted, enough);
    pair.store(bodies);
    pair.store_impulses(blocks);
  }
}

// Changes J V of the islands from, ..., end - 1. \param rates of their rows
void DirectSolver::change(Bodies& bodies, int from, int end, const std::vector<double>& rates) {
  for (int k = from; k < end; ++k) {
    IslandPair* const pair = islands_.pair_of(k);
    if (!pair || pair->iterated || (pair->islands[1] == k && pair->islands[0] >= from)) continue;
    const double* const given = rates.data() - islands_.islands()[from].first_row;
    bool any = false;
    for (const int lane : {0, 1}) {
      const bool used = pair->islands[lane] >= from && pair->islands[lane] < end;
      for (std::size_t n = 0; n < pair->blocks.size(); ++n) {
        const LaneBlock& block = pair->blocks[n];
        TwoLanes* const x = &pair->x[pair->row_of(block)];
        for (int i = 0; i < block.rows; ++i)
          any |= (x[i][lane] = used && i < block.own[lane] ? given[block.row[lane] + i] : 0) != 0;
      }
    }
    if (!any) continue;
    pair->load(bodies);
    pair->change();
    pair->store(bodies);
  }
}

// ---- added inertia ------------------------------------------------------------------------------

void DirectSolver::set_masses(IslandPair& pair, const Bodies& bodies, int only_lane) const {
  for (int column = 0; column < int(pair.bodies.size()); ++column)
    for (const int lane : {0, 1}) {
      const int slot = pair.bodies[column][lane];
      if (slot < 0 || !pair.moves[column] || lane == 1 - only_lane) continue;
      if (pulls_[slot].force_lever > 0) {
        Body slow = bodies.at(slot);
        slow.inverse_inertia_local = pulls_[slot].slowed.inverse_inertia_local;
        pair.set_mass(column, lane, slow);
      } else {
        pair.set_mass(column, lane, bodies.at(slot));
      }
    }
}

void DirectSolver::slow_down(const Bodies& bodies, int slot) {
  Pull& pull = pulls_[slot];
  if (bodies.at(slot).is_static()) pull.force_lever = 0;
  if (pull.force_lever > 0)
    pull.slowed = slowed(bodies.at(slot), pull.force_lever, blocks_->memory.inertia[slot],
                         added_inertia, h_);
}

// |F||r| of each body, from impulses that acted for the time `acted`. The length of a lever follows
// from the rows of its block: the squares of the three rows of a point add up to 2 |r|^2.
void DirectSolver::find_pulls(real acted, std::vector<Pull>& pulls) {
  if (acted == 0) return;  // there was no step yet
  for (const int k : islands_.order()) {
    const auto& [island, number, row] = islands_.at(k);
    const IslandPair* const pair = islands_.pair_of(island);
    if (!pair || pair->iterated || pair->is_tight(number, islands_.islands()[island].lane))
      continue;
    const Block& block = blocks_->list[k];
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
// after a blow and in the first step, which has no earlier forces. Then only the islands of such
// bodies are active and, if rows outside A act on one of them, all on which such rows act.
bool DirectSolver::forces_jumped(const Bodies& bodies) {
  next_pulls_.assign(pulls_.size(), Pull{});
  find_pulls(blocks_->acting, next_pulls_);
  const real follows = added_inertia * h_ * h_;
  const auto jumped = [&](int slot) {
    const vec3 moments = real(1) / bodies.at(slot).inverse_inertia_local;
    const real least = std::min({moments.x, moments.y, moments.z});
    return follows * next_pulls_[slot].force_lever >
           2 * std::max(follows * pulls_[slot].force_lever, least);
  };
  bool any = false;
  for (IslandPair& pair : islands_.pairs) {
    pair.active = false;
    if (pair.iterated) continue;
    for_moving(pair, [&](int slot) { pair.active = pair.active || jumped(slot); });
    any = any || pair.active;
  }
  if (alternating())
    for (IslandPair& pair : islands_.pairs)
      pair.active = pair.active || (pair.alternates && !pair.iterated);
  return any;
}

// Solves active islands again, with the inertia that their own forces require.
void DirectSolver::look_again(Bodies& bodies) {
  const auto go_back = [&](int slot) {
    bodies.at(slot).v = before_[slot].v, bodies.at(slot).w = before_[slot].w;
  };
  const bool outside = alternating();
  for (int slot = 0; slot < bodies.slots() && outside; ++slot)
    if (beside_[islands_.root_of(slot)]) go_back(slot);
  for (IslandPair& pair : islands_.pairs) {
    if (!pair.active) continue;
    for_moving(pair, [&](int slot) {
      go_back(slot);
      pulls_[slot] = next_pulls_[slot];
      slow_down(bodies, slot);
    });
    set_masses(pair, bodies);
    pair.factored = false;
  }
  if (outside) prepare_outside(bodies);
  warm_start(bodies, warm_ ? real(1) : real(0));
  solve_active(bodies, outside);
}

}  // namespace joints
