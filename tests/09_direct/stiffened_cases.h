// Exercise 9.8: bodies that lack inertia, and the path to the answer.
#pragma once

#include <algorithm>

#include "chapters/09_direct/direct.h"
#include "tests/checker/vector_cases.h"

namespace joints::testing {

struct StiffenedCase {
  std::string words;
  Body body;
  real force_lever, lever, kappa, h;
};
inline std::string stiffened_given(const StiffenedCase& c) {
  return "Case: mass " + short_number(1 / double(c.body.inverse_mass)) + " kg, force_lever " +
         short_number(double(c.force_lever)) + " N m, lever " + short_number(double(c.lever)) +
         " m, kappa " + short_number(double(c.kappa)) + ", h " + short_number(double(c.h)) +
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
inline real followed(const StiffenedCase& c) { return c.kappa * c.h * c.h * c.force_lever; }
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
  another(1, "kappa 0", [](StiffenedCase& c) { c.kappa = 0; });
  another(2, "no force", [](StiffenedCase& c) { c.force_lever = 0; });
  another(3, "kappa 4", [](StiffenedCase& c) { c.kappa = 4; });
  another(4, "at rest", [](StiffenedCase& c) { c.body.w = vec3(0); });
  another(5, "small", [](StiffenedCase& c) { c.body.inverse_inertia_local *= real(1000); });
  another(6, "no lever", [](StiffenedCase& c) { c.lever = 0; });
  another(1, "enough inertia", [](StiffenedCase& c) { c.force_lever = 1; });
  another(4, "a long step", [](StiffenedCase& c) {
    c.h = 1;
    c.force_lever = (real(1.5) + lever_part(c)) / c.kappa;
  });
  another(2, "a long lever", [](StiffenedCase& c) { c.lever = 3; });
  another(3, "hardly enough", [](StiffenedCase& c) {
    c.force_lever = real(0.95) * (real(0.35) + lever_part(c)) / (c.kappa * c.h * c.h);
  });
  return out;
}

/// The path to the answer, each piece by itself.
struct StiffenedReference {
  StiffenedCase c;
  vec3 moments, added, local, factors;
  real follows, least, m_r2;
  bool inverse = true, floored = true;
  Call<vec3(const StiffenedReference&)> added_of = {}, w_of = {};
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

}  // namespace joints::testing
