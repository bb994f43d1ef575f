// The parts of chapters 1 and 2, as the numeric checker wants them.
#pragma once

#include <array>

#include "chapters/01_distance/distance.h"
#include "chapters/02_ball/ball.h"
#include "tests/checker/check.h"
#include "tests/checker/rod_mistakes.h"

namespace joints::testing {

inline const char* const told_one_anchor_both =
    "#one-anchor-both one anchor for both bodies: each has its own";

// Turns body 2 about a point of it, which stays where it is.
inline void turn_about(Body& body, const vec3& point, const quat& turn) {
  body.x = point + turn * (body.x - point);
  body.q = normalize(turn * body.q);
}

struct CentreDistanceFixture {
  using Part = CentreDistance;
  static constexpr Subject J{"1.1", "the row J of a rod from centre to centre"};
  static constexpr Subject K{"1.2", "K of a rod from centre to centre"};
  static constexpr std::array rows{"C"};
  static constexpr bool exact_when_broken = true;
  static Part make(const Pair& pair) { return {length(pair.body2.x - pair.body1.x)}; }
  static void move_freely(const Part&, Pair& pair, Random& random) {
    turn_about(pair.body2, pair.body1.x, random.turn());
    pair.body1.q = random.turn();
    pair.body2.q = random.turn();
  }
  static WrongRows mistakes(const Part& part, const Pair& pair) {
    const auto& [one, two] = pair;
    const RodParts rod{one.x, two.x, vec3(0), vec3(0), part.length, part.error(one, two)};
    WrongRows out = wrong_directions(rod);
    const vec3 n = direction(rod.u());
    const char* const turned = "#direction-turned n is turned with a body: positions are in the "
                               "world already";
    for (const Body& body : {one, two})
      for (const quat& q : {body.q, conjugate(body.q)}) out.push_back({turned, rod.along(q * n)});
    out.push_back({"#arms-where-nothing-turns the blocks w1 and w2 should be zero: nothing turns",
                   to_jacobian(Row{-n, -n, n, n})});
    return out;
  }
  static WrongNumbers K_mistakes(const Part& part, const Pair& pair) {
    const RodParts rod{pair.body1.x, pair.body2.x, vec3(0), vec3(0), part.length, 0};
    const real K = dense_K(rod.along(direction(rod.u())), pair.body1, pair.body2)[0][0];
    return {{"#times-length-rod-n times the length of the rod: n is a unit vector, so K is "
             "independent of it",
             K * part.length},
            {"#times-error-k-knows times the error: K is independent of the error",
             K * part.error(pair.body1, pair.body2)},
            {"#always-one K is 1 here: it comes from the masses, and nothing bounds it", 1}};
  }
};

struct DistanceFixture {
  using Part = Distance;
  static constexpr Subject J{"1.6", "the row J of a rod between anchors"};
  static constexpr Subject K{"1.6", "K of a rod between anchors", 2};
  static constexpr std::array rows{"C"};
  static constexpr bool exact_when_broken = true;
  static Part make(const Pair& pair) {
    Part part{vec3(real(0.3), real(-0.2), real(0.4)), vec3(real(-0.5), real(0.1), real(0.2)), 1};
    part.length = real(1) + part.error(pair.body1, pair.body2);
    return part;
  }
  static void move_freely(const Part& part, Pair& pair, Random& random) {
    turn_about(pair.body2, world_point(pair.body1, part.anchor1_local), random.turn());
    turn_about(pair.body1, world_point(pair.body1, part.anchor1_local), random.turn());
    turn_about(pair.body2, world_point(pair.body2, part.anchor2_local), random.turn());
  }
  static WrongRows mistakes(const Part& part, const Pair& pair) {
    const auto& [one, two] = pair;
    const vec3 r1 = one.q * part.anchor1_local, r2 = two.q * part.anchor2_local;
    const RodParts rod{one.x, two.x, r1, r2, part.length, part.error(one, two)};
    WrongRows out = wrong_directions(rod);
    for (const auto& wrong : wrong_levers(rod)) out.push_back(wrong);
    for (const auto& [anchor1, anchor2] : {std::pair(part.anchor1_local, part.anchor1_local),
                                           std::pair(part.anchor2_local, part.anchor2_local)}) {
      const vec3 arm1 = to_world(one, anchor1), arm2 = to_world(two, anchor2);
      const RodParts same{one.x, two.x, arm1, arm2, part.length, 0};
      out.push_back({told_one_anchor_both,
                     same.along(direction(same.u()))});
    }
    const vec3 n = direction(rod.u());
    out.push_back({"#cross-product-body-space the cross product comes too early: the lever is "
                   "turned into the world first",
                   to_jacobian(Row{-n, -to_world(one, cross(part.anchor1_local, n)), n,
                                   to_world(two, cross(part.anchor2_local, n))})});
    return out;
  }
  static WrongNumbers K_mistakes(const Part& part, const Pair& pair) {
    const auto& [one, two] = pair;
    const vec3 r1 = one.q * part.anchor1_local, r2 = two.q * part.anchor2_local;
    const Row levers{vec3(1, 0, 0), r1, vec3(1, 0, 0), r2};
    return {{"#levers-for-arms the levers themselves stand beside the inertia: it is r x n, as in "
             "J",
             dense_K(to_jacobian(levers), one, two)[0][0]}};
  }
};

struct RopeFixture : DistanceFixture {
  using Part = Rope<Distance>;
  static constexpr Subject J{"", "the row J of a rope between anchors"};
  static constexpr Subject K{"", "K of a rope between anchors"};
  static Part make(const Pair& pair) { return {DistanceFixture::make(pair)}; }
  static void move_freely(const Part& part, Pair& pair, Random& random) {
    DistanceFixture::move_freely(part.rod, pair, random);
  }
};

struct PointFixture {
  using Part = Point;
  static constexpr Subject J{"2.1", "the rows J of a ball joint"};
  static constexpr Subject K{"2.2", "K of a ball joint"};
  static constexpr std::array rows{"C.x", "C.y", "C.z"};
  static constexpr bool exact_when_broken = true;
  static Part make(const Pair& pair) {
    return point_at(pair.body1, pair.body2, vec3(real(0.8), real(0.4), real(-0.6)));
  }
  static void move_freely(const Part& part, Pair& pair, Random& random) {
    turn_about(pair.body2, world_point(pair.body1, part.anchor1_local), random.turn());
  }
  static std::vector<std::pair<std::string, Jacobian<3>>> mistakes(const Part& part,
                                                                   const Pair& pair) {
    const auto& [one, two] = pair;
    const vec3 r1 = one.q * part.anchor1_local, r2 = two.q * part.anchor2_local;
    const mat3 E(1), ones(1, 1, 1, 1, 1, 1, 1, 1, 1);
    const auto rows = [](const mat3& block, const vec3& arm1, const vec3& arm2) {
      return jacobian_from_blocks(-block, skew(arm1), block, -skew(arm2));
    };
    const char* const anchors = told_one_anchor_both;
    return {
        {"#columns-taken-rows the sign of the blocks w1 and w2: a x b is -(b x a). Or columns for "
         "rows: skew(r)[i] is a column", rows(E, -r1, -r2)},
        {anchors, rows(E, to_world(one, part.anchor2_local), r2)},
        {anchors, rows(E, r1, to_world(two, part.anchor1_local))},
        {"#ones-everywhere E has ones on its diagonal alone: mat3(1)", rows(ones, r1, r2)},
        {"#lever-lever the lever runs from the body's own centre to its own anchor, not from "
         "lever to lever",
         rows(E, r2 - r1, r2 - r1)},
        {"#lever-length-1 a lever has its length: it is no unit vector",
         rows(E, direction(r1), direction(r2))},
        {"the lever of body 1 runs to its own anchor, not to that of body 2",
         rows(E, two.x + r2 - one.x, r2)},
    };
  }
};

}  // namespace joints::testing
