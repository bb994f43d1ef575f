// The move of all islands: by Newton's method, with the factor of the step.
#include "direct/positions.h"

#include <algorithm>
#include <cmath>

#include "engine/kernels.h"
#include "engine/rotation/free_rotation.h"

namespace joints {

// Rounding errors of C are at most about this times epsilon times the largest coordinate.
static constexpr double of_rounding = 8;

double Positions::largest(std::span<const double> C) {
  double out = 0;
  for (const double one : C) out = std::max(out, std::abs(one));
  return out;
}

void Positions::choose(int from, int end) {
  from_ = from, end_ = end;
  base_ = from < end ? islands_.list[from].first_row : 0;
}

void Positions::move(int newton, double tolerance) {
  own_.report = {};
  own_.errors_met.clear();
  const int count = int(islands_.list.size());
  own_.impulses.resize(std::size_t(count));
  for (int k = 0; k < count; ++k) {
    const std::vector<double>& now = islands_.list[k].system.impulse;
    own_.impulses[k].reserve(now.capacity());
    own_.impulses[k] = now;
  }
  own_.expected = corrections_.expected;
  own_.moved.assign(std::size_t(bodies_.slots()), false);
  own_.tries.assign(std::size_t(count), {});
  for (int k = 0; k < count; ++k) {
    choose(k, k + 1);
    begin(tolerance);
    // Without bounds nothing but poses has to be met, and free rotations conserve energy best.
    if (islands_.list[k].system.bounded.empty())
      for_bodies([](Body& body, int) { use_own_rate(body); });
  }
  choose(0, count);
  zeros(own_.C, std::size_t(islands_.rows()));
  find_corrected();
  own_.begin.assign(bodies_.data(), bodies_.data() + bodies_.slots());
  move_onto_constraints(bodies_, double(h_), newton, 0, *this, own_.start);
  bool closed = true;
  for (int k = 0; k < count; ++k) {
    if (own_.tries[k].exact) continue;
    choose(k, k + 1);
    closed = move_alone() && closed;
  }
  choose(0, count);
  expect();
  own_.report.moved_exactly = closed;
}

// Errors of all islands that move. Those that are closed, or do not approach it, stay as they
// are.
std::vector<double>& Positions::errors() {
  evaluate(false);
  double& met = own_.errors_met.emplace_back(0);
  for (std::size_t k = 0; k < own_.tries.size(); ++k) {
    Memory::Try& now = own_.tries[k];
    const std::span C(&own_.C[islands_.list[k].first_row], std::size_t(islands_.list[k].rows));
    const double error = largest(C);
    met = std::max(met, error);
    now.exact = now.exact || (now.moving && error <= now.most);
    now.moving = now.moving && !now.exact && error <= poor_contraction * now.last;
    now.last = error;
    if (!now.moving) std::fill(C.begin(), C.end(), 0.0);
  }
  return own_.C;
}

void Positions::change_rates(std::vector<double>& rates) {
  ++own_.report.corrections;
  for (std::size_t r = 0; r < rates.size(); ++r)
    corrections_.expected[base_ + r] += real(rates[r]);
  for_islands([&](Island& island, int k) {
    if (!moving(k)) return;
    JointSystem& system = island.system;
    for (const SystemBlock& block : system.blocks)
      std::copy_n(rates.data() + block.row - base_, block.rows, &system.x[system.row_of(block)]);
    system.load(bodies_);
    system.change_within_bounds();
    system.store(bodies_);
  });
}

void Positions::begin(double tolerance) {
  Memory::Try& now = own_.tries[from_];
  now.exact = true;  // unless this solver solves it
  real size = 0;  // errors that are only rounding errors need not be corrected
  for_islands([&](Island& island, int) {
    now.moving = true, now.exact = false;
    if (!island.system.factored) island.system.factor_now();  // sides were still wrong
  });
  for_bodies([&](Body& body, int) {
    const vec3 x = abs(body.x);
    size = std::max({size, x.x, x.y, x.z});
  });
  now.most = std::max(tolerance * double(h_) * double(h_),
                      of_rounding * double(epsilon * size));
}

// Errors are corrected in rows that hold a position, unless they belong to a spring, rebound, or
// are zero, as those of points that coincide: no impulse along them corrects anything.
void Positions::find_corrected() {
  own_.corrected.reserve(islands_.given.capacity());
  zeros(own_.corrected, list_.size());
  for_islands([&](Island& island, int) {
    const JointSystem& system = island.system;
    for (std::size_t k = 0; k < system.blocks.size(); ++k) {
      const int block = system.blocks[k].block;
      const RowSettings& target = list_[block].settings;
      if (system.is_spring(int(k)) || !target.holds_position) continue;
      const double* const original = &system.A.original[system.row_of(system.blocks[k])];
      for (int i = 0; i < list_[block].rows - (target.rate != 0); ++i)
        if (original[i] != 0) own_.corrected[block] |= 1 << i;
      for (int i = 0; i < list_[block].rows - target.one_sided(); ++i)
        own_.report.opened = std::max(
            own_.report.opened, std::abs(double(blocks_.C[std::size_t(list_[block].first + i)])));
    }
  });
}

void Positions::mark_moving(bool mark) {
  for_islands([&](Island& island, int k) {
    if (moving(k)) island.for_moving([&](int slot) { own_.moved[slot] = mark; });
  });
}

// C of all rows of moving islands at the present poses, 0 for rows without an error. \param rows
// also append the rows at these poses, and count limits that are exceeded
void Positions::evaluate(bool rows) {
  bool some = false;  // not all
  for (int k = 0; k < int(own_.tries.size()); ++k) some = some || !moving(k);
  if (some) mark_moving(true);
  own_.poses.clear();
  own_.poses.list.reserve(islands_.given.capacity());
  own_.poses.C.reserve(blocks_.C.capacity());
  if (rows) own_.poses.J.reserve(blocks_.J.capacity());
  own_.poses.errors_only = !rows;
  {
    const std::vector<bool>* const of = some ? &own_.moved : nullptr;
    const HeldMatrices matrices(bodies_, of);
    append_(own_.poses, of);
  }
  if (some) mark_moving(false);
  own_.met.clear();
  if (rows) own_.met.reserve(islands_.given.capacity());
  std::size_t k = 0;
  for (const Block& now : own_.poses.list) {
    const std::size_t begin = k;  // nearly always the next one
    while (list_[k].impulse != now.impulse)
      if (k = (k + 1) % list_.size(); k == begin) break;
    const auto& [island, number, row] = islands_.at(int(k));
    const bool met = list_[k].impulse == now.impulse && moving(island);
    if (rows) own_.met.push_back(met ? int(k) : -1);
    if (met) {
      const int corrected = own_.corrected[k];
      const real* const error = &own_.poses.C[now.first];
      double* const C = &own_.C[row - base_];
      for (int i = 0; i < now.rows; ++i) C[i] = corrected >> i & 1 ? double(error[i]) : 0;
    }
    if (++k == list_.size()) k = 0;
  }
  for_islands([&](Island& island, int) {
    for (const BoundedRow& bound : island.system.bounded) {
      double& C = C_of(island, bound);
      const bool one_sided = list_[island.system.blocks[bound.block].block].settings.one_sided();
      if (bound.side != Side::free && !(rows && C < 0 && one_sided)) C = 0;
    }
  });
}

// The next corrections of an open chain change as the present ones did. In a closed loop the same
// ones are expected again: those of rows that depend on others would grow without bound; and
// beside bounded rows too, which hold still or change sides.
void Positions::expect() {
  for_islands([&](Island& island, int) {
    if (!island.plan->list.empty() || !island.system.bounded.empty()) return;
    for (int row = island.first_row; row < island.first_row + island.rows; ++row) {
      real &last = corrections_.last[row], &next = corrections_.expected[row];
      const real now = next;
      if (last != 0) next += now - last;
      last = now;
    }
  });
}

}  // namespace joints
