// The direct solver moves the bodies: with the factor of the step, by secants if this is not
// enough, and at last with the factors of new poses.
#include <algorithm>
#include <cmath>
#include <limits>

#include "chapters/09_direct/direct_solver.h"

namespace joints {

namespace {

// Largest number of corrections by secants, and of those with factors of the new poses.
constexpr int most_corrections = 20;
// Corrections by secants that add more than this fraction to the kinetic energy are not used: they
// have found another pose than the next one.
constexpr double most_gain = 0.01;
// An error is small compared to another one if it is less than this fraction of it.
constexpr double small_share = 0.1;
// How often velocities are halved at most if no correction closes the joints.
constexpr int most_halved = 4;
// Rounding errors of C are at most about this times epsilon times the largest coordinate.
constexpr double of_rounding = 8;

// Twice the kinetic energy of all bodies [J].
double twice_kinetic(const Bodies& bodies) {
  double sum = 0;
  for (int slot = 0; slot < bodies.slots(); ++slot) {
    const Body& body = bodies.at(slot);
    if (body.is_static()) continue;
    const vec3 w = to_local(body, body.w);
    sum += double(dot(body.v, body.v) / body.inverse_mass + dot(w / body.inverse_inertia_local, w));
  }
  return sum;
}

// False for a row of zeros, as of points that coincide: no impulse along it corrects anything.
bool has_direction(const Row& J) {
  const vec3 none(0);
  return J.v1 != none || J.w1 != none || J.v2 != none || J.w2 != none;
}

}  // namespace

class DirectSolver::Poses : public Corrector {
 public:
  // J: receives the rows at the new poses, if not null
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
        if (has_direction(solver_.blocks_->J[block.first + i]))
          x[block.first + i] = double(poses.C[poses.list[k].first + i]);
      for (int i = 0; J_ && i < block.rows; ++i)
        (*J_)[block.first + i] = poses.J[poses.list[k].first + i];
      if (block.target.rate != 0) x[block.first + block.rows - 1] = 0;  // it rebounds
    }
    for (BoundedRow& row : solver_.bounded_) {
      const Block& block = *solver_.inside_[row.inside].block;
      double& C = x[block.first + block.rows - 1];
      if (J_ && C < 0 && block.target.one_sided()) row.side = Side::free;  // limit exceeded
      if (row.side != Side::free) C = 0;
    }
    double largest = 0;
    for (const double C : x) largest = std::max(largest, std::abs(C));
    solver_.errors_met_.push_back(largest);
    return x;
  }
  void change_rates(std::vector<double>& rates) override {
    std::vector<real>& expected = solver_.blocks_->memory.rates;
    for (std::size_t r = 0; r < rates.size(); ++r) expected[r] += real(rates[r]);
    solver_.change_rates(bodies_, rates);
    ++solver_.report_.corrections;
  }

 private:
  DirectSolver& solver_;
  Bodies& bodies_;
  const Append& append_;
  std::vector<Row>* J_;
};

// If Newton's method with the factor of the step fails, secants take over: they converge where an
// iteration multiplies some errors by nearly 1, as it does near the singular pose of a linkage.
// Their impulses still act along the rows of the step, which keeps the energy. If they fail as
// well, the factors of the new poses are used. They begin with the best velocities of the secants
// or, if these are no good either, with those that solve the velocity equations, without the
// correction predicted for the poses. If this does not close the joints, a body is too fast for the
// step, and is slowed down.
void DirectSolver::advance(Bodies& bodies, real h, const Append& append) {
  blocks_of(bodies);  // rejects other bodies
  report_.moved_exactly = false;
  report_.corrections = report_.halved = 0;
  errors_met_.clear();
  errors_met_.reserve(std::size_t(std::min(newton, 64) + (2 + most_halved) * most_corrections));
  at_open_.reserve(std::size_t(bodies.slots()));
  std::vector<real>& expected = blocks_->memory.rates;
  if (newton == 0 || report_.iterated) {
    std::fill(expected.begin(), expected.end(), real(0));
    return report_.iterated ? instead.advance(bodies, h, append) : integrate_poses(bodies, h);
  }
  if (!factored_) factor_now();  // sides were still wrong
  keep_best(bodies);
  in_vain_.assign(expected.begin(), expected.end());
  Poses poses(*this, bodies, append);
  const double most = largest_error(bodies, h);
  report_.moved_exactly = move_onto_constraints(bodies, h, newton, most, poses, start_);
  if (report_.moved_exactly) return;
  back_to_start(bodies);
  std::copy(in_vain_.begin(), in_vain_.end(), expected.begin());
  const double least = move_by_secants(bodies, h, most, poses);
  report_.moved_exactly = least <= most;
  if (report_.moved_exactly) return;
  back_to_start(bodies);
  if (std::isinf(least)) {
    for (double& rate : in_vain_) rate = -rate;
    change_rates(bodies, in_vain_);
  }
  std::fill(expected.begin(), expected.end(), real(0));
  report_.moved_exactly = project(bodies, h, most, append);
  while (!report_.moved_exactly && report_.halved < most_halved && halve(bodies, most, append))
    report_.moved_exactly = project(bodies, h, most, append);
}

// The error that need not be corrected [m or rad]. It is not below the rounding errors of points of
// the bodies.
double DirectSolver::largest_error(const Bodies& bodies, real h) const {
  real size = 0;
  for (int slot = 0; slot < bodies.slots(); ++slot) {
    if (bodies.at(slot).is_static()) continue;
    const vec3 x = abs(bodies.at(slot).x);
    size = std::max({size, x.x, x.y, x.z});
  }
  return std::max(tolerance * double(h) * double(h), of_rounding * double(epsilon * size));
}

// Restores the poses of the beginning, and the best velocities and impulses.
void DirectSolver::back_to_start(Bodies& bodies) const {
  std::copy(start_.begin(), start_.end(), bodies.data());
  back_to_best(bodies);
}

// Returns the largest error that the best velocities leave, or infinity if they are no better than
// those of the beginning. Bounded rows exclude secants: a limit that a correction exceeds would
// have to change its side.
double DirectSolver::move_by_secants(Bodies& bodies, real h, double most, Poses& poses) {
  const double kinetic = twice_kinetic(bodies);
  double least = std::numeric_limits<double>::infinity(), first = 0;
  if (!bounded_.empty()) return least;
  secants_.clear(x_.size(), most_corrections);
  for (int n = 0;; ++n) {
    const bool gains = twice_kinetic(bodies) > (1 + most_gain) * kinetic;
    integrate_poses(bodies, h);
    const std::vector<double>& C = poses.errors();
    const double largest = errors_met_.back();
    if (n == 0) first = largest;
    if (!gains && largest < least && (largest <= most || largest < small_share * first)) {
      least = largest;
      keep_best(bodies);
    }
    if (largest <= most || n == most_corrections || !std::isfinite(largest)) return least;
    secants_.correction(C, double(h), rates_);
    poses.change_rates(rates_);
    for (int slot = 0; slot < bodies.slots(); ++slot)
      bodies.at(slot).x = start_[slot].x, bodies.at(slot).q = start_[slot].q;
  }
}

// Halves the velocities of the bodies at joints that this step has opened: in their old poses these
// joints were closed. Returns false if there are none.
bool DirectSolver::halve(Bodies& bodies, double most, const Append& append) {
  const std::vector<double>& C = Poses(*this, bodies, append).errors();
  at_open_.assign(std::size_t(bodies.slots()), false);
  for (const Inside& one : inside_)
    for (int r = one.block->first; r < one.block->first + one.block->rows; ++r)
      if (small_share * std::abs(C[r]) > std::max(most, std::abs(double(blocks_->C[r]))))
        at_open_[one.block->body1] = at_open_[one.block->body2] = true;
  for (int slot = 0; slot < bodies.slots(); ++slot)
    if (at_open_[slot]) bodies.at(slot).v /= real(2), bodies.at(slot).w /= real(2);
  ++report_.halved;
  return std::find(at_open_.begin(), at_open_.end(), true) != at_open_.end();
}

// Stores velocities and impulses that may have to be restored.
void DirectSolver::keep_best(Bodies& bodies) {
  best_.assign(bodies.data(), bodies.data() + bodies.slots());
  impulses_.clear();
  for (const Inside& one : inside_)
    impulses_.insert(impulses_.end(), one.block->impulse, one.block->impulse + one.block->rows);
}

void DirectSolver::back_to_best(Bodies& bodies) const {
  for (int slot = 0; slot < bodies.slots(); ++slot)
    bodies.at(slot).v = best_[slot].v, bodies.at(slot).w = best_[slot].w;
  const real* impulse = impulses_.data();
  for (const Inside& one : inside_) {
    std::copy(impulse, impulse + one.block->rows, one.block->impulse);
    impulse += one.block->rows;
  }
}

// Makes and factors A for the given rows and the inertias at the present poses.
void DirectSolver::factor_at(const Bodies& bodies, const std::vector<Row>& J) {
  rows_of_J_ = J.data();
  for (int slot = 0; slot < bodies.slots(); ++slot) {
    Body body = bodies.at(slot);
    if (body.is_static()) continue;
    if (pulls_[slot].force_lever > 0)
      body.inverse_inertia_local = pulls_[slot].slowed.inverse_inertia_local;
    const mat3 I = inverse_inertia(body);
    masses_[slot].angular = {I[0][0], I[1][1], I[2][2], I[1][0], I[2][0], I[2][1]};
  }
  place_rows();
  factor_now();
}

// Newton's method with the factor of each new pose. A correction that makes the errors larger is
// halved. If the errors do not vanish, the best velocities are kept.
bool DirectSolver::project(Bodies& bodies, real h, double most, const Append& append) {
  const auto move = [&] {
    for (int slot = 0; slot < bodies.slots(); ++slot)
      bodies.at(slot).x = start_[slot].x, bodies.at(slot).q = start_[slot].q;
    integrate_poses(bodies, h);
  };
  at_start_ = masses_;
  double last = std::numeric_limits<double>::infinity(), share = 1;
  bool closed = false;
  keep_best(bodies);
  for (int n = 0; n < most_corrections; ++n) {
    move();
    new_J_ = blocks_->J;
    Poses poses(*this, bodies, append, &new_J_);
    const std::vector<double>& C = poses.errors();
    closed = errors_met_.back() <= most;
    if (closed || !std::isfinite(errors_met_.back())) break;
    if (errors_met_.back() < last) {
      last = errors_met_.back(), share = 1;
      keep_best(bodies);
      in_vain_ = C;
      factor_at(bodies, new_J_);
    } else {
      share /= 2;
      back_to_best(bodies);
    }
    x_ = in_vain_;
    for (double& rate : x_) rate *= -share / double(h);
    change_rates(bodies, x_);
    ++report_.corrections;
  }
  if (!closed) {
    back_to_best(bodies);
    move();
  }
  masses_ = at_start_;
  rows_of_J_ = blocks_->J.data();
  place_rows();
  factored_ = false;
  return closed;
}

}  // namespace joints
