// Exercise 3.5 as a table of cases with its usual mistakes: the motor.
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
  using Case = MotorCase;
  constexpr double h = motor_h;
  const auto clamped = [](double a, double bound) { return std::clamp(a, -bound, bound); };
  const auto lack = [](const Case& c) { return -(c.rate - c.speed) / c.K; };
  // a motor whose sum would be `wanted` without its bound
  const auto motor = [=](auto wanted, auto bound) {
    return [=](const Case& c) {
      const double sum = clamped(wanted(c), bound(c));
      return Numbers{sum - c.sum, sum};
    };
  };
  const auto bound = [](const Case& c) { return h * c.strength; };
  const auto wanting = [=](auto wanted) { return motor(wanted, bound); };
  const auto wanted = [=](const Case& c) { return c.sum + lack(c); };
  const auto bounded = [=](auto other) { return motor(wanted, other); };
  const auto right = motor(wanted, bound);
  const char* const each = "#each-change-clamped each change is clamped: it is the accumulated "
                           "impulse of a step that stays within h strength";
  const char* const no_h =
      "#torque-impulse the bound is h strength: an impulse is a torque times a time, and h is "
      "missing";
  const char* const not_stored = "#sum-not-stored the sum is not stored";
  const char* const bracket = "#precedence the bracket in (rate - speed) / K: all of the "
                              "difference is divided";
  const char* const too_fast =
      "#speed-already-size a motor that runs too fast brakes: its impulse may have either sign";
  const char* const threshold =
      "#early-out-1e-3 a motor pushes until its speed is reached: no threshold on the missing "
      "impulse";
  const char* const sign = "the sign: the impulse works against J V - speed";

  CaseTable<Case> table{{"3.5", "the impulse of a motor"}, {"returned", "new sum"}, {}, {}, {}, {}};
  table.yours = [=](const Case& c) {
    real sum = real(c.sum);
    const real change = motor_impulse(real(c.rate), real(c.K),
                                      {real(c.speed), real(c.strength)}, real(h), sum);
    return Numbers{double(change), double(sum)};
  };
  table.right = right;
  table.mistakes = {
      {"#sign-speed the sign of the speed: the row is J V - speed = 0, not J V + speed = 0",
       wanting([](const Case& c) { return c.sum - (c.rate + c.speed) / c.K; })},
      {sign, wanting([=](const Case& c) { return c.sum - lack(c); })},
      {no_h, bounded([](const Case& c) { return c.strength; })},
      {"the bound is h strength: times h, not divided by h",
       bounded([](const Case& c) { return c.strength / h; })},
      {each,
       [=](const Case& c) {
         const double change = clamped(lack(c), bound(c));
         return Numbers{change, c.sum + change};
       }},
      {each,
       [=](const Case& c) {
         const double change = clamped(wanted(c) - c.sum, bound(c));
         return Numbers{change, c.sum};
       }},
      {"each change is clamped, and h is missing: it is the sum that stays within h strength",
       [=](const Case& c) {
         const double change = clamped(lack(c), c.strength);
         return Numbers{change, c.sum + change};
       }},
      {"#strength-0-unlimited strength 0 is a motor that is off, not one without a bound",
       bounded([=](const Case& c) { return c.strength == 0 ? 1e30 : h * c.strength; })},
      {"#bound-by-speed the bound is h strength: it is independent of the speed",
       bounded([](const Case& c) { return h * std::abs(c.speed); })},
      {"#k-squared K is used twice: (rate - speed) / K",
       wanting([=](const Case& c) { return c.sum + lack(c) / c.K; })},
      {"a factor of 0.5 in the required impulse", wanting([=](const Case& c) {
         return c.sum + lack(c) / 2;
       })},
      {"#lack-sum the missing speed is divided by K and added to the sum",
       wanting([](const Case& c) { return c.speed - c.rate; })},
      {"always the full impulse: the motor gives (speed - rate) / K, at most h strength",
       wanting([=](const Case& c) { return c.sum + std::copysign(1e30, c.speed - c.rate); })},
      {"#bound-with-k the bound is h strength: it is independent of K",
       bounded([](const Case& c) { return h * c.strength / c.K; })},
      {"the bound is h strength: h is used twice",
       bounded([](const Case& c) { return h * h * c.strength; })},
      {"#step-1-60 the bound is h strength: h is the argument, not 1/60",
       bounded([](const Case& c) { return c.strength / 60; })},
      {"#int-strength the bound is cut off to a whole number: an int has no fraction",
       bounded([](const Case& c) { return std::trunc(h * c.strength); })},
      {"the required impulse is cut off to a whole number: an int has no fraction",
       wanting([=](const Case& c) { return std::trunc(wanted(c)); })},
      {"#int-speed the speed is cut off to a whole number: an int has no fraction",
       wanting([](const Case& c) { return c.sum - (c.rate - std::trunc(c.speed)) / c.K; })},
      {"#all-over-h an impulse does not contain h: (rate - speed) / K, and the bound is h strength",
       motor([=](const Case& c) { return c.sum + lack(c) / h; },
             [](const Case& c) { return c.strength; })},
      {"#clamp-not-assigned nothing is clamped, or the old sum is: the new one stays within h "
       "strength",
       bounded([](const Case&) { return 1e30; })},
      {"only the upper bound is there: the torque is bounded either way",
       [=](const Case& c) {
         const double sum = std::min(wanted(c), bound(c));
         return Numbers{sum - c.sum, sum};
       }},
      {"only the lower bound is there: the torque is bounded either way",
       [=](const Case& c) {
         const double sum = std::max(wanted(c), -bound(c));
         return Numbers{sum - c.sum, sum};
       }},
      {"#lower-bound-0 the sum is kept from 0 to h strength: the torque is bounded either way",
       [=](const Case& c) {
         const double sum = std::clamp(wanted(c), 0.0, bound(c));
         return Numbers{sum - c.sum, sum};
       }},
      {"#bound-one-side the sum is kept between 0 and the bound on the side of the speed: a motor "
       "brakes, too",
       [=](const Case& c) {
         const double end = c.speed < 0 ? -bound(c) : bound(c);
         const double sum = std::clamp(wanted(c), std::min(end, 0.0), std::max(end, 0.0));
         return Numbers{sum - c.sum, sum};
       }},
      {"#if-else-keeps-old below the lower bound the sum is that bound: it is not left as it was",
       [=](const Case& c) {
         const double sum = wanted(c) <= -bound(c) ? c.sum : std::min(wanted(c), bound(c));
         return Numbers{sum - c.sum, sum};
       }},
      {"#sum-thrown-away the sum so far is thrown away: it grows over all iterations of a step",
       [=](const Case& c) {
         const double sum = clamped(lack(c), bound(c));
         return Numbers{sum, sum};
       }},
      {"#min-max-exchanged the sum is always at its lower bound: are min and max exchanged, or is "
       "a variable never set?",
       [=](const Case& c) { return Numbers{-bound(c) - c.sum, -bound(c)}; }},
      {"the sum is always at its upper bound: are min and max exchanged, or is a variable never "
       "set?",
       [=](const Case& c) { return Numbers{bound(c) - c.sum, bound(c)}; }},
      {"#if-lower-sign-lost below the lower bound the sum is the lower bound, not the upper one",
       [=](const Case& c) {
         const double sum = std::abs(wanted(c)) > bound(c) ? bound(c) : wanted(c);
         return Numbers{sum - c.sum, sum};
       }},
      {"#drops-when-exceeding no impulse where the required one exceeds the bound: the motor gives "
       "its bound there",
       [=](const Case& c) {
         return std::abs(wanted(c)) > bound(c) ? Numbers{0, c.sum} : right(c);
       }},
      {"#does-not-push-when nothing is done for a sum at its bound: it may become smaller again",
       [=](const Case& c) {
         return std::abs(c.sum) >= bound(c) ? Numbers{0, c.sum} : right(c);
       }},
      {"#clamp-the-rate the rate is clamped: it is the sum that stays within h strength",
       [=](const Case& c) {
         const double sum = c.sum - clamped(c.rate - c.speed, bound(c)) / c.K;
         return Numbers{sum - c.sum, sum};
       }},
      {"#new-sum-added the new sum is added to the old one: it takes its place",
       [=](const Case& c) { return Numbers{right(c)[1], c.sum + right(c)[1]}; }},
      {not_stored, [=](const Case& c) { return Numbers{right(c)[0], c.sum}; }},
      {"the sum that is stored is not clamped",
       [=](const Case& c) { return Numbers{right(c)[0], wanted(c)}; }},
      {"#returns-the-sum the new sum is returned instead of its change",
       [=](const Case& c) { return Numbers{right(c)[1], right(c)[1]}; }},
      {"the required impulse is returned: return the change of the sum",
       [=](const Case& c) { return Numbers{lack(c), right(c)[1]}; }},
      {"the required impulse is returned: return the change of the sum",
       [=](const Case& c) { return Numbers{wanted(c), right(c)[1]}; }},
      {"the sum is returned and not stored: store it and return its change",
       [=](const Case& c) { return Numbers{right(c)[1], c.sum}; }},
      {"#returns-bound the bound is returned: return the change of the sum",
       [=](const Case& c) { return Numbers{bound(c), right(c)[1]}; }},
      {"old and new sum are added: return the change of the sum",
       [=](const Case& c) { return Numbers{right(c)[1] + c.sum, right(c)[1]}; }},
      {"#returns-what-was-cut the part that was cut off is returned: return the change of the sum",
       [=](const Case& c) { return Numbers{wanted(c) - right(c)[1], right(c)[1]}; }},
      {"the sign of the change: new sum minus old sum",
       [=](const Case& c) { return Numbers{-right(c)[0], right(c)[1]}; }},
      {"#before-after 0 is returned: keep the old sum before the new one is stored",
       [=](const Case& c) { return Numbers{0, right(c)[1]}; }},
      {"the sum so far is missing in the required sum", wanting(lack)},
      {"the change is added to the sum twice",
       [=](const Case& c) { return Numbers{right(c)[0], right(c)[1] + right(c)[0]}; }},
      {"times K where it must be divided by K",
       wanting([](const Case& c) { return c.sum - (c.rate - c.speed) * c.K; })},
      {bracket, wanting([](const Case& c) { return c.sum - (c.rate - c.speed / c.K); })},
      {bracket, wanting([](const Case& c) { return c.sum - c.rate - c.speed / c.K; })},
      {bracket, wanting([](const Case& c) { return c.sum - c.rate + c.speed / c.K; })},
      {bracket, wanting([](const Case& c) { return c.sum - c.rate / c.K - c.speed; })},
      {bracket, wanting([](const Case& c) { return c.sum - c.rate / c.K + c.speed; })},
      {"#minus-sum the sign of the sum so far: the required impulse is added to it",
       wanting([=](const Case& c) { return -c.sum + lack(c); })},
      {"#abs-rate no absolute value of the rate: it has a direction",
       wanting([](const Case& c) { return c.sum - (std::abs(c.rate) - c.speed) / c.K; })},
      {"#k-forgotten K is missing: divide by it",
       wanting([](const Case& c) { return c.sum - (c.rate - c.speed); })},
      {"the old sum is divided by K, too",
       wanting([](const Case& c) { return (c.sum - (c.rate - c.speed)) / c.K; })},
      {"the speed of the motor is missing: this is a brake",
       wanting([](const Case& c) { return c.sum - c.rate / c.K; })},
      {"the rate is missing: the motor adds only the missing speed",
       wanting([](const Case& c) { return c.sum + c.speed / c.K; })},
      {"the impulse is multiplied by h: it is an impulse already, not a torque",
       wanting([=](const Case& c) { return c.sum + h * lack(c); })}};
  const auto unless = [&](const std::string& words, auto idle) {
    table.mistakes.push_back(
        {words, [=](const Case& c) { return idle(c) ? Numbers{0, c.sum} : right(c); }});
  };
  unless(too_fast, [](const Case& c) { return c.rate >= c.speed; });
  unless(too_fast, [](const Case& c) { return c.rate > c.speed; });
  unless(too_fast, [](const Case& c) { return std::abs(c.rate) >= std::abs(c.speed); });
  unless(too_fast, [](const Case& c) { return std::abs(c.rate) > std::abs(c.speed); });
  unless("#early-out-speed-0 a motor whose speed is 0 is a brake: it pushes until nothing moves",
         [](const Case& c) { return c.speed == 0; });
  unless("a slow motor is one, too: no threshold on its speed",
         [](const Case& c) { return std::abs(c.speed) < 1e-3; });
  unless("#early-out-small-strength a weak motor is one, too: no threshold on its strength",
         [](const Case& c) { return c.strength < 1e-3; });
  for (const double small : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) {
    unless(threshold, [=](const Case& c) { return std::abs(c.rate - c.speed) < small; });
    unless(threshold, [=](const Case& c) { return std::abs(lack(c)) < small; });
  }
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
  table.leave_out_harmless();
  return table;
}

}  // namespace joints::testing
