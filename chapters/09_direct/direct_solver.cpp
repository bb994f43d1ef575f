// The direct solver: factors, corrects, and keeps bounds by an active set.
#include "chapters/09_direct/direct_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace joints {

namespace {
// A share of K that makes bounded rows solvable that depend on others, as motor and limit do. Until
// one of them is at its bound, their impulses are as large as this is small: with float velocities
// 1e-9 leaves nothing of what they were.
constexpr double bound_softness = sizeof(real) == 4 ? 1e-6 : 1e-9;
// If careful, a share of A's diagonal by which it is softened: of a direction that is nearly
// dependent, because the poses are not exact, no more force comes than this allows.
constexpr double softening = sizeof(real) == 4 ? 1e-5 : 1e-8;
// If careful, so often at most a step is solved again because its forces have jumped.
constexpr int looks = 4;
// If careful, so often at most the factor of the new poses corrects them.
constexpr int projections = 20;
// After so many passes in which no fewer rows were wrong, only the last wrong one changes sides.
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
  for (const Node& node : A.nodes)
    for (int i = 0; careful && i < node.rows; ++i)
      A.numbers[node.diagonal + i * (node.rows + 1)] *= 1 + softening;
  for (const Node& node : A.nodes)
    for (int i = 0; i < node.rows; ++i)
      A.original[node.row + i] = A.numbers[node.diagonal + i * (node.rows + 1)];
  factor(A, inverse);
  factored_ = true;
}

int DirectSolver::dropped() const {
  if (report_.iterated) return 0;  // there is no factor
  int count = 0;
  for (int k = 0; k < int(pattern_.size()); ++k) {
    const TwoLanes* const block = &maker_.A.numbers[maker_.diagonal(k)];
    for (int i = 0; i < pattern_[k].rows; ++i)
      count += block[i * (pattern_[k].rows + 1)][maker_.lane(k)] == 0;
  }
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

// What is left of all free rows becomes zero.
void DirectSolver::correct_velocities(Bodies& bodies) {
  std::fill(x_.begin(), x_.end(), 0.0);
  for (const Inside& one : inside_) {
    const Block& block = *one.block;
    for (int i = 0; i < block.rows; ++i)
      x_[block.first + i] = expected_[block.first + i] - rate_left(bodies, block, i);
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

// Rows on the wrong side change it; all of them, or only the last. Returns how many were wrong.
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
    if (bounded_.empty() && !careful) return;
    correct_velocities(bodies);  // refinement: softened rows, and bounded ones nearly dependent
    if (bounded_.empty()) return;
    report_.wrong = flip_wrong_ones(bodies, in_vain >= patience);
    if (report_.wrong == 0) return;
    in_vain = report_.wrong < fewest ? 0 : in_vain + 1;
    fewest = std::min(fewest, report_.wrong);
  }
}

void DirectSolver::solve(Bodies& bodies) {
  blocks_of(bodies);  // refuses other bodies
  if (report_.iterated) return instead.solve(bodies);
  solve_all(bodies);
  if (!careful || before_.size() != masses_.size()) return;
  for (int k = 0; k < looks && forces_jumped(bodies); ++k) look_again(bodies);
  for (int slot = 0; slot < bodies.slots(); ++slot)
    blocks_->inertia[slot] = stiffness * h_ * h_ * pulls_[slot].force_lever;
}

// The step once more, with the inertia that its own forces ask for.
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

// ---- positions ----------------------------------------------------------------------------------

class DirectSolver::Poses : public Corrector {
 public:
  // J: where the rows at the new poses go, if they are wanted
  Poses(DirectSolver& solver, Bodies& bodies, const Append& append, std::vector<Row>* J = nullptr)
      : solver_(solver), bodies_(bodies), append_(append), J_(J) {}

  std::vector<double>& errors() override {
    Blocks& poses = solver_.poses_;
    poses.clear();
    poses.errors_only = J_ == nullptr;
    append_(poses);
    std::vector<double>& x = solver_.x_;
    std::fill(x.begin(), x.end(), 0.0);
    std::size_t k = 0;
    for (const Inside& one : solver_.inside_) {
      const Block& block = *one.block;
      if (!block.target.holds_position || one.spring > 0) continue;
      const std::size_t begin = k;  // nearly always the next one
      while (poses.list[k].impulse != block.impulse)
        if (k = (k + 1) % poses.list.size(); k == begin) break;
      if (poses.list[k].impulse != block.impulse) continue;
      for (int i = 0; i < block.rows; ++i)
        x[block.first + i] = double(poses.C[poses.list[k].first + i]);
      for (int i = 0; J_ && i < block.rows; ++i)
        (*J_)[block.first + i] = poses.J[poses.list[k].first + i];
      if (block.target.rate != 0) x[block.first + block.rows - 1] = 0;  // it rebounds
    }
    for (const BoundedRow& row : solver_.bounded_) {
      const Block& block = *solver_.inside_[row.inside].block;
      if (row.side != Side::free) x[block.first + block.rows - 1] = 0;
    }
    double largest = 0;
    for (const double C : x) largest = std::max(largest, std::abs(C));
    solver_.errors_met_.push_back(largest);
    return x;
  }
  void change_rates(std::vector<double>& rates) override {
    for (std::size_t r = 0; r < rates.size(); ++r) solver_.expected_[r] += rates[r];
    solver_.change_rates(bodies_, rates);
    ++solver_.report_.corrections;
  }

 private:
  DirectSolver& solver_;
  Bodies& bodies_;
  const Append& append_;
  std::vector<Row>* J_;
};

// If there are no such poses, velocities and impulses are those that solve the velocities, without
// what was expected of the poses.
void DirectSolver::advance(Bodies& bodies, real h, const Append& append) {
  blocks_of(bodies);
  report_.moved_exactly = false;
  report_.corrections = 0;
  errors_met_.clear();
  errors_met_.reserve(std::size_t(std::min(newton, 64)));  // hardly ever more
  if (newton > 0 && careful && !report_.iterated && !factored_) factor_now();
  if (newton == 0 || report_.iterated || !factored_) {  // no factor: sides were still wrong
    std::fill(expected_.begin(), expected_.end(), 0.0);
    return report_.iterated ? instead.advance(bodies, h, append) : integrate_poses(bodies, h);
  }
  impulses_.clear();
  for (const Inside& one : inside_)
    impulses_.insert(impulses_.end(), one.block->impulse, one.block->impulse + one.block->rows);
  in_vain_ = expected_;
  Poses poses(*this, bodies, append);
  report_.moved_exactly = move_onto_constraints(bodies, h, newton, poses, start_);
  const bool closed = !careful || errors_met_.back() <= negligible * h * h;
  if (report_.moved_exactly && closed) return;
  std::copy(start_.begin(), start_.end(), bodies.data());
  const real* impulse = impulses_.data();
  for (const Inside& one : inside_) {
    std::copy(impulse, impulse + one.block->rows, one.block->impulse);
    impulse += one.block->rows;
  }
  for (double& rate : in_vain_) rate = -rate;
  change_rates(bodies, in_vain_);
  std::fill(expected_.begin(), expected_.end(), 0.0);
  if (careful) report_.moved_exactly = project(bodies, h, append);
  else integrate_poses(bodies, h);
}

// A of rows and moments of inertia at the present poses, and its factor.
void DirectSolver::factor_at(const Bodies& bodies, const std::vector<Row>& J) {
  rows_of_J_ = J.data();
  for (int slot = 0; slot < bodies.slots(); ++slot) {
    Body body = bodies.at(slot);
    if (body.is_static()) continue;
    if (pulls_[slot].force_lever > 0)
      body.inverse_inertia_local = pulls_[slot].inverse_inertia_local;
    const mat3 I = inverse_inertia(body);
    masses_[slot].angular = {I[0][0], I[1][1], I[2][2], I[1][0], I[2][0], I[2][1]};
  }
  place_rows();
  factor_now();
}

// Newton's method with the factor of each new pose. A correction that makes the errors larger is
// halved. If they do not vanish, the best velocities stay.
bool DirectSolver::project(Bodies& bodies, real h, const Append& append) {
  std::vector<Body> best;
  std::vector<real> best_impulses;
  const auto keep = [&] {
    best.assign(bodies.data(), bodies.data() + bodies.slots());
    best_impulses.clear();
    for (const Inside& one : inside_)
      best_impulses.insert(best_impulses.end(), one.block->impulse,
                           one.block->impulse + one.block->rows);
  };
  const auto back = [&] {
    for (int slot = 0; slot < bodies.slots(); ++slot)
      bodies.at(slot).v = best[slot].v, bodies.at(slot).w = best[slot].w;
    const real* impulse = best_impulses.data();
    for (const Inside& one : inside_) {
      std::copy(impulse, impulse + one.block->rows, one.block->impulse);
      impulse += one.block->rows;
    }
  };
  const auto move = [&] {
    for (int slot = 0; slot < bodies.slots(); ++slot)
      bodies.at(slot).x = start_[slot].x, bodies.at(slot).q = start_[slot].q;
    integrate_poses(bodies, h);
  };
  const std::vector<BodyMass> masses = masses_;
  double last = std::numeric_limits<double>::infinity(), share = 1;
  std::vector<double> rates, part;
  bool closed = false;
  keep();
  for (int n = 0; n < projections; ++n) {
    move();
    new_J_ = blocks_->J;
    const std::vector<double>& C = Poses(*this, bodies, append, &new_J_).errors();
    double now = 0;
    for (const double c : C) now = std::max(now, std::abs(c));
    closed = now <= negligible * double(h) * double(h);
    if (closed || std::isinf(now)) break;
    if (now < last) {
      last = now, share = 1;
      keep();
      rates = C;
      for (double& rate : rates) rate /= -double(h);
      factor_at(bodies, new_J_);
    } else {
      share /= 2;
      back();
    }
    part = rates;
    for (double& rate : part) rate *= share;
    change_rates(bodies, part);
    ++report_.corrections;
  }
  if (!closed) {
    back();
    move();
  }
  masses_ = masses;
  rows_of_J_ = blocks_->J.data();
  place_rows();
  factored_ = false;
  return closed;
}

}  // namespace joints
