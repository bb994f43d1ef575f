// Exercise 8.1: a corner and a ball above the top of a body as the numeric checker wants them, the
// rows along any direction beside their numeric reference, and the known mistakes with them.
#pragma once

#include "chapters/08_ground/ground.h"
#include "tests/checker/fixtures.h"
#include "tests/checker/known.h"

namespace joints::testing {

// ---- what is right ------------------------------------------------------------------------------

/// C, Eq. 8-1, seen from body 1: how high the centre of the ball stands there, less radius, height.
inline real gap(const Corner& corner, const Body& body1, const Body& body2) {
  const vec3 centre = body2.x + body2.q * corner.corner_local;
  return (conjugate(body1.q) * (centre - body1.x)).y - corner.radius - corner.height;
}

/// The rows of the exercise beside an error that is right whatever the exercise's own is.
struct CornerReference : Corner {
  real error(const Body& body1, const Body& body2) const { return gap(*this, body1, body2); }
};

/// Three rows of the exercise at once, along directions that ride on body 1.
struct Slides3 {
  Corner corner;
  std::array<vec3, 3> local;  ///< unit, body space of body 1

  static constexpr int rows = 3;
  vec3 direction(int i, const Body& body1) const { return to_world(body1, local[std::size_t(i)]); }
  Jacobian<3> jacobian(const Body& body1, const Body& body2) const {
    Jacobian<3> J;
    for (int i = 0; i < 3; ++i) J[i] = corner.along(direction(i, body1), body1, body2);
    return J;
  }
};

/// Follows the two pieces of matter that are at the same place now, one of each body: how far the
/// one of body 2 gets from the other along a direction that stays. J is how fast.
inline Jacobian<3> numeric_jacobian(const Slides3& part, const Body& body1, const Body& body2) {
  const vec3 p = body2.x + body2.q * part.corner.corner_local -
                 part.corner.radius * (body1.q * vec3(0, 1, 0));
  const vec3 matter1 = to_local(body1, p - body1.x), matter2 = to_local(body2, p - body2.x);
  Jacobian<3> J;
  for (int k = 0; k < 12; ++k) {
    const auto way = [&](real amount) {
      const Body one = k < 6 ? nudged(body1, k % 6, amount) : body1;
      const Body two = k < 6 ? body2 : nudged(body2, k % 6, amount);
      return world_point(two, matter2) - world_point(one, matter1);
    };
    const vec3 rate = (way(difference_step) - way(-difference_step)) / (2 * difference_step);
    for (int i = 0; i < 3; ++i) {
      Row& row = J[i];
      vec3& block = k < 3 ? row.v1 : k < 6 ? row.w1 : k < 9 ? row.v2 : row.w2;
      block[k % 3] = dot(part.direction(i, body1), rate);
    }
  }
  return J;
}

// ---- the known mistakes with the rows -----------------------------------------------------------

using Along = Row(const Corner&, const vec3&, const Body&, const Body&);

/// The rows along these directions with each known mistake. Along n alone many of them are the
/// same: there a mistake must give your row along another direction, too.
template <int N>
std::vector<std::pair<std::string, Jacobian<N>>> wrong_corner_rows(
    const Corner& corner, const Pair& pair, const std::array<vec3, N>& directions) {
  const auto& [one, two] = pair;
  const vec3 t = to_world(one, vec3(real(0.6), 0, real(0.8)));
  const Numbers yours = flat(to_jacobian(corner.along(t, one, two)));
  std::vector<std::pair<std::string, Jacobian<N>>> out;
  for (const auto& [words, along] : known_mistakes<Along>("8.1", 2)) {
    if (N == 1 && !close(yours, flat(to_jacobian(along(corner, t, one, two))),
                         difference_tolerance))
      continue;
    Jacobian<N> J;
    for (int i = 0; i < N; ++i) J[i] = along(corner, directions[std::size_t(i)], one, two);
    out.push_back({words, J});
  }
  return out;
}

// ---- the parts ----------------------------------------------------------------------------------

/// A sharp corner (radius 0) or a ball about it, on the top of body 1: C = 0.
inline Corner corner_on_top(const Pair& pair, real radius) {
  Corner corner{vec3(real(-0.4), real(-0.3), real(0.25)), radius, 0};
  corner.height = gap(corner, pair.body1, pair.body2);
  return corner;
}

struct CornerFixture {
  using Part = CornerReference;
  static constexpr Subject J{"8.1", "the row J of a corner", 2};
  static constexpr Subject K{"", "K of a corner"};
  static constexpr std::array rows{"C"};
  static constexpr bool exact_when_broken = true;
  static constexpr PoseWords broken{"off the top", "over or in the ground, C is not 0"};
  static Part make(const Pair& pair) { return {corner_on_top(pair, 0)}; }
  /// Slides over the top, turns about its corner: C stays 0.
  static void move_freely(const Corner& part, Pair& pair, Random& random) {
    const vec3 n = to_world(pair.body1, vec3(0, 1, 0)), move = random.vector(1);
    pair.body2.x += move - dot(move, n) * n;
    turn_about(pair.body2, world_point(pair.body2, part.corner_local), random.turn());
  }
  static std::vector<std::pair<std::string, Jacobian<1>>> mistakes(const Part& part,
                                                                   const Pair& pair) {
    return wrong_corner_rows<1>(part, pair, {to_world(pair.body1, vec3(0, 1, 0))});
  }
};

/// A ball rolls over the top: C stays 0.
struct BallOnTopFixture : CornerFixture {
  static constexpr Subject J{"8.1", "the row J of a ball on the ground", 2};
  static constexpr Subject K{"", "K of a ball on the ground"};
  static Part make(const Pair& pair) { return {corner_on_top(pair, real(0.35))}; }
};

/// The rows along two directions in the top and along n.
template <class Fixture>
struct SlidesFixture {
  using Part = Slides3;
  static constexpr Subject J{"8.1", "the rows J along two directions in the ground, and along n",
                             2};
  static constexpr std::array rows{"t1", "t2", "n"};
  static constexpr bool exact_when_broken = true;
  static constexpr PoseWords broken = Fixture::broken;
  static Part make(const Pair& pair) {
    return {Fixture::make(pair),
            {vec3(real(0.6), 0, real(0.8)), vec3(real(0.8), 0, real(-0.6)), vec3(0, 1, 0)}};
  }
  static void move_freely(const Part& part, Pair& pair, Random& random) {
    Fixture::move_freely(part.corner, pair, random);
  }
  static std::vector<std::pair<std::string, Jacobian<3>>> mistakes(const Part& part,
                                                                   const Pair& pair) {
    return wrong_corner_rows<3>(part.corner, pair,
                                {part.direction(0, pair.body1), part.direction(1, pair.body1),
                                 part.direction(2, pair.body1)});
  }
};
using CornerSlides = SlidesFixture<CornerFixture>;
using BallSlides = SlidesFixture<BallOnTopFixture>;

}  // namespace joints::testing
