// The usual mistakes in the row of a rod: a wrong direction, or wrong levers.
#pragma once

#include "tests/checker/unit_rates.h"

namespace joints::testing {

using WrongRows = std::vector<std::pair<std::string, Jacobian<1>>>;
using WrongNumbers = std::vector<std::pair<std::string, real>>;

inline constexpr const char* not_a_unit_vector =
    "#not-unit-vector not a unit vector: take direction(...) of the difference";
inline constexpr const char* over_the_length =
    "#over-length-rod divided by the length of the rod: that is the distance only while C = 0";

/// What a rod's row is made of.
struct RodParts {
  vec3 x1, x2, r1, r2;  ///< centres, levers (0 in a rod from centre to centre)
  real length, error;

  vec3 u() const { return x2 + r2 - x1 - r1; }
  /// The row with these vectors in the place of the direction and the levers.
  Jacobian<1> row(const vec3& n, const vec3& arm1, const vec3& arm2) const {
    return to_jacobian(row_by_rates(n, arm1, arm2));
  }
  Jacobian<1> along(const vec3& n) const { return row(n, r1, r2); }
};

/// Mistakes with the direction.
inline WrongRows wrong_directions(const RodParts& rod) {
  const vec3 u = rod.u(), n = direction(u);
  WrongRows out{
      {not_a_unit_vector, rod.along(u)},
      {over_the_length, rod.along(u / rod.length)},
      {"#divided-twice divided by the distance twice: n is a unit vector already",
       rod.along(n / length(u))},
      {"#positions-added the positions are added: the direction is their difference",
       rod.along(direction(rod.x2 + rod.r2 + rod.x1 + rod.r1))},
      {"#position-body-1-left the position of body 1 is missing in the direction",
       rod.along(direction(rod.x2 + rod.r2))},
      {"#sizes-direction the sign of each number of the direction is lost", rod.along(abs(n))},
      {"#sign-error the sign of the error is in the row: it belongs to the bias, and J is "
       "independent of it",
       rod.along(rod.error < 0 ? -n : n)},
      {"#only-where-too-long the row is 0 while the rod is too short: a rod pushes, too",
       rod.along(rod.error < 0 ? vec3(0) : n)},
      {"#only-where-there-error the row is 0 where the error is 0: a row constrains velocities, "
       "also there",
       rod.along(std::abs(rod.error) < real(1e-3) ? vec3(0) : n)},
      {"#times-the-error the row is multiplied by the error: the error belongs to the bias",
       rod.along(rod.error * n)},
      {"#times-the-length the row is multiplied by the length of the rod",
       rod.along(rod.length * n)},
  };
  for (int i = 0; i < 3; ++i) {
    vec3 before = u, after = n;
    before[i] = after[i] = 0;
    const std::string words = std::string("the ") + "xyz"[i] + " of the direction is left out";
    out.push_back({words, rod.along(direction(before))});
    out.push_back({words, rod.along(after)});
  }
  return out;
}

/// Mistakes with the levers.
inline WrongRows wrong_levers(const RodParts& rod) {
  const auto& [x1, x2, r1, r2, size, error] = rod;
  const vec3 d = x2 - x1, n = direction(rod.u()), along_centres = direction(d);
  const char* const centres = "#centre-centre the direction runs from centre to centre, not from "
                              "anchor to anchor";
  const char* const signs = "#sign-u a sign in u: it is x2 + r2 - x1 - r1";
  return {
      {centres, rod.along(along_centres)},
      {centres, rod.row(along_centres, vec3(0), vec3(0))},
      {"#centres-left-out the centres are missing in u: it is x2 + r2 - x1 - r1",
       rod.along(direction(r2 - r1))},
      {"the lever of body 1 is missing in u", rod.along(direction(d + r2))},
      {"the lever of body 2 is missing in u", rod.along(direction(d - r1))},
      {signs, rod.along(direction(d + r2 + r1))},
      {signs, rod.along(direction(d - r2 - r1))},
      {signs, rod.along(direction(d - r2 + r1))},
      {"the centres are counted twice in u: world_point adds them already",
       rod.along(direction(d + rod.u()))},
      {"#points-added-centres points where levers belong: world_point adds the centre, to_world "
       "does not",
       rod.row(direction(d + rod.u()), x1 + r1, x2 + r2)},
      {"#levers-times-u r x n takes the unit vector n, not u",
       to_jacobian(Row{-n, -cross(r1, rod.u()), n, cross(r2, rod.u())})},
      {"the lever runs from the body's own centre to its own anchor, not from anchor to anchor",
       rod.row(n, r2 - r1, r2 - r1)},
  };
}

}  // namespace joints::testing
