// Exercises 8.1 and 8.2: cases drawn over scales and sides.
#pragma once

#include "chapters/08_ground/ground.h"
#include "tests/checker/drawn.h"
#include "tests/checker/unit_rates.h"
#include "tests/checker/vector_cases.h"

namespace joints::testing {

/// A corner or a ball above the top or in it, by little or much.
inline Drawn drawn_corner(Draw& d, bool of_row) {
  const Draw::Units u = d.units(6);
  Pair pair = d.pair(u);
  const double lever = d.size("lever", d.length(u), "m");
  const double height = d.size("height", d.length(u), "m");
  Corner corner{d.vector(lever), 0, real(height)};
  if (d.chance("it is a ball")) corner.radius = real(0.3 * lever);
  const double apart = d.size("|C|", (lever + height) * std::pow(10, -5 * d.pick()), "m");
  const double C = d.chance("C is negative") ? -apart : apart;
  const vec3 n = pair.body1.q * vec3(0, 1, 0), beside = cross(n, d.vector(lever));
  const vec3 rho = corner.radius * n, arm = pair.body2.q * corner.corner_local;
  pair.body1.x = vec3(0);
  pair.body2.x = real(height + C) * n + beside - arm + rho;
  if (!of_row)
    return {{"C / |C|"}, {double(corner.error(pair.body1, pair.body2)) / apart}, {C / apart},
            {10 + (is_float ? 1e-3 : 1e-5) * (lever + height) / apart}};
  const vec3 r1 = pair.body2.x + arm - rho, r2 = arm - rho, t = normalize(d.vector());
  const double l1 = double(length(r1)), l2 = double(length(r2));
  const double rounding_of = is_float ? 1e-3 : 1e-6;
  return drawn_rows(to_jacobian(corner.along(t, pair.body1, pair.body2)),
                    to_jacobian(row_by_rates(t, r1, r2)), l1 + rounding_of * l2,
                    l2 + rounding_of * l1);
}

/// Bodies that slide at any speed or hardly, where t1 is any direction across n, or nearly.
inline Drawn drawn_tangents(Draw& d) {
  const vec3 n = d.turn() * vec3(0, 1, 0);
  const bool near_limit = d.chance("the sliding is near 1e-4 m/s");
  const bool slower = d.chance("it is slower");
  const double beside = std::pow(10, -(is_float ? 2 : 6) * d.pick()) / 2;
  const double from = near_limit ? 1 + beside : std::pow(10, 8 * d.pick());
  const double speed = d.size("sliding across n", 1e-4 * (slower ? 1 / from : from), "m/s");
  const double along = d.size("speed along n", (is_float ? 1 : 100) * d.pick() * speed, "m/s");
  const vec3 across = normalize(cross(n, d.vector()));
  const auto [t1, t2] = tangents(n, real(speed) * across + real(along) * n);
  const vec3 right = slower ? normalize(t1 - dot(n, t1) * n) : across;
  return drawn_vectors({"t1", "t2"}, flat(std::vector<vec3>{t1, t2}),
                       flat(std::vector<vec3>{right, cross(n, right)}), {1});
}

inline Drawn drawn_friction(Draw& d) {
  const double rate = d.size("|rate|", d.any_size(), "m/s");
  const double K = d.size("K", d.scale(12), "1/kg"), stops = std::abs(rate) / K;
  const double mu = d.size("mu", std::abs(d.number()), "");
  const double normal = d.size("normal", stops / mu * d.scale(3), "N s"), bound = mu * normal;
  const double before = d.old_sum(bound);
  d.side("the rate is negative", rate < 0);
  d.side("it sticks", std::abs(before - rate / K) < bound);
  real sum = real(before);
  const double change = double(friction_impulse(real(rate), real(K), real(mu), real(normal), sum));
  const double right = std::clamp(before - rate / K, -bound, bound);
  const double size = std::min(stops, bound);
  return {{"change", "new sum"}, {change / size, double(sum) / size},
          {(right - before) / size, right / size}, {10 + 1e-6 * (bound + stops) / size}};
}

}  // namespace joints::testing
