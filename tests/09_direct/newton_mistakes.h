// Exercise 9.6: what the usual mistakes do.
#pragma once

#include "tests/09_direct/newton_reference.h"
#include "tests/checker/pieces.h"

namespace joints::testing {

inline const char* const told_errors_before_move =
    "#errors-before-move the errors are computed before the bodies move: C is that at the new "
    "poses";
inline const char* const told_last_begun_one =
    "#last-begun-one the first error is compared with a number: in the first iteration any error "
    "is accepted, use infinity";

inline Pieces<NewtonReference> wrong_newtons() {
  using T = NewtonReference;
  const auto norm = [](auto of) { return [=](T& t) { t.norm = of; }; };
  const auto rate = [](auto of) { return [=](T& t) { t.rate = of; }; };
  using Cs = std::vector<double>;
  const char* const largest = "the largest error counts, by its size: of all rows max |C|";
  return {
      {"#sign-j-v-changes the sign: J V changes by -C/h",
       rate([](double C, double h) { return C / h; })},
      {"#h-missing h is missing: J V changes by -C/h", rate([](double C, double) { return -C; })},
      {"#rates-not-made-all h is missing, and the sign: J V changes by -C/h",
       rate([](double C, double) { return C; })},
      {"#times-h times h: J V changes by -C/h", rate([](double C, double h) { return -C * h; })},
      {"#divided-h-squared divided by h^2: J V changes by -C/h",
       rate([](double C, double h) { return -C / (h * h); })},
      {"#rate-fixed-step 60/s in the place of 1/h: J V changes by -C/h",
       rate([](double C, double) { return -60 * C; })},
      {"#half-rate half of it: J V changes by -C/h",
       rate([](double C, double h) { return -C / (2 * h); })},
      {"twice: J V changes by -C/h", rate([](double C, double h) { return -2 * C / h; })},
      {"errors below the tolerance are not corrected: one row above it corrects all of them",
       [](T& t) {
         t.rate = [enough = t.c.tolerance](double C, double h) {
           return std::abs(C) <= enough ? 0 : -C / h;
         };
       }},
      {"the sizes of the errors: J V changes by -C/h",
       rate([](double C, double h) { return -std::abs(C) / h; })},
      {"#not-put-back the bodies are not put back: they move from their first places each time",
       [](T& t) { t.back = T::Back::none; }},
      {"#only-x-put-back only x is put back: every body as it was",
       [](T& t) { t.back = T::Back::x; }},
      {"#only-q-put-back only q is put back: every body as it was",
       [](T& t) { t.back = T::Back::q; }},
      {"#only-poses-put-back only the poses are put back: the move has changed the angular "
       "velocities, too",
       [](T& t) { t.back = T::Back::pose; }},
      {"#all-put-back the bodies are put back after their velocities were changed: the change is "
       "lost, put them back first",
       [](T& t) { t.change_first = true; }},
      {"#start-written-once `start` is written once: before each move, so that the corrections add "
       "up",
       [](T& t) { t.start_once = true; }},
      {"`start` does not hold the bodies as they were: the caller restores "
       "them from it if there is no such pose",
       [](T& t) { t.keeps_start = false; }},
      {"#rates-never-changed change_rates() is never called", [](T& t) { t.changes = false; }},
      {told_errors_before_move,
       [](T& t) { t.moves_first = false; }},
      {"#no-final-move after the last correction the bodies stay where they began: they move, and "
       "the errors are evaluated once more",
       [](T& t) { t.end = T::End::stay; }},
      {"#last-correction-unseen after the last correction the errors are not evaluated: true "
       "only if they are at most the tolerance",
       [](T& t) { t.end = T::End::true_unseen; }},
      {"#false-end false after the last correction: evaluate the errors once more, it may have "
       "closed the joints",
       [](T& t) { t.end = T::End::false_unseen; }},
      {"#used-up-is-true true after the last correction although its errors are above the "
       "tolerance: that is false",
       [](T& t) { t.result = T::Result::end_is_true; }},
      {"#near-enough-breaks-moves where the error is at most the tolerance the bodies move once "
       "more: they are there already, return",
       [](T& t) { t.moves_again = true; }},
      {"the bodies move for half of h: for all of it",
       [](T& t) { t.move_h = t.last_h = 0.5; }},
      {"the bodies move for half of h in each iteration: for all of it",
       [](T& t) { t.move_h = 0.5; }},
      {told_errors_before_move,
       [](T& t) { t.moves_first = false, t.asks_before = true; }},
      {"#errors-asked-twice the errors are computed more than once in an iteration: store them",
       [](T& t) { t.asks = 2; }},
      {"#changed-twice change_rates() is called twice in an iteration: once",
       [](T& t) { t.changes_twice = true; }},
      {"#zero-iterations-do-nothing with no iterations the bodies do not move: they do, by the "
       "velocities that they have",
       [](T& t) { t.zero_does_nothing = true; }},
      {"#last-begun-zero the last error is 0 at first: in the first iteration any error is "
       "accepted",
       [](T& t) { t.first_last = 0; }},
      {told_last_begun_one,
       [](T& t) { t.first_last = 0.5; }},
      {told_last_begun_one,
       [](T& t) { t.first_last = 1; }},
      {"#returned-once-when-poor the velocities are changed before poor_contraction is tested: "
       "then they are not restored",
       [](T& t) { t.poor_late = true; }},
      {"#poor-goes-break where the error hardly decreases the bodies move on: stop there, they "
       "have moved",
       [](T& t) { t.poor_breaks = true; }},
      {"#largest-not-begun-anew the largest error is not begun anew in each iteration: from 0",
       [](T& t) { t.keeps_largest = true; }},
      {"#last-body-not-put the last body is not put back: all slots",
       [](T& t) { t.last_back = 1; }},
      {"#static-body-taken-first the first body is not put back: all slots from 0",
       [](T& t) { t.first_back = 1; }},
      {"#first-body-not-put the first bodies are not put back: all slots from 0",
       [](T& t) { t.first_back = 2; }},
      {"#start-written-after-bodies `start` is written after the bodies have moved: before, as "
       "they were",
       [](T& t) { t.start_moved = true; }},
      {"#one-iteration-too-many one iteration too many: n < iterations", [](T& t) { t.more = 1; }},
      {"#one-iteration-too-few one iteration too few: from 0 while n < iterations",
       [](T& t) { t.more = -1; }},
      {"#last-iteration-missing one iteration too few: the velocities are changed `iterations` "
       "times, and the errors are evaluated once more than that, also where `iterations` is 0",
       [](T& t) { t.more = -1, t.least = -1; }},
      {"#tolerance-not-used the tolerance is the argument, not a number of your own",
       [](T& t) { t.own_tolerance = 1e-7; }},
      {"#tolerance-of-last the error of the iteration before is compared with the tolerance: the "
       "present one",
       [](T& t) { t.near_of_last = true; }},
      {"#near-enough-not-asked it is not tested whether the error is at most the tolerance: "
       "return true then",
       [](T& t) { t.asks_near = false; }},
      {"#strictly-nearer-than-near at exactly the tolerance it is enough: <=",
       [](T& t) { t.strictly_near = true; }},
      {"#last-not-kept an iteration after which more than poor_contraction of the error remains "
       "does not end it: is `last` stored, and is it used?",
       [](T& t) { t.asks_poor = false; }},
      {"#strictly-less-than-poor at exactly poor_contraction it goes on: <=",
       [](T& t) { t.strictly_poor = true; }},
      {"#only-growth-poor only an error that grows ends it: at most poor_contraction of the last "
       "one may remain",
       [](T& t) { t.poor = 1; }},
      {"#error-times-share divided by poor_contraction: at most that fraction of the last error "
       "may remain",
       [](T& t) { t.poor = 1 / poor_contraction; }},
      {"#poor-before-near poor_contraction is tested before the tolerance: an error below it is "
       "good in any case",
       [](T& t) { t.poor_first = true; }},
      {"#count-before-tolerance the number of iterations is tested before the tolerance: the last "
       "correction may have closed the joints, so test first whether the error is at most that",
       [](T& t) { t.count_first = true; }},
      {"#both-before-tolerance the number of iterations and poor_contraction are tested before the "
       "tolerance: an error that is at most that is good in any case",
       [](T& t) { t.count_first = t.poor_first = true; }},
      {"#last-only-once the first error is kept for ever: compare with that of the iteration "
       "before",
       [](T& t) { t.last_by_first = true; }},
      {std::string(largest) + ". The sign is not removed",
       norm([](const Cs& C) {
         double out = 0;
         for (const double a : C) out = std::max(out, a);
         return out;
       })},
      {std::string(largest) + ". Only the first row is used",
       norm([](const Cs& C) { return std::abs(C[0]); })},
      {std::string(largest) + ". Only the last row is used",
       norm([](const Cs& C) { return std::abs(C.back()); })},
      {std::string(largest) + ", not the sum",
       norm([](const Cs& C) {
         double sum = 0;
         for (const double a : C) sum += std::abs(a);
         return sum;
       })},
      {std::string(largest) + ", not the sum",
       norm([](const Cs& C) {
         double sum = 0;
         for (const double a : C) sum += a;
         return std::abs(sum);
       })},
      {std::string(largest) + ", not the length of all of them",
       norm([](const Cs& C) {
         double sum = 0;
         for (const double a : C) sum += a * a;
         return std::sqrt(sum);
       })},
      {std::string(largest) + ", not the sum of the squares",
       norm([](const Cs& C) {
         double sum = 0;
         for (const double a : C) sum += a * a;
         return sum;
       })},
      {std::string(largest) + ", not the smallest",
       norm([](const Cs& C) {
         double out = std::abs(C[0]);
         for (const double a : C) out = std::min(out, std::abs(a));
         return out;
       })},
      {"#size-asked-after-division the size is taken of -C/h, not of C: compare before you divide",
       [](T& t) { t.sizes_of_rates = true; }},
      {"#poor-is-true true where the error hardly becomes less: that is false, the joints are not "
       "closed",
       [](T& t) { t.result = T::Result::poor_is_true; }},
      {"#near-enough-false false where the error is at most the tolerance: that is true",
       [](T& t) { t.result = T::Result::near_is_false; }},
      {"always false: true where the errors are at most the tolerance",
       [](T& t) { t.result = T::Result::always_false; }}};
}

inline std::vector<std::string> newton_names(const NewtonCase&) {
  std::vector<std::string> out{"result (0 false, 1 true)", "calls of errors()",
                               "calls of change_rates()"};
  const auto call = [](std::size_t n) { return " " + std::to_string(n + 1); };
  for (std::size_t n = 0; n < asked_at_most; ++n)
    for (const char* what : {"x.x", "x.y", "q.w", "q.z"})
      out.push_back(std::string(what) + " at errors()" + call(n));
  for (std::size_t n = 0; n < asked_at_most; ++n)
    for (int i = 0; i < 3; ++i)
      out.push_back("rates[" + std::to_string(i) + "] at change_rates()" + call(n));
  out.push_back("bodies in start");
  for (const char* what : {"x.x", "x.y", "x.z", "v.x", "v.y", "v.z"})
    out.push_back(std::string("start[1].") + what);
  for (int k = 0; k < 4; ++k)
    for (const char* what : {"x.x", "x.y", "x.z", "v.x", "v.y", "v.z", "w.x", "w.y", "w.z", "q.w",
                             "q.x", "q.y", "q.z"})
      out.push_back(std::string(what) + " of body " + std::to_string(k) + " at the end");
  return out;
}

inline constexpr Subject newton_subject{"9.6", "Newton's method on the positions"};
inline CaseTable<NewtonCase> newton_table() {
  using T = NewtonReference;
  auto table = padded_table<NewtonCase>(newton_subject, numbers_of_newton, newton_names);
  table.tolerance = 10 * rounding;
  table.cases = newton_cases();
  // the bodies at the end matter where the right answer ends well
  const auto ends_well = [](const NewtonCase& c) {
    Bodies bodies = newton_bodies(c);
    std::vector<Body> start;
    return T{c}.move(bodies, c.h, c.iterations, c.tolerance, *c.corrector(bodies), start);
  };
  table.yours = [=](const NewtonCase& c) {
    return newton_numbers(c, ends_well(c), move_onto_constraints);
  };
  const auto answer = [=](const T& t) {
    return newton_numbers(t.c, ends_well(t.c),
                          [&](Bodies& bodies, double h, int iterations, double tolerance,
                              Corrector& corrector, std::vector<Body>& start) {
                            return t.move(bodies, h, iterations, tolerance, corrector, start);
                          });
  };
  table.right = [=](const NewtonCase& c) { return answer(T{c}); };
  add_pieces(table, [](const NewtonCase& c) { return T{c}; }, answer, wrong_newtons());
  tell_where_it_holds(table);
  return table;
}

/// For a test of another kind: the table's mistakes explain whatever is wrong.
inline void expect_newton(const std::string& entry, double yours, double right, double tolerance,
                          const std::string& words = "") {
  const bool same = std::abs(yours - right) <= tolerance;
  const std::string given = words.empty() ? "" : "Case: " + words + ".";
  Subject about = newton_subject;
  about.given = given.c_str();
  expect(about, entry, yours, right, tolerance,
         same ? std::vector<Suspect>{} : newton_table().explain(yours));
}

}  // namespace joints::testing
