// The bounds of a pair of islands, by an active set: passes solve the free rows exactly and then
// change the sides of others.
#include <algorithm>

#include "chapters/09_direct/island_pair.h"

namespace joints {

// After this many passes without progress the impulses of an island stay inside their bounds.
static constexpr int patience = 3;
// A bounded row nearly depends on others if its pivot is below this fraction of K.
static constexpr double nearly = sizeof(real) == 4 ? 1e-3 : 1e-4;

// An impulse that is not free is exactly at its bound.
void IslandPair::go_to_bounds() {
  for (const BoundedRow& row : bounded) {
    if (row.side == Side::free) continue;
    const int node = blocks[row.block].node, last = last_row(row);
    const double change = row.bound(row.side) - impulse[last][row.lane];
    TwoLanes by[most_rows]{};
    by[last - A.nodes[node].row][row.lane] = change;
    if (change != 0) push(node, by);
    impulse[last][row.lane] = row.bound(row.side);
  }
}

// Shortens the changes `x` of the impulses until no free row leaves its bounds; the first ones that
// reach them stay there. Each pass then comes closer to the solution, with any sides.
void IslandPair::stay_inside() {
  for (const int lane : {0, 1}) {
    if (!inside_[lane]) continue;
    double part = 1;
    const auto for_leaving = [&](const auto& f) {
      for (BoundedRow& row : bounded) {
        if (row.lane != lane || row.side != Side::free) continue;
        const double now = impulse[last_row(row)][lane], by = x[last_row(row)][lane];
        const Side next = next_side(Side::free, now + by, row.lower, row.upper, 0);
        if (next != Side::free) f(row, next, std::max(0.0, (row.bound(next) - now) / by));
      }
    };
    for_leaving([&](BoundedRow&, Side, double reached) { part = std::min(part, reached); });
    for_leaving([&](BoundedRow& row, Side next, double reached) {
      if (reached > part) return;
      row.side = next;
      factored = false;
      ++left_[lane];
    });
    for (TwoLanes& one : x) one[lane] *= part;
  }
}

// True if a free bounded row nearly depends on others, as those of a motor and a limit do.
bool IslandPair::bounds_depend() const {
  return std::any_of(bounded.begin(), bounded.end(), [&](const BoundedRow& row) {
    const LaneBlock& block = blocks[row.block];
    return row.side == Side::free && is_below(nearly, block, block.rows - 1, row.lane);
  });
}

// Changes the sides of all wrong rows, but in an island where one has just come to its bound.
// Returns how many were wrong.
int IslandPair::flip_wrong_ones(std::array<Progress, 2>& progress) {
  std::array<int, 2> count = left_;
  for (BoundedRow& row : bounded) {
    if (left_[row.lane] > 0) continue;
    const LaneBlock& block = blocks[row.block];
    double rate = 0;  // of a free row, whose equation holds
    if (row.side != Side::free) {
      for (const int of : {0, 1})
        rate += dot(half(block, of)[block.rows - 1], velocities_[block.columns[of]])[row.lane];
      rate += row.bias;
    }
    const Side next =
        next_side(row.side, impulse[last_row(row)][row.lane], row.lower, row.upper, rate);
    if (next == row.side) continue;
    row.side = next;
    factored = false;
    ++count[row.lane];
  }
  for (const int lane : {0, 1}) {
    auto& [fewest, in_vain] = progress[lane];
    in_vain = count[lane] < fewest ? 0 : in_vain + 1;
    fewest = std::min(fewest, count[lane]);
    inside_[lane] = inside_[lane] || in_vain >= patience;
  }
  return count[0] + count[1];
}

void IslandPair::solve(int most_passes, bool refine) {
  refine = !plan->loops.empty() && (refine || !bounded.empty());
  std::array<Progress, 2> progress;
  progress.fill({int(bounded.size()) + 1, 0});
  for (int pass = 0; pass < most_passes; ++pass) {
    if (!factored) {
      factor_now();
      ++passes;
    }
    left_ = {};
    go_to_bounds();
    correct();
    refine = refine || bounds_depend();  // for large impulses would round those of later passes
    if (factored && refine) correct();
    if (bounded.empty()) return;
    wrong = flip_wrong_ones(progress);
    if (wrong == 0) break;
  }
  inside_ = {};
}

}  // namespace joints
