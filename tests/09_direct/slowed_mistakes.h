// Exercise 9.8: a body with more inertia as a table, with the usual mistakes.
#pragma once

#include "tests/09_direct/slowed_cases.h"
#include "tests/checker/pieces.h"

namespace joints::testing {

inline CaseTable<SlowedCase> slowed_table() {
  using T = SlowedReference;
  CaseTable<SlowedCase> table{{"9.8", "a body with more inertia"},
                              {"inverse_inertia", "w"}, {}, {}, {}, slowed_cases()};
  table.tolerance = 10 * rounding;
  table.yours = [](const SlowedCase& c) {
    const Slowed out = slowed(c.body, c.force_lever, c.before, c.kappa, c.h);
    return flat(std::vector<vec3>{out.inverse_inertia_local, out.w});
  };
  table.right = [](const SlowedCase& c) { return T(c).numbers(); };
  // what the step follows, the moments, their ratio, the angular velocity: another one
  const auto follows = [](auto of) { return [=](T& t) { t.follows = of(t.c); }; };
  const auto now = [](auto of) { return [=](T& t) { t.now_of = of; }; };
  const auto ratio = [](auto of) { return [=](T& t) { t.ratio_of = of; }; };
  const auto w = [](auto of) { return [=](T& t) { t.w_of = of; }; };
  using C = SlowedCase;
  const char* const square = "#h-not-squared h is squared: kappa h^2 |F||r|";
  const char* const inverse_of = "#inverse-moments the inverse moments are taken for moments: 1 "
                                 "over each of them "
                                 "first";
  const char* const body_axes = "#scaled-in-world the angular velocity is scaled in the world's "
                                "axes: to_local() "
                                "first, to_world() at last";
  const char* const fixed = "#fixed-kappa a fixed number: `kappa` is an argument";
  const char* const linear = "#linear-velocity the linear velocity: w is the angular one";
  const char* const one_ratio = "#one-ratio one ratio for all three: each axis has its own";
  // of a body whose three components are scaled alike, this is the energy
  const auto energy = [](const vec3& moments, const vec3& w) { return dot(moments * w, w); };
  const auto alike = [=](auto factor) {
    return w([=](const T& t) { return factor(t) * t.c.body.w; });
  };
  add_pieces(table, [](const C& c) { return T(c); }, [](const T& t) { return t.numbers(); },
             Pieces<T>{
      {square, follows([](const C& c) { return c.kappa * c.h * c.force_lever; })},
      {"#h-cubed h to the third power: kappa h^2 |F||r|",
       follows([](const C& c) { return c.kappa * c.h * c.h * c.h * c.force_lever; })},
      {"#followed-h-missing h is missing: kappa h^2 |F||r|",
       follows([](const C& c) { return c.kappa * c.force_lever; })},
      {"#followed-divided-h-squared divided by h^2: times h^2",
       follows([](const C& c) { return c.kappa * c.force_lever / (c.h * c.h); })},
      {"#kappa-missing kappa is missing: kappa h^2 |F||r|",
       follows([](const C& c) { return c.h * c.h * c.force_lever; })},
      {"#force-missing the force is missing: kappa h^2 |F||r|",
       follows([](const C& c) { return c.kappa * c.h * c.h; })},
      {"#force-squared the force is squared: it is |F||r| itself",
       follows([](const C& c) { return followed(c) * c.force_lever; })},
      {"#kappa-squared kappa is squared: kappa h^2 |F||r|",
       follows([](const C& c) { return followed(c) * c.kappa; })},
      {"#fixed-step-h a fixed step of 1/60 s: take h",
       follows([](const C& c) { return c.kappa / 3600 * c.force_lever; })},
      {"#root-kappa the root of kappa: kappa h^2 |F||r|",
       follows([](const C& c) { return std::sqrt(c.kappa) * c.h * c.h * c.force_lever; })},
      {"#quarter-of-h-squared a quarter of h^2, without kappa: that is the inertia with which h nu "
       "is 2. With kappa h^2 |F||r| it is 1 / sqrt(kappa)",
       follows([](const C& c) { return c.h * c.h / 4 * c.force_lever; })},
      {"#divided-by-kappa divided by kappa: h nu is 1 / sqrt(kappa) with kappa h^2 |F||r|",
       follows([](const C& c) { return c.h * c.h / c.kappa * c.force_lever; })},
      {"#followed-half half of it: kappa h^2 |F||r|",
       follows([](const C& c) { return followed(c) / 2; })},
      {"#twice twice: kappa h^2 |F||r|", follows([](const C& c) { return 2 * followed(c); })},
      {fixed,
       follows([](const C& c) { return 8 * c.h * c.h * c.force_lever; })},
      {fixed,
       follows([](const C& c) { return 16 * c.h * c.h * c.force_lever; })},
      {"#middle-moment each moment becomes at least the middle one: at least kappa h^2 |F||r|",
       now([](const T& t) {
         const vec3 a = t.moments;
         const real middle = std::max(std::min(a.x, a.y), std::min(std::max(a.x, a.y), a.z));
         return max(max(a, vec3(middle)), vec3(t.follows));
       })},
      {"#inertia-added kappa h^2 |F||r| is added to the moments: each becomes at least that",
       now([](const T& t) { return t.moments + vec3(t.follows); })},
      {"#lesser the lesser of the moment and kappa h^2 |F||r|: the greater",
       now([](const T& t) { return min(t.moments, vec3(t.follows)); })},
      {"#own-moments-lost the body's own moments are lost: the greater of the two",
       now([](const T& t) { return vec3(t.follows); })},
      {"#least-lacks the difference of the least moment is added to all: each is raised separately",
       now([](const T& t) {
         const real least = std::min({t.moments.x, t.moments.y, t.moments.z});
         return t.moments + vec3(std::max(real(0), t.follows - least));
       })},
      {"#first-moment-alone only the first moment grows: all three",
       now([](const T& t) {
         return vec3(std::max(t.moments.x, t.follows), t.moments.y, t.moments.z);
       })},
      {"#bound-of-last-step `before` is of the last step: this one has kappa h^2 |F||r|",
       now([](const T& t) { return max(t.moments, vec3(t.before)); })},
      {"#never-smaller a moment stays as large as in the last step: it may become smaller again",
       now([](const T& t) { return max(t.last(), vec3(t.follows)); })},
      {"#force-ignored the force is ignored, and nothing changes",
       now([](const T& t) { return t.moments; })},
      {inverse_of, [](T& t) { t.moments = t.c.body.inverse_inertia_local; }},
      {"#inverse-both the inverse moments are taken for moments, and the greater is returned: 1 "
       "over "
       "each of both",
       [](T& t) {
         t.moments = t.c.body.inverse_inertia_local;
         t.inverse = false;
       }},
      {"#moments-returned the moments are returned: 1 over each of them",
       [](T& t) { t.inverse = false; }},
      {"#last-step-forgotten the last step is forgotten: then each moment was at least `before`",
       ratio([](const T& t) { return min(vec3(1), t.moments / t.now()); })},
      {"#last-moments-lost the body's own moments of the last step are lost: the greater of them "
       "and `before`",
       ratio([](const T& t) { return min(vec3(1), vec3(t.before) / t.now()); })},
      {"#ratio-unbounded where a moment becomes smaller the angular velocity becomes larger: it "
       "stays, at most 1",
       ratio([](const T& t) { return t.last() / t.now(); })},
      {"#first-time-not-slowed nothing is slowed where `before` is 0: then each moment was the "
       "body's own, and the ratio is that over the new one",
       ratio([](const T& t) {
         return t.before > 0 ? min(vec3(1), t.last() / t.now()) : vec3(1);
       })},
      {"#last-step-replaced the last step is forgotten, and its moments, too: each was at least "
       "`before`",
       ratio([](const T& t) { return min(vec3(1), vec3(t.follows) / t.now()); })},
      {"#ratio-inverted the new moment over the old one: the old one over the new one",
       ratio([](const T& t) { return min(vec3(1), t.now() / t.last()); })},
      {"#ratio-at-least-one the greater of 1 and the ratio: the lesser",
       ratio([](const T& t) { return max(vec3(1), t.last() / t.now()); })},
      {"#momentum-kept the angular momentum is kept: it is the energy that stays, with a square "
       "root",
       w([](const T& t) { return to_world(t.c.body, t.ratio() * t.local); })},
      {"#ratio-squared the ratio is squared: its root",
       w([](const T& t) { return to_world(t.c.body, t.ratio() * t.ratio() * t.local); })},
      {"#w-stays the angular velocity stays: it becomes smaller where a moment grows",
       w([](const T& t) { return t.c.body.w; })},
      {"#ratio-upside-down the angular velocity becomes larger: the old moment over the new one",
       w([](const T& t) { return to_world(t.c.body, t.local / t.factors()); })},
      {body_axes, w([](const T& t) { return t.factors() * t.c.body.w; })},
      {"#to-world-missing to_world() is missing: w is in the world", w([](const T& t) {
         return t.factors() * t.local;
       })},
      {"#to-local-missing to_local() is missing: the moments are those of the body's own axes",
       w([](const T& t) { return to_world(t.c.body, t.factors() * t.c.body.w); })},
      {"#axes-exchanged to_local() and to_world() are exchanged",
       w([](const T& t) {
         return to_local(t.c.body, t.factors() * to_world(t.c.body, t.c.body.w));
       })},
      {"#to-local-twice to_local() twice: to_world() at last",
       w([](const T& t) { return to_local(t.c.body, t.factors() * t.local); })},
      {one_ratio, w([](const T& t) { return t.factors().x * t.c.body.w; })},
      {one_ratio, w([](const T& t) { return t.factors().y * t.c.body.w; })},
      {one_ratio, w([](const T& t) { return t.factors().z * t.c.body.w; })},
      {one_ratio, alike([](const T& t) {
         const vec3 f = t.factors();
         return std::min({f.x, f.y, f.z});
       })},
      {one_ratio, alike([=](const T& t) {
         const real after = energy(t.now(), t.local);
         return after > 0 ? std::sqrt(std::min(real(1), energy(t.last(), t.local) / after)) : 1;
       })},
      {one_ratio, alike([=](const T& t) {
         const real after = energy(t.now(), t.local);
         return after > 0 ? std::sqrt(energy(t.last(), t.local) / after) : 1;
       })},
      {"#mean-ratio the mean ratio for all three: each axis has its own",
       w([](const T& t) {
         const vec3 f = t.factors();
         return (f.x + f.y + f.z) / 3 * t.c.body.w;
       })},
      {linear,
       w([](const T& t) {
         return to_world(t.c.body, t.factors() * to_local(t.c.body, t.c.body.v));
       })},
      {"#momentum-returned the angular momentum is returned: the ratio times w",
       w([](const T& t) { return to_world(t.c.body, t.moments * t.local); })},
      {"#w-zero the angular velocity becomes zero: the energy stays",
       w([](const T&) { return vec3(0); })},
      {linear, w([](const T& t) { return t.c.body.v; })}});
  table.leave_out_harmless();
  table.given = [copy = table](const C& c) { return slowed_given(c) + " " + copy.holds_in(); };
  return table;
}

}  // namespace joints::testing
