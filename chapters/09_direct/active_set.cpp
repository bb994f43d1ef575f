// The bounds of a system, by an active set: passes solve the free rows exactly and then change the
// sides of others.
#include <algorithm>
#include <cmath>

#include "chapters/09_direct/joint_system.h"

namespace joints {

// After this many passes without progress the impulses stay inside their bounds.
static constexpr int patience = 3;
// A bounded row nearly depends on others if its pivot is below this fraction of K.
static constexpr double nearly = sizeof(real) == 4 ? 1e-3 : 1e-4;

// An impulse that is not free is exactly at its bound.
void JointSystem::go_to_bounds() {
  for (const BoundedRow& row : bounded) {
    if (row.side == Side::free) continue;
    const int node = blocks[row.block].node, last = last_row(row);
    double by[most_rows]{};
    by[last - A.nodes[node].row] = row.bound(row.side) - impulse[last];
    push(node, by);
    impulse[last] = row.bound(row.side);
  }
}

// Shortens the changes `x` of the impulses until no free row leaves its bounds; the first ones that
// reach them stay there. Each pass then comes closer to the solution, with any sides.
void JointSystem::stay_inside() {
  double part = 1;
  const auto for_leaving = [&](const auto& f) {
    for (BoundedRow& row : bounded) {
      if (row.side != Side::free) continue;
      const double now = impulse[last_row(row)], by = x[last_row(row)];
      const Side next = next_side(Side::free, now + by, row.lower, row.upper, 0);
      if (next != Side::free) f(row, next, std::max(0.0, (row.bound(next) - now) / by));
    }
  };
  for_leaving([&](BoundedRow&, Side, double reached) { part = std::min(part, reached); });
  for_leaving([&](BoundedRow& row, Side next, double reached) {
    if (reached > part) return;
    row.side = next;
    factored = false;
    ++left_;
  });
  for (double& one : x) one *= part;
}

// True if a free bounded row nearly depends on others, as those of a motor and a limit do.
bool JointSystem::bounds_depend() const {
  return std::any_of(bounded.begin(), bounded.end(), [&](const BoundedRow& row) {
    const SystemBlock& block = blocks[row.block];
    return row.side == Side::free && is_below(nearly, block, block.rows - 1);
  });
}

// Changes the sides of all wrong rows, unless one has just come to its bound, and counts them.
void JointSystem::flip_wrong_ones(Progress& progress) {
  wrong = left_;
  for (BoundedRow& row : bounded) {
    if (left_ > 0) break;
    const SystemBlock& block = blocks[row.block];
    const int last = last_row(row);
    double rate = 0;  // of a free row, whose equation holds
    if (row.side != Side::free) {
      double rates[most_rows];
      rates_of(block.node, rates);
      rate = rates[last - A.nodes[block.node].row] + row.bias;
    }
    const Side next = next_side(row.side, impulse[last], row.lower, row.upper, rate);
    if (next == row.side) continue;
    row.side = next;
    factored = false;
    ++wrong;
  }
  auto& [fewest, in_vain] = progress;
  in_vain = wrong < fewest ? 0 : in_vain + 1;
  fewest = std::min(fewest, wrong);
  inside_ = inside_ || in_vain >= patience;
}

void JointSystem::change_within_bounds() {
  change();
  for (;;) {
    for (BoundedRow& row : bounded) {
      if (row.side != Side::free || std::isinf(row.lower) || std::isinf(row.upper)) continue;
      row.side = next_side(Side::free, impulse[last_row(row)], row.lower, row.upper, 0);
      if (row.side != Side::free) factored = false;
    }
    if (factored) return;
    for (std::size_t k = 0; k < columns_.size(); ++k) rates_of(int(k), &wanted_[A.nodes[k].row]);
    factor_now();
    go_to_bounds();
    for (std::size_t k = 0; k < columns_.size(); ++k) rates_of(int(k), &x[A.nodes[k].row]);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = wanted_[i] - x[i];
    change();
  }
}

void JointSystem::solve(int most_passes, bool refine) {
  refine = loops_ && (refine || !bounded.empty());
  Progress progress{int(bounded.size()) + 1, 0};
  for (int pass = 0; pass < most_passes; ++pass) {
    if (!factored) {
      factor_now();
      ++passes;
    }
    left_ = 0;
    go_to_bounds();
    correct();
    refine = refine || bounds_depend();  // for large impulses would round those of later passes
    if (factored && refine) correct();
    if (bounded.empty()) return;
    flip_wrong_ones(progress);
    if (wrong == 0) break;
  }
  inside_ = false;
}

}  // namespace joints
