// Exercise 9.8: a body with more inertia as a table, with the usual mistakes.
#pragma once

#include "tests/09_direct/stiffened_cases.h"
#include "tests/checker/pieces.h"

namespace joints::testing {

inline CaseTable<StiffenedCase> stiffened_table() {
  using T = StiffenedReference;
  CaseTable<StiffenedCase> table{{"9.8", "a body with more inertia"},
                                 {"inverse_inertia", "w"}, {}, {}, {}, stiffened_cases()};
  table.tolerance = 10 * rounding;
  table.yours = [](const StiffenedCase& c) {
    const Stiffened out = stiffened(c.body, c.force_lever, c.lever, c.kappa, c.h);
    return flat(std::vector<vec3>{out.inverse_inertia_local, out.w});
  };
  table.right = [](const StiffenedCase& c) { return T(c).numbers(); };
  // what is added, another way
  const auto adds = [](auto of) {
    return [=](T& t) {
      t.added_of = of;
      t.add();
    };
  };
  // what the step follows, the least moment, m r^2: another one
  const auto follows = [](auto of) {
    return [=](T& t) {
      t.follows = of(t.c);
      t.add();
    };
  };
  const auto least = [](auto of) {
    return [=](T& t) {
      t.least = of(t.moments);
      t.add();
    };
  };
  const auto m_r2 = [](auto of) {
    return [=](T& t) {
      t.m_r2 = of(t.c, real(1) / t.c.body.inverse_mass);
      t.add();
    };
  };
  const auto w = [](auto of) { return [=](T& t) { t.w_of = of; }; };
  using C = StiffenedCase;
  const char* const square = "h is squared: kappa h^2 |F||r|";
  const char* const inverse_of = "the inverse moments are taken for moments: 1 over each of them "
                                 "first";
  const char* const body_axes = "the angular velocity is scaled in the world's axes: to_local() "
                                "first, to_world() at last";
  add_pieces(table, [](const C& c) { return T(c); }, [](const T& t) { return t.numbers(); },
             Pieces<T>{
      {square, follows([](const C& c) { return c.kappa * c.h * c.force_lever; })},
      {"h to the third power: kappa h^2 |F||r|",
       follows([](const C& c) { return c.kappa * c.h * c.h * c.h * c.force_lever; })},
      {"h is missing: kappa h^2 |F||r|",
       follows([](const C& c) { return c.kappa * c.force_lever; })},
      {"divided by h^2: times h^2",
       follows([](const C& c) { return c.kappa * c.force_lever / (c.h * c.h); })},
      {"kappa is missing: kappa h^2 |F||r|",
       follows([](const C& c) { return c.h * c.h * c.force_lever; })},
      {"the force is missing: kappa h^2 |F||r|",
       follows([](const C& c) { return c.kappa * c.h * c.h; })},
      {"force_lever is |F||r| already: it is not multiplied by the lever once more",
       follows([](const C& c) { return followed(c) * c.lever; })},
      {"the force is squared: it is |F||r| itself",
       follows([](const C& c) { return followed(c) * c.force_lever; })},
      {"kappa is squared: kappa h^2 |F||r|",
       follows([](const C& c) { return followed(c) * c.kappa; })},
      {"half of it: kappa h^2 |F||r|", follows([](const C& c) { return followed(c) / 2; })},
      {"twice: kappa h^2 |F||r|", follows([](const C& c) { return 2 * followed(c); })},
      {"a fixed number: `kappa` is an argument",
       follows([](const C& c) { return 8 * c.h * c.h * c.force_lever; })},
      {"a fixed number: `kappa` is an argument",
       follows([](const C& c) { return 16 * c.h * c.h * c.force_lever; })},
      {"the least moment is not taken away: only what is missing is added",
       least([](const vec3&) { return real(0); })},
      {"the least moment is added: what is there is taken away",
       least([](const vec3& I) { return -least_of(I); })},
      {"the greatest moment in the place of the least",
       least([](const vec3& I) { return -least_of(-I); })},
      {"the first moment in the place of the least", least([](const vec3& I) { return I.x; })},
      {"the second moment in the place of the least", least([](const vec3& I) { return I.y; })},
      {"the third moment in the place of the least", least([](const vec3& I) { return I.z; })},
      {"the mean of the moments in the place of the least",
       least([](const vec3& I) { return (I.x + I.y + I.z) / 3; })},
      {"the sum of the moments in the place of the least",
       least([](const vec3& I) { return I.x + I.y + I.z; })},
      {"the least inverse moment belongs to the greatest moment: 1 over each of them first",
       least([](const vec3& I) { return least_of(real(1) / I); })},
      {"m r^2 is not taken away: it is there, too",
       m_r2([](const C&, real) { return real(0); })},
      {"m r^2 is added: what is there is taken away",
       m_r2([](const C& c, real m) { return -m * c.lever * c.lever; })},
      {"r is squared: m r^2", m_r2([](const C& c, real m) { return m * c.lever; })},
      {"the mass is missing: m r^2", m_r2([](const C& c, real) { return c.lever * c.lever; })},
      {"divided by the mass: inverse_mass is 1/m, so divide by it",
       m_r2([](const C& c, real m) { return c.lever * c.lever / m; })},
      {"half of m r^2: all of it",
       m_r2([](const C& c, real m) { return m * c.lever * c.lever / 2; })},
      {"what is missing may be negative: then nothing is added, at least 0",
       [](T& t) {
         t.floored = false;
         t.add();
       }},
      {"nothing that is there is taken away: only what is missing is added",
       adds([](const T& t) { return vec3(t.follows); })},
      {"all of kappa h^2 |F||r| is added where something is missing: only what is missing",
       adds([](const T& t) {
         return vec3(t.follows > t.least + t.m_r2 ? t.follows : real(0));
       })},
      {"each moment lacks something of its own here: what the least one lacks is added to all",
       adds([](const T& t) {
         return max(vec3(0), vec3(t.follows - t.m_r2) - t.moments);
       })},
      {"the lesser of 0 and what is missing: the greater",
       adds([](const T& t) { return vec3(std::min(real(0), t.follows - t.least - t.m_r2)); })},
      {"the size of what is missing: where it is negative there is enough, and nothing is added",
       adds([](const T& t) { return vec3(std::abs(t.follows - t.least - t.m_r2)); })},
      {"the moments are multiplied by what is missing: it is added",
       adds([](const T& t) {
         return t.moments * (std::max(real(0), t.follows - t.least - t.m_r2) - 1);
       })},
      {"the inertia is taken away: each moment grows",
       adds([](const T& t) { return -vec3(std::max(real(0), t.follows - t.least - t.m_r2)); })},
      {"the moments are multiplied by what is missing: it is added",
       adds([](const T& t) {
         return t.moments * std::max(real(0), t.follows - t.least - t.m_r2);
       })},
      {"only the first moment grows: all three",
       adds([](const T& t) {
         return vec3(std::max(real(0), t.follows - t.least - t.m_r2), 0, 0);
       })},
      {"only the least moment grows: all three, so that the body keeps its axes",
       adds([](const T& t) {
         const real missing = std::max(real(0), t.follows - t.least - t.m_r2);
         vec3 out(0);
         for (int i = 0; i < 3; ++i) out[i] = t.moments[i] == t.least ? missing : real(0);
         return out;
       })},
      {"the force is never looked at, and nothing changes",
       adds([](const T&) { return vec3(0); })},
      {inverse_of, [](T& t) {
         t.moments = t.c.body.inverse_inertia_local;
         t.least = least_of(t.moments);
         t.add();
       }},
      {std::string(inverse_of) + ", and it is the inverse that is wanted: 1 over the sum",
       [](T& t) {
         t.moments = t.c.body.inverse_inertia_local;
         t.least = least_of(t.moments);
         t.add();
         t.inverse = false;
       }},
      {"the moments are returned: 1 over each of them",
       [](T& t) { t.inverse = false; }},
      {"the angular velocity stays: the angular momentum stays, so it becomes smaller",
       w([](const T& t) { return t.c.body.w; })},
      {"the angular velocity becomes larger: the momentum I w stays, so moments / more",
       w([](const T& t) { return to_world(t.c.body, t.local / t.factors); })},
      {body_axes, w([](const T& t) { return t.factors * t.c.body.w; })},
      {"to_world() is missing: w is in the world", w([](const T& t) {
         return t.factors * t.local;
       })},
      {"to_local() is missing: the moments are those of the body's own axes",
       w([](const T& t) { return to_world(t.c.body, t.factors * t.c.body.w); })},
      {"to_local() and to_world() are exchanged",
       w([](const T& t) {
         return to_local(t.c.body, t.factors * to_world(t.c.body, t.c.body.w));
       })},
      {"to_local() twice: to_world() at last",
       w([](const T& t) { return to_local(t.c.body, t.factors * t.local); })},
      {"one ratio for all three: each axis has its own",
       w([](const T& t) { return t.factors.x * t.c.body.w; })},
      {"one ratio for all three: each axis has its own",
       w([](const T& t) { return t.factors.y * t.c.body.w; })},
      {"one ratio for all three: each axis has its own",
       w([](const T& t) { return t.factors.z * t.c.body.w; })},
      {"the mean ratio for all three: each axis has its own",
       w([](const T& t) {
         return (t.factors.x + t.factors.y + t.factors.z) / 3 * t.c.body.w;
       })},
      {"one ratio for all three: each axis has its own",
       w([](const T& t) {
         const vec3 more = t.moments + t.added;
         return (t.moments.x + t.moments.y + t.moments.z) / (more.x + more.y + more.z) *
                t.c.body.w;
       })},
      {"the ratio is squared: moments / more, once",
       w([](const T& t) { return to_world(t.c.body, t.factors * t.factors * t.local); })},
      {"the linear velocity: w is the angular one",
       w([](const T& t) {
         return to_world(t.c.body, t.factors * to_local(t.c.body, t.c.body.v));
       })},
      {"the angular momentum is returned: divide it by the new moments",
       w([](const T& t) { return to_world(t.c.body, t.moments * t.local); })},
      {"only divided by the new moments: the momentum is the old moments times w",
       w([](const T& t) { return to_world(t.c.body, t.local / (t.moments + t.added)); })},
      {"the energy is kept: it is the angular momentum that stays, without a square root",
       w([](const T& t) {
         return to_world(t.c.body, vec3(std::sqrt(t.factors.x), std::sqrt(t.factors.y),
                                        std::sqrt(t.factors.z)) * t.local);
       })},
      {"the angular velocity becomes zero: the momentum stays",
       w([](const T&) { return vec3(0); })},
      {"the linear velocity: w is the angular one", w([](const T& t) { return t.c.body.v; })}});
  table.leave_out_harmless();
  table.given = [copy = table](const C& c) { return stiffened_given(c) + " " + copy.holds_in(); };
  return table;
}

/// The body with your inertia and angular velocity.
inline Body stiff_body(const StiffenedCase& c) {
  const Stiffened out = stiffened(c.body, c.force_lever, c.lever, c.kappa, c.h);
  Body body = c.body;
  body.inverse_inertia_local = out.inverse_inertia_local;
  body.w = out.w;
  return body;
}

/// For a test of another kind: the table's mistakes explain whatever is wrong.
inline void expect_stiffened(const StiffenedCase& c, const std::string& entry, const vec3& yours,
                             const vec3& right, double tolerance) {
  const bool same = length(yours - right) <= real(tolerance);  // false for what is no number
  const std::string given = same ? "" : stiffened_given(c) + " Body: " + c.words + ".";
  Subject about = stiffened_table().subject;
  about.given = given.c_str();
  expect(about, entry, yours, right, tolerance,
         same ? std::vector<VectorSuspect>{} : why(stiffened_table(), yours));
}

}  // namespace joints::testing
