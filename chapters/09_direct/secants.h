// Newton's method without derivatives: learns from its own corrections how errors follow the rates.
// There is nothing to edit here.
#pragma once

#include <cmath>
#include <vector>

/// \addtogroup chapter9
/// @{
namespace joints {

/// The changes of rates that make errors zero. At first it assumes that an error changes by h times
/// the change of its rate. Every correction shows how the errors really change in one direction,
/// and from then on this is used there. Source: Anderson 1965, with an unlimited memory.
class Secants {
 public:
  /// Forgets all corrections.
  void clear() { seen_.clear(), C_.clear(); }

  /// The change of all rates that would make the errors zero. It must be applied before the next
  /// call. \param C the errors now [m or rad] \param h step [s]
  std::vector<double> correction(std::vector<double> C, double h) {
    learn(C);
    C_ = C;
    rates_.assign(C.size(), 0);
    for (const Secant& one : seen_) remove(C, rates_, one);
    for (std::size_t r = 0; r < C.size(); ++r) rates_[r] -= C[r] / h;
    return rates_;
  }

 private:
  struct Secant {
    std::vector<double> C;      // of length 1 and perpendicular to those of all others
    std::vector<double> rates;  // the change of the rates that changes the errors by C
  };

  static double dot(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t r = 0; r < a.size(); ++r) sum += a[r] * b[r];
    return sum;
  }
  // Takes the part along a secant out of `C`, and the rates that belong to it out of `rates`.
  static void remove(std::vector<double>& C, std::vector<double>& rates, const Secant& one) {
    const double part = dot(one.C, C);
    for (std::size_t r = 0; r < C.size(); ++r)
      C[r] -= part * one.C[r], rates[r] -= part * one.rates[r];
  }
  // Adds the secant of the last correction, unless it is only a combination of those before.
  void learn(const std::vector<double>& C) {
    if (C_.empty()) return;
    Secant one{C, rates_};
    for (std::size_t r = 0; r < C.size(); ++r) one.C[r] -= C_[r];
    const double before = std::sqrt(dot(one.C, one.C));
    for (const Secant& other : seen_) remove(one.C, one.rates, other);
    const double length = std::sqrt(dot(one.C, one.C));
    if (!(length > 1e-8 * before)) return;
    for (std::size_t r = 0; r < C.size(); ++r) one.C[r] /= length, one.rates[r] /= length;
    seen_.push_back(std::move(one));
  }

  std::vector<Secant> seen_;
  std::vector<double> C_, rates_;  // the last errors, and the correction for them
};

}  // namespace joints
/// @}
