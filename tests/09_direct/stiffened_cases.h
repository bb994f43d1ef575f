// Exercise 9.8: a body with more inertia as a table, with the usual mistakes.
#pragma once

#include <algorithm>

#include "chapters/09_direct/direct.h"
#include "tests/checker/pieces.h"
#include "tests/checker/vector_cases.h"

namespace joints::testing {

struct StiffenedCase {
  std::string words;
  Body body;
  real force_lever, lever, factor, h;
};
inline std::string stiffened_given(const StiffenedCase& c) {
  return "Case: mass " + short_number(1 / double(c.body.inverse_mass)) + " kg, force_lever " +
         short_number(double(c.force_lever)) + " N m, lever " + short_number(double(c.lever)) +
         " m, factor " + short_number(double(c.factor)) + ", h " + short_number(double(c.h)) +
         " s.";
}

/// The body for pencil and paper: moments 1, 2 and 4 kg m^2. The step follows 6, 1 and m r^2 = 1
/// are there, 4 are added.
inline StiffenedCase paper_stiffened() {
  Body body = body_with(1, vec3(1, 2, 4), vec3(0));
  body.w = vec3(5, 3, 2);
  return {"by hand", body, 3, 1, 8, real(0.5)};
}

/// How much inertia the step can follow, and how much there is.
inline real followed(const StiffenedCase& c) { return c.factor * c.h * c.h * c.force_lever; }
inline real lever_part(const StiffenedCase& c) { return c.lever * c.lever / c.body.inverse_mass; }
inline real least_of(const vec3& moments) {
  return std::min(moments.x, std::min(moments.y, moments.z));
}

inline std::vector<StiffenedCase> stiffened_cases() {
  std::vector<StiffenedCase> out{paper_stiffened()};
  out[0].words = "not turned";
  Random random(98);
  for (int draw = 0; draw < 6; ++draw) {
    const vec3 order[] = {{real(0.3), real(0.5), real(0.6)}, {real(0.9), real(0.4), real(0.7)},
                          {real(0.8), real(0.6), real(0.35)}};
    Body body = body_with(real(0.5) + real(draw), order[draw % 3], random.vector(3),
                          random.turn());
    body.v = random.vector(4);
    body.w = random.vector(3);
    StiffenedCase c{"turned", body, 0, random.uniform(real(0.2), real(0.7)), 8,
                    real(draw % 2 ? 0.01 : 0.05)};
    const real there = real(0.35) + lever_part(c);
    c.force_lever = (there + random.uniform(1, 4)) / (8 * c.h * c.h);
    out.push_back(c);
  }
  Body isotropic = body_with(2, vec3(real(0.4)), vec3(1), random.turn());
  isotropic.w = vec3(3, -1, 2);
  out.push_back({"isotropic", isotropic, 900, real(0.3), 8, real(0.02)});
  const auto another = [&](std::size_t of, const char* words, auto change) {
    out.push_back(out[of]);
    out.back().words = words;
    change(out.back());
  };
  another(1, "factor 0", [](StiffenedCase& c) { c.factor = 0; });
  another(2, "no force", [](StiffenedCase& c) { c.force_lever = 0; });
  another(3, "factor 4", [](StiffenedCase& c) { c.factor = 4; });
  another(4, "at rest", [](StiffenedCase& c) { c.body.w = vec3(0); });
  another(5, "small", [](StiffenedCase& c) { c.body.inverse_inertia_local *= real(1000); });
  another(6, "no lever", [](StiffenedCase& c) { c.lever = 0; });
  another(1, "enough inertia", [](StiffenedCase& c) { c.force_lever = 1; });
  another(4, "a long step", [](StiffenedCase& c) {
    c.h = 1;
    c.force_lever = (real(1.5) + lever_part(c)) / c.factor;
  });
  another(2, "a long lever", [](StiffenedCase& c) { c.lever = 3; });
  another(3, "hardly enough", [](StiffenedCase& c) {
    c.force_lever = real(0.95) * (real(0.35) + lever_part(c)) / (c.factor * c.h * c.h);
  });
  return out;
}

/// The path to the answer, each piece by itself.
struct StiffenedReference {
  StiffenedCase c;
  vec3 moments, added, local, factors;
  real follows, least, m_r2;
  bool inverse = true, floored = true;
  std::function<vec3(const StiffenedReference&)> added_of = {}, w_of = {};
  explicit StiffenedReference(const StiffenedCase& c)
      : c(c), moments(real(1) / c.body.inverse_inertia_local),
        local(to_local(c.body, c.body.w)), follows(followed(c)), least(least_of(moments)),
        m_r2(lever_part(c)) {
    add();
  }
  void add() {
    const real missing = follows - least - m_r2;
    added = added_of ? added_of(*this) : vec3(floored ? std::max(real(0), missing) : missing);
    factors = moments / (moments + added);
  }
  Numbers numbers() const {
    const vec3 more = moments + added;
    const vec3 w = w_of ? w_of(*this) : to_world(c.body, factors * local);
    return flat(std::vector<vec3>{inverse ? real(1) / more : more, w});
  }
};

inline CaseTable<StiffenedCase> stiffened_table() {
  using T = StiffenedReference;
  CaseTable<StiffenedCase> table{{"9.8", "a body with more inertia"},
                                 {"inverse_inertia", "w"}, {}, {}, {}, stiffened_cases()};
  table.tolerance = 10 * rounding;
  table.yours = [](const StiffenedCase& c) {
    const Stiffened out = stiffened(c.body, c.force_lever, c.lever, c.factor, c.h);
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
  const char* const square = "h is squared: factor h^2 |F||r|";
  const char* const inverse_of = "the inverse moments are taken for moments: 1 over each of them "
                                 "first";
  const char* const body_axes = "the angular velocity is scaled in the world's axes: to_local() "
                                "first, to_world() at last";
  add_pieces(table, [](const C& c) { return T(c); }, [](const T& t) { return t.numbers(); },
             Pieces<T>{
      {square, follows([](const C& c) { return c.factor * c.h * c.force_lever; })},
      {"h to the third power: factor h^2 |F||r|",
       follows([](const C& c) { return c.factor * c.h * c.h * c.h * c.force_lever; })},
      {"h is missing: factor h^2 |F||r|",
       follows([](const C& c) { return c.factor * c.force_lever; })},
      {"divided by h^2: times h^2",
       follows([](const C& c) { return c.factor * c.force_lever / (c.h * c.h); })},
      {"the factor is missing: factor h^2 |F||r|",
       follows([](const C& c) { return c.h * c.h * c.force_lever; })},
      {"the force is missing: factor h^2 |F||r|",
       follows([](const C& c) { return c.factor * c.h * c.h; })},
      {"force_lever is |F||r| already: it is not multiplied by the lever once more",
       follows([](const C& c) { return followed(c) * c.lever; })},
      {"the force is squared: it is |F||r| itself",
       follows([](const C& c) { return followed(c) * c.force_lever; })},
      {"the factor is squared: factor h^2 |F||r|",
       follows([](const C& c) { return followed(c) * c.factor; })},
      {"half of it: factor h^2 |F||r|", follows([](const C& c) { return followed(c) / 2; })},
      {"twice: factor h^2 |F||r|", follows([](const C& c) { return 2 * followed(c); })},
      {"a fixed factor: `factor` is one",
       follows([](const C& c) { return 8 * c.h * c.h * c.force_lever; })},
      {"a fixed factor: `factor` is one",
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
      {"all of factor h^2 |F||r| is added where something is missing: only what is missing",
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
  const Stiffened out = stiffened(c.body, c.force_lever, c.lever, c.factor, c.h);
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
