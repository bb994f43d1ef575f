// Exercise 8.1: the room of a corner at every pose as a table, with its usual mistakes.
#pragma once

#include "tests/checker/cases.h"
#include "tests/08_ground/ground_cases.h"

namespace joints::testing {

struct RoomCase {
  std::string words;
  Corner corner;
  Pair pair;
};

/// What a corner's pose is called.
inline std::string corner_pose(int pose) {
  return pose == 3 ? CornerFixture::broken.name : pose_names[std::size_t(pose)];
}

/// Sharp corners and balls at every pose.
inline std::vector<RoomCase> room_cases() {
  std::vector<RoomCase> out;
  visit_poses<CornerFixture>([&](int pose, const Corner& part, const Pair& pair) {
    out.push_back({"corner, " + corner_pose(pose), part, pair});
  });
  visit_poses<BallOnTopFixture>([&](int pose, const Corner& part, const Pair& pair) {
    out.push_back({"ball, " + corner_pose(pose), part, pair});
  });
  return out;
}

inline CaseTable<RoomCase> room_table() {
  using Case = RoomCase;
  const auto n_of = [](const Case& c) { return to_world(c.pair.body1, vec3(0, 1, 0)); };
  const auto centre = [](const Case& c) {
    return world_point(c.pair.body2, c.corner.corner_local);
  };
  const auto right = [](const Case& c) {
    return Numbers{double(room(c.corner, c.pair.body1, c.pair.body2))};
  };
  // what comes on top of the right C
  const auto plus = [=](auto more) {
    return [=](const Case& c) { return Numbers{right(c)[0] + double(more(c))}; };
  };
  // measured from x1 along another direction; the point itself is right
  const auto along = [=](auto direction) {
    return [=](const Case& c) {
      const vec3 p = centre(c) - c.corner.radius * n_of(c);
      return Numbers{double(dot(direction(c), p - c.pair.body1.x) - c.corner.height)};
    };
  };
  // another vector in the place of p - x1
  const auto from = [=](auto vector) {
    return [=](const Case& c) {
      return Numbers{double(dot(n_of(c), vector(c)) - c.corner.height)};
    };
  };
  const auto changed = [=](double (*change)(double)) {
    return [=](const Case& c) { return Numbers{change(right(c)[0])}; };
  };
  const vec3 y(0, 1, 0);
  const auto point = [=](const Case& c) { return centre(c) - c.corner.radius * n_of(c); };

  CaseTable<Case> table{{"8.1", "the error C of a corner"}, {"C"}, {}, {}, {}, room_cases()};
  table.yours = [](const Case& c) {
    return Numbers{double(c.corner.error(c.pair.body1, c.pair.body2))};
  };
  table.right = right;
  table.mistakes = {
      {"n is not turned: up is the y axis of body 1, up(body1), not that of the world",
       along([=](const Case&) { return y; })},
      {"n is not turned, and height is forgotten",
       [=](const Case& c) { return Numbers{double((point(c) - c.pair.body1.x).y)}; }},
      {"n is the axis of body 2: up is the y axis of body 1",
       along([=](const Case& c) { return c.pair.body2.q * y; })},
      {"n is turned the wrong way round: body 1 turns it into the world, up(body1)",
       along([=](const Case& c) { return conjugate(c.pair.body1.q) * y; })},
      {"height is forgotten: the top stands above the centre of body 1",
       plus([](const Case& c) { return c.corner.height; })},
      {"height is added: it is taken away, the top is where it ends",
       plus([](const Case& c) { return 2 * c.corner.height; })},
      {"the radius is forgotten: the lowest point of the ball counts, point()",
       plus([](const Case& c) { return c.corner.radius; })},
      {"the radius is added: the point is below the centre of the ball",
       plus([](const Case& c) { return 2 * c.corner.radius; })},
      {"the radius is taken away twice: point() has done so already",
       plus([](const Case& c) { return -c.corner.radius; })},
      {"the radius and height are forgotten",
       plus([](const Case& c) { return c.corner.radius + c.corner.height; })},
      {"the radius along the y axis of the world: it is along n",
       from([=](const Case& c) { return centre(c) - c.corner.radius * y - c.pair.body1.x; })},
      {"a world point in the place of p - x1: C is measured from body 1", from(point)},
      {"x1 and height are forgotten: C is measured from the top of body 1",
       [=](const Case& c) { return Numbers{double(dot(n_of(c), point(c)))}; }},
      {"the height of the point in the world: C is measured from body 1, along its n",
       [=](const Case& c) { return Numbers{double(point(c).y - c.corner.height)}; }},
      {"the lever of body 2 in the place of the one of body 1: p - x1",
       from([=](const Case& c) { return point(c) - c.pair.body2.x; })},
      {"point(body2, body1): the other way round, the corner is one of body 2",
       from([](const Case& c) {
         return c.corner.point(c.pair.body2, c.pair.body1) - c.pair.body1.x;
       })},
      {"from centre to centre: the corner counts, point()",
       from([](const Case& c) { return c.pair.body2.x - c.pair.body1.x; })},
      {"corner_local is not turned into the world: point() does it",
       from([=](const Case& c) {
         return c.pair.body2.x + c.corner.corner_local - c.corner.radius * n_of(c) -
                c.pair.body1.x;
       })},
      {"the length of p - x1: only what is along n counts, the dot product",
       [=](const Case& c) {
         return Numbers{double(length(point(c) - c.pair.body1.x) - c.corner.height)};
       }},
      {"height along the y axis of the world: it is along n",
       [=](const Case& c) {
         return Numbers{double(dot(n_of(c), point(c) - c.pair.body1.x - c.corner.height * y))};
       }},
      {"the sign: C is positive above the top", changed([](double C) { return -C; })},
      {"the size of C: below the top it is negative",
       changed([](double C) { return std::abs(C); })},
      {"nothing below the top: C is negative there, that tells how deep the corner is",
       changed([](double C) { return std::max(C, 0.0); })},
      {"only below the top: while C > 0 it is the room that may be used up",
       changed([](double C) { return std::min(C, 0.0); })},
      {"C is never measured: it is 0 everywhere", changed([](double) { return 0.0; })}};
  table.tolerance = 10 * rounding;
  return table;
}

}  // namespace joints::testing
