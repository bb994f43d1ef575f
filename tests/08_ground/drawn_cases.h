// Exercises 8.1 to 8.4: cases drawn over scales and sides.
#pragma once

#include "tests/08_ground/contact_cases.h"
#include "tests/checker/drawn.h"
#include "tests/checker/vector_cases.h"

namespace joints::testing {

/// A corner or a ball above the top or in it, by little or much.
inline Drawn drawn_corner(Draw& d, bool of_row) {
  const Draw::Units u = d.units(6);
  Pair pair = d.pair(u);
  const double lever = d.size("distance of the corner", d.length(u), "m");
  const double height = d.chance("height is 0") ? 0 : d.length(u);
  d.size("height", height, "m");
  const double radius = d.chance("it is a ball") ? lever * d.scale(3) : 0;
  d.size("radius", radius, "m");
  Corner corner{d.vector(lever), real(radius), real(height)};
  if (d.chance("corner_local has an entry that is 0"))
    corner.corner_local[int(2.99 * d.pick())] = 0;
  const double far = lever + height + radius;
  const double apart = d.size("|C|", far * std::pow(10, -5 * d.pick()), "m");
  const double C = d.chance("C is negative") ? -apart : apart;
  if (!d.chance("body 1 is beside the origin")) pair.body1.x = vec3(0);
  const vec3 n = pair.body1.q * vec3(0, 1, 0), beside = cross(n, d.vector(lever));
  const vec3 rho = corner.radius * n, arm = pair.body2.q * corner.corner_local;
  const vec3 r1 = real(height + C) * n + beside, r2 = arm - rho;
  pair.body2.x = pair.body1.x + r1 - r2;
  if (!of_row)
    return {{"C / |C|"}, {double(corner.error(pair.body1, pair.body2)) / apart}, {C / apart},
            {10 + (is_float ? 1e-3 : 1e-5) * (far + u.m) / apart}};
  const vec3 t = normalize(d.vector());
  d.size("lever of body 1", double(length(r1)), "m");
  d.size("lever of body 2", double(length(r2)), "m");
  const double l1 = double(length(r1)), l2 = double(length(r2));
  const double rounding_of = is_float ? 1e-3 : 1e-6;
  return drawn_rows(to_jacobian(corner.along(t, pair.body1, pair.body2)),
                    to_jacobian(row_by_rates(t, r1, r2)), l1 + rounding_of * l2,
                    l2 + rounding_of * l1);
}

/// Bodies that slide at any speed or hardly, where t1 is any direction across n, or nearly.
inline Drawn drawn_tangents(Draw& d) {
  vec3 n = d.turn() * vec3(0, 1, 0);
  if (d.chance("n is along x, y or z")) {
    const int axis = int(2.99 * d.pick());
    n = vec3(0);
    n[axis] = d.pick() < 0.5 ? 1 : -1;
  }
  const bool near_limit = d.chance("the sliding is near 1e-4 m/s");
  const bool slower = d.chance("it is slower");
  const double beside = std::pow(10, -(is_float ? 2 : 6) * d.pick()) / 2;
  const double from = near_limit ? 1 + beside : std::pow(10, 8 * d.pick());
  const double speed = d.size("sliding across n", 1e-4 * (slower ? 1 / from : from), "m/s");
  const double ratio = d.chance("the speed along n is 0") ? 0 : d.scale(6);
  const double along = d.size("speed along n", (is_float ? d.pick() : ratio) * speed, "m/s");
  const double tilt = std::atan2(double(length(vec3(n.x, 0, n.z))), double(n.y));
  d.size("angle between n and y", tilt, "rad");
  d.size("speed along n over sliding", along / speed, "");
  vec3 aside = d.vector();
  if (d.chance("the sliding has an entry that is 0")) aside[int(2.99 * d.pick())] = 0;
  const vec3 across = normalize(cross(n, aside));
  const auto [t1, t2] = tangents(n, real(speed) * across + real(along) * n);
  const vec3 right = slower ? normalize(t1 - dot(n, t1) * n) : across;
  return drawn_vectors({"t1", "t2"}, flat(std::vector<vec3>{t1, t2}),
                       flat(std::vector<vec3>{right, cross(n, right)}), {1});
}

/// Each number is 0 now and then, or spread over twelve decades beside the others.
inline Drawn drawn_friction(Draw& d) {
  const double apart = is_float ? 2 : 6;
  const double speed = d.any_size(), K = d.size("K", d.scale(12), "1/kg");
  const double rate = d.size("|rate|", d.chance("the rate is 0") ? 0 : speed, "m/s");
  const double stops = std::abs(speed) / K;
  const double mu = d.size("mu", d.chance("mu is 0") ? 0 : d.scale(6), "");
  const double normal =
      d.size("normal", mu > 0 ? stops / mu * d.scale(int(apart)) : stops * d.scale(3), "N s");
  const bool presses = !d.chance("nothing presses");
  const bool beyond = d.chance("the required impulse is just beyond its bound");
  double bound = presses ? mu * normal : 0;
  double before = d.chance("the old sum is 0") ? 0 : d.old_sum(bound, stops);
  if (beyond) {
    const double more = 1 + std::pow(10, -(is_float ? 2 : 8) * d.pick()) / 2;
    before = rate / K + (rate > 0 ? -more : more) * bound;
  }
  d.size("mu normal", bound, "N s");
  d.size("|old sum|", before, "N s");
  d.size("|sum - rate / K|", before - rate / K, "N s");
  d.side("the rate is negative", rate < 0);
  d.side("it sticks", std::abs(before - rate / K) < bound);
  real sum = real(before);
  const double change = double(
      friction_impulse(real(rate), real(K), real(mu), real(presses ? normal : 0), sum));
  const double right = std::clamp(before - rate / K, -bound, bound);
  const double size = bound > 0 ? std::min(stops, bound) : stops;
  return {{"change", "new sum"}, {change / size, double(sum) / size},
          {(right - before) / size, right / size},
          {10 + 1e-6 * (bound + stops + std::abs(before)) / size}};
}

/// Up to eight corners above the ground and in it, some just beside the margin.
inline Drawn drawn_live(Draw& d) {
  const double h = d.size("h", 0.01 * d.scale(6), "s");
  LiveCase c{"", {}, {}, real(h)};
  const double beside = std::pow(10, -(is_float ? 2 : 6) * d.pick()) / 2;
  d.size("distance to the margin / margin", beside, "");
  const int corners = 1 + int(7.99 * d.pick());
  for (int k = 0; k < corners; ++k) {
    const double rate = d.chance("a rate is 0") ? 0 : d.number();
    const double after = d.chance("a corner is beside the margin")
                             ? 0.1 * h * (1 + (d.pick() < 0.5 ? beside : -beside) * (1 + 0.1 * k))
                             : h * d.number();
    c.rate.push_back(real(rate));
    c.C.push_back(real(after - h * rate));
  }
  const Numbers yours = counted(live_corners(c.C, c.rate, c.h, real(0.1)), c.C.size());
  return {{"0", "1", "2", "3", "4", "5", "6", "7", "no corner"}, yours, live_right(c),
          Numbers(9, 1)};
}
/// Corners of a pair in any units.
inline ContactCase drawn_contact_case(Draw& d, int corners) {
  const Draw::Units u = d.units(6);
  ContactCase c{"", {}, d.chance("mu is 0") ? 0 : 0.5 * std::abs(d.number()), d.pair(u)};
  if (c.pair.body1.is_static() && c.pair.body2.is_static()) c.pair.body2 = d.body(u);
  for (Body* body : {&c.pair.body1, &c.pair.body2})
    body->v = d.vector(u.m / u.s), body->w = d.vector(1 / u.s);
  const vec3 n = d.turn() * vec3(0, 1, 0), t1 = normalize(cross(n, d.vector()));
  for (int k = 0; k < corners; ++k) {
    const vec3 r1 = d.vector(u.m), r2 = d.vector(u.m);
    c.corners.push_back(contact_rows(n, t1, r1, r2, c.pair));
    c.corners.back().bias = real(d.chance("the bias is 0") ? 0 : d.number() * u.m / u.s);
    if (d.chance("it is cold")) continue;
    for (const std::size_t i : {2, 0, 1})
      c.corners.back().sum[i] =
          real((i == 2 ? std::abs(d.number()) : 0.5 * c.mu * d.number()) * u.kg * u.m / u.s);
  }
  return c;
}
/// Sums beside the largest of them; the velocities follow from the sums.
inline Drawn drawn_sums(const Numbers& yours, const Numbers& right, std::size_t corners) {
  Drawn out;
  double size = 1e-300;
  for (std::size_t i = 12; i < 12 + 3 * corners; ++i) {
    out.entries.push_back(contact_names()[i]);
    out.yours.push_back(yours[i]);
    out.right.push_back(right[i]);
    size = std::max(size, std::abs(right[i]));
  }
  for (double& a : out.yours) a /= size;
  for (double& a : out.right) a /= size;
  out.sizes = {1000};
  return out;
}
inline Drawn drawn_contact(Draw& d) {
  const ContactCase c = drawn_contact_case(d, 2);
  ContactCase mine = c;
  solve_contact(mine.corners, real(c.mu), mine.pair.body1, mine.pair.body2);
  return drawn_sums(numbers_of(mine.corners, mine.pair), contact_right(c), 2);
}
inline Drawn drawn_rebound(Draw& d) {
  ReboundCase c{"", drawn_contact_case(d, 2), {}, 2};
  const double speed = double(length(c.contact.pair.body2.v));
  for (int k = 0; k < 2; ++k)
    c.bounces.push_back(d.chance("no rebound") ? Bounce{}
                                               : Bounce{real(speed * std::abs(d.number())),
                                                        real(d.pick())});
  ContactCase mine = c.contact;
  rebound(mine.corners, c.bounces, c.iterations, mine.pair.body1, mine.pair.body2);
  return drawn_sums(numbers_of(mine.corners, mine.pair), rebound_right(c), 2);
}
inline Drawn drawn_impact_speed(Draw& d) {
  const double speed = std::abs(d.any_size(6)), h = 0.01 * d.scale(4);
  const double kick = d.chance("the kick is 0") ? 0 : -speed * d.scale(is_float ? 1 : 6);
  const double C = d.chance("C is 0") ? 0 : speed * h * std::abs(d.number());
  d.size("kick", -kick, "m/s"), d.size("C", C, "m"), d.size("rate", speed, "m/s");
  const double begin = speed + kick / 2, square = begin * begin - 2 * kick / h * C;
  const double right = square > 0 ? std::sqrt(square) : 0;
  const double yours = double(impact_speed(real(C), real(-speed), real(kick), real(h)));
  return {{"v_hit / speed"}, {yours / speed}, {right / speed},
          {10 + std::abs(kick) / speed + (right > 0 ? begin * begin / right / speed : 0)}};
}

}  // namespace joints::testing
