// Exercise 3.5 as a table of cases: the motor.
#pragma once

#include <algorithm>

#include "chapters/03_hinge/hinge.h"
#include "tests/checker/cases.h"

namespace joints::testing {

/// One solve, in a step of 1/10 s.
struct MotorCase {
  std::string words;
  double rate, K, speed, strength, sum;
};
inline constexpr double motor_h = 0.1;

inline CaseTable<MotorCase> motor_table() {
  CaseTable<MotorCase> table{{"3.5", "the impulse of a motor"}, {"returned", "new sum"},
                             {}, {}, {}, {}};
  judge(table, motor_impulse, [](auto motor_impulse, const MotorCase& c) {
    real sum = real(c.sum);
    const real change = motor_impulse(real(c.rate), real(c.K), {real(c.speed), real(c.strength)},
                                      real(motor_h), sum);
    return Numbers{double(change), double(sum)};
  });
  table.right = [](const MotorCase& c) {
    const double bound = motor_h * c.strength;
    const double sum = std::min(std::max(c.sum + (c.speed - c.rate) / c.K, -bound), bound);
    return Numbers{sum - c.sum, sum};
  };
  const auto add = [&](double rate, double K, double speed, double strength, double sum) {
    table.cases.push_back({"rate " + short_number(rate) + " sum " + short_number(sum), rate, K,
                           speed, strength, sum});
  };
  for (const double way : {1, -1}) {
    add(way * 0, 0.5, way * 3, 10, 0);             // the two iterations of the text
    add(way * 0.5, 0.5, way * 3, 10, way * 1);
    add(way * 2.9, 0.5, way * 3, 10, 0);           // within the bound
    add(way * 2.9, 0.5, way * 3, 10, way * 0.5);
    add(way * 3.25, 0.5, way * 3, 10, way * 0.75);  // too fast: gives back
    add(way * 9, 0.5, way * 3, 10, way * 0.5);     // much too fast: brakes with all it has
    add(way * 9, 0.5, way * 3, 10, way * 1);       // and from its bound
    add(way * 1, 2.5, way * 4, 30, way * 1.5);
    add(way * 1, 2.5, way * 4, 0, 0);              // off
    add(way * 0, 0.5, way * 2.5, 7, 0);            // no whole numbers
    add(way * 1, 2.5, way * 1.75, 70, way * 1.5);
    add(way * 2, 0.5, 0, 70, way * 0.5);           // a brake
    add(way * 0, 20, way * 8e-4, 10, 0);           // slow, and little to do
    add(way * 0, 0.01, way * 5e-4, 10, 0);
    add(way * 3.0005, 20, way * 3, 10, 0);
    add(way * 2.985, 20, way * 3, 10, 0);          // little impulse, then little speed
    add(way * 2.9996, 0.01, way * 3, 10, 0);
    add(way * 3.00000002, 0.01, way * 3, 10, way * 0.5);
    add(way * 0, 0.5, way * 3, 5e-4, way * 2e-5);  // weak
  }
  table.tolerance = 10 * rounding;
  return table;
}

}  // namespace joints::testing
