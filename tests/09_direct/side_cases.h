// Exercise 9.7: the side of a bounded row as a table, with the usual mistakes.
#pragma once

#include "chapters/09_direct/direct.h"
#include "tests/checker/pieces.h"

namespace joints::testing {

inline const char* const told_zero_lower_bound =
    "#zero-lower-bound the sign of the impulse decides: compare it with the bounds, which need "
    "not be 0";
inline const char* const told_bounded_rows_are_free =
    "#bounded-rows-are-free the side `now` is ignored: the rate of a bounded row decides, not its "
    "impulse";
inline const char* const told_rate_decides_everywhere =
    "#rate-decides-everywhere the rate decides on every side: for a free row the impulse decides";
inline const char* const told_now_ignored =
    "#now-ignored `now` does not choose the number that decides: Eq. 9-12 says which rows are "
    "right, not where a wrong one goes. A free row has no right or wrong rate, and the impulse of "
    "a row at a bound is at that bound but for rounding";
inline const char* const told_sum =
    "#sum-impulse-rate impulse and rate are combined into one number: the impulse alone decides "
    "for a free row, the rate alone for a bounded one";
inline const char* const told_sizes_compared =
    "#sizes-compared the sizes are compared: impulse and bounds have signs";

struct SideCase {
  std::string words;
  Side now;
  double impulse, lower, upper, rate;
};
inline std::string side_in_words(Side side) {
  return side == Side::lower ? "at its lower bound"
         : side == Side::upper ? "at its upper bound" : "free";
}
inline std::string side_given(const SideCase& c) {
  return "Case: " + side_in_words(c.now) + ", impulse " + short_number(c.impulse) +
         " N s, bounds " + short_number(c.lower) + " and " + short_number(c.upper) +
         " N s, rate " + short_number(c.rate) + " m/s.";
}

inline std::vector<SideCase> side_cases() {
  const double inf = std::numeric_limits<double>::infinity();
  std::vector<SideCase> out;
  for (const auto& [lower, upper] : {std::pair{0.0, inf}, {-2.0, 3.0}, {-inf, 0.0}, {-inf, inf},
                                     {0.0, 0.0}, {1.0, 4.0}, {-5.0, -1.0}}) {
    const double small = 1e-9;
    std::vector<double> impulses{-7, -1.5, -0.5, 0, 0.5, 1.5, 7};
    for (const double bound : {lower, upper})
      if (std::isfinite(bound))
        for (const double off : {-small, 0.0, small}) impulses.push_back(bound + off);
    for (const double impulse : impulses)
      for (const double rate : {-2.0, -small, 0.0, small, 2.0})
        out.push_back({"", Side::free, impulse, lower, upper, rate});
    for (const Side side : {Side::lower, Side::upper}) {
      const double impulse = side == Side::lower ? lower : upper;
      if (!std::isfinite(impulse)) continue;
      for (const double off : {0.0, -small, small})
        for (const double rate : {-2.0, -small, 0.0, small, 2.0})
          out.push_back({"", side, impulse + off, lower, upper, rate});
    }
  }
  return out;
}

/// The branches of the rule, each of which a mistake may change.
struct SideReference {
  SideCase c;
  using Rule = Call<Side(const SideCase&)>;
  Rule free = [](const SideCase& c) {
    return c.impulse < c.lower ? Side::lower : c.impulse > c.upper ? Side::upper : Side::free;
  };
  Rule at_lower = [](const SideCase& c) { return c.rate < 0 ? Side::free : Side::lower; };
  Rule at_upper = [](const SideCase& c) { return c.rate > 0 ? Side::free : Side::upper; };
  Side next() const {
    return c.now == Side::free ? free(c) : c.now == Side::lower ? at_lower(c) : at_upper(c);
  }
};

inline CaseTable<SideCase> side_table() {
  using R = SideReference;
  using C = SideCase;
  CaseTable<C> table{{"9.7", "the side of a bounded row"}, {"side (-1, 0 or 1)"}, {}, {}, {},
                     side_cases()};
  const auto number = [](Side side) { return Numbers{double(static_cast<signed char>(side))}; };
  table.yours = [=](const C& c) {
    return number(next_side(c.now, c.impulse, c.lower, c.upper, c.rate));
  };
  table.right = [=](const C& c) { return number(R{c}.next()); };
  table.tolerance = 0;
  const auto free = [](auto rule) { return [=](R& r) { r.free = rule; }; };
  const auto lower = [](auto rule) { return [=](R& r) { r.at_lower = rule; }; };
  const auto upper = [](auto rule) { return [=](R& r) { r.at_upper = rule; }; };
  const auto whole = [](auto rule) {
    return [=](R& r) { r.free = r.at_lower = r.at_upper = rule; };
  };
  const auto stays = [](const C& c) { return c.now; };
  const char* const exact = "#flips-either-bound at exactly a bound nothing flips: < and >, not "
                            "<= and >=";
  const char* const zero = "#flips-rate-zero at a rate of exactly 0 nothing flips: < and >, not "
                           "<= and >=";
  Pieces<R> pieces{
      {"#free-row-stays a free row never becomes bounded: beyond a bound it goes to that side",
       free(stays)},
      {"#lower-bound-free-row a free row never goes to its lower bound: impulse < lower is beyond "
       "it",
       free([](const C& c) { return c.impulse > c.upper ? Side::upper : Side::free; })},
      {"#upper-bound-free-row a free row never goes to its upper bound: impulse > upper is beyond "
       "it",
       free([](const C& c) { return c.impulse < c.lower ? Side::lower : Side::free; })},
      {"#lower-upper-exchanged lower and upper are exchanged for a free row",
       free([](const C& c) {
         return c.impulse < c.lower ? Side::upper : c.impulse > c.upper ? Side::lower : Side::free;
       })},
      {"#comparisons-free-row-turned the comparisons of a free row are reversed: below lower, or "
       "above upper",
       free([](const C& c) {
         return c.impulse > c.lower ? Side::lower : c.impulse < c.upper ? Side::upper : Side::free;
       })},
      {exact, free([](const C& c) {
         return c.impulse <= c.lower ? Side::lower : c.impulse >= c.upper ? Side::upper
                                                                        : Side::free;
       })},
      {exact, free([](const C& c) {
         return c.impulse <= c.lower ? Side::lower : c.impulse > c.upper ? Side::upper : Side::free;
       })},
      {exact, free([](const C& c) {
         return c.impulse < c.lower ? Side::lower : c.impulse >= c.upper ? Side::upper : Side::free;
       })},
      {told_zero_lower_bound,
       free([](const C& c) {
         return c.impulse < 0 ? Side::lower : c.impulse > c.upper ? Side::upper : Side::free;
       })},
      {told_zero_lower_bound,
       free([](const C& c) { return c.impulse < 0 ? Side::lower : Side::free; })},
      {told_sizes_compared,
       free([](const C& c) {
         return std::abs(c.impulse) > std::abs(c.upper) ? Side::upper
                : c.impulse < c.lower                   ? Side::lower : Side::free;
       })},
      {told_sizes_compared,
       free([](const C& c) {
         return c.impulse < c.lower                           ? Side::lower
                : std::abs(c.impulse) > std::abs(c.upper) ? Side::upper : Side::free;
       })},
      {"a small impulse beyond a bound is accepted: there is no threshold",
       free([](const C& c) {
         return c.impulse < c.lower - 1e-7   ? Side::lower
                : c.impulse > c.upper + 1e-7 ? Side::upper : Side::free;
       })},
      {"#threshold-impulse a small impulse below the lower bound is accepted: there is no "
       "threshold",
       free([](const C& c) {
         return c.impulse < c.lower - 1e-7 ? Side::lower
                : c.impulse > c.upper      ? Side::upper : Side::free;
       })},
      {"a small impulse above the upper bound is accepted: there is no threshold",
       free([](const C& c) {
         return c.impulse < c.lower          ? Side::lower
                : c.impulse > c.upper + 1e-7 ? Side::upper : Side::free;
       })},
      {"#threshold-rate a small rate is accepted at the lower bound: there is no threshold",
       lower([](const C& c) { return c.rate < -1e-7 ? Side::free : Side::lower; })},
      {"a small rate is accepted at the upper bound: there is no threshold",
       upper([](const C& c) { return c.rate > 1e-7 ? Side::free : Side::upper; })},
      {"the rate of a free row is tested: only its impulse counts, its rate is zero already",
       free([](const C& c) {
         return c.rate < 0 ? Side::lower : c.rate > 0 ? Side::upper : Side::free;
       })},
      {"the rate of a free row is tested: only its impulse counts, its rate is zero already",
       free([](const C& c) {
         return c.rate > 0 ? Side::lower : c.rate < 0 ? Side::upper : Side::free;
       })},
      {"#free-asks-rate-well the rate of a free row is tested, too: only its impulse counts",
       free([](const C& c) {
         return c.impulse < c.lower && c.rate > 0   ? Side::lower
                : c.impulse > c.upper && c.rate < 0 ? Side::upper : Side::free;
       })},
      {"a row at its lower bound stays there: at a negative rate a larger impulse would help",
       lower(stays)},
      {"a row at its lower bound is always free next: only at a negative rate",
       lower([](const C&) { return Side::free; })},
      {"#sign-rate-lower-bound the sign of the rate at the lower bound: at a negative rate a "
       "larger impulse would help",
       lower([](const C& c) { return c.rate > 0 ? Side::free : Side::lower; })},
      {zero, lower([](const C& c) { return c.rate <= 0 ? Side::free : Side::lower; })},
      {"#lower-upper from the lower bound to the upper one at once: it is free first",
       lower([](const C& c) { return c.rate < 0 ? Side::upper : Side::lower; })},
      {"the impulse of a row at its lower bound is tested: it is at the bound, the rate counts",
       lower([](const C& c) { return c.impulse > c.lower ? Side::free : Side::lower; })},
      {"the impulse of a row at its lower bound is tested: it is at the bound, the rate counts",
       lower([](const C& c) { return c.impulse < c.lower ? Side::lower : Side::free; })},
      {"#upper-branch-missing a row at its upper bound stays there: at a positive rate a smaller "
       "impulse would help",
       upper(stays)},
      {"a row at its upper bound is always free next: only at a positive rate",
       upper([](const C&) { return Side::free; })},
      {"#sign-rate-upper-bound the sign of the rate at the upper bound: at a positive rate a "
       "smaller impulse would help",
       upper([](const C& c) { return c.rate < 0 ? Side::free : Side::upper; })},
      {zero, upper([](const C& c) { return c.rate >= 0 ? Side::free : Side::upper; })},
      {"#upper-lower from the upper bound to the lower one at once: it is free first",
       upper([](const C& c) { return c.rate > 0 ? Side::lower : Side::upper; })},
      {"the impulse of a row at its upper bound is tested: it is at the bound, the rate counts",
       upper([](const C& c) { return c.impulse < c.upper ? Side::free : Side::upper; })},
      {"the impulse of a row at its upper bound is tested: it is at the bound, the rate counts",
       upper([](const C& c) { return c.impulse > c.upper ? Side::upper : Side::free; })},
      {"a row that leaves its upper bound goes to the lower one's branch: both have their own",
       upper([](const C& c) { return c.rate > 0 ? Side::free : Side::lower; })},
      {"#both-signs-rate both signs of the rate are reversed: at the lower bound a negative rate "
       "frees, at the upper one a positive rate",
       [](R& r) {
         r.at_lower = [](const C& c) { return c.rate > 0 ? Side::free : Side::lower; };
         r.at_upper = [](const C& c) { return c.rate < 0 ? Side::free : Side::upper; };
       }},
      {std::string(zero) + ", at either bound",
       [](R& r) {
         r.at_lower = [](const C& c) { return c.rate <= 0 ? Side::free : Side::lower; };
         r.at_upper = [](const C& c) { return c.rate >= 0 ? Side::free : Side::upper; };
       }},
      {"#bounded-rows-stay a bounded row never becomes free: at the lower bound a negative rate "
       "frees it, at the upper one a positive rate",
       [=](R& r) { r.at_lower = r.at_upper = stays; }},
      {"#any-rate-frees a bounded row is free as soon as its rate is not 0: at the lower bound a "
       "negative one, at the upper one a positive one",
       [](R& r) {
         r.at_lower = r.at_upper = [](const C& c) { return c.rate != 0 ? Side::free : c.now; };
       }},
      {told_bounded_rows_are_free,
       whole([](const C& c) {
         return c.impulse < c.lower ? Side::lower : c.impulse > c.upper ? Side::upper : Side::free;
       })},
      {told_bounded_rows_are_free,
       whole([](const C& c) {
         return c.impulse <= c.lower ? Side::lower : c.impulse >= c.upper ? Side::upper
                                                                        : Side::free;
       })},
      {told_rate_decides_everywhere,
       whole([](const C& c) {
         return c.rate < 0 ? Side::lower : c.rate > 0 ? Side::upper : Side::free;
       })},
      {told_rate_decides_everywhere,
       whole([](const C& c) {
         return c.rate > 0 ? Side::lower : c.rate < 0 ? Side::upper : Side::free;
       })},
      {"#now-returned nothing ever flips: `now` is returned", whole(stays)},
      {told_bounded_rows_are_free,
       [](R& r) { r.at_lower = r.at_upper = [](const C&) { return Side::free; }; }},
      {"always free: beyond its bounds an impulse must not be", whole([](const C&) {
         return Side::free;
       })},
      {"always the lower bound", whole([](const C&) { return Side::lower; })},
      {"always the upper bound", whole([](const C&) { return Side::upper; })}};
  // Eq. 9-12 as it stands there, and other ways to leave `now` out
  const auto right_at = [](const C& c, bool low, bool strict) {
    return low ? (strict ? c.rate > 0 : c.rate >= 0) : strict ? c.rate < 0 : c.rate <= 0;
  };
  for (const int near : {0, 1, 2})
    for (const bool strict : {false, true}) {
      const auto at = [=](const C& c, bool low) {
        const double beyond = low ? c.lower - c.impulse : c.impulse - c.upper;
        return near == 0 ? beyond == 0 : near == 1 ? beyond >= 0 : beyond > 0;
      };
      pieces.push_back({told_now_ignored, whole([=](const C& c) {
                          return at(c, true) && right_at(c, true, strict)     ? Side::lower
                                 : at(c, false) && right_at(c, false, strict) ? Side::upper
                                                                              : Side::free;
                        })});
      pieces.push_back({told_now_ignored, whole([=](const C& c) {
                          for (const bool low : {true, false})
                            if (at(c, low))
                              return !right_at(c, low, strict) ? Side::free
                                     : low                     ? Side::lower : Side::upper;
                          return Side::free;
                        })});
      pieces.push_back({told_now_ignored, whole([=](const C& c) {
                          const bool beyond = c.impulse < c.lower || c.impulse > c.upper;
                          if (beyond && near != 1)
                            return c.impulse < c.lower ? Side::lower : Side::upper;
                          return at(c, true) && right_at(c, true, strict)     ? Side::lower
                                 : at(c, false) && right_at(c, false, strict) ? Side::upper
                                                                              : Side::free;
                        })});
    }
  // impulse and rate in one number, everywhere, for a free row alone or for a bounded one alone
  for (const double sign : {-1, 1})
    for (const bool at_equality : {false, true}) {
      const auto by_sum = [=](const C& c) {
        const double sum = c.impulse + sign * c.rate;
        return sum < c.lower || (at_equality && sum == c.lower)   ? Side::lower
               : sum > c.upper || (at_equality && sum == c.upper) ? Side::upper : Side::free;
      };
      pieces.push_back({told_sum, whole(by_sum)});
      pieces.push_back({told_sum, free(by_sum)});
      pieces.push_back({told_sum, [=](R& r) { r.at_lower = r.at_upper = by_sum; }});
    }
  pieces.push_back({told_now_ignored, whole([=](const C& c) {
                      const bool low = c.now == Side::lower;
                      if (c.now != Side::free && right_at(c, low, false)) return c.now;
                      return c.impulse < c.lower ? Side::lower
                             : c.impulse > c.upper ? Side::upper : Side::free;
                    })});
  add_pieces(table, [](const C& c) { return R{c}; },
             [=](const R& r) { return number(r.next()); }, pieces);
  table.given = [copy = table](const C& c) { return side_given(c) + " " + copy.holds_in(); };
  return table;
}

}  // namespace joints::testing
