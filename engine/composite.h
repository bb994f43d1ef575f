// Several parts as one block: what a whole joint is made of.
#pragma once

#include "engine/matrix.h"

/// \addtogroup joint
/// @{
namespace joints {

/// Two parts as one, with the rows of the first above those of the second, so that they are solved
/// together. A composite is a part like any other; composites can be composed.
template <class First, class Second>
struct Composite {
  First first;    ///< the upper rows
  Second second;  ///< the lower rows

  static constexpr int rows = First::rows + Second::rows;  ///< of both
  static constexpr bool one_sided = Second::one_sided;     ///< bounds belong to the last row
  /// C of both.
  Vector<rows> error(const Body& body1, const Body& body2) const {
    return together<Vector<rows>>(to_vector(first.error(body1, body2)),
                                  to_vector(second.error(body1, body2)));
  }
  /// J of both.
  Jacobian<rows> jacobian(const Body& body1, const Body& body2) const {
    return together<Jacobian<rows>>(to_jacobian(first.jacobian(body1, body2)),
                                    to_jacobian(second.jacobian(body1, body2)));
  }
  /// K of all rows, with what those of the one part do to those of the other.
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
