// The direct solver moves the bodies: with the factor of the step, and single islands by secants if
// this is not enough, and at last with the factors of new poses.
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
constexpr double small_fraction = 0.1;
// How often velocities are halved at most if no correction closes the joints.
constexpr int most_halved = 4;
// Rounding errors of C are at most about this times epsilon times the largest coordinate.
constexpr double of_rounding = 8;

// False for a row of zeros, as of points that coincide: no impulse along it corrects anything.
bool has_direction(const Row& J) {
  const vec3 none(0);
  return J.v1 != none || J.w1 != none || J.v2 != none || J.w2 != none;
}

double largest(const std::vector<double>& C) {
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
// without the correction predicted for the poses. If this does not close the joints, a body is too
// fast for the step, and is slowed down.
class DirectSolver::Positions : public Corrector {
 public:
  Positions(DirectSolver& solver, Bodies& bodies, real h, const Append& append)
      : solver_(solver), islands_(solver.islands_), own_(solver.motion_), bodies_(bodies), h_(h),
        append_(append), expected_(solver.blocks_->memory.rates) {}

  // Moves all bodies. Returns true if all joints are closed.
  bool move() {
    begin();
    move_onto_constraints(bodies_, double(h_), solver_.newton, 0, *this, own_.start);
    alone_ = true;
    bool closed = true;
    for (int k = 0; k < int(own_.tries.size()); ++k)
      if (!own_.tries[k].exact) closed = move_alone(k) && closed;
    return closed;
  }

  // Errors of all islands that move. Those that are closed, or do not approach it, stay as they
  // are.
  std::vector<double>& errors() override {
    evaluate(0, int(own_.tries.size()), false);
    for (std::size_t k = 0; k < own_.tries.size(); ++k) {
      Motion::Try& now = own_.tries[k];
      const auto from = own_.C.begin() + islands_.islands()[k].first_row;
      const auto end = from + islands_.islands()[k].rows;
      double most = 0;
      for (auto C = from; C != end; ++C) most = std::max(most, std::abs(*C));
      now.exact = now.exact || (now.moving && most <= now.most);
      now.moving = now.moving && !now.exact && most <= poor_contraction * now.last;
      now.last = most;
      if (!now.moving) std::fill(from, end, 0.0);
    }
    return own_.C;
  }
  void change_rates(std::vector<double>& rates) override {
    change(0, int(own_.tries.size()), rates);
  }

 private:
  void begin() {
    own_.impulses.resize(std::size_t(islands_.rows()));
    own_.expected.assign(expected_.begin(), expected_.end());
    own_.moved.assign(std::size_t(bodies_.slots()), false);
    own_.tries.clear();
    for (int k = 0; k < int(islands_.islands().size()); ++k) {
      const bool solved = pair_of(k) && !pair_of(k)->iterated;
      const double infinite = std::numeric_limits<double>::infinity();
      own_.tries.push_back({0, infinite, solved, !solved});
      if (!solved) continue;
      if (!pair_of(k)->factored) pair_of(k)->factor_now();  // sides were still wrong
      real size = 0;  // errors that are only rounding errors need not be corrected
      for_bodies(k, [&](Body& body, int) {
        const vec3 x = abs(body.x);
        size = std::max({size, x.x, x.y, x.z});
      });
      own_.tries.back().most = std::max(solver_.tolerance * double(h_) * double(h_),
                                        of_rounding * double(epsilon * size));
      keep_impulses(k);
    }
  }

  // ---- islands from, ..., end - 1 ---------------------------------------------------------------

  IslandPair* pair_of(int island) {
    const int pair = islands_.islands()[island].pair;
    return pair < 0 ? nullptr : &islands_.pairs[pair];
  }
  template <class F>
  void for_bodies(int island, const F& f) {
    const IslandPair& pair = *pair_of(island);
    for (int k = 0; k < int(pair.bodies.size()); ++k)
      if (const int slot = pair.bodies[k][islands_.islands()[island].lane]; pair.moves[k])
        f(bodies_.at(slot), slot);
  }

  // C of all rows at the present poses, 0 for rows without an error. \param rows also append the
  // rows at these poses, and free limits that are exceeded
  void evaluate(int from, int end, bool rows) {
    const int base = end > from ? islands_.islands()[from].first_row : 0;
    if (alone_) for_bodies(from, [&](Body&, int slot) { own_.moved[slot] = true; });
    own_.poses.clear();
    own_.poses.errors_only = !rows;
    append_(own_.poses, alone_ ? &own_.moved : nullptr);
    if (alone_) for_bodies(from, [&](Body&, int slot) { own_.moved[slot] = false; });
    int count = 0;
    for (int k = from; k < end; ++k) count += islands_.islands()[k].rows;
    zeros(own_.C, std::size_t(count));
    own_.met.clear();
    const std::vector<Block>& list = solver_.blocks_->list;
    std::size_t k = 0;
    for (const Block& now : own_.poses.list) {
      own_.met.push_back(-1);
      const std::size_t begin = k;  // nearly always the next one
      while (list[k].impulse != now.impulse)
        if (k = (k + 1) % list.size(); k == begin) break;
      const auto& [island, number, row] = islands_.at(int(k));
      if (list[k].impulse != now.impulse || island < from || island >= end) continue;
      if (!own_.tries[island].moving && !alone_) continue;
      own_.met.back() = int(k);
      const Block& block = list[k];
      if (!block.target.holds_position || pair_of(island)->is_spring(number, lane_of(island)))
        continue;
      double* const C = &own_.C[row - base];
      for (int i = 0; i < block.rows; ++i)
        if (has_direction(solver_.blocks_->J[block.first + i]))
          C[i] = double(own_.poses.C[now.first + i]);
      if (block.target.rate != 0) C[block.rows - 1] = 0;  // it rebounds
    }
    for_bounded(from, end, [&](BoundedRow& bound, const LaneBlock& at) {
      double& C = own_.C[at.row[bound.lane] + at.rows - 1 - base];
      const RowTarget& target = list[at.block[bound.lane]].target;
      if (rows && C < 0 && target.one_sided()) bound.side = Side::free;  // limit exceeded
      if (bound.side != Side::free) C = 0;
    });
    solver_.errors_met_.push_back(largest(own_.C));
  }
  int lane_of(int island) const { return islands_.islands()[island].lane; }
  template <class F>
  void for_bounded(int from, int end, const F& f) {
    for (int k = from; k < end; ++k)
      if (IslandPair* const pair = pair_of(k))
        for (BoundedRow& bound : pair->bounded)
          if (bound.lane == lane_of(k)) f(bound, pair->blocks[bound.block]);
  }

  // Changes velocities and impulses so that J V changes by `rates`, with the present factors.
  void change(int from, int end, const std::vector<double>& rates) {
    ++solver_.report_.corrections;
    const int base = islands_.islands()[from].first_row;
    real* const expected = expected_.data() + base;
    for (std::size_t r = 0; r < rates.size(); ++r) expected[r] += real(rates[r]);
    for (int k = from; k < end; ++k) {
      IslandPair* const pair = pair_of(k);
      const int other = pair ? pair->islands[1 - lane_of(k)] : -1;
      const bool both = other >= from && other < end;
      if (!pair || pair->iterated || (both && lane_of(k) == 1)) continue;
      for (int n = 0; n < int(pair->blocks.size()); ++n)
        for (const int lane : {0, 1}) {
          const LaneBlock& block = pair->blocks[n];
          const bool used = both || lane == lane_of(k);
          for (int i = 0; i < block.rows; ++i)
            pair->x[pair->A.nodes[n].row + i][lane] =
                used && i < block.own[lane] ? rates[block.row[lane] - base + i] : 0;
        }
      pair->load(bodies_);
      pair->change();
      pair->store(bodies_, *solver_.blocks_);
    }
  }

  // ---- a single island --------------------------------------------------------------------------

  bool move_alone(int island) {
    const double most = own_.tries[island].most;
    const int from = islands_.islands()[island].first_row;
    const int rows = islands_.islands()[island].rows;
    own_.best.resize(std::size_t(bodies_.slots()));
    for_bodies(island, [&](Body& body, int slot) { own_.best[slot] = body = own_.start[slot]; });
    back_to_best(island);
    std::copy_n(own_.expected.begin() + from, rows, expected_.begin() + from);
    const double least = move_by_secants(island, most);
    if (least <= most) return true;
    back_to_poses(island);
    back_to_best(island);
    if (std::isinf(least)) {
      own_.rates.assign(own_.expected.begin() + from, own_.expected.begin() + from + rows);
      for (double& rate : own_.rates) rate = -rate;
      change(island, island + 1, own_.rates);
    }
    bool closed = project(island, most);
    for (int n = 0; n < most_halved && !closed && halve(island, most); ++n)
      closed = project(island, most);
    std::fill_n(expected_.begin() + from, rows, real(0));
    return closed;
  }

  void back_to_poses(int island) {
    for_bodies(island, [&](Body& body, int slot) {
      body.x = own_.start[slot].x, body.q = own_.start[slot].q;
    });
  }
  void move_island(int island) {
    for_bodies(island, [&](Body& body, int) { integrate_pose(body, h_); });
  }
  // Twice the kinetic energy [J].
  double twice_kinetic(int island) {
    double sum = 0;
    for_bodies(island, [&](Body& body, int) {
      const vec3 w = to_local(body, body.w);
      sum += double(dot(body.v, body.v) / body.inverse_mass +
                    dot(w / body.inverse_inertia_local, w));
    });
    return sum;
  }
  // Stores velocities and impulses that may have to be restored.
  void keep_best(int island) {
    for_bodies(island, [&](Body& body, int slot) { own_.best[slot] = body; });
    keep_impulses(island);
  }
  void keep_impulses(int island) {
    for_impulses(island, [](double& stored, const double& now) { stored = now; });
  }
  void back_to_best(int island) {
    for_bodies(island, [&](Body& body, int slot) {
      body.v = own_.best[slot].v, body.w = own_.best[slot].w;
    });
    for_impulses(island, [](double& stored, double& now) { now = stored; });
    pair_of(island)->load(bodies_);
    pair_of(island)->store(bodies_, *solver_.blocks_);
  }
  template <class F>
  void for_impulses(int island, const F& f) {
    IslandPair& pair = *pair_of(island);
    const int lane = lane_of(island);
    for (std::size_t k = 0; k < pair.blocks.size(); ++k)
      for (int i = 0; i < pair.blocks[k].own[lane]; ++i) {
        TwoLanes& both = pair.impulse[pair.A.nodes[k].row + i];
        double now = both[lane];
        f(own_.impulses[pair.blocks[k].row[lane] + i], now);
        both[lane] = now;
      }
  }

  // Returns the largest error that the best velocities leave, or infinity if they are no better
  // than those of the beginning. Bounded rows exclude secants: a limit that a correction exceeds
  // would have to change its side.
  double move_by_secants(int island, double most) {
    const double kinetic = twice_kinetic(island);
    double least = std::numeric_limits<double>::infinity(), first = 0;
    bool bounded = false;
    for_bounded(island, island + 1, [&](BoundedRow&, const LaneBlock&) { bounded = true; });
    if (bounded) return least;
    own_.secants.clear(std::size_t(islands_.islands()[island].rows), most_corrections);
    for (int n = 0;; ++n) {
      const bool gains = twice_kinetic(island) > (1 + most_gain) * kinetic;
      move_island(island);
      evaluate(island, island + 1, false);
      const double now = largest(own_.C);
      if (n == 0) first = now;
      if (!gains && now < least && (now <= most || now < small_fraction * first)) {
        least = now;
        keep_best(island);
      }
      if (now <= most || n == most_corrections || !std::isfinite(now)) return least;
      own_.secants.correction(own_.C, double(h_), own_.rates);
      change(island, island + 1, own_.rates);
      back_to_poses(island);
    }
  }

  // Newton's method with the factor of each new pose. A correction that makes the errors larger is
  // halved. If the errors do not vanish, the best velocities are kept.
  bool project(int island, double most) {
    IslandPair& pair = *pair_of(island);
    double last = std::numeric_limits<double>::infinity(), fraction = 1;
    bool closed = false;
    keep_best(island);
    for (int n = 0; n < most_corrections; ++n) {
      back_to_poses(island);
      move_island(island);
      evaluate(island, island + 1, true);
      const double now = largest(own_.C);
      closed = now <= most;
      if (closed || !std::isfinite(now)) break;
      if (now < last) {
        last = now, fraction = 1;
        keep_best(island);
        own_.last_C = own_.C;
        for (std::size_t k = 0; k < own_.met.size(); ++k)
          if (own_.met[k] >= 0)
            pair.set_rows(islands_.at(own_.met[k]).block, lane_of(island),
                          &own_.poses.J[own_.poses.list[k].first]);
        solver_.set_masses(pair, bodies_, lane_of(island));
        pair.factor_now();
      } else {
        fraction /= 2;
        back_to_best(island);
      }
      own_.rates = own_.last_C;
      for (double& rate : own_.rates) rate *= -fraction / double(h_);
      change(island, island + 1, own_.rates);
    }
    pair.factored = false;  // not that of the step
    if (closed) return true;
    back_to_best(island);
    back_to_poses(island);
    move_island(island);
    return false;
  }

  // Halves the velocities of the bodies at joints that this step has opened: in their old poses
  // these joints were closed. Returns false if there are none.
  bool halve(int island, double most) {
    evaluate(island, island + 1, false);
    own_.open.assign(std::size_t(bodies_.slots()), false);
    const JointIslands::Island& own = islands_.islands()[island];
    for (int n = own.first; n < own.end; ++n) {
      const Block& block = solver_.blocks_->list[islands_.order()[n]];
      const int row = islands_.at(islands_.order()[n]).row - own.first_row;
      for (int i = 0; i < block.rows; ++i)
        if (small_fraction * std::abs(own_.C[row + i]) >
            std::max(most, std::abs(double(solver_.blocks_->C[block.first + i]))))
          own_.open[block.body1] = own_.open[block.body2] = true;
    }
    bool any = false;
    for_bodies(island, [&](Body& body, int slot) {
      if (own_.open[slot]) body.v /= real(2), body.w /= real(2), any = true;
    });
    solver_.report_.halved += any;
    return any;
  }

  DirectSolver& solver_;
  JointIslands& islands_;
  Motion& own_;
  Bodies& bodies_;
  real h_;
  const Append& append_;
  std::vector<real>& expected_;
  bool alone_ = false;  // single islands move
};

void DirectSolver::advance(Bodies& bodies, real h, const Append& append) {
  blocks_of(bodies);  // rejects other bodies
  report_.corrections = report_.halved = 0;
  report_.moved_exactly = false;
  errors_met_.clear();
  if (newton > 0) {
    report_.moved_exactly = Positions(*this, bodies, h, append).move() && !report_.iterated;
    if (!report_.iterated) return;
    for (int slot = 0; slot < bodies.slots(); ++slot)  // `instead` moves all bodies
      bodies.at(slot).x = motion_.start[slot].x, bodies.at(slot).q = motion_.start[slot].q;
  }
  report_.iterated ? instead.advance(bodies, h, append) : integrate_poses(bodies, h);
}

}  // namespace joints
