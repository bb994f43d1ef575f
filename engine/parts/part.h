// What a part must have, as a concept with a message for each member that is missing; and two parts
// as one.
#pragma once

#include <concepts>

#include "engine/matrix.h"

/// \addtogroup rows
/// @{
namespace joints {

/// The number of rows of a part: `static constexpr int rows`, 1 to 6.
template <class P>
concept HasRows = requires { { P::rows } -> std::convertible_to<int>; } &&
                  bool(P::rows >= 1 && P::rows <= 6);
/// Whether its last row only enforces C >= 0: `static constexpr bool one_sided`. Its joint then
/// gives it the bound RowSettings::lower = 0, by which solvers know it.
template <class P>
concept HasSides = std::same_as<decltype(P::one_sided), const bool>;
/// The form of its rows: `static constexpr Form form`. Solvers have shorter formulas for some.
template <class P>
concept HasForm = std::same_as<decltype(P::form), const Form>;
/// Its C: a const function of two bodies that returns as many numbers as there are rows.
template <class P>
concept HasError = requires(const P& part, const Body& body) {
  { to_vector(part.error(body, body)) } -> std::convertible_to<Vector<P::rows>>;
};
/// Its J: a const function of two bodies that returns as many rows.
template <class P>
concept HasJacobian = requires(const P& part, const Body& body) {
  { to_jacobian(part.jacobian(body, body)) } -> std::convertible_to<Jacobian<P::rows>>;
};
/// Everything that a block needs of the geometry of a joint.
template <class P>
concept Part = HasRows<P> && HasSides<P> && HasForm<P> && HasError<P> && HasJacobian<P>;

/// A free function in the namespace of the part that throws std::invalid_argument for impossible
/// geometry. A joint calls it.
template <class P>
concept Checked = requires(const P& part) { check(part); };

/// Stops the compiler with a sentence unless P is a Part. \return true
template <class P>
consteval bool require_part() {
  if constexpr (!HasRows<P>)
    static_assert(HasRows<P>, "this part needs `static constexpr int rows`, from 1 to 6");
  else if constexpr (!HasSides<P>)
    static_assert(HasSides<P>, "this part needs `static constexpr bool one_sided`: false if its "
                               "rows hold C = 0, true if the last one holds C >= 0");
  else if constexpr (!HasForm<P>)
    static_assert(HasForm<P>, "this part needs `static constexpr Form form`: Form::any for rows of "
                              "any kind, Form::angular for v1 = v2 = 0 and w1 = -w2, Form::point "
                              "for those of a Point");
  else if constexpr (!HasError<P>)
    static_assert(HasError<P>, "this part needs a const function `error(body1, body2)` of two "
                               "const Body& that returns C: a real for one row, a vec3 for three, "
                               "or a Vector<rows>");
  else if constexpr (!HasJacobian<P>)
    static_assert(HasJacobian<P>, "this part needs a const function `jacobian(body1, body2)` of "
                                  "two const Body& that returns J: a Row, or a Jacobian<rows>");
  return true;
}

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
    Vector<rows> C;  // by the function below, not by that of matrix.h
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
