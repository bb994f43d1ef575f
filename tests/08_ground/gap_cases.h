// Exercise 8.1: the gap of a corner at every pose as a table, with its usual mistakes.
#pragma once

#include "tests/08_ground/ground_cases.h"
#include "tests/checker/pieces.h"

namespace joints::testing {

struct GapCase {
  std::string words;
  Corner corner;
  Pair pair;
};

/// What a corner's pose is called.
inline std::string corner_pose(int pose) {
  return pose == 3 ? CornerFixture::broken.name : pose_names[std::size_t(pose)];
}

/// Sharp corners and balls at every pose, and one of each over a static ground.
inline std::vector<GapCase> gap_cases() {
  std::vector<GapCase> out;
  const auto look = [&](const std::string& what) {
    return [&, what](int pose, const Corner& part, const Pair& pair) {
      out.push_back({what + corner_pose(pose), part, pair});
    };
  };
  for_each_pose<CornerFixture>(look("corner, "));
  for_each_pose<BallOnTopFixture>(look("ball, "));
  for (const std::size_t k : {std::size_t(14), out.size() - 1}) {
    out.push_back(out[k]);
    out.back().words = (k == 14 ? "corner, 1 static, " : "ball, 1 static, ") + corner_pose(3);
    Body& ground = out.back().pair.body1;
    ground = static_body(ground.x, ground.q);
  }
  return out;
}

/// n . (place + arm - rho - origin) - height, each by itself.
struct GapReference {
  GapCase c;
  vec3 n, place, arm, rho, origin;
  real height;
  Call<real(const GapReference&)> instead;  ///< of the whole
  Call<real(real)> after;                   ///< what becomes of C

  explicit GapReference(const GapCase& c)
      : c(c), n(to_world(c.pair.body1, vec3(0, 1, 0))), place(c.pair.body2.x),
        arm(to_world(c.pair.body2, c.corner.corner_local)), rho(c.corner.radius * n),
        origin(c.pair.body1.x), height(c.corner.height) {}
  vec3 point() const { return place + arm - rho; }
  real gap() const {
    const real C = instead ? instead(*this) : dot(n, point() - origin) - height;
    return after ? after(C) : C;
  }
};

inline Pieces<GapReference> wrong_gaps() {
  using T = GapReference;
  using Change = Call<void(T&)>;
  const auto up = [](auto of) { return Change([=](T& t) { t.n = of(t); }); };
  const auto radius = [](auto of) { return Change([=](T& t) { t.rho = of(t); }); };
  const auto origin = [](auto of) { return Change([=](T& t) { t.origin = of(t); }); };
  const auto height = [](auto of) { return Change([=](T& t) { t.height = of(t); }); };
  const auto after = [](auto of) { return Change([=](T& t) { t.after = of; }); };
  const auto instead = [](auto of) { return Change([=](T& t) { t.instead = of; }); };
  const vec3 y(0, 1, 0);
  return {
      {"#n-not-turned n is not turned: up is the y axis of body 1, up(body1), not that of the "
       "world",
       up([=](const T&) { return y; })},
      {"#n-body-2 n is the axis of body 2: up is the y axis of body 1",
       up([=](const T& t) { return to_world(t.c.pair.body2, y); })},
      {"#turned-back n is turned the wrong way round: body 1 turns it into the world, up(body1)",
       up([=](const T& t) { return to_local(t.c.pair.body1, y); })},
      {"n is the x axis of body 1: up is its y axis",
       up([](const T& t) { return to_world(t.c.pair.body1, vec3(1, 0, 0)); })},
      {"#z-axis n is the z axis of body 1: up is its y axis",
       up([](const T& t) { return to_world(t.c.pair.body1, vec3(0, 0, 1)); })},
      {"#height-forgotten height is forgotten: the top stands above the centre of body 1",
       height([](const T&) { return real(0); })},
      {"#height-added height is added: it is subtracted, because it ends at the top",
       height([](const T& t) { return -t.height; })},
      {"height is subtracted twice: once", height([](const T& t) { return 2 * t.height; })},
      {"half of height: the top is all of it above the centre of body 1",
       height([](const T& t) { return t.height / 2; })},
      {"#radius-for-height the radius in the place of height: point() has the radius in it",
       height([](const T& t) { return t.c.corner.radius; })},
      {"the position of body 1 is subtracted, too: p - x1 contains it already",
       height([](const T& t) { return t.height + t.c.pair.body1.x.y; })},
      {"#height-upright height along the y axis of the world: it is along n",
       [=](T& t) { t.origin += t.height * y, t.height = 0; }},
      {"#radius-forgotten the radius is forgotten: the lowest point of the ball counts, point()",
       radius([](const T&) { return vec3(0); })},
      {"#radius-added the radius is added: the point is below the centre of the ball",
       radius([](const T& t) { return -t.rho; })},
      {"#radius-twice the radius is subtracted twice: point() has subtracted it already",
       radius([](const T& t) { return real(2) * t.rho; })},
      {"#radius-upright the radius along the y axis of the world: it is along n",
       radius([=](const T& t) { return t.c.corner.radius * y; })},
      {"#world-point a world point in the place of p - x1: C is measured from body 1",
       origin([](const T&) { return vec3(0); })},
      {"x1 is added: C is measured from p - x1", origin([](const T& t) { return -t.origin; })},
      {"#lever-body-2 the lever of body 2 in the place of the one of body 1: p - x1",
       origin([](const T& t) { return t.c.pair.body2.x; })},
      {"#point-body-1 point(body2, body1): the other way round, the corner is one of body 2",
       [](T& t) {
         t.place = t.c.corner.point(t.c.pair.body2, t.c.pair.body1);
         t.arm = t.rho = vec3(0);
       }},
      {"#centre-centre-corner-counts from centre to centre: the corner counts, point()",
       [](T& t) { t.arm = t.rho = vec3(0); }},
      {"#corner-not-turned corner_local is not turned into the world: point() does it",
       [](T& t) { t.arm = t.c.corner.corner_local; }},
      {"the place of body 2 is missing in the point: point() has it in it",
       [](T& t) { t.place = vec3(0); }},
      {"the lever of the corner alone: it lies at x2 + R2 corner_local, less x1",
       [](T& t) { t.place = t.origin = vec3(0); }},
      {"#height-world the height of the point in the world: C is measured from body 1, along its n",
       [=](T& t) { t.n = y, t.origin = vec3(0); }},
      {"#length the length of p - x1: only its part along n counts, the dot product",
       instead([](const T& t) { return length(t.point() - t.origin) - t.height; })},
      {"the length of a cross product: only the part along n counts, the dot product",
       instead([](const T& t) { return length(cross(t.n, t.point() - t.origin)) - t.height; })},
      {"#length-top the distance from the top: only the part along n counts, the dot product",
       instead([](const T& t) { return length(t.point() - t.origin - t.height * t.n); })},
      {"#x-y-only only x and y count in the dot product: all three do", instead([](const T& t) {
         const vec3 r = t.point() - t.origin;
         return t.n.x * r.x + t.n.y * r.y - t.height;
       })},
      {"times height: it is taken away",
       instead([](const T& t) { return dot(t.n, t.point() - t.origin) * t.height; })},
      {"#sign-vector the sign of p - x1: it runs from body 1 to the point",
       instead([](const T& t) { return dot(t.n, t.origin - t.point()) - t.height; })},
      {"over a static body it is measured in the world: C is measured from body 1, along its n",
       instead([=](const T& t) {
         return t.c.pair.body1.is_static() ? t.point().y - t.height
                                           : dot(t.n, t.point() - t.origin) - t.height;
       })},
      {"#sign-c-positive-above the sign: C is positive above the top",
       after([](real C) { return -C; })},
      {"#size the size of C: below the top it is negative",
       after([](real C) { return std::abs(C); })},
      {"#nothing-below nothing below the top: C is negative there and gives the depth of the "
       "corner",
       after([](real C) { return std::max(C, real(0)); })},
      {"only below the top: while C > 0 it is the gap that may be used up",
       after([](real C) { return std::min(C, real(0)); })},
      {"#cut-whole-numbers C is 0 everywhere: it is not measured, or cut to a whole number by an "
       "int",
       after([](real) { return real(0); })}};
}

inline CaseTable<GapCase> gap_table() {
  CaseTable<GapCase> table{{"8.1", "the error C of a corner"}, {"C"}, {}, {}, {}, gap_cases()};
  table.yours = [](const GapCase& c) {
    return Numbers{double(c.corner.error(c.pair.body1, c.pair.body2))};
  };
  table.right = [](const GapCase& c) {
    return Numbers{double(gap(c.corner, c.pair.body1, c.pair.body2))};
  };
  table.tolerance = 10 * rounding;
  add_pieces(table, [](const GapCase& c) { return GapReference(c); },
             [](const GapReference& t) { return Numbers{double(t.gap())}; }, wrong_gaps());
  return table;
}

}  // namespace joints::testing
