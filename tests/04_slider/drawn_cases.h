// Exercises 4.1 to 4.3: cases drawn over scales, sides and angles.
#pragma once

#include <numbers>

#include "chapters/04_slider/slider.h"
#include "tests/checker/drawn.h"
#include "tests/checker/unit_rates.h"
#include "tests/checker/vector_cases.h"

namespace joints::testing {

/// Two bodies whose points are apart by any distance.
struct DrawnGap {
  Draw::Units u;
  vec3 anchor1, anchor2;
  Pair pair;
  vec3 gap, r1, r2;
  double apart;
};
inline DrawnGap drawn_gap(Draw& d) {
  DrawnGap g{d.units(12), {}, {}, {}, {}, {}, {}, 0};
  const auto anchors = d.levers(g.u);
  g.anchor1 = anchors[0], g.anchor2 = anchors[1];
  g.pair = d.pair(g.u);
  g.r1 = to_world(g.pair.body1, g.anchor1), g.r2 = to_world(g.pair.body2, g.anchor2);
  const double levers = double(length(g.r1) + length(g.r2));
  g.apart = d.size("distance of the points", levers * d.scale(5), "m");
  g.pair.body1.x = vec3(0) - g.r1;
  g.pair.body2.x = d.vector(g.apart) - g.r2;
  g.gap = g.pair.body2.x + g.r2 - g.pair.body1.x - g.r1;
  return g;
}
inline Numbers gap_sizes(const DrawnGap& g) {
  return {10 + 1e-4 * double(length(g.r1) + length(g.r2)) / g.apart};
}

/// From point 2 to body 2 it has the rounding errors of the distance.
inline double unit_of_lever2(const DrawnGap& g) {
  return double(length(g.r2)) + (is_float ? 1e-3 : 1e-6) * double(length(g.r1) + length(g.gap));
}

/// The row of the gap along a direction of body 1, which turns with it.
inline Row row_along(const DrawnGap& g, const vec3& local) {
  const vec3 n = g.pair.body1.q * local;
  return row_of([&](const Row& V) {
    return dot(relative_velocity(V, g.r1, g.r2), n) + dot(g.gap, cross(V.w1, n));
  });
}

inline Drawn drawn_line(Draw& d) {
  const DrawnGap g = drawn_gap(d);
  const quat frame = d.turn();
  const Line line{g.anchor1, g.anchor2, frame * vec3(1, 0, 0), frame * vec3(0, 1, 0)};
  const Vector<2> C = line.error(g.pair.body1, g.pair.body2);
  const auto along = [&](const vec3& n) {
    return double(dot(g.gap, g.pair.body1.q * n)) / g.apart;
  };
  const double right[] = {along(line.n1_local), along(line.n2_local)};
  d.size("smaller C", g.apart * std::min(std::abs(right[0]), std::abs(right[1])), "m");
  return {{"C[0] / distance", "C[1] / distance"}, {double(C[0]) / g.apart, double(C[1]) / g.apart},
          {right[0], right[1]}, gap_sizes(g)};
}
inline Drawn drawn_line_rows(Draw& d) {
  const DrawnGap g = drawn_gap(d);
  const quat frame = d.turn();
  const Line line{g.anchor1, g.anchor2, frame * vec3(1, 0, 0), frame * vec3(0, 1, 0)};
  return drawn_rows(line.jacobian(g.pair.body1, g.pair.body2),
                    Jacobian<2>{{row_along(g, line.n1_local), row_along(g, line.n2_local)}},
                    double(length(g.r1) + length(g.gap)), unit_of_lever2(g));
}

inline Drawn drawn_slide(Draw& d) {
  const DrawnGap g = drawn_gap(d);
  const Slide slide{g.anchor1, g.anchor2, normalize(d.vector())};
  const double right = d.size("displacement", double(dot(g.gap, g.pair.body1.q * slide.a1_local)),
                              "m");
  return {{"displacement / distance"},
          {double(slide.error(g.pair.body1, g.pair.body2)) / g.apart}, {right / g.apart},
          gap_sizes(g)};
}

inline Drawn drawn_slide_row(Draw& d) {
  const DrawnGap g = drawn_gap(d);
  const Slide slide{g.anchor1, g.anchor2, normalize(d.vector())};
  return drawn_rows(to_jacobian(slide.jacobian(g.pair.body1, g.pair.body2)),
                    to_jacobian(row_along(g, slide.a1_local)),
                    double(length(g.r1) + length(g.gap)), unit_of_lever2(g));
}

/// At exactly half a turn either sign is right.
inline Drawn drawn_lock(Draw& d) {
  const double angle = d.angle();
  d.size("excess", std::remainder(angle, 2 * std::numbers::pi), "rad");
  d.size("excess beside half a turn", std::remainder(angle - std::numbers::pi,
                                                     2 * std::numbers::pi), "rad");
  const vec3 axis = normalize(d.vector());
  const quat q1 = d.turn(), start = d.turn();
  const quat q2 = rotation(real(angle) * axis) * q1 * start;
  const vec3 yours = RotationLock{start}.error(static_body(vec3(0), q1), static_body(vec3(0), q2));
  const double half = std::remainder(angle, 2 * std::numbers::pi) / 2;
  vec3 right = real(2 * std::sin(half)) * axis;
  if (std::cos(half) < 1e-12 && dot(yours, right) < 0) right = -right;
  const double unit = std::abs(2 * std::sin(half)) + 1e-13;
  Drawn out = drawn_vectors({"C / size"}, flat(std::vector<vec3>{yours}),
                            flat(std::vector<vec3>{right}), {unit});
  out.sizes = {10 + 1e-5 / unit};
  return out;
}

}  // namespace joints::testing
