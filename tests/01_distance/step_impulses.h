// Exercise 1.4: the usual ways to get the impulses of a step wrong, of rods and of ropes.
#pragma once

#include "tests/01_distance/step_mistakes.h"

namespace joints::testing {

/// Which bodies and which row.
inline Ways wrong_bodies() {
  const auto swapped = [](const Turn& t) -> Turn {
    return {t.link, t.row, t.body2, t.body1, t.settings};
  };
  const Way right;
  Ways out;
  out.push_back({"#bodies-place-link the bodies are taken by the place of the link: use link.body1 "
                 "and link.body2",
                 way_with([](Way& w) {
                   w.link = [](const Scene& s, int k) {
                     Link link = s.links[k];
                     const int bodies = int(s.bodies.size());
                     link.body1 = k % bodies;
                     link.body2 = (k + 1) % bodies;
                     return link;
                   };
                 })});
  out.push_back({"#first-row-all every link takes the first row: row and link have the same place",
                 way_with([](Way& w) { w.row = [](int) { return 0; }; })});
  out.push_back({"#bodies-exchanged-row-impulse bodies 1 and 2 are exchanged in row_impulse",
                 way_with([=](Way& w) { w.wants = [=](const Turn& t) {
                   return right.wants(swapped(t));
                 }; })});
  out.push_back({"#bodies-exchanged-apply-impulse the impulse acts the wrong way: its sign, or "
                 "bodies 1 and 2 are exchanged in apply_impulse",
                 way_with([=](Way& w) { w.gives = [=](real lambda, const Turn& t) {
                   right.gives(lambda, swapped(t));
                 }; })});
  return out;
}

/// What is asked for, and when.
inline Ways wrong_impulses() {
  Ways out;
  // what is right for another row
  const auto wants = [&](const char* words, auto change) {
    out.push_back({words, way_with([&](Way& w) {
                     w.wants = [change, right = w.wants](const Turn& t) {
                       LinkRow row = t.row;
                       change(row, t.settings);
                       return right({t.link, row, t.body1, t.body2, t.settings});
                     };
                   })});
  };
  const auto skips = [&](const char* words, auto which) {
    out.push_back({words, way_with([&](Way& w) { w.skips = which; })});
  };
  const auto gets = [&](const char* words, auto what) {
    out.push_back({words, way_with([&](Way& w) { w.gets = what; })});
  };
  using S = const StepSettings&;
  wants("#bias-not-used the bias of the row is not used",
        [](LinkRow& row, S) { row.bias = 0; });
  wants("#bodies-exchanged-both the sign of the bias, or bodies 1 and 2 are exchanged in "
        "row_impulse and apply_impulse",
        [](LinkRow& row, S) { row.bias *= -1; });
  wants("#bias-times-h the bias is multiplied by h: it is a velocity already",
        [](LinkRow& row, S s) { row.bias *= s.h; });
  wants("the bias is multiplied by beta: set_up has done so",
        [](LinkRow& row, S s) { row.bias *= s.beta; });
  wants("#k-not-used K is not used: row_impulse takes the K of the row",
        [](LinkRow& row, S) { row.K = 1; });
  wants("times K: row_impulse takes K and divides by it",
        [](LinkRow& row, S) { row.K = 1 / row.K; });
  const char* const impulse = "#lambda-taken-force lambda is an impulse, not a force: it is not "
                              "multiplied by h";
  wants(impulse, [](LinkRow& row, S s) { row.K /= s.h; });
  wants("lambda is an impulse, not a force: it is not divided by h",
        [](LinkRow& row, S s) { row.K *= s.h; });
  skips("#rows-behind-empty-ones no impulse was applied. Are the bodies copies (write Body& "
        "body1) or both the same one, or is the row an empty one?",
        [](const Turn&) { return true; });
  const char* const rest = "#no-impulse-where-error no impulse where the error is 0: such a row is "
                           "solved, too, because of its velocity";
  for (const real limit : {real(1e-12), real(1e-6), real(1e-3)})
    skips(rest, [=](const Turn& t) { return std::abs(t.row.bias) < limit; });
  for (const real limit : {real(1e-12), real(1e-6), real(1e-3)})
    skips(rest, [=](const Turn& t) {
      return std::abs(length(t.body2.x - t.body1.x) - t.link.length) < limit;
    });
  const char* const wall = "#links-walls-left-out links to a static body are left out: the other "
                           "body can move";
  skips(wall, [](const Turn& t) { return t.body1.is_static() || t.body2.is_static(); });
  skips(wall, [](const Turn& t) { return t.body1.is_static(); });
  const auto small = "#smaller-impulses-left-out a small impulse is left out: a light body needs "
                     "only a small one";
  for (int digits = 1; digits <= 9; ++digits) {
    const real limit = std::pow(real(10), real(-digits));
    const auto is_small = [=](const Turn& t) { return std::abs(Way{}.wants(t)) < limit; };
    skips(small, is_small);
    skips(small, is_small);
    out.back().second.skip_is_the_last = true;
  }
  gets("#impulse-whole-number the fraction of lambda is cut off: an int holds whole numbers only",
       [](real wanted, const Turn&) { return std::trunc(wanted); });
  gets("#rods-clamped-like-ropes a rod is clamped like a rope, but it pushes, too: does the "
       "condition use link.rope?",
       [](real wanted, const Turn& t) { return Way::allowed(wanted, t.row.sum); });
  gets("rods are clamped instead of ropes: is the condition link.rope the wrong way round?",
       [](real wanted, const Turn& t) {
         return t.link.rope ? wanted : Way::allowed(wanted, t.row.sum);
       });
  const char* const one_way = "a rod pushes and pulls: lambda has either sign";
  gets(one_way, [](real wanted, const Turn&) { return std::max(wanted, real(0)); });
  gets(one_way, [](real wanted, const Turn&) { return std::min(wanted, real(0)); });
  return out;
}

/// What a rope is allowed.
inline Ways wrong_ropes() {
  Ways out;
  const auto gets = [&](const char* words, auto rope) {
    out.push_back({words, way_with([&](Way& w) {
                     w.gets = [rope](real wanted, const Turn& t) {
                       return t.link.rope ? real(rope(wanted, t.row.sum)) : wanted;
                     };
                   })});
  };
  gets("#result-clamp-sum-dropped a rope pushes: its impulse is not clamped. Is clamp_sum called "
       "for a rope, before apply_impulse, and does its result replace lambda?",
       [](real wanted, real&) { return wanted; });
  const char* const each = "#each-impulse-rope-clamped the sum of a rope begins at 0 in every "
                           "iteration, so each impulse is clamped separately. Is the row a copy "
                           "(write LinkRow& row), is set_up called within the iterations, or is "
                           "the sum not that of the row?";
  gets(each, [](real wanted, real&) { return std::max(wanted, real(0)); });
  out.push_back({each, way_with([](Way& w) { w.sum = Way::Sum::of_iteration; })});
  out.push_back({"#one-sum-all-ropes all ropes share one sum: each row has its own",
                 way_with([](Way& w) { w.sum = Way::Sum::of_all; })});
  gets("#sum-rope-applied the sum of the rope is applied: apply the result of clamp_sum, the "
       "growth of the sum",
       [](real wanted, real& sum) {
         Way::allowed(wanted, sum);
         return sum;
       });
  gets("#sum-overwritten the sum is overwritten by the result of clamp_sum: clamp_sum updates it "
       "itself",
       [](real wanted, real& sum) { return sum = Way::allowed(wanted, sum); });
  gets("#clamped-twice clamp_sum is called twice for an impulse", [](real wanted, real& sum) {
    return Way::allowed(Way::allowed(wanted, sum), sum);
  });
  const char* const sign = "#sign-rope the sign of a rope's impulse: a positive one pulls the "
                           "bodies together";
  gets(sign, [](real wanted, real& sum) { return -Way::allowed(-wanted, sum); });
  gets(sign, [](real wanted, real&) { return std::min(wanted, real(0)); });
  gets(sign, [](real wanted, real& sum) { return -Way::allowed(wanted, sum); });
  const auto skips = [&](const char* words, auto which) {
    out.push_back({words, way_with([&](Way& w) { w.skips = which; })});
  };
  skips("#ropes-left-out ropes are left out", [](const Turn& t) { return t.link.rope; });
  skips("#slack-ropes-left-out a slack rope is left out: it may become taut within the step, so "
        "its row is solved, too",
        [](const Turn& t) { return t.link.rope && t.row.bias > 0; });
  return out;
}

/// All of them.
inline Ways step_mistakes() {
  Ways out;
  for (const Ways& ways : {wrong_forces(), wrong_places(), fixed_steps(), orders_of_pieces(),
                           wrong_iterations(), wrong_bodies(), wrong_impulses(), wrong_ropes()})
    out.insert(out.end(), ways.begin(), ways.end());
  return out;
}

}  // namespace joints::testing
