// Two parts as one block: J, C and K of both.
#pragma once

#include "engine/matrix.h"

/// \addtogroup joint
/// @{
namespace joints {

/// Two parts as one block: the rows of the first above those of the second. A composite is itself a
/// part, so that composites can be nested.
template <class First, class Second>
struct Composite {
  static_assert(!First::one_sided, "bounds belong to the last row: only the lower part has them");
  First first;    ///< the upper rows
  Second second;  ///< the lower rows

  static constexpr int rows = First::rows + Second::rows;  ///< of both
  static constexpr bool one_sided = Second::one_sided;     ///< bounds belong to the last row
  /// C, first above second.
  Vector<rows> error(const Body& body1, const Body& body2) const {
    return together<Vector<rows>>(to_vector(first.error(body1, body2)),
                                  to_vector(second.error(body1, body2)));
  }
  /// J, first above second.
  Jacobian<rows> jacobian(const Body& body1, const Body& body2) const {
    return together<Jacobian<rows>>(to_jacobian(first.jacobian(body1, body2)),
                                    to_jacobian(second.jacobian(body1, body2)));
  }
  /// K = J M^-1 J^T of all rows, with the cross terms between the two parts.
  Matrix<rows> K(const Body& body1, const Body& body2) const {
    const Jacobian<rows> J = jacobian(body1, body2);
    Row response[rows];
    Matrix<rows> K;
    form_responses(J.row.data(), rows, body1, body2, response);
    form_K(J.row.data(), response, rows, K[0].data());
    return K;
  }

 private:
  template <class Both, class Upper, class Lower>
  static Both together(const Upper& upper, const Lower& lower) {
    Both both;
    for (int i = 0; i < First::rows; ++i) both[i] = upper[i];
    for (int i = 0; i < Second::rows; ++i) both[First::rows + i] = lower[i];
    return both;
  }
};

}  // namespace joints
/// @}
