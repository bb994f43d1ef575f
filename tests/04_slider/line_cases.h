// The errors of exercises 4.1 and 4.3 as tables of cases, each with its usual mistakes: beside a
// line and along it.
#pragma once

#include "tests/04_slider/slider_references.h"
#include "tests/checker/cases.h"

namespace joints::testing {

template <class Part>
struct PartCase {
  std::string words;
  Part part;
  Pair pair;
};

/// A part at every pose, then with a static body each.
template <class Fixture>
std::vector<PartCase<typename Fixture::Part>> part_cases() {
  std::vector<PartCase<typename Fixture::Part>> out;
  for_each_pose<Fixture>([&](int pose, const auto& part, const Pair& pair) {
    out.push_back({pose_names[pose], part, pair});
  });
  for (const bool second : {false, true}) {
    out.push_back(out.back());
    out.back().words = second ? "2 static" : "1 static";
    Body &one = out.back().pair.body1, &two = out.back().pair.body2;
    one = second ? body_with(2, vec3(1), one.x, one.q) : static_body(one.x, one.q);
    if (second) two = static_body(two.x, two.q);
  }
  return out;
}

/// A table whose numbers are u.d for some directions d of body 1. \param name of a direction
template <class Fixture>
CaseTable<PartCase<typename Fixture::Part>> along_table(
    const Subject& subject, const std::vector<std::string>& entries,
    std::vector<vec3> (*locals)(const typename Fixture::Part&), const std::string& name) {
  using Case = PartCase<typename Fixture::Part>;
  const auto along = [=](auto u, auto turn) {
    return [=](const Case& c) {
      Numbers out;
      for (const vec3& local : locals(c.part)) out.push_back(double(dot(u(c), turn(c, local))));
      return out;
    };
  };
  const auto u = [](const Case& c) {
    return world_point(c.pair.body2, c.part.anchor2_local) -
           world_point(c.pair.body1, c.part.anchor1_local);
  };
  const auto d = [](const Case& c) { return c.pair.body2.x - c.pair.body1.x; };
  const auto on_1 = [](const Case& c, const vec3& local) { return c.pair.body1.q * local; };
  const auto on_2 = [](const Case& c, const vec3& local) { return c.pair.body2.q * local; };
  const auto as_it_is = [](const Case&, const vec3& local) { return local; };
  const auto back = [](const Case& c, const vec3& local) {
    return conjugate(c.pair.body1.q) * local;
  };
  const auto point = [](const Case& c, const vec3& local) {
    return c.pair.body1.x + c.pair.body1.q * local;
  };
  const auto seen_from_1 = [=](const Case& c) { return conjugate(c.pair.body1.q) * u(c); };
  const auto p2 = [](const Case& c) {
    return world_point(c.pair.body2, c.part.anchor2_local);
  };
  const auto opposite = [=](const Case& c) { return -u(c); };
  const auto right = along(u, on_1);
  const auto each = [=](auto f) {
    return [=](const Case& c) {
      Numbers out = right(c);
      for (double& number : out) number = f(number);
      return out;
    };
  };
  const auto unless_static = [=](bool first, bool second) {
    return [=](const Case& c) {
      const bool is = (first && c.pair.body1.is_static()) || (second && c.pair.body2.is_static());
      return is ? Numbers(entries.size(), 0) : right(c);
    };
  };
  const std::string body_space =
      name + " is left in body space: turn it into the world with body 1";
  const std::string points = name + " is a direction, not a point: to_world, not world_point";
  const char* const unit = "#cosine u is not made a unit vector: its length counts";
  const char* const statics = "#zero-static-body a static body has an error, too";

  CaseTable<Case> table{subject, entries, {}, right, {}, part_cases<Fixture>()};
  table.yours = [](const Case& c) {
    const auto C = to_vector(c.part.error(c.pair.body1, c.pair.body2));
    return Numbers(C.begin(), C.end());
  };
  table.mistakes = {
      {"#sign-u-runs-point the sign: u runs from the point of body 1 to that of body 2",
       along(opposite, on_1)},
      {body_space, along(u, as_it_is)},
      {name + " is turned the wrong way round: to_world, not to_local", along(u, back)},
      {name + " is turned with body 2: the line rides on body 1", along(u, on_2)},
      {points, along(u, point)},
      {"u is turned, too: u and " + name + " are both in the world", along(seen_from_1, on_1)},
      {"#centres-place-anchors-u centres in place of anchors: u is p2 - p1", along(d, on_1)},
      {"centres in place of anchors, and " + name + " left in body space", along(d, as_it_is)},
      {"#p2-only the point of body 2 in the place of u: u is p2 - p1", along(p2, on_1)},
      {"#p1-x2 the anchor of body 2 is forgotten: u is p2 - p1", along([=](const Case& c) {
         return c.pair.body2.x - world_point(c.pair.body1, c.part.anchor1_local);
       }, on_1)},
      {"the anchor of body 1 is forgotten: u is p2 - p1",
       along([=](const Case& c) { return p2(c) - c.pair.body1.x; }, on_1)},
      {unit, along([=](const Case& c) { return direction(u(c)); }, on_1)},
      {unit, along([=](const Case& c) { return normalize(u(c)); }, on_1)},
      {"the length of u: only its part along " + name + " counts",
       [=](const Case& c) { return Numbers(entries.size(), double(length(u(c)))); }},
      {"the length of u: only its part along " + name + " counts",
       [=](const Case& c) {
         Numbers out = right(c);
         for (double& number : out) number = std::copysign(double(length(u(c))), number);
         return out;
       }},
      {"the length of a cross product: take the dot product of u and " + name,
       [=](const Case& c) {
         Numbers out;
         for (const vec3& local : locals(c.part))
           out.push_back(double(length(cross(u(c), on_1(c, local)))));
         return out;
       }},
      {"the square: the dot product of u and " + name + " itself",
       each([](double a) { return a * a; })},
      {statics, unless_static(true, false)},
      {statics, unless_static(false, true)},
      {statics, unless_static(true, true)}};
  table.tolerance = 10 * rounding;
  return table;
}

inline CaseTable<PartCase<Line>> line_table() {
  auto table = along_table<LineFixture>({"4.1", "the error C of a line"}, row_names<LineFixture>(),
                               [](const Line& part) {
                                 return std::vector<vec3>{part.n1_local, part.n2_local};
                               },
                               "n");
  const auto with = [&](const char* words, auto change) {
    table.mistakes.push_back({words, [=, right = table.right](const auto& c) {
                                const Numbers C = right(c);
                                return change(C[0], C[1]);
                              }});
  };
  with("#swapped n1 and n2 are exchanged", [](double a, double b) { return Numbers{b, a}; });
  with("#n1-twice n1 twice: the second number belongs to n2",
       [](double a, double) { return Numbers{a, a}; });
  with("n2 twice: the first number belongs to n1", [](double, double b) { return Numbers{b, b}; });
  with("the second number is missing", [](double a, double) { return Numbers{a, 0}; });
  with("the first number is missing", [](double, double b) { return Numbers{0, b}; });
  table.mistakes.push_back(
      {"#n1-x-n2 n1 x n2 runs along the line, where the displacement is free: C holds u.n1 and "
       "u.n2",
       [](const PartCase<Line>& c) {
         const vec3 a = c.pair.body1.q * cross(c.part.n1_local, c.part.n2_local);
         const double along = double(dot(gap(c.part, c.pair.body1, c.pair.body2), a));
         return Numbers{along, along};
       }});
  return table;
}

inline CaseTable<PartCase<Slide>> slide_table() {
  auto table = along_table<SlideFixture>(
      {"4.3", "the displacement along a line"}, {"u.a"},
      [](const Slide& part) { return std::vector<vec3>{part.a1_local}; }, "a");
  table.mistakes.push_back({"#abs the displacement has a sign: it is negative behind the start",
                            [right = table.right](const auto& c) {
                              return Numbers{std::abs(right(c)[0])};
                            }});
  return table;
}

}  // namespace joints::testing
