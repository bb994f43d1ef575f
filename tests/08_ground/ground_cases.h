// Exercise 8.1: a corner and a ball above the top of a body as the numeric checker wants them, the
// rows along any direction beside their numeric reference, and the usual mistakes with them.
#pragma once

#include "chapters/08_ground/ground.h"
#include "tests/checker/fixtures.h"

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

// ---- the usual mistakes with the rows -----------------------------------------------------------

/// Rows along these directions with other levers, or along other directions.
template <int N>
std::vector<std::pair<std::string, Jacobian<N>>> wrong_corner_rows(
    const Corner& corner, const Pair& pair, const std::array<vec3, N>& directions) {
  const Body &one = pair.body1, &two = pair.body2;
  const vec3 n = to_world(one, vec3(0, 1, 0)), centre = world_point(two, corner.corner_local);
  const vec3 p = centre - corner.radius * n, r1 = p - one.x, r2 = p - two.x;
  std::vector<std::pair<std::string, Jacobian<N>>> out;
  const auto add = [&](const std::string& words, const vec3& arm1, const vec3& arm2,
                       const auto& turned) {
    Jacobian<N> J;
    for (int i = 0; i < N; ++i) {
      const vec3 d = turned(directions[std::size_t(i)]);
      J[i] = row_by_rates(d, arm1, arm2);
    }
    out.push_back({words, J});
  };
  const auto as_it_is = [](const vec3& d) { return d; };
  const auto levers = [&](const std::string& words, const vec3& arm1, const vec3& arm2) {
    add(words, arm1, arm2, as_it_is);
  };
  const std::string of_1 = ": the lever of body 1 is p - x1, with the same p as the one of body 2";
  for (const real part : {real(1), real(-1)})
    levers("r1 ends on the top, below the corner" + of_1,
           r1 - part * gap(corner, one, two) * n, r2);
  levers((N == 1 ? "w1 is zero, as if r1 ended in the middle of the top"
                 : "r1 ends in the middle of the top") + of_1, corner.height * n, r2);
  levers("#height-taken-away height is taken from r1" + of_1, r1 - corner.height * n, r2);
  levers("#centre-body-2 r1 ends at the centre of body 2" + of_1, two.x - one.x, r2);
  levers("r1 ends at the centre of body 2, and body 2 has no lever", two.x - one.x, vec3(0));
  const std::string lowest = ": the levers end at point(), the lowest point of the ball";
  const vec3 c1 = centre - one.x, c2 = centre - two.x, rho = corner.radius * n;
  levers("the radius is forgotten" + lowest, c1, c2);
  levers("the radius is forgotten in r1" + lowest, c1, r2);
  levers("#radius-forgotten-r2 the radius is forgotten in r2" + lowest, r1, c2);
  levers("#radius-twice the radius is subtracted twice: point() has subtracted it already",
         r1 - rho, r2 - rho);
  levers("#sign-radius-point-below the sign of the radius: the point is below the centre of the "
         "ball", c1 + rho, c2 + rho);
  const std::string place = "#point-for-levers a point where a lever belongs: p - x1 and p - x2, "
                            "not p itself";
  levers(place, p, p);
  levers(place + " (body 1)", p, r2);
  levers(place + " (body 2)", r1, p);
  const std::string own = ": each lever begins at its own body's centre";
  levers("#one-lever-both the lever of body 1 for both bodies" + own, r1, r1);
  levers("the lever of body 2 for both bodies" + own, r2, r2);
  const std::string left = "#corner-not-turned corner_local is not turned into the world: point() "
                           "does it";
  const vec3 local = two.x + corner.corner_local - rho;
  levers(left, local - one.x, local - two.x);
  levers(left + " (r2)", r1, corner.corner_local);
  levers(left + " (r2)", r1, corner.corner_local - rho);
  const std::string order = "#point-body-1 point(body2, body1): the other way round, the corner "
                            "is one of body 2";
  const vec3 exchanged = corner.point(two, one);
  levers(order, exchanged - one.x, exchanged - two.x);
  levers(order, exchanged - two.x, exchanged - one.x);
  levers(order, exchanged - one.x, r2);
  levers(order, r1, exchanged - two.x);
  levers("#levers-body-axes J is in world axes: levers in axes of the bodies do not go with it",
         to_local(one, r1), to_local(two, r2));
  levers("#height-taken-both-levers height is taken from both levers: they end at point()",
         r1 - corner.height * n,
         r2 - corner.height * n);
  // along n alone many of them are the same: they have to explain another direction, too
  const vec3 t = to_world(one, vec3(real(0.6), 0, real(0.8)));
  const Row yours = corner.along(t, one, two);
  const auto built = [&](const std::string& words, const auto& row) {
    if (!close(flat(to_jacobian(yours)), flat(to_jacobian(row(t))), difference_tolerance)) return;
    Jacobian<N> J;
    for (int i = 0; i < N; ++i) J[i] = row(directions[std::size_t(i)]);
    out.push_back({words, J});
  };
  const auto right = [&](const vec3& d) { return row_by_rates(d, r1, r2); };
  const auto turned = [&](const char* words, const auto& turn) {
    built(words, [&](const vec3& d) { return right(turn(d)); });
  };
  add(N == 1 ? "#sign-whole-row-c the sign of the whole row: C grows when body 2 moves up"
             : "the sign of the whole row: J V is how fast body 2 moves along the direction",
      r1, r2, [](const vec3& d) { return -d; });
  const char* const already = "#direction-turned-back the direction is turned once more: it is "
                              "given in the world";
  turned("#always-n n in the place of the direction: along() is called with other directions, too",
         [&](const vec3&) { return n; });
  turned("#always-y the y axis of the world in the place of the direction that is given",
         [&](const vec3&) { return vec3(0, 1, 0); });
  turned(already, [&](const vec3& d) { return one.q * d; });
  turned(already, [&](const vec3& d) { return two.q * d; });
  turned(already, [&](const vec3& d) { return conjugate(one.q) * d; });
  turned("the part along n is subtracted from the direction: take the direction as it is given",
         [&](const vec3& d) { return d - dot(d, n) * n; });
  // one or two of the four blocks
  vec3 Row::*const blocks[] = {&Row::v1, &Row::w1, &Row::v2, &Row::w2};
  const char* const names[] = {"v1", "w1", "v2", "w2"};
  for (const int which : {5, 10, 1, 2, 4, 8}) {
    std::string who;
    for (int k = 0; k < 4; ++k)
      if (which >> k & 1) who += (who.empty() ? "" : " and ") + std::string(names[k]);
    const auto in_blocks = [&](const std::string& words, const auto& other) {
      built(words + " in " + who, [&](const vec3& d) {
        Row J = right(d);
        const Row instead = other(d);
        for (int k = 0; k < 4; ++k)
          if (which >> k & 1) J.*blocks[k] = instead.*blocks[k];
        return J;
      });
    };
    in_blocks("n in the place of the direction", [&](const vec3&) { return right(n); });
    if (which & 5) continue;
    in_blocks("a lever made a unit vector: it keeps its length,", [&](const vec3& d) {
      return Row{d, -cross(normalize(r1), d), d, cross(normalize(r2), d)};
    });
    in_blocks("entry times entry where the cross product belongs,", [&](const vec3& d) {
      return Row{d, -(r1 * d), d, r2 * d};
    });
  }
  if (one.is_static())
    built("#nothing-static-body beside a static body its blocks are left out: they stay, its "
          "inverse mass is 0 already",
          [&](const vec3& d) { return Row{vec3(0), vec3(0), d, cross(r2, d)}; });
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
