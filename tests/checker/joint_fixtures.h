// The parts of chapters 3 to 5 and whole joints, as the numeric checker wants them.
#pragma once

#include "chapters/05_fixed/fixed.h"
#include "joints/driven_joint.h"
#include "tests/checker/fixtures.h"

namespace joints::testing {

inline const char* const told_ones_everywhere =
    "#ones-everywhere E has ones on its diagonal alone: mat3(1)";
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

// What may go wrong with the rows of points that slide along n, which rides on body 1.
template <int N>
std::vector<std::pair<std::string, Jacobian<N>>> wrong_levers(
    const Pair& pair, const vec3& anchor1_local, const vec3& anchor2_local,
    const std::array<vec3, N>& local, const std::string& name) {
  const vec3 r1 = to_world(pair.body1, anchor1_local), r2 = to_world(pair.body2, anchor2_local);
  const vec3 p1 = pair.body1.x + r1, p2 = pair.body2.x + r2, u = p2 - p1;
  const vec3 d = pair.body2.x - pair.body1.x;
  std::array<vec3, N> n, on2;
  for (int i = 0; i < N; ++i) {
    n[i] = to_world(pair.body1, local[i]);
    on2[i] = to_world(pair.body2, local[i]);
  }
  std::vector<std::pair<std::string, Jacobian<N>>> out;
  const auto add = [&](const std::string& words, const std::array<vec3, N>& along, const vec3& arm1,
                       const vec3& arm2, real sign = 1) {
    Jacobian<N> J;
    for (int i = 0; i < N; ++i) J[i] = row_by_rates(sign * along[i], arm1, arm2);
    out.push_back({words, J});
  };
  const std::string rides = name + " rides on body 1", is = "the lever of body 1 is r1 + u";
  add("u is forgotten, " + is + ", because " + rides, n, r1, r2);
  add("r1 is forgotten, " + is, n, u, r2);
  for (real sign : {1, -1}) {
    add("the sign of u or of r1, " + is, n, sign * (r1 - u), r2);
    add("u belongs to the lever of body 1: " + rides, n, r1, r2 + sign * u);
    add("#u-in-both u belongs to the lever of body 1 alone", n, r1 + u, r2 + sign * u);
  }
  add("#levers-exchanged the levers r1 and r2 are exchanged", n, r2 + u, r1);
  add("#doubled-u u belongs to the lever of body 1 once", n, r1 + real(2) * u, r2);
  add("u belongs to the lever of body 1, all of it: " + rides, n, r1 + u / real(2),
      r2 - u / real(2));
  add("#lever-length-1 a lever has its length: it is no unit vector",
      n, direction(r1 + u), direction(r2));
  add("#r1-plain-place-r2 the lever of body 2 is r2, not r1", n, r1 + u, r1);
  add("#r2-for-r1 the lever of body 1 is r1 + u, not r2 + u", n, r2 + u, r2);
  std::array<vec3, N> gaps;
  gaps.fill(normalize(u));
  for (const vec3& arm1 : {r1 + u, r1})
    add("the unit vector along u in the place of " + name + ": the row runs along " + name, gaps,
        arm1, r2);
  const std::string centres = "#centres-place-anchors-u centres in place of anchors: u is p2 - p1";
  for (const vec3& arm1 : {r1 + d, d}) add(centres, n, arm1, r2);
  for (const vec3& arm1 : {p1, p2})
    for (const vec3& arm2 : {r2, p2}) add("a point where a lever belongs: " + is, n, arm1, arm2);
  for (const vec3& arm1 : {r1 + u, r1}) {
    add(name + " is turned with body 2 here, but " + rides, on2, arm1, r2);
    add(name + " is left in body space: turn it into the world with body 1", local, arm1, r2);
  }
  const std::string bare = "levers are missing: such a row drives the centres, not the points";
  add(bare, n, vec3(0), vec3(0));
  add(bare + ", and its sign is wrong as well", n, vec3(0), vec3(0), -1);
  return out;
}

struct LineFixture {
  using Part = Line;
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
  static std::vector<std::pair<std::string, Jacobian<2>>> mistakes(const Part& part,
                                                                   const Pair& pair) {
    return wrong_levers<2>(pair, part.anchor1_local, part.anchor2_local,
                           {part.n1_local, part.n2_local}, "n");
  }
};

struct RotationLockFixture {
  using Part = RotationLock;
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
  static std::vector<std::pair<std::string, Jacobian<3>>> mistakes(const Part&, const Pair& pair) {
    const mat3 R1 = glm::mat3_cast(pair.body1.q), R2 = glm::mat3_cast(pair.body2.q);
    const mat3 ones(1, 1, 1, 1, 1, 1, 1, 1, 1);
    const auto turning = [](const mat3& one, const mat3& two) {
      return jacobian_from_blocks(mat3(0), -one, mat3(0), two);
    };
    const char* const axes = "the rows are in the axes of a body: C, w1 and w2 are in the world";
    return {{axes, turning(transpose(R1), transpose(R1))}, {axes, turning(R1, R1)},
            {axes, turning(transpose(R2), transpose(R2))}, {axes, turning(R2, R2)},
            {axes, turning(transpose(R1), transpose(R2))}, {axes, turning(R1, R2)},
            {told_ones_everywhere, turning(ones, ones)},
            {told_ones_everywhere, turning(mat3(1), ones)},
            {"a lock turns and does not push: E belongs to w1 and w2, not to v1 and v2",
             jacobian_from_blocks(mat3(-1), mat3(0), mat3(1), mat3(0))},
            {"#sign-body-1 w1 and w2 with the same sign: C grows with w2 - w1",
             turning(mat3(-1), mat3(1))}};
  }
};

struct SlideFixture {
  using Part = Slide;
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
  static std::vector<std::pair<std::string, Jacobian<1>>> mistakes(const Part& part,
                                                                   const Pair& pair) {
    return wrong_levers<1>(pair, part.anchor1_local, part.anchor2_local, {part.a1_local}, "a");
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
