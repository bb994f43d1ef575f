// The parts of chapters 3 to 5 and whole joints, as the numeric checker wants them.
#pragma once

#include "chapters/05_fixed/fixed.h"
#include "joints/driven_joint.h"
#include "tests/checker/fixtures.h"

namespace joints::testing {

// ---- chapter 3 ----------------------------------------------------------------------------------

struct AxisFixture {
  using Part = Axis;
  using Exercise = Axis;
  static constexpr Subject J{"3.1", "the rows J of a hinge's axis", 2};
  static constexpr Subject K{"", "K of a hinge's axis"};
  static constexpr std::array rows{"C.b", "C.c"};
  static constexpr bool exact_when_broken = true;
  static Part make(const Pair& pair) {
    return axis_along(pair.body1, pair.body2, vec3(real(0.6), -1, real(0.3)));
  }
  static void move_freely(const Part& part, Pair& pair, Random& random) {
    pair.body2.x += random.vector(1);
    const vec3 a1 = to_world(pair.body1, part.a1_local);
    turn_about(pair.body2, pair.body2.x, rotation(random.uniform(-3, 3) * a1));
  }
};

struct HingeAngleFixture {
  using Part = HingeAngle;
  static constexpr Subject J{"", "the row J of a hinge's angle"};
  static constexpr Subject K{"", "K of a hinge's angle"};
  static constexpr std::array rows{"C"};
  static constexpr bool exact_when_broken = true;
  static Part make(const Pair& pair) {
    return angle_about(pair.body1, pair.body2, vec3(real(0.6), -1, real(0.3)));
  }
  static void move_freely(const Part& part, Pair& pair, Random& random) {
    pair.body2.x += random.vector(1);
    const vec3 a1 = to_world(pair.body1, part.a1_local);
    turn_about(pair.body2, pair.body2.x, rotation(random.uniform(-1, 1) * a1));
  }
};

// ---- chapter 4 ----------------------------------------------------------------------------------

inline Line line_along(const Pair& pair, const vec3& anchor, const vec3& along) {
  const Axis axis = axis_along(pair.body2, pair.body1, along);
  return {to_local(pair.body1, anchor - pair.body1.x), to_local(pair.body2, anchor - pair.body2.x),
          axis.b_local, axis.c_local};
}

struct LineFixture {
  using Part = Line;
  using Exercise = Line;
  static constexpr Subject J{"4.1", "the rows J of a line", 2};
  static constexpr Subject K{"", "K of a line"};
  static constexpr std::array rows{"C.1", "C.2"};
  static constexpr bool exact_when_broken = true;
  static Part make(const Pair& pair) {
    return line_along(pair, vec3(real(0.8), real(0.4), real(-0.6)),
                      vec3(real(0.6), -1, real(0.3)));
  }
  static void move_freely(const Part& part, Pair& pair, Random& random) {
    const vec3 along = to_world(pair.body1, cross(part.n1_local, part.n2_local));
    pair.body2.x += random.uniform(-2, 2) * along;
    turn_about(pair.body2, world_point(pair.body2, part.anchor2_local), random.turn());
  }
};

struct RotationLockFixture {
  using Part = RotationLock;
  using Exercise = RotationLock;
  static constexpr Subject J{"4.2", "the rows J of a lock", 2};
  static constexpr Subject K{"", "K of a lock"};
  static constexpr std::array rows{"C.x", "C.y", "C.z"};
  static constexpr bool exact_when_broken = false;
  static Part make(const Pair& pair) { return lock_of(pair.body1, pair.body2); }
  static void move_freely(const Part&, Pair& pair, Random& random) {
    pair.body2.x += random.vector(1);
    const quat turn = random.turn();
    pair.body1.q = normalize(turn * pair.body1.q);
    pair.body2.q = normalize(turn * pair.body2.q);
  }
};

struct SlideFixture {
  using Part = Slide;
  using Exercise = Slide;
  static constexpr Subject J{"4.3", "the row J of a displacement", 2};
  static constexpr Subject K{"", "K of a displacement"};
  static constexpr std::array rows{"C"};
  static constexpr bool exact_when_broken = true;
  static Part make(const Pair& pair) {
    const Line line = LineFixture::make(pair);
    return {line.anchor1_local, line.anchor2_local, cross(line.n1_local, line.n2_local)};
  }
  static void move_freely(const Part& part, Pair& pair, Random& random) {
    const vec3 a = to_world(pair.body1, part.a1_local), across = random.vector(1);
    pair.body2.x += across - dot(across, a) * a;
    turn_about(pair.body2, world_point(pair.body2, part.anchor2_local), random.turn());
  }
};

// ---- whole joints -------------------------------------------------------------------------------

struct HingeFixture {
  using Part = Composite<Point, Axis>;
  static constexpr Subject J{"", "the five rows J of a hinge"};
  static constexpr Subject K{"", "K of a hinge"};
  static constexpr std::array rows{"C.x", "C.y", "C.z", "C.b", "C.c"};
  static constexpr bool exact_when_broken = true;
  static Part make(const Pair& pair) { return {PointFixture::make(pair), AxisFixture::make(pair)}; }
  static void move_freely(const Part& part, Pair& pair, Random& random) {
    const vec3 a1 = to_world(pair.body1, part.second.a1_local);
    turn_about(pair.body2, world_point(pair.body1, part.first.anchor1_local),
               rotation(random.uniform(-3, 3) * a1));
  }
};

struct SliderFixture {
  using Part = Composite<Line, RotationLock>;
  static constexpr Subject J{"", "the five rows J of a slider"};
  static constexpr Subject K{"", "K of a slider"};
  static constexpr std::array rows{"C.1", "C.2", "C.x", "C.y", "C.z"};
  static constexpr bool exact_when_broken = false;
  static Part make(const Pair& pair) {
    return {LineFixture::make(pair), RotationLockFixture::make(pair)};
  }
  static void move_freely(const Part& part, Pair& pair, Random& random) {
    const Line& line = part.first;
    const vec3 along = to_world(pair.body1, cross(line.n1_local, line.n2_local));
    pair.body2.x += random.uniform(-2, 2) * along;
  }
};

struct WeldFixture {
  using Part = Weld;
  static constexpr Subject J{"", "the six rows J of a weld"};
  static constexpr Subject K{"5.1", "K of a weld"};
  static constexpr std::array rows{"C.x", "C.y", "C.z", "turn x", "turn y", "turn z"};
  static constexpr bool exact_when_broken = false;
  static Part make(const Pair& pair) {
    return {PointFixture::make(pair), RotationLockFixture::make(pair)};
  }
  static void move_freely(const Part&, Pair& pair, Random& random) {
    move_together(pair, random);
  }
};

}  // namespace joints::testing
