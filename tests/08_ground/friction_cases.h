// Exercise 8.2: what a solve adds to the impulse of friction as a table of cases, with the usual
// mistakes.
#pragma once

#include <algorithm>

#include "chapters/08_ground/ground.h"
#include "tests/checker/arguments.h"

namespace joints::testing {

struct FrictionCase {
  std::string words;
  double rate, K, mu, normal, sum;
};
inline const Arguments<FrictionCase> friction_arguments{{"rate", &FrictionCase::rate, "m/s"},
                                                        {"K", &FrictionCase::K, "1/kg"},
                                                        {"mu", &FrictionCase::mu},
                                                        {"normal", &FrictionCase::normal, "N s"},
                                                        {"sum", &FrictionCase::sum, "N s"}};
inline std::string friction_given(const FrictionCase& c) {
  return "Case: " + arguments_of(c, friction_arguments) + ".";
}

/// What is wanted, or the bound, by another formula: of each exponent and factor, in words.
inline CaseTable<FrictionCase>::Mistakes other_formulas() {
  using Case = FrictionCase;
  const auto clamped = [](double a, double bound) { return std::clamp(a, -bound, bound); };
  const auto result = [=](const Case& c, double wanted, double bound) {
    const double sum = clamped(wanted, std::abs(bound));
    return Numbers{sum - c.sum, sum};
  };
  const auto factors = [](double factor) {
    return factor == 1 ? std::string() : short_number(factor) + " ";
  };
  const auto power = [](const char* name, double exponent) {
    return exponent == 0 ? std::string()
           : exponent == 1 ? name + std::string(" ")
                           : name + ("^" + short_number(exponent)) + " ";
  };
  CaseTable<Case>::Mistakes out;
  for (const double of_mu : {0, 1, 2, -1})
    for (const double of_normal : {0, 1, 2})
      for (const double of_K : {0, 1, -1})
        for (const double of_rate : {0, 1})
          for (const double factor : {1.0, 2.0, 0.5})
            out.push_back({"the bound is mu normal, yours is " + factors(factor) +
                               power("mu", of_mu) + power("normal", of_normal) + power("K", of_K) +
                               power("|rate|", of_rate),
                           [=](const Case& c) {
                             return result(c, c.sum - c.rate / c.K,
                                           factor * std::pow(c.mu, of_mu) *
                                               std::pow(c.normal, of_normal) *
                                               std::pow(c.K, of_K) *
                                               std::pow(std::abs(c.rate), of_rate));
                           }});
  for (const double of_sum : {1, 0, -1})
    for (const double factor : {-1.0, 1.0, -2.0, 2.0, -0.5, 0.5})
      for (const double of_K : {-1, 0, 1})
        out.push_back({std::string("sum - rate/K is wanted, yours is ") +
                           (of_sum > 0 ? "sum " : of_sum < 0 ? "-sum " : "") +
                           (factor < 0 ? "- " : "+ ") + factors(std::abs(factor)) + "rate" +
                           (of_K < 0 ? "/K" : of_K > 0 ? " K" : ""),
                       [=](const Case& c) {
                         return result(c, of_sum * c.sum + factor * c.rate * std::pow(c.K, of_K),
                                       c.mu * c.normal);
                       }});
  return out;
}

inline CaseTable<FrictionCase> friction_table() {
  using Case = FrictionCase;
  const auto clamped = [](double a, double bound) { return std::clamp(a, -bound, bound); };
  const auto step = [](const Case& c) { return -c.rate / c.K; };
  const auto wanted = [=](const Case& c) { return c.sum + step(c); };
  const auto bound = [](const Case& c) { return c.mu * c.normal; };
  // what brings the sum to its new value, and returns by how much it changed
  const auto to = [](auto sum) {
    return [=](const Case& c) { return Numbers{sum(c) - c.sum, sum(c)}; };
  };
  const auto wanting = [=](auto other) {
    return to([=](const Case& c) { return clamped(other(c), bound(c)); });
  };
  const auto bounded = [=](auto other) {
    return to([=](const Case& c) { return clamped(wanted(c), other(c)); });
  };
  const auto right = bounded(bound);
  const auto no_more = [=](const Case& c) { return std::abs(wanted(c)) > bound(c); };
  const char* const each = "#each-change-clamped each change is clamped: it is the accumulated "
                           "impulse that stays within +-mu normal";
  const char* const dropped = "#dropped-beyond-bound nothing where the required sum exceeds the "
                              "bound: the sum becomes -mu normal or +mu normal";
  const char* const always = "#full-bound-always always the full bound: friction gives no more "
                             "than the impulse that stops the sliding";
  const char* const lost = "#size-rate the sign of the rate is lost: friction works against J V, "
                           "which may have either sign";
  const char* const added = "#new-sum-added the new sum is added to the old one: it takes its "
                            "place";
  const char* const inwards = "#bound-only-outwards the bound moves inwards when the normal "
                              "impulse becomes less, and the sum goes with it: clamp the sum anew "
                              "in each iteration";
  const char* const early = "#clamped-early the old sum is clamped as well: only the new one is";
  const char* const either = ": friction is bounded either way, -mu normal and +mu normal";
  const char* const same_bound = "#always-the-bound always the same bound: are the ends of clamp "
                                 "exchanged, clamp(a, low, high), or was a variable never set?";
  const char* const returns = "#returns-what-was-wanted the required impulse is returned: return "
                              "the change of the sum";

  CaseTable<Case> table{{"8.2", "the impulse of friction", 2}, {"change", "sum"}, {}, {}, {}, {}};
  table.given = friction_given;
  table.yours = [=](const Case& c) {
    real sum = real(c.sum);
    const real change =
        friction_impulse(real(c.rate), real(c.K), real(c.mu), real(c.normal), sum);
    return Numbers{double(change), double(sum)};
  };
  table.right = right;
  table.mistakes = {
      {"#sign-friction-works-against the sign: friction works against J V, wanted = sum - rate/K",
       wanting([=](const Case& c) { return c.sum - step(c); })},
      {lost, wanting([=](const Case& c) { return c.sum - std::abs(step(c)); })},
      {lost, wanting([=](const Case& c) { return c.sum + std::abs(step(c)); })},
      {each,
       [=](const Case& c) {
         const double change = clamped(step(c), bound(c));
         return Numbers{change, c.sum + change};
       }},
      {each,
       [=](const Case& c) {
         const double change = clamped(step(c), bound(c));
         return Numbers{change, change};
       }},
      {inwards, to([=](const Case& c) {
         return std::clamp(wanted(c), std::min(c.sum, -bound(c)), std::max(c.sum, bound(c)));
       })},
      {dropped, to([=](const Case& c) { return no_more(c) ? c.sum : wanted(c); })},
      {inwards, to([=](const Case& c) {
         return std::abs(c.sum) >= bound(c) ? c.sum : clamped(wanted(c), bound(c));
       })},
      {early, [=](const Case& c) {
         const double old = clamped(c.sum, bound(c)), sum = clamped(old - c.rate / c.K, bound(c));
         return Numbers{sum - old, sum};
       }},
      {early, to([=](const Case& c) {
         return clamped(clamped(c.sum, bound(c)) - c.rate / c.K, bound(c));
       })},
      {"#nothing-beyond-bound nothing is done beyond the bound: the sum goes to the bound",
       to([=](const Case& c) { return no_more(c) ? 0 : wanted(c); })},
      {"#mu-forgotten the bound is mu times the normal impulse: mu is missing",
       bounded([](const Case& c) { return c.normal; })},
      {"#normal-forgotten the bound is mu times the normal impulse: normal is missing",
       bounded([](const Case& c) { return c.mu; })},
      {"the bound is mu times the normal impulse: times, not divided by mu",
       bounded([](const Case& c) { return c.normal / c.mu; })},
      {"mu plus normal: the bound is mu times the normal impulse",
       bounded([](const Case& c) { return c.mu + c.normal; })},
      {"#bound-over-k the bound is divided by K: it is an impulse already",
       bounded([=](const Case& c) { return bound(c) / c.K; })},
      {"a half of the bound: it is mu normal either way",
       bounded([=](const Case& c) { return bound(c) / 2; })},
      {"#mu-squared mu is taken twice in the bound",
       bounded([=](const Case& c) { return c.mu * bound(c); })},
      {"#nothing-clamped nothing is clamped", bounded([](const Case&) { return 1e30; })},
      {"nothing is clamped, and the sum is not stored",
       [=](const Case& c) { return Numbers{step(c), c.sum}; }},
      {std::string("only the upper bound is there") + either,
       to([=](const Case& c) { return std::min(wanted(c), bound(c)); })},
      {std::string("only the lower bound is there") + either,
       to([=](const Case& c) { return std::max(wanted(c), -bound(c)); })},
      {std::string("#from-zero the sum is kept from 0 to mu normal") + either,
       to([=](const Case& c) { return std::clamp(wanted(c), 0.0, bound(c)); })},
      {std::string("the sum is kept from -mu normal to 0") + either,
       to([=](const Case& c) { return std::clamp(wanted(c), -bound(c), 0.0); })},
      {std::string("the size of the required impulse is clamped") + either,
       to([=](const Case& c) { return std::min(std::abs(wanted(c)), bound(c)); })},
      {"#only-pushes this is a row that only pushes, sum >= 0: friction has the bound mu normal",
       to([=](const Case& c) { return std::max(wanted(c), 0.0); })},
      {always,
       to([=](const Case& c) { return c.rate > 0 ? -bound(c) : c.rate < 0 ? bound(c) : 0; })},
      {always, to([=](const Case& c) { return c.rate > 0 ? -bound(c) : bound(c); })},
      {always, to([=](const Case& c) { return c.rate < 0 ? bound(c) : -bound(c); })},
      {always, to([=](const Case& c) { return wanted(c) < 0 ? -bound(c) : bound(c); })},
      {always, to([=](const Case& c) { return wanted(c) > 0 ? bound(c) : -bound(c); })},
      {std::string(always) + ", and works against J V",
       to([=](const Case& c) { return c.rate < 0 ? -bound(c) : bound(c); })},
      {std::string(always) + ", and works against J V",
       to([=](const Case& c) { return c.rate > 0 ? bound(c) : -bound(c); })},
      {same_bound, to([=](const Case& c) { return -bound(c); })},
      {same_bound, to(bound)},
      {"#ends-exchanged-hand the ends of clamp are exchanged: clamp(a, low, high), -mu normal is "
       "the low one",
       to([=](const Case& c) {
         return wanted(c) < bound(c) ? bound(c) : std::min(wanted(c), -bound(c));
       })},
      {added, [=](const Case& c) { return Numbers{right(c)[1], c.sum + right(c)[1]}; }},
      {added, [=](const Case& c) { return Numbers{right(c)[0], c.sum + right(c)[1]}; }},
      {added, [=](const Case& c) { return Numbers{-c.sum, c.sum + right(c)[1]}; }},
      {"#copy-sum the sum is not stored: the next iteration needs it",
       [=](const Case& c) { return Numbers{right(c)[0], c.sum}; }},
      {"#stored-unclamped the sum that is stored is not clamped",
       [=](const Case& c) { return Numbers{right(c)[0], wanted(c)}; }},
      {"#returns-the-sum the new sum is returned instead of its change",
       [=](const Case& c) { return Numbers{right(c)[1], right(c)[1]}; }},
      {returns, [=](const Case& c) { return Numbers{step(c), right(c)[1]}; }},
      {returns, [=](const Case& c) { return Numbers{wanted(c), right(c)[1]}; }},
      {"the sign of the change: new sum minus old sum",
       [=](const Case& c) { return Numbers{-right(c)[0], right(c)[1]}; }},
      {"#new-sum-plus-old new sum plus old sum: the change is new sum minus old sum",
       [=](const Case& c) { return Numbers{right(c)[1] + c.sum, right(c)[1]}; }},
      {"#none-at-rest nothing is done where nothing slides: the bound may have moved inwards all "
       "the same",
       [=](const Case& c) { return c.rate == 0 ? Numbers{0, c.sum} : right(c); }},
      {"#none-air nothing is done where nothing presses: the sum goes back to 0 then",
       [=](const Case& c) { return c.normal == 0 ? Numbers{0, c.sum} : right(c); }},
      {"without friction the sliding is stopped all the same: the bound is 0 then",
       [=](const Case& c) { return c.mu == 0 ? Numbers{step(c), c.sum} : right(c); }},
      {"#none-slow-sliding slow sliding is ignored: there is no threshold, friction stops slow "
       "bodies, too",
       [=](const Case& c) { return std::abs(c.rate) < 0.075 ? Numbers{0, c.sum} : right(c); }},
      {"#less-what-was-given the remaining part of the bound is used for both directions: the sum "
       "itself stays within +-mu normal", [=](const Case& c) {
         const double change = clamped(step(c), std::max(bound(c) - std::abs(c.sum), 0.0));
         return Numbers{change, c.sum + change};
       }},
      {"#lower-end-without-mu mu is missing in the lower bound: -mu normal and +mu normal",
       to([=](const Case& c) { return std::clamp(wanted(c), -c.normal, bound(c)); })},
      {"mu is missing in the upper bound: -mu normal and +mu normal",
       to([=](const Case& c) { return std::clamp(wanted(c), -bound(c), c.normal); })},
      {"the required impulse is cut to a whole number: an int has no fraction",
       wanting([=](const Case& c) { return std::trunc(wanted(c)); })},
      {"#bound-int the bound is cut to a whole number: an int has no fraction",
       bounded([=](const Case& c) { return std::trunc(bound(c)); })},
      {"the sum is cut to a whole number: an int has no fraction",
       to([=](const Case& c) { return std::trunc(right(c)[1]); })},
      {"#returns-zero 0 is returned: keep the old sum before the new one is stored",
       [=](const Case& c) { return Numbers{0, right(c)[1]}; }},
      {"#sum-forgotten the sum so far is missing in the required sum: sum - rate/K", wanting(step)},
      {"the change is added to the sum twice",
       [=](const Case& c) { return Numbers{right(c)[0], right(c)[1] + right(c)[0]}; }},
      {"#times-k-where-must times K where it must be divided by K",
       wanting([](const Case& c) { return c.sum - c.rate * c.K; })},
      {"#k-missing-impulse-speed K is missing: an impulse is a speed divided by K",
       wanting([](const Case& c) { return c.sum - c.rate; })},
      {"#sum-over-k the old sum is divided by K, too",
       wanting([](const Case& c) { return (c.sum - c.rate) / c.K; })}};
  for (const double steps : {20, 30, 50, 60, 100, 120})
    for (const double factor : {steps, 1 / steps})
      table.mistakes.push_back({"#bound-over-h the bound is an impulse already: mu normal, "
                                "without h",
                                bounded([=](const Case& c) { return bound(c) * factor; })});
  for (const double way : {1, -1}) {
    const auto add = [&](double rate, double K, double mu, double normal, double sum) {
      table.cases.push_back({"", way * rate, K, mu, normal, way * sum});
    };
    add(2.88, 11.0 / 60, 0.5, 1.2, 0);      // the text's: slides on
    add(2.77, 11.0 / 60, 0.5, 1.2, -0.6);   // and once more
    add(0.05, 0.4, 0.5, 1.2, 0);            // within the bound: stops
    add(0.05, 0.4, 0.5, 1.2, -0.2);
    add(-0.1, 0.4, 0.5, 1.2, -0.4);         // gives back
    add(-3, 0.4, 0.5, 1.2, -0.4);           // gives all back, and brakes the other way
    add(0, 0.4, 0.5, 0.7, 0.6);             // the normal impulse has become less
    add(0.05, 0.4, 0.5, 0.7, 0.6);
    add(-1, 0.4, 0.5, 0.7, 0.6);
    add(0, 0.4, 0.5, 0, 0.6);               // lifted off
    add(-0.3, 0.4, 0.5, 0, 0.6);
    add(2, 2.5, 1.5, 3, 1.5);               // a rough ground, a light body
    add(-9, 1.25, 1.4, 1.6, 0.3);
    add(0.8, 0.125, 0.3, 2.4, -0.1);        // a smooth one, a heavy body
    add(-1.5, 0.8, 0.8, 0.9, 0.35);
    add(2, 2.5, 0, 3, 0);                   // no friction
  }
  table.tolerance = 10 * rounding;
  for (const auto& [words, mistake] : other_formulas())
    if (!table.knows(mistake) && !table.is_right(mistake))
      table.mistakes.push_back({words, mistake});
  for (const Argument<Case>& a : friction_arguments) {
    const auto cut = [=](const Case& c) {
      Case other = c;
      other.*a.of = std::trunc(other.*a.of);
      const double sum = right(other)[1];
      return Numbers{sum - c.sum, sum};
    };
    if (a.of != &Case::K && !table.knows(cut))
      table.mistakes.push_back({a.name + std::string(" is cut to a whole number: an int has no "
                                                     "fraction"), cut});
  }
  return table;
}

}  // namespace joints::testing
