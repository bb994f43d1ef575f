// The errors of exercises 4.1 and 4.3 as tables of cases: beside a line and along it.
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

/// A table of the error of a part. \param right of the part and of the gap, seen from body 1
template <class Fixture, class Error, class Measure>
CaseTable<PartCase<typename Fixture::Part>> error_table(const Subject& subject,
                                                        const std::vector<std::string>& entries,
                                                        Error* yours, const Measure& right) {
  using Case = PartCase<typename Fixture::Part>;
  CaseTable<Case> table{subject, entries, {}, {}, {}, part_cases<Fixture>()};
  judge(table, yours, [](auto error, const Case& c) {
    const auto C = to_vector(error(c.part, c.pair.body1, c.pair.body2));
    return Numbers(C.begin(), C.end());
  });
  table.right = [=](const Case& c) {
    return right(c.part, conjugate(c.pair.body1.q) * gap(c.part, c.pair.body1, c.pair.body2));
  };
  table.tolerance = 10 * rounding;
  return table;
}

inline CaseTable<PartCase<Line>> line_table() {
  return error_table<LineFixture>(
      {"4.1", "the error C of a line"}, row_names<LineFixture>(),
      +[](const Line& line, const Body& body1, const Body& body2) {
        return line.error(body1, body2);
      },
      [](const Line& line, const vec3& seen) {
        return Numbers{double(dot(seen, line.n1_local)), double(dot(seen, line.n2_local))};
      });
}

inline CaseTable<PartCase<Slide>> slide_table() {
  return error_table<SlideFixture>(
      {"4.3", "the displacement along a line"}, {"u.a"},
      +[](const Slide& slide, const Body& body1, const Body& body2) {
        return slide.error(body1, body2);
      },
      [](const Slide& slide, const vec3& seen) {
        return Numbers{double(dot(seen, slide.a1_local))};
      });
}

}  // namespace joints::testing
