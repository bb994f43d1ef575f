// Two parts as one block: J, C and K of both.
#pragma once

#include "engine/part.h"

/// \addtogroup joint
/// @{
namespace joints {

/// Two parts as one block, with the rows of the first above those of the second. A composite is
/// itself a part, so composites can be nested.
template <class First, class Second>
struct Composite {
  static_assert(require_part<First>() && require_part<Second>());
  static_assert(!First::one_sided, "bounds belong to the last row: only the lower part has them");
  First first;    ///< the upper rows
  Second second;  ///< the lower rows

  static constexpr int rows = First::rows + Second::rows;  ///< rows of both parts
  static constexpr bool one_sided = Second::one_sided;     ///< bounds belong to the last row
  /// The form of the first part if the second one adds only angular rows, else Form::any.
  static constexpr Form form =
      Second::form == Form::angular ? First::form : Form::any;
  /// C of both parts, the first above the second.
  Vector<rows> error(const Body& body1, const Body& body2) const {
    Vector<rows> C;
    write_error(*this, body1, body2, C.data());
    return C;
  }
  /// J of both parts, the first above the second.
  Jacobian<rows> jacobian(const Body& body1, const Body& body2) const {
    Jacobian<rows> J;
    write_jacobian(*this, body1, body2, J.row.data());
    return J;
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
};

/// C of both parts, one after the other.
template <class First, class Second>
void write_error(const Composite<First, Second>& part, const Body& body1, const Body& body2,
                 real* C) {
  write_error(part.first, body1, body2, C);
  write_error(part.second, body1, body2, C + First::rows);
}
/// J of both parts, one after the other.
template <class First, class Second>
void write_jacobian(const Composite<First, Second>& part, const Body& body1, const Body& body2,
                    Row* J) {
  write_jacobian(part.first, body1, body2, J);
  write_jacobian(part.second, body1, body2, J + First::rows);
}

/// Both parts by their own check(). \throws std::invalid_argument from either
template <Checked First, Checked Second>
void check(const Composite<First, Second>& part) {
  check(part.first);
  check(part.second);
}

}  // namespace joints
/// @}
