// Exercise 9.8: bodies that lack inertia as a table.
#pragma once

#include <algorithm>

#include "chapters/09_direct/direct.h"
#include "tests/checker/vector_cases.h"

namespace joints::testing {

struct SlowedCase {
  std::string words;
  Body body;
  vec3 force_lever{0}, before{0};
  real kappa, h;
};
inline std::string slowed_given(const SlowedCase& c) {
  return "Case: mass " + short_number(1 / double(c.body.inverse_mass)) + " kg, force_lever " +
         in_words(c.force_lever) + " N m, before " + in_words(c.before) + " kg m^2, kappa " +
         short_number(double(c.kappa)) + ", h " + short_number(double(c.h)) + " s.";
}

/// The body for pencil and paper: moments 1, 4 and 4 kg m^2, of which the step follows 4, 2 and 4.
inline SlowedCase paper_slowed() {
  Body body = body_with(1, vec3(1, 4, 4), vec3(0));
  body.w = vec3(6, 3, 2);
  return {"by hand", body, vec3(2, 1, 2), vec3(0), 8, real(0.5)};
}

/// The moments that the step can follow [kg m^2].
inline vec3 followed(const SlowedCase& c) { return c.kappa * c.h * c.h * c.force_lever; }

inline std::vector<SlowedCase> slowed_cases() {
  std::vector<SlowedCase> out{paper_slowed()};
  out[0].words = "not turned";
  Random random(98);
  // the step follows between the moments and above them; so did the last step
  const real follows[] = {real(0.7), real(1.4), real(0.45), real(2), real(0.55), real(3)};
  const real before[] = {0, real(0.45), real(1.1), real(5), real(0.7), real(0.33)};
  for (int draw = 0; draw < 6; ++draw) {
    const vec3 order[] = {{real(0.3), real(0.5), real(0.6)}, {real(0.9), real(0.4), real(0.7)},
                          {real(0.8), real(0.6), real(0.35)}};
    Body body = body_with(real(0.5) + real(draw), order[draw % 3], random.vector(3),
                          random.turn());
    body.v = random.vector(4);
    body.w = random.vector(3);
    const real h = real(draw % 2 ? 0.01 : 0.05);
    const vec3 each = vec3(1) + random.vector(real(0.3));  // about each axis
    const vec3 last = vec3(1) + random.vector(real(0.3));
    out.push_back({"turned", body, follows[draw] / (8 * h * h) * each, before[draw] * last, 8, h});
  }
  Body isotropic = body_with(2, vec3(real(0.4)), vec3(1), random.turn());
  isotropic.w = vec3(3, -1, 2);
  out.push_back({"isotropic", isotropic, vec3(900, 500, 100), vec3(0), 8, real(0.02)});
  const auto another = [&](std::size_t of, const char* words, auto change) {
    out.push_back(out[of]);
    out.back().words = words;
    change(out.back());
  };
  another(2, "kappa 0", [](SlowedCase& c) { c.kappa = 0; });
  another(3, "no force", [](SlowedCase& c) { c.force_lever = vec3(0); });
  another(5, "no force about one axis", [](SlowedCase& c) { c.force_lever.y = 0; });
  another(4, "kappa 4", [](SlowedCase& c) { c.kappa = 4; });
  another(5, "at rest", [](SlowedCase& c) { c.body.w = vec3(0); });
  another(3, "a great force", [](SlowedCase& c) { c.force_lever *= real(100); });
  another(1, "enough inertia", [](SlowedCase& c) { c.force_lever = vec3(1); });
  another(2, "the moments of the last step", [](SlowedCase& c) { c.before = followed(c); });
  another(4, "a long step", [](SlowedCase& c) {
    c.h = 1;
    c.force_lever = vec3(real(1.5), 1, real(0.4)) / c.kappa;
  });
  return out;
}

/// The inverse moments and the angular velocity, Eq. 9-13 and 9-14.
inline Numbers right_slowed(const SlowedCase& c) {
  const vec3 local = to_local(c.body, c.body.w);
  vec3 inverse, w;
  for (int k = 0; k < 3; ++k) {
    const real own = 1 / c.body.inverse_inertia_local[k];
    const real now = std::max(own, followed(c)[k]);
    inverse[k] = 1 / now;
    w[k] = std::sqrt(std::min(real(1), std::max(own, c.before[k]) / now)) * local[k];
  }
  return flat(std::vector<vec3>{inverse, to_world(c.body, w)});
}

inline CaseTable<SlowedCase> slowed_table() {
  CaseTable<SlowedCase> table{{"9.8", "a body with more inertia"},
                              {"inverse_inertia", "w"}, {}, {}, {}, slowed_cases()};
  table.tolerance = 10 * rounding;
  table.in_pairs = true;
  judge(table, slowed, [](auto slow, const SlowedCase& c) {
    const Slowed out = slow(c.body, c.force_lever, c.before, c.kappa, c.h);
    return flat(std::vector<vec3>{out.inverse_inertia_local, out.w});
  });
  table.right = right_slowed;
  table.given = [copy = table](const SlowedCase& c) {
    return slowed_given(c) + " " + copy.holds_in();
  };
  return table;
}

}  // namespace joints::testing
