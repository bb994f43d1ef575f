// The part of exercise 10.5: its two functions stay on the side of the answer.
// By hand: own_part
#pragma once

#include "chapters/10_own/own.h"
#include "tests/remote/function.h"

namespace joints::by_hand {

using namespace joints::testing::remote;
/// What the tests get: rows, whether it is one-sided, its place among those that were made.
struct Made {
  int rows;
  bool one_sided;
  std::size_t place;
};
using Part = Function<Made(const Body&, const Body&)>;
using Errors = Function<std::array<real, 6>(std::size_t, const Body&, const Body&)>;
using Rows = Function<std::array<Row, 6>(std::size_t, const Body&, const Body&)>;

inline OwnPart own_part(const Body& body1, const Body& body2) {
  const Made made = Part::call("10.5", "own_part", nullptr, body1, body2);
  return {made.rows, made.one_sided,
          [=](const Body& one, const Body& two) {
            return Errors::call("10.5", "error", nullptr, made.place, one, two);
          },
          [=](const Body& one, const Body& two) {
            return Rows::call("10.5", "jacobian", nullptr, made.place, one, two);
          }};
}

inline void serve() {
  static std::vector<OwnPart> all;
  Part::serve("own_part", [](const Body& body1, const Body& body2) {
    all.push_back(joints::own_part(body1, body2));
    return Made{all.back().rows, all.back().one_sided, all.size() - 1};
  });
  Errors::serve("error", [](std::size_t place, const Body& body1, const Body& body2) {
    return all.at(place).error(body1, body2);
  });
  Rows::serve("jacobian", [](std::size_t place, const Body& body1, const Body& body2) {
    return all.at(place).jacobian(body1, body2);
  });
}

}  // namespace joints::by_hand
