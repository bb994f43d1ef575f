// The direct solver: the factor, the corrections, and the bounds by an active set.
#include "chapters/09_direct/direct_solver.h"

#include <algorithm>
#include <cmath>

namespace joints {

namespace {
// Bounded rows are softened by this fraction of K, since they may depend on others, as those of a
// motor and a limit do. Until one of them is at its bound, their impulses are inversely
// proportional to it. With float velocities 1e-9 would make them so large that the velocities are
// lost.
constexpr double bound_softness = sizeof(real) == 4 ? 1e-6 : 1e-9;
// At most this many times a step is solved again because its forces have jumped.
constexpr int looks = 4;
// In an open chain only the masses make a pivot small, so there its threshold is multiplied by
// this.
constexpr double of_open_chains = 1e-3;
// A row is dependent if its pivot is below this multiple of the softening.
constexpr double of_softening = sizeof(real) == 4 ? 100 : 1000;
// After this many passes without progress only the last wrong row changes its side.
constexpr int patience = 3;

Triple<double> of(const vec3& a) { return {double(a.x), double(a.y), double(a.z)}; }

}  // namespace

// ---- the factor ---------------------------------------------------------------------------------

void DirectSolver::factor_now() {
  require(blocks_ != nullptr && !report_.iterated,
          "solver: there is no matrix: nothing was prepared, or for iterations");
  maker_.assemble(J_, masses_);
  JointMatrixOf<TwoLanes>& A = maker_.A;
  for (BoundedRow& row : bounded_) {
    const int rows = inside_[row.inside].block->rows, lane = maker_.lane(row.inside);
    TwoLanes& entry = A.numbers[maker_.diagonal(row.inside) + rows * rows - 1];
    row.softness = bound_softness * entry[lane];
    entry[lane] += row.softness;
  }
  for (int k = 0; k < int(inside_.size()); ++k) {
    if (inside_[k].spring == 0) continue;
    const int n = inside_[k].block->rows, lane = maker_.lane(k);
    TwoLanes* const block = &A.numbers[maker_.diagonal(k)];
    for (int i = 0; i < n * n; ++i) block[i][lane] *= 1 + inside_[k].spring;
  }
  for (int k = 0; k < int(pattern_.size()); ++k) {
    if (maker_.loop(k) < 0) continue;
    const int n = pattern_[k].rows, lane = maker_.lane(k);
    TwoLanes* const block = &A.numbers[maker_.diagonal(k)];
    for (int i = 0; i < n - pattern_[k].bounded; ++i) block[i * (n + 1)][lane] *= 1 + softening;
  }
  note_diagonal();
  factor(A, inverse);
  factored_ = true;
}

// Stores the diagonal before any elimination.
void DirectSolver::note_diagonal() {
  JointMatrixOf<TwoLanes>& A = maker_.A;
  for (int k = 0; k < int(pattern_.size()); ++k) {
    const int n = pattern_[k].rows, lane = maker_.lane(k);
    const double share = maker_.loop(k) < 0 ? of_open_chains : 1;
    for (int i = 0; i < n; ++i)
      A.original[maker_.row(k) + i][lane] =
          share * A.numbers[maker_.diagonal(k) + i * (n + 1)][lane];
  }
}

// Number of the rows of a block whose pivot is 0 or less than this fraction of the original entry.
int DirectSolver::rows_below(double share, int block) const {
  const int n = pattern_[block].rows, lane = maker_.lane(block);
  int count = 0;
  for (int i = 0; i < n; ++i) {
    const double inverse = maker_.A.numbers[maker_.diagonal(block) + i * (n + 1)][lane];
    count += inverse == 0 || inverse * maker_.A.original[maker_.row(block) + i][lane] * share > 1;
  }
  return count;
}

int DirectSolver::dependent() const {
  if (report_.iterated) return 0;  // there is no factor
  int count = 0;
  for (int k = 0; k < int(pattern_.size()); ++k)
    count += rows_below(maker_.loop(k) < 0 ? 0 : of_softening * softening, k);
  for (const BoundedRow& row : bounded_) count -= row.side != Side::free;
  return count;
}

// ---- corrections --------------------------------------------------------------------------------

std::array<HalfRow, 2> DirectSolver::changes(const Block& block, const double* impulse) const {
  double sum[12] = {};  // J^T times the impulses
  for (int i = 0; i < block.rows; ++i) {
    const real* const J = reinterpret_cast<const real*>(&rows_of_J_[block.first + i]);
    for (int k = 0; k < 12; ++k) sum[k] += impulse[i] * double(J[k]);
  }
  const BodyMass &mass1 = masses_[block.body1], &mass2 = masses_[block.body2];
  const auto triple_at = [&](int k) { return Triple<double>{sum[k], sum[k + 1], sum[k + 2]}; };
  return {HalfRow{mass1.linear * triple_at(0), mass1.angular * triple_at(3)},
          HalfRow{mass2.linear * triple_at(6), mass2.angular * triple_at(9)}};
}

void DirectSolver::change_impulses(Bodies& bodies, const Block& block,
                                   const double* change) const {
  for (int i = 0; i < block.rows; ++i) block.impulse[i] += real(change[i]);
  const auto push = [&](int slot, const HalfRow& by) {
    if (masses_[slot].linear == 0) return;
    Body& body = bodies.at(slot);
    body.v += vec3(real(by.v.x), real(by.v.y), real(by.v.z));
    body.w += vec3(real(by.w.x), real(by.w.y), real(by.w.z));
  };
  const auto [by1, by2] = changes(block, change);
  push(block.body1, by1);
  push(block.body2, by2);
}

void DirectSolver::change_rates(Bodies& bodies, std::vector<double>& rates) {
  require(rates.size() == blocks_of(bodies).C.size() && factored_,
          "rates: there must be one for each row, and a factor");
  for (int k = 0; k < int(inside_.size()); ++k) {
    const Block& block = *inside_[k].block;
    TwoLanes* const place = &on_lanes_[maker_.row(k)];
    for (int i = 0; i < block.rows; ++i) place[i][maker_.lane(k)] = rates[block.first + i];
  }
  joints::solve(maker_.A, on_lanes_.data());
  for (int k = 0; k < int(inside_.size()); ++k) {
    const Block& block = *inside_[k].block;
    const TwoLanes* const place = &on_lanes_[maker_.row(k)];
    for (int i = 0; i < block.rows; ++i) rates[block.first + i] = place[i][maker_.lane(k)];
    change_impulses(bodies, block, &rates[block.first]);
  }
}

// J V + bias of a row.
double DirectSolver::rate_left(const Bodies& bodies, const Block& block, int i) const {
  const Row& J = blocks_->J[block.first + i];
  return double(row_velocity(J, bodies.at(block.body1), bodies.at(block.body2))) +
         bias_[block.first + i];
}

// Makes the remaining errors of all free rows zero.
void DirectSolver::correct_velocities(Bodies& bodies) {
  const std::vector<real>& expected = blocks_->memory.rates;
  std::fill(x_.begin(), x_.end(), 0.0);
  for (const Inside& one : inside_) {
    const Block& block = *one.block;
    for (int i = 0; i < block.rows; ++i)
      x_[block.first + i] = double(expected[block.first + i]) - rate_left(bodies, block, i);
    if (one.spring == 0) continue;
    double impulse[6];
    std::copy(block.impulse, block.impulse + block.rows, impulse);
    const auto [by1, by2] = changes(block, impulse);
    for (int i = 0; i < block.rows; ++i) {  // K lambda of a spring
      const Row& J = blocks_->J[block.first + i];
      x_[block.first + i] -= one.spring * (dot(of(J.v1), by1.v) + dot(of(J.w1), by1.w) +
                                           dot(of(J.v2), by2.v) + dot(of(J.w2), by2.w));
    }
  }
  for (const BoundedRow& row : bounded_) {
    const Block& block = *inside_[row.inside].block;
    double& x = x_[block.first + block.rows - 1];
    x = row.side == Side::free ? x - row.softness * double(block.impulse[block.rows - 1]) : 0;
  }
  change_rates(bodies, x_);
}

// ---- bounds -------------------------------------------------------------------------------------

// An impulse that is not free is exactly at its bound.
void DirectSolver::go_to_bounds(Bodies& bodies) {
  for (const BoundedRow& row : bounded_) {
    if (row.side == Side::free) continue;
    const Block& block = *inside_[row.inside].block;
    double change[6] = {};
    real& impulse = block.impulse[block.rows - 1];
    const double bound = row.side == Side::lower ? row.lower : row.upper;
    change[block.rows - 1] = bound - double(impulse);
    if (change[block.rows - 1] == 0) continue;
    change_impulses(bodies, block, change);
    impulse = real(bound);
  }
}

// Changes the sides of all wrong rows, or of the last one only. Returns how many were wrong.
int DirectSolver::flip_wrong_ones(Bodies& bodies, bool only_last) {
  int wrong = 0;
  for (auto row = bounded_.rbegin(); row != bounded_.rend(); ++row) {
    const Block& block = *inside_[row->inside].block;
    const int last = block.rows - 1;
    const double impulse = double(block.impulse[last]);
    const Side next = next_side(row->side, impulse, row->lower, row->upper,
                                rate_left(bodies, block, last) + row->softness * impulse);
    if (next == row->side) continue;
    if (++wrong > 1 && only_last) continue;
    row->side = next;
    place_row(row->inside, last, next == Side::free);
  }
  if (wrong > 0) factored_ = false;
  return wrong;
}

void DirectSolver::solve_joints(Bodies& bodies) {
  int fewest = int(bounded_.size()) + 1, in_vain = 0;
  for (int pass = 0; pass < passes; ++pass) {
    if (!factored_) {
      factor_now();
      ++report_.passes;
    }
    go_to_bounds(bodies);
    correct_velocities(bodies);
    // Refines softened rows and bounded rows that nearly depend on others. If rows outside
    // alternate with these, the next alternation does that.
    if (bounded_.empty() && (maker_.loops().empty() || !outside_.list.empty())) return;
    correct_velocities(bodies);
    if (bounded_.empty()) return;
    report_.wrong = flip_wrong_ones(bodies, in_vain >= patience);
    if (report_.wrong == 0) return;
    in_vain = report_.wrong < fewest ? 0 : in_vain + 1;
    fewest = std::min(fewest, report_.wrong);
  }
}

void DirectSolver::solve(Bodies& bodies) {
  blocks_of(bodies);  // rejects other bodies
  if (report_.iterated) return instead.solve(bodies);
  solve_all(bodies);
  if (before_.empty()) return;
  for (int k = 0; k < looks && forces_jumped(bodies); ++k) look_again(bodies);
  for (int slot = 0; slot < bodies.slots(); ++slot)
    blocks_->memory.inertia[slot] = added_inertia * h_ * h_ * pulls_[slot].force_lever;
}

// Solves the step again, with the inertia that its own forces require.
void DirectSolver::look_again(Bodies& bodies) {
  pulls_.swap(next_pulls_);
  for (int slot = 0; slot < bodies.slots(); ++slot)
    bodies.at(slot).v = before_[slot].v, bodies.at(slot).w = before_[slot].w;
  collect_masses(bodies);
  prepare_outside(bodies, h_);
  warm_start(bodies, warm_ ? real(1) : real(0));
  factored_ = false;
  solve_all(bodies);
}

void DirectSolver::solve_all(Bodies& bodies) {
  if (outside_.list.empty()) return solve_joints(bodies);
  for (int n = 0; n < alternations; ++n) {
    contacts_.solve(bodies);
    solve_joints(bodies);
  }
}

}  // namespace joints
