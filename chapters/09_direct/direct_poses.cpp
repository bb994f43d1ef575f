// The direct solver moves the bodies: with the factor of the step, and single islands by secants if
// this is not enough, and at last with the factors of new poses.
#include <algorithm>
#include <cmath>
#include <span>

#include "chapters/09_direct/direct_solver.h"

namespace joints {

namespace {

// Largest number of corrections by secants, and of those with factors of the new poses.
constexpr int most_corrections = 20;
// Corrections by secants that add more than this fraction to the kinetic energy are not used: they
// have found another pose than the next one.
constexpr double most_gain = 0.01;
// An error is small compared to another one if it is less than this fraction of it.
constexpr double small_fraction = 0.1;
// How often velocities are halved at most if no correction closes the joints.
constexpr int most_halved = 4;
// Rounding errors of C are at most about this times epsilon times the largest coordinate.
constexpr double of_rounding = 8;

double largest(std::span<const double> C) {
  double out = 0;
  for (const double one : C) out = std::max(out, std::abs(one));
  return out;
}

}  // namespace

// If Newton's method with the factor of the step fails in an island, secants take over: they
// converge where an iteration multiplies some errors by nearly 1, as it does near the singular pose
// of a linkage. Their impulses still act along the rows of the step, which keeps the energy. If
// they fail as well, the factors of the new poses are used. They begin with the best velocities of
// the secants or, if these are no good either, with those that solve the velocity equations,
// without the correction predicted for the poses. If this does not close the joints, a body turns
// too far in the step, and the island is slowed down.
class DirectSolver::Positions : public Corrector {
 public:
  Positions(DirectSolver& solver, Bodies& bodies, real h, const Append& append)
      : solver_(solver), list_(solver.blocks_->list), islands_(solver.islands_),
        expected_(solver.blocks_->memory.corrections), own_(solver.motion_), bodies_(bodies), h_(h),
        append_(append) {}

  // Moves all bodies. Returns true if all joints are closed.
  bool move() {
    const int count = int(islands_.islands().size());
    own_.expected.assign(expected_.begin(), expected_.end());
    own_.moved.assign(std::size_t(bodies_.slots()), false);
    own_.tries.assign(std::size_t(count), {});
    for (int k = 0; k < count; ++k) {
      choose(k, k + 1);
      begin();
    }
    choose(0, count);
    zeros(own_.C, std::size_t(islands_.rows()));
    find_corrected();
    move_onto_constraints(bodies_, double(h_), solver_.newton, 0, *this, own_.start);
    bool closed = true;
    for (int k = 0; k < count; ++k) {
      if (own_.tries[k].exact) continue;
      choose(k, k + 1);
      closed = move_alone() && closed;
    }
    choose(0, count);
    expect();
    return closed;
  }

  // Errors of all islands that move. Those that are closed, or do not approach it, stay as they
  // are.
  std::vector<double>& errors() override {
    evaluate(false);
    double& met = solver_.errors_met_.emplace_back(0);
    for (std::size_t k = 0; k < own_.tries.size(); ++k) {
      Motion::Try& now = own_.tries[k];
      const std::span C(&own_.C[islands_.islands()[k].first_row], islands_.islands()[k].rows);
      const double error = largest(C);
      met = std::max(met, error);
      now.exact = now.exact || (now.moving && error <= now.most);
      now.moving = now.moving && !now.exact && error <= poor_contraction * now.last;
      now.last = error;
      if (!now.moving) std::fill(C.begin(), C.end(), 0.0);
    }
    return own_.C;
  }
  void change_rates(std::vector<double>& rates) override {
    ++solver_.report_.corrections;
    Correction* const all = expected_.data() + base_;
    for (std::size_t r = 0; r < rates.size(); ++r) all[r].next += real(rates[r]);
    solver_.change(bodies_, from_, end_, rates);
  }

 private:
  // ---- the chosen islands -----------------------------------------------------------------------

  void choose(int from, int end) {
    from_ = from, end_ = end;
    base_ = from < end ? islands_.islands()[from].first_row : 0;
  }
  // Calls f(pair, lane) for all of them that this solver solves.
  template <class F>
  void for_islands(const F& f) {
    for (int k = from_; k < end_; ++k)
      if (IslandPair* const pair = islands_.pair_of(k); pair && !pair->iterated)
        f(*pair, islands_.islands()[k].lane);
  }
  template <class F>
  void for_bodies(const F& f) {
    for_islands([&](IslandPair& pair, int lane) {
      for (std::size_t k = 0; k < pair.bodies.size(); ++k)
        if (pair.moves[k]) f(bodies_.at(pair.bodies[k][lane]), pair.bodies[k][lane]);
    });
  }
  template <class F>
  void for_bounded(const F& f) {
    for_islands([&](IslandPair& pair, int lane) {
      for (BoundedRow& bound : pair.bounded)
        if (bound.lane == lane) f(bound, pair.blocks[bound.block]);
    });
  }

  bool moving(int island) const {
    return island >= from_ && island < end_ && own_.tries[island].moving;
  }
  void mark_moving(bool mark) {
    for_islands([&](IslandPair& pair, int lane) {
      if (!moving(pair.islands[lane])) return;
      for (std::size_t k = 0; k < pair.bodies.size(); ++k)
        if (pair.moves[k]) own_.moved[pair.bodies[k][lane]] = mark;
    });
  }

  // C of all rows of moving islands at the present poses, 0 for rows without an error. \param rows
  // also append the rows at these poses, and free limits that are exceeded
  void evaluate(bool rows) {
    bool some = false;  // not all
    for (int k = 0; k < int(own_.tries.size()); ++k) some = some || !moving(k);
    if (some) mark_moving(true);
    own_.poses.clear();
    own_.poses.errors_only = !rows;
    {
      const std::vector<bool>* const of = some ? &own_.moved : nullptr;
      const HeldMatrices matrices(bodies_, of);
      append_(own_.poses, of);
    }
    if (some) mark_moving(false);
    own_.met.clear();
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
    for_bounded([&](BoundedRow& bound, const LaneBlock& at) {
      double& C = own_.C[at.row[bound.lane] + at.rows - 1 - base_];
      const RowTarget& target = list_[at.block[bound.lane]].target;
      if (rows && C < 0 && target.one_sided()) bound.side = Side::free;  // limit exceeded
      if (bound.side != Side::free) C = 0;
    });
  }

  void to_start() {
    for_bodies([&](Body& body, int slot) {
      body.x = own_.start[slot].x, body.q = own_.start[slot].q;
    });
  }
  void move_bodies() {
    for_bodies([&](Body& body, int) { integrate_pose(body, h_); });
  }
  // Stores velocities and impulses that may have to be restored.
  void keep_best() {
    for_islands([&](IslandPair& pair, int lane) { pair.keep(bodies_, lane); });
  }
  void back_to_best() {
    for_islands([&](IslandPair& pair, int lane) { pair.go_back(bodies_, lane); });
  }
  // The largest error before an iteration.
  double next_error() { return solver_.errors_met_.emplace_back(largest(own_.C)); }
  // Twice the kinetic energy [J].
  double twice_kinetic() {
    double sum = 0;
    for_bodies([&](Body& body, int) {
      const vec3 w = to_local(body, body.w);
      sum += double(dot(body.v, body.v) / body.inverse_mass +
                    dot(w / body.inverse_inertia_local, w));
    });
    return sum;
  }

  // ---- a single island --------------------------------------------------------------------------

  void begin() {
    Motion::Try& now = own_.tries[from_];
    now.exact = true;  // unless this solver solves it
    real size = 0;  // errors that are only rounding errors need not be corrected
    for_islands([&](IslandPair& pair, int) {
      now.moving = true, now.exact = false;
      if (!pair.factored) pair.factor_now();  // sides were still wrong
    });
    for_bodies([&](Body& body, int) {
      const vec3 x = abs(body.x);
      size = std::max({size, x.x, x.y, x.z});
    });
    now.most = std::max(solver_.tolerance * double(h_) * double(h_),
                        of_rounding * double(epsilon * size));
    keep_best();
  }

  // Errors are corrected in rows that hold a position, unless they belong to a spring, rebound, or
  // are zero, as those of points that coincide: no impulse along them corrects anything.
  void find_corrected() {
    zeros(own_.corrected, list_.size());
    for_islands([&](IslandPair& pair, int lane) {
      for (int k = 0; k < int(pair.blocks.size()); ++k) {
        const int block = pair.blocks[k].block[lane];
        if (block < 0 || pair.is_spring(k, lane)) continue;
        const RowTarget& target = list_[block].target;
        const int rows = list_[block].rows - (target.rate != 0);
        const TwoLanes* const original = &pair.A.original[pair.row_of(pair.blocks[k])];
        for (int i = 0; target.holds_position && i < rows; ++i)
          if (original[i][lane] != 0) own_.corrected[block] |= 1 << i;
      }
    });
  }

  // The next corrections of an open chain change as the present ones did. In a closed loop the same
  // ones are expected again: those of rows that depend on others would grow without bound; and
  // beside bounded rows too, which hold still or change sides.
  void expect() {
    for_islands([&](IslandPair& pair, int lane) {
      if (!pair.plan->loops.empty() || !pair.bounded.empty()) return;
      const JointIslands::Island& own = islands_.islands()[pair.islands[lane]];
      for (auto& [last, next] : std::span(expected_).subspan(own.first_row, own.rows)) {
        const real now = next;
        if (last != 0) next += now - last;
        last = now;
      }
    });
  }

  bool move_alone() {
    Motion::Try& now = own_.tries[from_];
    const auto expected = expected_.begin() + base_, stored = own_.expected.begin() + base_;
    const int rows = islands_.islands()[from_].rows;
    now.moving = true;
    zeros(own_.C, std::size_t(rows));
    to_start();
    back_to_best();
    std::copy_n(stored, rows, expected);
    const double least = move_by_secants(now.most);
    if (least <= now.most) return true;
    ++solver_.report_.projected;
    to_start();
    back_to_best();
    if (std::isinf(least)) {
      own_.rates.clear();
      for (int r = 0; r < rows; ++r) own_.rates.push_back(-double(stored[r].next));
      change_rates(own_.rates);
    }
    for (int n = 0; !(now.exact = project(now.most)) && n < most_halved && opened(now.most); ++n) {
      for_bodies([](Body& body, int) { body.v /= real(2), body.w /= real(2); });
      ++solver_.report_.halved;
    }
    std::fill_n(expected, rows, Correction{});
    return now.exact;
  }

  // True if the errors are larger than in the old poses.
  bool opened(double most) {
    evaluate(false);
    double before = most / small_fraction;
    const JointIslands::Island& own = islands_.islands()[from_];
    for (int n = own.first; n < own.end; ++n) {
      const int k = islands_.order()[n], row = islands_.at(k).row - base_;
      for (int i = 0; i < list_[k].rows; ++i)
        if (own_.C[row + i] != 0)
          before = std::max(before, std::abs(double(solver_.blocks_->C[list_[k].first + i])));
    }
    return largest(own_.C) > before;
  }

  // Returns the largest error that the best velocities leave, or infinity if they are no better
  // than those of the beginning. Bounded rows exclude secants: a limit that a correction exceeds
  // would have to change its side.
  double move_by_secants(double most) {
    const double kinetic = twice_kinetic();
    double least = IslandPair::infinite, first = 0;
    bool bounded = false;
    for_bounded([&](BoundedRow&, const LaneBlock&) { bounded = true; });
    if (bounded) return least;
    own_.secants.clear(std::size_t(islands_.islands()[from_].rows), most_corrections);
    for (int n = 0;; ++n) {
      const bool gains = twice_kinetic() > (1 + most_gain) * kinetic;
      move_bodies();
      evaluate(false);
      const double now = next_error();
      if (n == 0) first = now;
      if (!gains && now < least && (now <= most || now < small_fraction * first)) {
        least = now;
        keep_best();
      }
      if (now <= most || n == most_corrections || !std::isfinite(now)) return least;
      own_.secants.correction(own_.C, double(h_), own_.rates);
      change_rates(own_.rates);
      to_start();
    }
  }

  // Newton's method with the factor of each new pose. A correction that makes the errors larger is
  // halved. If the errors do not vanish, the best velocities are kept.
  bool project(double most) {
    IslandPair& pair = *islands_.pair_of(from_);
    const int lane = islands_.islands()[from_].lane;
    double last = IslandPair::infinite, fraction = 1;
    bool closed = false;
    keep_best();
    for (int n = 0; n < most_corrections; ++n) {
      to_start();
      move_bodies();
      evaluate(true);
      const double now = next_error();
      closed = now <= most;
      if (closed || !std::isfinite(now)) break;
      if (now < last) {
        last = now, fraction = 1;
        keep_best();
        own_.last_C = own_.C;
        for (std::size_t k = 0; k < own_.met.size(); ++k)
          if (own_.met[k] >= 0)
            pair.set_rows(islands_.at(own_.met[k]).block, lane,
                          &own_.poses.J[own_.poses.list[k].first]);
        solver_.set_masses(pair, bodies_, lane);
        pair.factor_now();
      } else {
        fraction /= 2;
        back_to_best();
      }
      own_.rates = own_.last_C;
      for (double& rate : own_.rates) rate *= -fraction / double(h_);
      change_rates(own_.rates);
    }
    pair.factored = false;  // not that of the step
    if (closed) return true;
    back_to_best();
    to_start();
    move_bodies();
    return false;
  }

  DirectSolver& solver_;
  const std::vector<Block>& list_;
  JointIslands& islands_;
  std::vector<Correction>& expected_;
  Motion& own_;
  Bodies& bodies_;
  real h_;
  const Append& append_;
  int from_ = 0, end_ = 0, base_ = 0;  // the chosen islands, and their first row
};

void DirectSolver::advance(Bodies& bodies, real h, const Append& append) {
  blocks_of(bodies);  // rejects other bodies
  report_.corrections = report_.projected = report_.halved = 0;
  report_.moved_exactly = false;
  errors_met_.clear();
  if (newton > 0) {
    report_.moved_exactly = Positions(*this, bodies, h, append).move() && !report_.iterated;
    for (const IslandPair& pair : islands_.pairs)
      if (!pair.iterated) pair.store_impulses(*blocks_);
    if (!report_.iterated) return;
    for (int slot = 0; slot < bodies.slots(); ++slot)  // `instead` moves all bodies
      bodies.at(slot).x = motion_.start[slot].x, bodies.at(slot).q = motion_.start[slot].q;
  }
  report_.iterated ? instead.advance(bodies, h, append) : integrate_poses(bodies, h);
}

}  // namespace joints
