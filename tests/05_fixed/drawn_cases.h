// Exercises 5.1 to 5.3: cases drawn over scales and sides.
#pragma once

#include "tests/05_fixed/sleeve_cases.h"
#include "tests/checker/drawn.h"
#include "tests/checker/vector_cases.h"

namespace joints::testing {

inline Drawn drawn_cross_K(Draw& d) {
  const Draw::Units u = d.units();
  const Pair pair = d.pair(u);
  const auto [anchor1, anchor2] = d.levers(u);
  const Point point{anchor1, anchor2};
  const vec3 r1 = pair.body1.q * point.anchor1_local, r2 = pair.body2.q * point.anchor2_local;
  const mat3 X = cross_K(point, pair.body1, pair.body2);
  const mat3 right = -(skew(r1) * inverse_inertia(pair.body1)) -
                     skew(r2) * inverse_inertia(pair.body2);
  const double size = double(length(r1) + length(r2));
  Drawn out = drawn_vectors({"column x", "column y", "column z"},
                            flat(std::vector<vec3>{X[0], X[1], X[2]}),
                            flat(std::vector<vec3>{right[0], right[1], right[2]}),
                            {size / (u.kg * u.m * u.m)});
  out.sizes = {20};
  return out;
}

inline Drawn drawn_load(Draw& d) {
  const Draw::Units u = d.units();
  const double h = 0.01 * u.s, force = d.size("force", u.kg * u.m / u.s / u.s, "N");
  const vec3 push = d.vector(h * force), couple = d.vector(h * force * u.m);
  const Reaction load = carried({push.x, push.y, push.z, couple.x, couple.y, couple.z}, real(h));
  return drawn_vectors({"force", "torque"}, flat(std::vector<vec3>{load.force, load.torque}),
                       flat(std::vector<vec3>{push / real(h), couple / real(h)}),
                       {force, force * u.m});
}
inline Drawn drawn_about(Draw& d) {
  const Draw::Units u = d.units();
  const double force = d.size("force", u.kg * u.m / u.s / u.s, "N");
  const Reaction load{d.vector(force), d.vector(force * u.m)};
  const bool plane = d.chance("all lies in a plane z");
  const vec3 from = d.vector(u.m) * vec3(1, 1, plane ? 0 : 1);
  const vec3 to = d.vector(u.m) * vec3(1, 1, plane ? 0 : 1);
  const Reaction yours = about(load, from, to);
  return drawn_vectors({"force", "torque"}, flat(std::vector<vec3>{yours.force, yours.torque}),
                       flat(std::vector<vec3>{load.force, load.torque +
                                                              skew(load.force) * (to - from)}),
                       {force, force * u.m});
}
/// Force and torque a little below their bounds or above.
inline Drawn drawn_breaks(Draw& d) {
  const double force = d.size("force", d.scale(), "N"), torque = d.size("torque", d.scale(), "N m");
  const double beside = std::pow(10, -9 * d.pick()) / 2;
  d.size("distance to a bound / bound", beside, "");
  const bool too_far = d.chance("the force is too large");
  const bool turned = d.chance("the torque is too large");
  const auto of = [&](double bound, bool above) {
    const double size = bound * (above ? 1 + beside : 1 - beside);
    return real(size) * normalize(d.vector());
  };
  const bool unbounded = !too_far && d.chance("the force is not bounded");
  const Reaction load{of(force, too_far), of(torque, turned)};
  const real most = unbounded ? std::numeric_limits<real>::infinity() : real(force);
  return {{"breaks (1 yes)"}, {double(breaks(load, {most, real(torque)}))},
          {double(too_far || turned)}, {1}};
}

/// A pair and a kit of any size, at any pose.
inline SleeveCase drawn_kit(Draw& d, const Draw::Units& u) {
  const Pair pair = d.pair(u);
  const auto [anchor1, anchor2] = d.levers(u);
  const quat turn = d.turn();
  const vec3 b = turn * vec3(0, 1, 0), c = turn * vec3(0, 0, 1);
  return {"", {{anchor1, anchor2}, {anchor1, anchor2, b, c}, {cross(b, c), c, b}, {}}, pair};
}
inline Drawn drawn_sleeve(Draw& d) {
  const Draw::Units u = d.units();
  const auto [words, kit, pair] = drawn_kit(d, u);
  return drawn_K(d, sleeve(kit, pair.body1, pair.body2).K, composed(kit, pair).J, pair, u.kg);
}
inline Drawn drawn_transmitted(Draw& d) {
  const Draw::Units u = d.units();
  const auto [words, kit, pair] = drawn_kit(d, u);
  const double h = 0.01 * u.s, force = d.size("force", u.kg * u.m / u.s / u.s, "N");
  TransmittedCase c{"", composed(kit, pair).J, {}, real(h), pair.body2, d.vector(u.m)};
  for (const std::size_t i : {0, 1, 2, 3})
    c.impulse[i] = d.chance("an impulse is 0") ? 0 : real(d.number() * h * force *
                                                          (i < 2 ? 1 : u.m));
  const Reaction load = transmitted(c.J, c.impulse, c.h, c.body2, c.seam);
  const Numbers right = transmitted_right(c);
  double lever = double(length(c.body2.x - c.seam)) + u.m;
  for (const Row& row : c.J.row) lever += double(length(row.w2)) / 4;
  Drawn out = drawn_vectors({"force", "torque"}, flat(std::vector<vec3>{load.force, load.torque}),
                            right, {force, force * lever});
  out.sizes = {5};
  return out;
}

}  // namespace joints::testing
