// The direct solver: which blocks are in A, alternation with the others, and added inertia.
#include "direct/direct_solver.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace joints {

// At most this many times a step is solved again because its forces have jumped.
static constexpr int most_again = 4;

// Largest number of corrections in reach().
static constexpr int rounds = 12;
// Largest number of passes of the active set in one solve.
static constexpr int most_passes = 200;
// A joint that is open by more than this at the beginning of a step is told [m or rad].
static constexpr double wide_open = 0.1;
// A change of an island's kinetic energy by more than this fraction, to close its joints, is told.
static constexpr double much_changed = 0.1;
// A rotation of a body by more than this in a step is told [rad].
static constexpr double far_turned = 2.5;

DirectSolver DirectSolver::velocities_only() {
  DirectSolver solver;
  solver.newton = 0;
  solver.added_inertia = 0;
  return solver;
}

void DirectSolver::check() const {
  require(newton >= 0, "newton", real(newton), "must not be negative");
  require(tolerance > 0, "tolerance", real(tolerance), "must be positive [m/s^2]");
  require(finite(added_inertia) && added_inertia >= 0, "added_inertia", added_inertia,
          "must be finite and not negative");
  require(softening >= 0 && softening < 1, "softening", real(softening),
          "must be at least 0 and below 1");
  require(alternations > 0, "alternations", real(alternations), "must be positive");
  require(most_work >= 0, "most_work", real(most_work), "must not be negative");
  require(inverse != nullptr, "inverse: must be a function, such as inverse_pivot");
  fallback.check();
}

std::vector<std::string> DirectSolver::Report::sentences() const {
  std::vector<std::string> out;
  const auto tell = [&out](const char* begin, double value, const char* end) {
    std::ostringstream words;
    words << begin << value << end;
    out.push_back(words.str());
  };
  if (corrections > 0 && !moved_exactly && !iterated)
    out.push_back("Joints are open at the new poses: their rows contradict each other, or a body "
                  "turns too far in a step. Take a shorter step.");
  else if (halved > 0)
    out.push_back("A body turned too far in the step, and its island was slowed down. Take a "
                  "shorter step.");
  else if (changed > much_changed)
    out.push_back("Joints could be closed only by a change of the kinetic energy: a mechanism "
                  "passes a pose too fast for the step. Take a shorter step.");
  if (iterated)
    out.push_back("A body has so many joints that its island was iterated. Raise most_work to "
                  "solve it directly.");
  if (wrong > 0)
    out.push_back("A limit, motor or contact is on the wrong side of its bounds. Take a shorter "
                  "step.");
  if (turned > far_turned)
    tell("A body turned by ", turned,
         " rad in the step: its joints hold, but its energy may change. Take a shorter step.");
  if (opened > wide_open)
    tell("A joint was open by ", opened,
         " (m or rad) when the step began, and was closed within it. Place bodies where their "
         "joints are closed, or lead them with move_to.");
  return out;
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
    memory_.read(blocks.memory, bodies.slots());
    inertia_.begin(bodies.slots(), added_inertia, h);
  }
  islands_.group(collect_blocks(bodies), bodies.slots(), most_work);
  split_blocks();
  recall_corrections();
  report_.multiplications = report_.fill = 0;
  for (Island& island : islands_.list) {
    JointSystem& system = island.system;
    island.active = !island.left;
    if (island.left) continue;
    report_.multiplications += system.multiplications();
    report_.fill += system.fill();
    if (late && !island.is_new &&
        std::none_of(system.blocks.begin(), system.blocks.end(),
                     [&](const SystemBlock& block) { return block.block >= first; }))
      continue;
    system.softening = softening;
    system.inverse = inverse;
    system.prepare(blocks, newton > 0 ? memory_.expected.data() : nullptr, h);
    inertia_.set_masses(island, bodies);
    if (!late && inertia_.used()) inertia_.find_tight_loops(island);
  }
  if (!late && inertia_.used()) {
    inertia_.add(bodies, blocks, islands_, memory_);
    for (Island& island : islands_.list) inertia_.set_masses(island, bodies);
  }
  prepare_outside(bodies);
  if (report_.iterated) fallback.prepare(bodies, left_, 0, h);
}

// Returns true if the pattern of the blocks has changed.
bool DirectSolver::collect_blocks(const Bodies& bodies) {
  followed_.clear();
  for (const Block& block : blocks_->list)
    if (block.settings.follows != 0) followed_.push_back(block.impulse + block.settings.follows);
  std::sort(followed_.begin(), followed_.end());
  bool changed = islands_.given.size() != blocks_->list.size();
  if (islands_.given.capacity() < blocks_->list.size())
    islands_.given.reserve(2 * blocks_->list.size());  // late limits are blocks of their own
  islands_.given.resize(blocks_->list.size());
  BlockPattern* known = islands_.given.data();
  for (const Block& block : blocks_->list) {
    const bool bounded = block.settings.lower > -unbounded || block.settings.upper < unbounded;
    const BlockPattern now{
        {block.body1, block.body2},
        {!bodies.at(block.body1).is_static(), !bodies.at(block.body2).is_static()},
        is_outside(block) ? 0 : block.rows, bounded};
    changed = changed || now != *known;
    *known++ = now;
  }
  return changed;
}

// True for rows whose bound depends on another impulse, and for the rows of these impulses.
bool DirectSolver::is_outside(const Block& block) const {
  if (block.settings.follows != 0) return true;
  const auto next = std::lower_bound(followed_.begin(), followed_.end(), block.impulse);
  return next != followed_.end() && *next < block.impulse + block.rows;
}

// Copies the blocks that are not in A: those of islands that are left, and others.
void DirectSolver::split_blocks() {
  for (Blocks* list : {&outside_, &left_}) {
    list->clear();
    list->J.clear();
    list->impulse_duration = blocks_->impulse_duration;
  }
  for (int k = 0; k < int(islands_.given.size()); ++k) {
    if (islands_.in_matrix(k)) continue;
    Blocks& to = islands_.is_left(k) ? left_ : outside_;
    const Block& block = blocks_->list[k];
    to.list.push_back(block);
    to.list.back().first = int(to.C.size());
    to.J.insert(to.J.end(), &blocks_->J[block.first], &blocks_->J[block.first] + block.rows);
    to.C.insert(to.C.end(), &blocks_->C[block.first], &blocks_->C[block.first] + block.rows);
  }
  report_.iterated = !left_.list.empty();
}

// The corrections of the last step are used in islands whose rows are the same.
void DirectSolver::recall_corrections() {
  SolverMemory& now = recalled_;
  now.patterns.clear();
  for (const Island& island : islands_.list)
    now.patterns.insert(now.patterns.end(), {island.pattern, island.rows});
  if (newton == 0) memory_.patterns.clear(), memory_.last.clear(), memory_.expected.clear();
  if (newton == 0 || memory_.patterns == now.patterns) return;
  zeros(now.last, std::size_t(islands_.rows()));
  zeros(now.expected, std::size_t(islands_.rows()));
  std::size_t from = 0, next = 0;  // of the old ones
  for (const Island& island : islands_.list)
    for (std::size_t n = 0; n < memory_.patterns.size(); n += 2) {
      if (next == memory_.patterns.size()) next = from = 0;
      const int* const old = &memory_.patterns[next];
      const bool same = old[0] == island.pattern && old[1] == island.rows;
      if (same) {
        std::copy_n(&memory_.last[from], island.rows, &now.last[island.first_row]);
        std::copy_n(&memory_.expected[from], island.rows, &now.expected[island.first_row]);
      }
      next += 2, from += std::size_t(old[1]);
      if (same) break;
    }
  memory_.last.swap(now.last);
  memory_.expected.swap(now.expected);
  memory_.patterns.swap(now.patterns);
}

// Rows outside A need the same masses as the rows in it. Otherwise alternating between the two
// would add energy.
void DirectSolver::prepare_outside(const Bodies& bodies) {
  if (outside_.list.empty()) return;
  slow_bodies_ = bodies;
  inertia_.set_inertia(slow_bodies_);
  contacts_.iterations = 1;
  contacts_.prepare_as(slow_bodies_, bodies, outside_, h_);
}

void DirectSolver::warm_start(Bodies& bodies, real ratio) {
  blocks_of(bodies);  // rejects other bodies
  if (!again_) {
    if (report_.iterated) fallback.warm_start(bodies, 0);
    ratio_ = ratio > 0 ? real(1) : real(0);
    const bool free = newton > 0 && std::any_of(islands_.list.begin(), islands_.list.end(),
                                                AddedInertia::is_free);
    if (inertia_.used() || free) before_.assign(bodies.begin(), bodies.end());
  }
  for (const Island& island : islands_.list)
    if (inertia_.used() && island.active)
      island.for_moving([&](int slot) { inertia_.set_velocity(bodies.at(slot), slot); });
  if (again_ ? alternating() : !outside_.list.empty()) contacts_.warm_start(bodies, ratio);
  for (Island& island : islands_.list) {
    if (!island.active) continue;
    JointSystem& system = island.system;
    if (ratio != 0) system.load(bodies);
    system.start(double(ratio));
    if (ratio != 0) system.store(bodies), system.store_impulses(*blocks_);  // else solve() does
  }
}

// ---- the solution -------------------------------------------------------------------------------

void DirectSolver::solve(Bodies& bodies) {
  blocks_of(bodies);  // rejects other bodies
  if (report_.iterated) fallback.solve(bodies);
  for (Island& island : islands_.list) island.active = !island.left;
  solve_active(bodies, !outside_.list.empty());
  if (inertia_.used()) {
    for (int k = 0; k < most_again && forces_jumped(bodies); ++k) solve_again(bodies);
    inertia_.remember(memory_);
  }
  memory_.write(blocks_->memory);
  report_.passes = report_.wrong = 0;
  for (const Island& island : islands_.list) {
    if (island.left) continue;
    report_.passes = std::max(report_.passes, island.system.passes);
    report_.wrong += island.system.wrong;
  }
}

// Islands on which no row outside A acts are solved once. \param outside with the rows outside A
void DirectSolver::solve_active(Bodies& bodies, bool outside) {
  for (int n = 0; n < (outside ? alternations : 1); ++n) {
    if (outside) contacts_.solve(bodies);
    for (Island& island : islands_.list) {
      if (!island.active || (n > 0 && !island.alternates)) continue;
      island.system.load(bodies);
      island.system.solve(most_passes, !island.alternates);  // the next alternation refines
      island.system.store(bodies);
      island.system.store_impulses(*blocks_);
    }
  }
}

bool DirectSolver::alternating() const {
  return std::any_of(islands_.list.begin(), islands_.list.end(),
                     [](const Island& island) { return island.active && island.alternates; });
}

// True if the forces have jumped at a body. Then only the islands of such bodies are active and, if
// rows outside A act on one of them, all on which such rows act.
bool DirectSolver::forces_jumped(const Bodies& bodies) {
  inertia_.find_next(bodies, *blocks_, islands_);
  bool any = false;
  for (Island& island : islands_.list) {
    island.active = false;
    island.for_moving([&](int slot) {
      island.active = island.active || inertia_.jumped(bodies.at(slot), slot);
    });
    any = any || island.active;
  }
  if (alternating())
    for (Island& island : islands_.list)
      island.active = island.active || (island.alternates && !island.left);
  return any;
}

// Solves active islands again, with the inertia that their own forces require.
void DirectSolver::solve_again(Bodies& bodies) {
  const auto go_back = [&](int slot) { bodies.at(slot) = before_[slot]; };
  const bool outside = alternating();
  for (int slot = 0; slot < bodies.slots() && outside; ++slot)
    if (islands_.is_beside(islands_.root_of(slot))) go_back(slot);
  for (Island& island : islands_.list) {
    if (!island.active) continue;
    island.for_moving([&](int slot) {
      go_back(slot);
      inertia_.add_next(bodies.at(slot), slot, memory_);
    });
    inertia_.set_masses(island, bodies);
    island.system.factored = false;
  }
  if (outside) prepare_outside(bodies);
  again_ = true;
  warm_start(bodies, ratio_);
  again_ = false;
  solve_active(bodies, outside);
}

void DirectSolver::advance(Bodies& bodies, real h, const Append& append) {
  blocks_of(bodies);  // rejects other bodies
  if (newton > 0) {
    Positions(positions_, islands_, inertia_, *blocks_, memory_, bodies, h, append)
        .move(newton, tolerance);
    memory_.write(blocks_->memory);
    for (const Island& island : islands_.list)
      if (!island.left) island.system.store_impulses(*blocks_);
    Positions::Report& report = report_;
    report = positions_.report;
  }
  if (report_.iterated) {
    report_.moved_exactly = false;
    for (int slot = 0; newton > 0 && slot < bodies.slots(); ++slot)
      bodies.at(slot) = positions_.start[slot];
    fallback.advance(bodies, h, append);  // moves all bodies
  } else if (newton == 0) {
    integrate_poses(bodies, h);
  }
  double fastest = 0;  // squared [rad^2/s^2]
  for (const Island& island : islands_.list) {
    if (!before_.empty()) inertia_.keep_momentum(island, before_, bodies);
    island.for_moving([&](int slot) {
      const vec3& w = bodies.at(slot).w;
      fastest = std::max(fastest, double(dot(w, w)));
    });
  }
  report_.turned = std::sqrt(fastest) * double(h);
}

// ---- for the stages of a Runge-Kutta method -----------------------------------------------------

void DirectSolver::factor_now() {
  require(blocks_ != nullptr && !report_.iterated,
          "solver: there is no matrix: nothing was prepared, or for iterations");
  for (Island& island : islands_.list) island.system.factor_now();
}

int DirectSolver::dependent() const {
  int count = 0;
  for (const Island& island : islands_.list)
    if (!island.left && island.system.passes > 0) count += island.system.dependent();
  return count;
}

// Mostly it takes more than one solution: A is softened, and belongs to other poses than `at`.
void DirectSolver::reach(Bodies& bodies, const Blocks& at, const std::vector<real>& wanted,
                         double enough) {
  const Blocks& blocks = blocks_of(bodies);
  bool factored = true;
  for (const Island& island : islands_.list) factored = factored && island.system.factored;
  require(wanted.size() == blocks.C.size() && at.list.size() == blocks.list.size() && factored,
          "rates: there must be one for each row, and a factor");
  for (Island& island : islands_.list) {
    JointSystem& system = island.system;
    system.load(bodies);
    double before = 0;
    for (int n = 0; n < rounds; ++n) {
      double largest = 0;
      for (const SystemBlock& block : system.blocks)
        for (int i = 0, row = at.list[block.block].first; i < block.rows; ++i, ++row) {
          double& x = system.x[system.row_of(block) + i];
          x = double(wanted[row]) - system.rate(block, at.J[row]);
          largest = std::max(largest, std::abs(x));
        }
      if (largest <= enough || (n >= 2 && !(largest < before / 2))) break;
      before = largest;
      system.change();
    }
    system.store(bodies);
    system.store_impulses(blocks);
  }
}

}  // namespace joints
