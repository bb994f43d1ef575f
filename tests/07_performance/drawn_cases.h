// Exercises 7.1 to 7.3: cases drawn over sizes, scales and sides.
#pragma once

#include "tests/07_performance/colour_cases.h"
#include "tests/07_performance/solve_cases.h"
#include "tests/07_performance/hoist_cases.h"
#include "tests/07_performance/whole_K_cases.h"
#include "tests/checker/drawn.h"

namespace joints::testing {

/// A hinge whose axes and points are apart by little or much: numbers of the hoist.
inline Drawn drawn_hoist(Draw& d) {
  const Draw::Units u = d.units(4);
  HingeCase c{"", {}, d.pair(u), real(u.s)};
  const auto [anchor1, anchor2] = d.levers(u);
  c.hinge.point = {anchor1, anchor2};
  const double tilt = d.size("angle between the axes", std::pow(10, -9 * d.pick()), "rad");
  const vec3 b = d.turn() * vec3(1, 0, 0);
  const vec3 other = normalize(cross(b, vec3(real(0.3), real(0.5), real(0.8))));
  const vec3 a1 = rotation(real(tilt) * normalize(b + real(0.7) * other)) * cross(b, other);
  c.hinge.axis = {conjugate(c.pair.body1.q) * a1, conjugate(c.pair.body2.q) * b,
                  conjugate(c.pair.body2.q) * other};
  c.hinge.beta = real(d.pick());
  const vec3 r1 = to_world(c.pair.body1, c.hinge.point.anchor1_local);
  const vec3 r2 = to_world(c.pair.body2, c.hinge.point.anchor2_local);
  const double l1 = double(length(r1)), l2 = double(length(r2));
  const double gap = d.size("gap", (l1 + l2) * std::pow(10, -9 * d.pick()), "m");
  c.pair.body1.x = -r1, c.pair.body2.x = d.vector(gap) - r2;
  const HingeNumbers<real> yours = hoisted(c);
  const HingeNumbers<real> right = reference_numbers(c);
  Drawn out = drawn_vectors({"r1", "r2"},
                            flat({to_vec3(yours.r1), to_vec3(yours.r2)}), flat({r1, r2}),
                            {l1, l1, l1, l2, l2, l2});
  for (std::size_t i = 0; i < 5; ++i) {
    const double unit = (i < 3 ? gap : tilt) / u.s;
    out.entries.push_back("bias[" + std::to_string(i) + "] in units of the error");
    out.yours.push_back(double(yours.bias[i]) / unit);
    out.right.push_back(double(right.bias[i]) / unit);
  }
  const double size = 10 + (is_float ? 100 : 1e-4 * (l1 + l2) / gap + 1e-5 / tilt);
  for (const bool second : {false, true})
    for (int k = 0; k < 6; ++k) {
      const double unit = 1 / (u.kg * u.m * u.m);
      out.entries.push_back(std::string(second ? "I2." : "I1.") + inertia_entries[k]);
      out.yours.push_back(six_numbers(second ? yours.I2 : yours.I1)[std::size_t(k)] / unit);
      out.right.push_back(six_numbers(second ? right.I2 : right.I1)[std::size_t(k)] / unit);
    }
  out.sizes = {size};
  return out;
}

inline Drawn drawn_whole_K(Draw& d) {
  const Draw::Units u = d.units();
  const Pair pair = d.pair(u);
  const auto [r1, r2] = d.levers(u);
  const vec3 rows[] = {d.vector(), d.vector()};
  HingeNumbers<real> hinge{};
  hinge.r1 = triple(r1), hinge.r2 = triple(r2);
  for (int i = 0; i < 2; ++i) hinge.axis_row[std::size_t(i)] = triple(rows[i]);
  hinge.I1 = symmetric(inverse_inertia(pair.body1));
  hinge.I2 = symmetric(inverse_inertia(pair.body2));
  Jacobian<5> J;
  for (int i = 0; i < 3; ++i) J[i] = row_by_rates(unit_vector(i), r1, r2);
  for (int i = 0; i < 2; ++i) J[3 + i] = {vec3(0), -rows[i], vec3(0), rows[i]};
  const Matrix<5> K = whole_K(hinge, pair.body1.inverse_mass, pair.body2.inverse_mass);
  const Matrix<5> right = dense_K(J, pair.body1, pair.body2);
  const double lever = 1 + double(length(r1) + length(r2)) / u.m;
  Drawn out{names_of_K(), {}, {}};
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) {
      const double unit = (i < 3 ? 1 : 1 / u.m) * (j < 3 ? 1 : 1 / u.m) / u.kg;
      out.sizes.push_back(20 * (i < 3 ? lever : 1) * (j < 3 ? lever : 1));
      out.yours.push_back(double(K[i][j]) / unit);
      out.right.push_back(double(right[i][j]) / unit);
    }
  return out;
}

/// Joints between any two bodies, and a hub with many.
inline Drawn drawn_colours(Draw& d) {
  const int bodies = d.count("bodies", d.whole(2, 600));
  const int joints = d.count("joints", d.whole(0, 100));
  const int hub = d.count("joints of a hub", d.whole(0, 300));
  Random random = d.many();
  const auto any = [&](int below) { return int(random.uniform(0, real(below) - real(0.01))); };
  ColourScene scene{"", {}, {}};
  for (int k = 0; k < bodies + 1; ++k) scene.moves.push_back(k == 0 || random.uniform(0, 1) > 0.2);
  for (int k = 0; k < joints; ++k) {
    const int one = 1 + any(bodies);
    if (const int other = any(bodies + 1); other != one) scene.links.push_back({one, other});
  }
  for (int k = 0; k < hub; ++k) scene.links.push_back({0, 1 + k % bodies});
  const Colours yours = your_colours(scene), right = right_colours(scene);
  Drawn out{{"number of colours"}, {double(yours.size())}, {double(right.size())}, {1}};
  for (std::size_t k = 0; k < right.size(); ++k) {
    out.entries.push_back("colour of joint " + std::to_string(k));
    out.yours.push_back(k < yours.size() ? yours[k] : -1);
    out.right.push_back(right[k]);
  }
  return out;
}

}  // namespace joints::testing
