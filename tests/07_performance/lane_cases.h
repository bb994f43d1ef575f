// Exercise 7.4: the lanes on which several hinges are solved.
#pragma once

#include "engine/simd/lanes.h"
#include "tests/07_performance/solve_cases.h"

namespace joints::testing {

inline constexpr Subject lanes_subject{"7.4", "the solve on lanes"};

struct LaneCase {
  HingeNumbers<Lanes> hinge;
  Velocities<Lanes> body1, body2;
};
/// As many hinges as there are lanes, from the one with this number on.
inline LaneCase on_lanes(std::size_t first) {
  const std::vector<SolveCase> cases = solve_cases();
  LaneCase all{};
  for (int lane = 0; lane < lane_count; ++lane) {
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
