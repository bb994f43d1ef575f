// What a part must have, as a concept, and a message in words for each member that is missing.
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
/// Whether its last row only enforces C >= 0: `static constexpr bool one_sided`.
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

}  // namespace joints
/// @}
