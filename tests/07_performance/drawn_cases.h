// Exercises 7.2 and 7.3: cases drawn over sizes, scales and sides.
#pragma once

#include "tests/07_performance/colour_cases.h"
#include "tests/07_performance/whole_K_cases.h"
#include "tests/checker/drawn.h"

namespace joints::testing {

inline Drawn drawn_whole_K(Draw& d) {
  const Draw::Units u = d.units();
  const Pair pair = d.pair(u);
  const vec3 r1 = d.vector(u.m), r2 = d.vector(u.m), rows[] = {d.vector(), d.vector()};
  HingeNumbers<real> hinge{};
  hinge.r1 = triple(r1), hinge.r2 = triple(r2);
  for (int i = 0; i < 2; ++i) hinge.axis_row[std::size_t(i)] = triple(rows[i]);
  hinge.I1 = symmetric(inverse_inertia(pair.body1));
  hinge.I2 = symmetric(inverse_inertia(pair.body2));
  Jacobian<5> J;
  for (int i = 0; i < 3; ++i) {
    vec3 e(0);
    e[i] = 1;
    J[i] = {-e, -cross(r1, e), e, cross(r2, e)};
  }
  for (int i = 0; i < 2; ++i) J[3 + i] = {vec3(0), -rows[i], vec3(0), rows[i]};
  const Matrix<5> K = whole_K(hinge, pair.body1.inverse_mass, pair.body2.inverse_mass);
  const Matrix<5> right = dense_K(J, pair.body1, pair.body2);
  Drawn out{names_of(-1), {}, {}, {100}};
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) {
      const double unit = (i < 3 ? 1 : 1 / u.m) * (j < 3 ? 1 : 1 / u.m) / u.kg;
      out.yours.push_back(double(K[i][j]) / unit);
      out.right.push_back(double(right[i][j]) / unit);
    }
  return out;
}

/// Joints between any two bodies, and a hub with many.
inline Drawn drawn_colours(Draw& d) {
  const int bodies = d.count("bodies", d.whole(2, 300));
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
