// A single island where Newton's method with the factor of the step has failed: secants, factors of
// the new poses, and a slower motion.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "direct/positions.h"

namespace joints {

// Largest number of corrections by secants, and of those with factors of the new poses.
static constexpr int most_corrections = 20;
// Corrections by secants that add more than this fraction to the kinetic energy are not used: they
// have found another pose than the next one.
static constexpr double most_gain = 0.01;
// Corrections with factors of new poses that multiply it by more than this have found a wrong pose.
static constexpr double most_growth = 4;
// An error is small compared to another one if it is less than this fraction of it.
static constexpr double small_fraction = 0.1;
// A correction with the factor of a new pose rotates no body by more than this [rad].
static constexpr double most_turn = 2;
// How often velocities are halved at most if no correction closes the joints.
static constexpr int most_halved = 4;

// The change of the angular velocity that rotates the pose at the end of the step by h times
// `change`, if the body rotates by `phi` [rad] in the step: rotations do not simply add up.
static vec3 as_spin(const vec3& change, const vec3& phi) {
  const real angle = std::clamp(length(phi), real(0.01), std::numbers::pi_v<real>);
  const vec3 once = cross(phi, change);
  return change - once / real(2) +
         (1 - angle / 2 / std::tan(angle / 2)) / (angle * angle) * cross(phi, once);
}

void Positions::move_bodies() {
  for_bodies([&](Body& body, int slot) {
    own_.start[slot] = body;
    integrate_pose(body, h_);
  });
}

void Positions::move_back() {
  for_bodies([&](Body& body, int slot) { body = own_.start[slot]; });
}

void Positions::keep_best() {
  own_.best.clear();
  for_bodies([&](Body& body, int) { own_.best.push_back(body); });
  own_.best_impulses = islands_.list[from_].system.impulse;
}

void Positions::back_to_best() {
  auto best = own_.best.begin();
  for_bodies([&](Body& body, int) { body.v = best->v, body.w = best->w, ++best; });
  islands_.list[from_].system.impulse = own_.best_impulses;
}

double Positions::next_error() { return own_.errors_met.emplace_back(largest(own_.C)); }

// Twice the kinetic energy [J].
double Positions::twice_kinetic() {
  double sum = 0;
  for_bodies([&](Body& body, int) {
    const vec3 w = to_local(body, body.w);
    sum += double(dot(body.v, body.v) / body.inverse_mass +
                  dot(w / body.inverse_inertia_local, w));
  });
  return sum;
}

bool Positions::move_alone() {
  Memory::Try& now = own_.tries[from_];
  const auto last = corrections_.last.begin() + base_;
  const auto expected = corrections_.expected.begin() + base_;
  const auto stored = own_.expected.begin() + base_;
  const int rows = islands_.list[from_].rows;
  now.moving = true;
  zeros(own_.C, std::size_t(rows));
  for_bodies([&](Body& body, int slot) { body = own_.begin[slot]; });
  const double kinetic = twice_kinetic();
  double slow = 0;  // as if each body corrected ten times what need not be corrected
  for_bodies([&](Body& body, int) {
    const vec3 moments = real(1) / body.inverse_inertia_local;
    slow += double(1 / body.inverse_mass + std::max({moments.x, moments.y, moments.z}));
  });
  const double most_kinetic =
      most_growth * kinetic + slow * std::pow(10 * now.most / double(h_), 2);
  islands_.list[from_].system.impulse = own_.impulses[from_];
  keep_best();
  std::copy_n(stored, rows, expected);
  const double least = move_by_secants(now.most);
  if (least <= now.most) return true;
  ++own_.report.projected;
  back_to_best();
  if (std::isinf(least)) {
    zeros(own_.rates, std::size_t(rows));
    for (int r = 0; r < rows; ++r) own_.rates[r] = -double(stored[r]);
    change_rates(own_.rates);
  }
  const auto scale_speeds = [&](real factor) {
    for_bodies([&](Body& body, int) {
      for (vec3* velocity : {&body.v, &body.w, &body.precession}) *velocity *= factor;
    });
    ++own_.report.halved;
  };
  bool gained = false;
  for (int n = 0;; ++n) {
    const bool closed = project(now.most);
    gained = twice_kinetic() > most_kinetic;
    now.exact = closed && !gained;
    if (now.exact || n == most_halved || !(gained || opened(now.most))) break;
    move_back();
    scale_speeds(real(0.5));
  }
  if (gained) scale_speeds(real(std::sqrt(kinetic / twice_kinetic())));
  const double enough = std::max(kinetic, (most_kinetic - most_growth * kinetic));
  own_.report.changed =
      std::max(own_.report.changed, std::abs(twice_kinetic() - kinetic) / enough);
  std::fill_n(last, rows, real(0));
  std::fill_n(expected, rows, real(0));
  return now.exact;
}

// By how much the last correction changes the rotation of a body in the step at most [rad].
double Positions::largest_change() {
  double largest = 0;
  auto spin = own_.spins.begin();
  for_bodies([&](Body& body, int) {
    largest = std::max(largest, double(h_ * length(body.w - *spin++)));
  });
  return largest;
}

// True if the errors are larger than in the old poses.
bool Positions::opened(double most) {
  evaluate(false);
  double before = most / small_fraction;
  const Island& own = islands_.list[from_];
  for (int n = own.first; n < own.end; ++n) {
    const int k = islands_.order()[n], row = islands_.at(k).row - base_;
    for (int i = 0; i < list_[k].rows; ++i)
      if (own_.C[row + i] != 0)
        before = std::max(before, std::abs(double(blocks_.C[list_[k].first + i])));
  }
  return largest(own_.C) > before;
}

// Returns the largest error that the best velocities leave, or infinity if they are no better
// than those of the beginning. Bounded rows exclude secants: a limit that a correction exceeds
// would have to change its side.
double Positions::move_by_secants(double most) {
  const double kinetic = twice_kinetic();
  double least = JointSystem::infinite, first = 0;
  if (!islands_.list[from_].system.bounded.empty()) return least;
  own_.secants.clear(std::size_t(islands_.list[from_].rows), most_corrections);
  for (int n = 0;; ++n) {
    const bool gains = twice_kinetic() > (1 + most_gain) * kinetic;
    move_bodies();
    evaluate(false);
    const double now = next_error();
    if (n == 0) first = now;
    const bool better = !gains && now < least && (now <= most || now < small_fraction * first);
    if (better) least = now;
    if (better && now <= most) return least;
    move_back();
    if (better) keep_best();
    if (now <= most || n == most_corrections || !std::isfinite(now)) return least;
    own_.secants.correction(own_.C, double(h_), own_.rates);
    change_rates(own_.rates);
  }
}

// Newton's method with the factor of each new pose. Each impulse acts along the rows of that pose,
// and rotates the bodies there. A correction that makes the errors larger is halved. If the errors
// do not vanish, the best velocities are kept.
bool Positions::project(double most) {
  Island& island = islands_.list[from_];
  JointSystem& system = island.system;
  double last = JointSystem::infinite, fraction = 1;
  bool closed = false;
  keep_best();
  for (int n = 0; n < most_corrections; ++n) {
    move_bodies();
    evaluate(true);
    const double now = next_error();
    closed = now <= most;
    if (closed || !std::isfinite(now)) break;
    if (now < last) {
      last = now, fraction = 1;
      own_.last_C = own_.C;
      for (BoundedRow& bound : system.bounded)
        if (C_of(island, bound) != 0) bound.side = Side::free;  // a limit that is exceeded here
      for (std::size_t k = 0; k < own_.met.size(); ++k)
        if (own_.met[k] >= 0)
          system.set_rows(system.blocks[islands_.at(own_.met[k]).block],
                          &own_.poses.J[own_.poses.list[k].first]);
      inertia_.set_masses(island, bodies_);
      system.factor_now();
      move_back();
      keep_best();
    } else {
      move_back();
      fraction /= 2;
      back_to_best();
    }
    own_.rates = own_.last_C;
    for (double& rate : own_.rates) rate *= -fraction / double(h_);
    own_.spins.clear();
    for_bodies([&](Body& body, int) { own_.spins.push_back(body.w); });
    change_rates(own_.rates);
    if (const double turn = largest_change(); turn > most_turn) {
      back_to_best();
      for (double& rate : own_.rates) rate *= most_turn / turn;
      change_rates(own_.rates);
    }
    auto spin = own_.spins.begin();
    for_bodies([&](Body& body, int) {
      body.w = *spin + as_spin(body.w - *spin, h_ * *spin);
      ++spin;
    });
  }
  system.factored = false;  // not that of the step
  if (closed) return true;
  move_back();
  back_to_best();
  move_bodies();
  return false;
}

}  // namespace joints
