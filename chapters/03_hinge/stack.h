// Two parts as one: what a whole-joint block is made of. Given, there is nothing to edit here.
#pragma once

#include "chapters/03_hinge/hinge.h"

/// \addtogroup chapter3
/// @{
namespace joints {

/// Two parts stacked into one, with the rows of the first above those of the second, so that they
/// are solved together. K has the parts' own K on its diagonal, coupling() everywhere else.
/// A stack is a part like any other; stacks can be stacked.
template <class First, class Second>
struct Composite {
  First first;    ///< the upper rows
  Second second;  ///< the lower rows

  static constexpr int rows = First::rows + Second::rows;      ///< of both
  static constexpr bool one_sided = Second::one_sided;         ///< bounds belong to the last row
  /// C of both.
  Vector<rows> error(const Body& body1, const Body& body2) const {
    Vector<rows> C;
    put(C, 0, to_vector(first.error(body1, body2)), First::rows);
    put(C, First::rows, to_vector(second.error(body1, body2)), Second::rows);
    return C;
  }
  /// J of both.
  Jacobian<rows> jacobian(const Body& body1, const Body& body2) const {
    Jacobian<rows> J;
    put(J, 0, to_jacobian(first.jacobian(body1, body2)), First::rows);
    put(J, First::rows, to_jacobian(second.jacobian(body1, body2)), Second::rows);
    return J;
  }
  /// K of both, with what the rows of the one do to those of the other, Eq. 3-8.
  Matrix<rows> K(const Body& body1, const Body& body2) const {
    return K_of_rows(jacobian(body1, body2), body1, body2);
  }
  /// The same where J is known already.
  Matrix<rows> K_of_rows(const Jacobian<rows>& J, const Body& body1, const Body& body2) const {
    const Matrix<First::rows> upper = to_matrix(first.K(body1, body2));
    const Matrix<Second::rows> lower = to_matrix(second.K(body1, body2));
    Matrix<rows> K;
    for (int i = 0; i < First::rows; ++i)
      for (int j = 0; j < First::rows; ++j) K[i][j] = upper[i][j];
    for (int i = First::rows; i < rows; ++i) {
      for (int j = 0; j < First::rows; ++j)
        K[i][j] = K[j][i] = coupling(J[i], J[j], body1, body2);
      for (int j = First::rows; j < rows; ++j)
        K[i][j] = lower[i - First::rows][j - First::rows];
    }
    return K;
  }

 private:
  // Copies `some`, of n numbers or rows, into `all` from place `from` on.
  template <class Long, class Short>
  static void put(Long& all, int from, const Short& some, int n) {
    for (int i = 0; i < n; ++i) all[from + i] = some[i];
  }
};

/// One limit of a coordinate as a part: C = sign (x - bound) >= 0.
template <class Coordinate>
struct Limit {
  Coordinate coordinate;  ///< the part whose error is x
  real bound = 0;         ///< the value of x at the limit [rad or m]
  real sign = 1;          ///< +1 for a lower limit, -1 for an upper one

  static constexpr int rows = 1;           ///< one
  static constexpr bool one_sided = true;  ///< it only pushes C up
  /// Room left [rad or m].
  real error(const Body& body1, const Body& body2) const {
    return sign * (coordinate.error(body1, body2) - bound);
  }
  /// The coordinate's row with the limit's sign.
  Row jacobian(const Body& body1, const Body& body2) const {
    const Row J = coordinate.jacobian(body1, body2);
    return {sign * J.v1, sign * J.w1, sign * J.v2, sign * J.w2};
  }
  /// The coordinate's K.
  real K(const Body& body1, const Body& body2) const { return coordinate.K(body1, body2); }
};

}  // namespace joints
/// @}
