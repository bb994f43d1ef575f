// Exercise 9.8: a body with more inertia as a table, with the usual mistakes.
#pragma once

#include "chapters/09_direct/direct.h"
#include "tests/checker/pieces.h"
#include "tests/checker/vector_cases.h"

namespace joints::testing {

struct StiffenedCase {
  std::string words;
  Body body;
  real force_lever, factor, h;
};
inline std::string stiffened_given(const StiffenedCase& c) {
  return "Case: force_lever " + short_number(double(c.force_lever)) + " N m, factor " +
         short_number(double(c.factor)) + ", h " + short_number(double(c.h)) + " s.";
}

/// The body for pencil and paper: moments 1, 2 and 4 kg m^2, to which 4 are added.
inline StiffenedCase paper_stiffened() {
  Body body = body_with(1, vec3(1, 2, 4), vec3(0));
  body.w = vec3(5, 3, 2);
  return {"by hand", body, 1, 16, real(0.5)};
}

inline std::vector<StiffenedCase> stiffened_cases() {
  std::vector<StiffenedCase> out{paper_stiffened()};
  out[0].words = "not turned";
  Random random(98);
  for (int draw = 0; draw < 6; ++draw) {
    Body body = body_with(real(0.5) + real(draw), vec3(real(0.3), real(0.5) + real(draw) / 4,
                                                       real(0.6)),
                          random.vector(3), random.turn());
    body.v = random.vector(4);
    body.w = random.vector(3);
    out.push_back({"turned", body, random.uniform(1, 400), 16, real(draw % 2 ? 0.01 : 0.05)});
  }
  Body isotropic = body_with(2, vec3(real(0.4)), vec3(1), random.turn());
  isotropic.w = vec3(3, -1, 2);
  out.push_back({"isotropic", isotropic, 30, 16, real(0.02)});
  out.push_back(out[1]);
  out.back().words = "factor 0";
  out.back().factor = 0;
  out.push_back(out[2]);
  out.back().words = "no force";
  out.back().force_lever = 0;
  out.push_back(out[3]);
  out.back().words = "factor 4";
  out.back().factor = 4;
  out.push_back(out[4]);
  out.back().words = "at rest";
  out.back().body.w = vec3(0);
  out.push_back(out[5]);
  out.back().words = "small";
  out.back().body.inverse_inertia_local *= real(1000);
  return out;
}

/// The path to the answer, each piece by itself.
struct StiffenedReference {
  StiffenedCase c;
  vec3 moments, added, local, factors;
  bool world_w = true, inverse = true;
  explicit StiffenedReference(const StiffenedCase& c)
      : c(c), moments(real(1) / c.body.inverse_inertia_local),
        added(vec3(c.factor * c.h * c.h * c.force_lever)), local(to_local(c.body, c.body.w)),
        factors(moments / (moments + added)) {}
  std::function<vec3(const StiffenedReference&)> w_of = {};
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
    const Stiffened out = stiffened(c.body, c.force_lever, c.factor, c.h);
    return flat(std::vector<vec3>{out.inverse_inertia_local, out.w});
  };
  table.right = [](const StiffenedCase& c) { return T(c).numbers(); };
  // another sum that is added to the moments
  const auto adds = [](auto of) {
    return [=](T& t) {
      t.added = of(t);
      t.factors = t.moments / (t.moments + t.added);
    };
  };
  const auto adds_number = [=](auto of) { return adds([=](const T& t) { return vec3(of(t.c)); }); };
  const auto w = [](auto of) { return [=](T& t) { t.w_of = of; }; };
  using C = StiffenedCase;
  const char* const square = "h is squared: factor h^2 |F||r|";
  const char* const inverse_of = "the inverse moments are taken for moments: 1 over each of them "
                                 "first";
  const char* const body_axes = "the angular velocity is scaled in the world's axes: to_local() "
                                "first, to_world() at last";
  add_pieces(table, [](const C& c) { return T(c); }, [](const T& t) { return t.numbers(); },
             Pieces<T>{
      {square, adds_number([](const C& c) { return c.factor * c.h * c.force_lever; })},
      {"h to the third power: factor h^2 |F||r|",
       adds_number([](const C& c) { return c.factor * c.h * c.h * c.h * c.force_lever; })},
      {"h is missing: factor h^2 |F||r|",
       adds_number([](const C& c) { return c.factor * c.force_lever; })},
      {"divided by h^2: times h^2",
       adds_number([](const C& c) { return c.factor * c.force_lever / (c.h * c.h); })},
      {"the factor is missing: factor h^2 |F||r|",
       adds_number([](const C& c) { return c.h * c.h * c.force_lever; })},
      {"the force is missing: factor h^2 |F||r|",
       adds_number([](const C& c) { return c.factor * c.h * c.h; })},
      {"the force is squared: it is |F||r| itself",
       adds_number([](const C& c) {
         return c.factor * c.h * c.h * c.force_lever * c.force_lever;
       })},
      {"the factor is squared, or h times it: factor h^2",
       adds_number([](const C& c) { return c.factor * c.factor * c.h * c.h * c.force_lever; })},
      {"half of it: factor h^2 |F||r|",
       adds_number([](const C& c) { return c.factor * c.h * c.h * c.force_lever / 2; })},
      {"twice: factor h^2 |F||r|",
       adds_number([](const C& c) { return 2 * c.factor * c.h * c.h * c.force_lever; })},
      {"a fixed factor of 16: `factor` is one",
       adds_number([](const C& c) { return 16 * c.h * c.h * c.force_lever; })},
      {"the inertia is taken away: each moment grows",
       adds_number([](const C& c) { return -(c.factor * c.h * c.h * c.force_lever); })},
      {"the inertia is multiplied: each moment grows by factor h^2 |F||r|",
       adds([](const T& t) { return t.moments * t.added - t.moments; })},
      {"times 1 + factor h^2 |F||r|: that is added to the moment",
       adds([](const T& t) { return t.moments * t.added; })},
      {"the mean of the moments takes their place: each grows by itself",
       adds([](const T& t) {
         return vec3((t.moments.x + t.moments.y + t.moments.z) / 3) - t.moments + t.added;
       })},
      {"only one moment grows: all three", adds([](const T& t) { return vec3(t.added.x, 0, 0); })},
      {"only one moment grows: all three", adds([](const T& t) { return vec3(0, t.added.x, 0); })},
      {"only one moment grows: all three", adds([](const T& t) { return vec3(0, 0, t.added.x); })},
      {"the greater one of moment and factor h^2 |F||r|: their sum",
       adds([](const T& t) { return max(t.moments, t.added) - t.moments; })},
      {"the mass is added, too: only factor h^2 |F||r|",
       adds([](const T& t) { return t.added + vec3(1 / t.c.body.inverse_mass); })},
      {"it is divided by the mass: |F||r| is a torque already",
       adds([](const T& t) { return t.added * t.c.body.inverse_mass; })},
      {"the force is never looked at, and nothing changes",
       adds([](const T&) { return vec3(0); })},
      {inverse_of, [](T& t) {
         t.moments = t.c.body.inverse_inertia_local;
         t.factors = t.moments / (t.moments + t.added);
       }},
      {std::string(inverse_of) + ", and it is the inverse that is wanted: 1 over the sum",
       [](T& t) {
         t.moments = t.c.body.inverse_inertia_local;
         t.factors = t.moments / (t.moments + t.added);
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
