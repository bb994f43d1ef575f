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
  double near = negligible, power = 2, poor = poor_contraction;  ///< near times h to that power
  double share = stalled_share;  ///< of the first error, where it stops
  bool strictly_near = false, strictly_poor = false, asks_near = true, asks_poor = true;
  bool poor_first = false, moves_first = true, moves_at_end = true;
  bool moves_again = false, start_each_time = false, changes = true, keeps_start = true;
  bool asks_at_end = false, last_by_first = false;
  enum class Back { none, x, q, pose, all } back = Back::pose;
  enum class Result { right, poor_is_true, poor_is_false, poor_by_last, turned, end_is_false,
                      near_is_false, always_false, by_the_last } result = Result::right;
  int more = 0, asks = 1, first_back = 0;
  double move_h = 1, last_h = 1;  ///< of the moves in the iterations, and of the last one
  double first_last = std::numeric_limits<double>::infinity();
  bool asks_before = false, poor_breaks = false, poor_late = false, changes_twice = false;
  bool zero_does_nothing = false, keeps_largest = false, w_back = false, start_moved = false;
  bool adds_to_start = false, near_of_last = false;
  int last_back = 0;  ///< so many at the end are not put back

  bool move(Bodies& bodies, double h, int iterations, Corrector& corrector,
            std::vector<Body>& start) const {
    const auto keep = [&] {
      if (!adds_to_start) start.clear();
      start.insert(start.end(), bodies.data(), bodies.data() + bodies.slots());
    };
    if (zero_does_nothing && iterations == 0) return true;
    std::vector<Body> own(bodies.data(), bodies.data() + bodies.slots());
    if (keeps_start) keep();
    const auto answer = [&](bool right) {
      return result == Result::right ? right : result != Result::always_false && right;
    };
    double last = first_last, before = 0, first = 0;
    const double enough = near * std::pow(h, power);
    const auto stops = [&](double largest) {
      switch (result) {
        case Result::poor_is_true: return true;
        case Result::poor_is_false:
        case Result::always_false: return false;
        case Result::poor_by_last: return largest <= share * last;
        case Result::by_the_last: return last <= share * first;
        case Result::turned: return !(largest <= share * first);
        default: return largest <= share * first;
      }
    };
    for (int n = 0; n < iterations + more; ++n) {
      if (start_each_time && n > 0) keep(), own = start;
      if (moves_first) integrate_poses(bodies, real(move_h * h));
      if (start_moved && n == 0) keep(), own = start;
      for (int again = 1; again < asks; ++again) corrector.errors();
      std::vector<double>& rates = corrector.errors();
      if (asks_before) integrate_poses(bodies, real(h));
      const double largest = keeps_largest ? std::max(before, norm(rates)) : norm(rates);
      before = largest;
      if (n == 0) first = largest;
      for (double& C : rates) C = rate(C, h);
      const bool is_poor = strictly_poor ? !(largest < poor * last) : !(largest <= poor * last);
      if (asks_poor && poor_first && is_poor) return stops(largest);
      const double asked_near = near_of_last ? last : largest;
      if (asks_near && (strictly_near ? largest < enough : asked_near <= enough)) {
        if (moves_again) integrate_poses(bodies, real(h));
        return answer(result != Result::near_is_false);
      }
      if (asks_poor && !poor_first && is_poor) {
        if (poor_breaks) break;
        if (poor_late) corrector.change_rates(rates);
        return stops(largest);
      }
      if (!(last_by_first && n > 0)) last = largest;
      if (changes) corrector.change_rates(rates);
      if (changes_twice) corrector.change_rates(rates);
      for (int k = first_back; k < bodies.slots() - last_back; ++k) {
        Body& body = bodies.at(k);
        if (back == Back::all) body = own[std::size_t(k)];
        if (back == Back::x || back == Back::pose) body.x = own[std::size_t(k)].x;
        if (back == Back::q || back == Back::pose) body.q = own[std::size_t(k)].q;
        if (w_back) body.w = own[std::size_t(k)].w;
      }
    }
    if (moves_at_end) integrate_poses(bodies, real(last_h * h));
    if (asks_at_end) return norm(corrector.errors()) <= enough;
    return answer(result != Result::end_is_false);
  }
};

}  // namespace joints::testing
