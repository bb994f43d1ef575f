// Exercise 9.6: the iteration in parts that a mistake may change.
#pragma once

#include "tests/09_direct/newton_cases.h"

namespace joints::testing {

/// The iteration, each part of which a mistake may change.
struct NewtonReference {
  NewtonCase c;
  using Norm = Call<double(const std::vector<double>&)>;
  Norm norm = [](const std::vector<double>& C) {
    double largest = 0;
    for (const double a : C) largest = std::max(largest, std::abs(a));
    return largest;
  };
  Call<double(double C, double h)> rate = [](double C, double h) { return -C / h; };
  double own_tolerance = 0;  ///< if not 0, it replaces the argument
  double poor = poor_contraction;
  bool strictly_near = false, strictly_poor = false, asks_near = true, asks_poor = true;
  bool poor_first = false, moves_first = true;
  bool moves_again = false, start_once = false, changes = true, keeps_start = true;
  bool last_by_first = false, sizes_of_rates = false;
  enum class Back { none, x, q, pose, all } back = Back::all;
  /// After the last correction: right, or these without asking errors().
  enum class End { right, stay, true_unseen, false_unseen } end = End::right;
  enum class Result { right, poor_is_true, end_is_true, near_is_false, always_false } result =
      Result::right;
  int more = 0, asks = 1, first_back = 0;
  int least = 0;  ///< -1: without iterations it goes on without an end
  double move_h = 1, last_h = 1;  ///< of the moves before corrections, and of the last one
  double first_last = std::numeric_limits<double>::infinity();
  bool asks_before = false, poor_breaks = false, poor_late = false, changes_twice = false;
  bool zero_does_nothing = false, keeps_largest = false, start_moved = false;
  bool near_of_last = false, change_first = false, count_first = false;
  int last_back = 0;  ///< so many at the end are not put back

  bool move(Bodies& bodies, double h, int iterations, double tolerance, Corrector& corrector,
            std::vector<Body>& start) const {
    if (zero_does_nothing && iterations == 0) return true;
    std::vector<Body> own;
    const auto keep = [&] {
      own.assign(bodies.data(), bodies.data() + bodies.slots());
      if (keeps_start) start = own;
    };
    const auto answer = [&](bool right) { return result != Result::always_false && right; };
    double last = first_last, before = 0;
    const double enough = own_tolerance > 0 ? own_tolerance : tolerance;
    const auto near = [&](double largest) {
      return strictly_near ? largest < enough : largest <= enough;
    };
    const int most = std::max(least, iterations + more);
    for (int n = 0; n < 99; ++n) {
      if (n == 0 || !start_once) keep();
      if (n == most && end == End::stay) return true;
      if (moves_first) integrate_poses(bodies, real((n < most ? move_h : last_h) * h));
      if (start_moved) keep();
      if (n == most && end != End::right) return end == End::true_unseen;
      for (int again = 1; again < asks; ++again) corrector.errors();
      std::vector<double>& rates = corrector.errors();
      if (asks_before) integrate_poses(bodies, real(h));
      const double now = norm(rates) / (sizes_of_rates ? h : 1);
      const double largest = keeps_largest ? std::max(before, now) : now;
      before = largest;
      for (double& C : rates) C = rate(C, h);
      const bool is_poor = strictly_poor ? !(largest < poor * last) : !(largest <= poor * last);
      if (count_first && n == most) return false;
      if (asks_poor && poor_first && is_poor) return false;
      if ((asks_near || n == most) && near(near_of_last ? last : largest)) {
        if (moves_again) integrate_poses(bodies, real(h));
        return answer(result != Result::near_is_false);
      }
      if (n == most) return result == Result::end_is_true;
      if (asks_poor && is_poor) {
        if (poor_late) corrector.change_rates(rates);
        if (!poor_breaks) return result == Result::poor_is_true;
        integrate_poses(bodies, real(h));
        return near(norm(corrector.errors()));
      }
      if (!(last_by_first && n > 0)) last = largest;
      const auto change = [&] {
        if (changes) corrector.change_rates(rates);
        if (changes_twice) corrector.change_rates(rates);
      };
      if (change_first) change();
      for (int k = first_back; k < bodies.slots() - last_back; ++k) {
        Body& body = bodies.at(k);
        if (back == Back::all) body = own[std::size_t(k)];
        if (back == Back::x || back == Back::pose) body.x = own[std::size_t(k)].x;
        if (back == Back::q || back == Back::pose) body.q = own[std::size_t(k)].q;
      }
      if (!change_first) change();
    }
    return false;
  }
};

}  // namespace joints::testing
