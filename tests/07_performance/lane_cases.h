// Exercise 7.4: what a solve must keep, and the lanes on which several hinges are solved.
#pragma once

#include "engine/simd/lanes.h"
#include "tests/07_performance/solve_pieces.h"

namespace joints::testing {

// ---- one hinge ----------------------------------------------------------------------------------

/// Whatever is wrong, the table's mistake explains it.
inline void expect_solved(const std::string& entry, double yours, double right, double tolerance) {
  const bool same = near(yours, right, tolerance);
  expect({"7.4", "the solve of a whole hinge"}, entry, yours, right, tolerance,
         same ? std::vector<Suspect>{} : solve_table().explain(yours));
}
inline void expect_solved(const std::string& entry, const vec3& yours, const vec3& right,
                   double tolerance) {
  for (int k = 0; k < 3; ++k)
    expect_solved(entry + "." + "xyz"[k], double(yours[k]), double(right[k]), tolerance);
}
inline constexpr double loose = is_float ? 5e-3 : 1e-9;  ///< what mounts up where masses are small

/// The bodies' momentum, and their angular momentum about the anchor that both of them touch.
struct Momentum {
  vec3 push{0}, turn{0};
  double energy = 0;
  /// \param c with these velocities \param masses and these masses
  Momentum(const SolveCase& c, const SolveCase& masses) {
    const auto add = [&](const Velocities<real>& body, real inverse_mass, const Triple<real>& r,
                         const Symmetric<real>& I) {
      if (inverse_mass == 0) return;
      const vec3 p = to_vec3(body.v) / inverse_mass, w = to_vec3(body.w);
      const vec3 L = inverse(to_mat3(I)) * w;
      push += p;
      turn += cross(-to_vec3(r), p) + L;
      energy += double(dot(to_vec3(body.v), p) + dot(w, L)) / 2;
    };
    add(c.body1, masses.body1.inverse_mass, c.hinge.r1, c.hinge.I1);
    add(c.body2, masses.body2.inverse_mass, c.hinge.r2, c.hinge.I2);
  }
};

// ---- lanes --------------------------------------------------------------------------------------

inline constexpr Subject lanes_subject{"7.4", "the solve on lanes"};

struct LaneCase {
  HingeNumbers<Lanes> hinge;
  Velocities<Lanes> body1, body2;
};
/// As many hinges as there are lanes, from the one with this number on, but for no_lane.
inline LaneCase on_lanes(std::size_t first, int no_lane = -1) {
  const std::vector<SolveCase> cases = solve_cases();
  LaneCase all{};
  for (int lane = 0; lane < lane_count; ++lane) {
    if (lane == no_lane) continue;
    const SolveCase& c = cases[(first + std::size_t(lane)) % cases.size()];
    scatter(c.hinge, all.hinge, lane);
    scatter(c.body1, all.body1, lane);
    scatter(c.body2, all.body2, lane);
  }
  return all;
}
inline FourVelocities lane_velocities(const LaneCase& all, int lane) {
  const auto body1 = gather<Velocities<real>>(all.body1, lane);
  const auto body2 = gather<Velocities<real>>(all.body2, lane);
  return {to_vec3(body1.v), to_vec3(body1.w), to_vec3(body2.v), to_vec3(body2.w)};
}
inline void solve_lanes(LaneCase& all) { solve(all.hinge, all.body1, all.body2); }

/// Each velocity of a lane beside the right one.
inline void expect_lane(int lane, const std::string& words, const FourVelocities& yours,
                        const FourVelocities& right, double tolerance,
                        const FourVelocities& before, const std::string& otherwise) {
  const char* const names[] = {"v1", "w1", "v2", "w2"};
  for (std::size_t k = 0; k < 4; ++k)
    expect(lanes_subject, names[k] + (" of lane " + std::to_string(lane)) + words, yours[k],
           right[k], tolerance,
           {{before[k], "this lane is not solved: with + - * of Number all lanes are"},
            {yours[k], otherwise}});
}

}  // namespace joints::testing
