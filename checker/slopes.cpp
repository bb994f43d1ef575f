// Rows as vectors of 12 numbers: the slope of any C, what rows span, and poses where C is 0.
#include "checker/slopes.h"

#include <algorithm>
#include <array>

namespace joints::testing {

double dot12(const double* a, const double* b) {
  double sum = 0;
  for (int k = 0; k < 12; ++k) sum += a[k] * b[k];
  return sum;
}

Span::Span(const Numbers& J) {
  for (std::size_t i = 0; i < J.size(); i += 12) {
    Numbers row(J.begin() + long(i), J.begin() + long(i) + 12);
    const double size = std::sqrt(dot12(row.data(), row.data()));
    for (double& number : row) number /= size > 0 ? size : 1;
    for (int again = 0; again < 2; ++again) remove_from(row);
    const double rest = std::sqrt(dot12(row.data(), row.data()));
    left.push_back(rest);
    if (rest < least) continue;
    for (double number : row) basis.push_back(number / rest);
  }
}
void Span::remove_from(Numbers& row) const {
  for (std::size_t b = 0; b < basis.size(); b += 12) {
    const double along = dot12(row.data(), &basis[b]);
    for (std::size_t k = 0; k < 12; ++k) row[k] -= along * basis[b + k];
  }
}

Numbers slope(const Errors& C_of, const Pair& at) {
  const std::size_t rows = C_of(at).size();
  Numbers J(12 * rows);
  for (std::size_t k = 0; k < 12; ++k) {
    const auto C = [&](real amount) {
      Pair moved = at;
      Body& body = k < 6 ? moved.body1 : moved.body2;
      body = nudged(body, int(k % 6), amount);
      return C_of(moved);
    };
    const Numbers ahead = C(difference_step), behind = C(-difference_step);
    for (std::size_t i = 0; i < rows; ++i)
      J[12 * i + k] = (ahead[i] - behind[i]) / (2 * double(difference_step));
  }
  return J;
}

bool close_joint(const Errors& C_of, Pair& at) {
  for (int n = 0; n < 60; ++n) {
    const Numbers C = C_of(at);
    double size = 0;
    for (const double c : C) size = std::max(size, std::abs(c));
    if (!std::isfinite(size)) return false;
    if (size < (is_float ? 1e-5 : 1e-11)) return true;
    const Numbers J = slope(C_of, at);
    std::vector<real> K;  // J J^T, a little larger so that redundant rows do no harm
    for (std::size_t i = 0; i < C.size(); ++i)
      for (std::size_t j = 0; j < C.size(); ++j)
        K.push_back(real(dot12(&J[12 * i], &J[12 * j]) * (i == j ? 1 + 1e-6 : 1) +
                         (i == j ? 1e-9 : 0)));
    invert_symmetric(K.data(), int(C.size()));
    std::array<double, 12> move{};
    double longest = 0;
    for (std::size_t k = 0; k < 12; ++k) {
      for (std::size_t i = 0; i < C.size(); ++i)
        for (std::size_t j = 0; j < C.size(); ++j)
          move[k] -= J[12 * i + k] * double(K[i * C.size() + j]) * C[j];
      longest = std::max(longest, std::abs(move[k]));
    }
    for (std::size_t k = 0; k < 12; ++k) {
      Body& body = k < 6 ? at.body1 : at.body2;
      body = nudged(body, int(k % 6), real(move[k] / std::max(1.0, 2 * longest)));
    }
  }
  return false;
}

}  // namespace joints::testing
