// Rows as vectors of 12 numbers: the slope of any C, what rows span, and poses where C is 0.
#pragma once

#include "checker/samples.h"

namespace joints::testing {

/// C at a pose.
using Errors = std::function<Numbers(const Pair&)>;

/// The product of two rows of 12 numbers.
double dot12(const double* a, const double* b);

/// J by central differences of C, 12 numbers per row.
Numbers slope(const Errors& C_of, const Pair& at);

/// Moves both bodies until C is 0: Gauss-Newton with the slope, as if all masses were 1. Returns
/// false where that does not succeed.
bool close_joint(const Errors& C_of, Pair& at);

/// Orthonormal rows that span the rows of a J.
struct Span {
  Numbers basis;
  std::vector<double> left;  ///< of each row, what is independent of those before it, relative

  explicit Span(const Numbers& J);
  void remove_from(Numbers& row) const;  ///< leaves what is perpendicular to the rows
  static constexpr double least = is_float ? 1e-2 : 1e-5;  ///< below it a row depends on others
};

}  // namespace joints::testing
