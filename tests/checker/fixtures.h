// The parts of chapters 1 and 2, as the numeric checker wants them.
#pragma once

#include <array>

#include "chapters/01_distance/distance.h"
#include "chapters/02_ball/ball.h"
#include "tests/checker/check.h"

namespace joints::testing {

// Turns body 2 about a point of it, which stays where it is.
inline void turn_about(Body& body, const vec3& point, const quat& turn) {
  body.x = point + turn * (body.x - point);
  body.q = normalize(turn * body.q);
}

struct CentreDistanceFixture {
  using Part = CentreDistance;
  using Exercise = CentreDistance;
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
};

struct DistanceFixture {
  using Part = Distance;
  using Exercise = Distance;
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
};

struct RopeFixture {
  using Part = Rope<Distance>;
  static constexpr Subject J{"", "the row J of a rope between anchors"};
  static constexpr Subject K{"", "K of a rope between anchors"};
  static constexpr std::array rows{"C"};
  static constexpr bool exact_when_broken = true;
  static Part make(const Pair& pair) { return {DistanceFixture::make(pair)}; }
  static void move_freely(const Part& part, Pair& pair, Random& random) {
    DistanceFixture::move_freely(part.rod, pair, random);
  }
};

struct PointFixture {
  using Part = Point;
  using Exercise = Point;
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
};

}  // namespace joints::testing
