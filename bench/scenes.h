// The benchmark scenes: bodies, joints, the marks by which they are measured, a tip to follow.
#pragma once

#include "engine/instruments/scene.h"
#include "joints/hinge_joint.h"

/// \defgroup bench Benchmark
/// \brief Scenes, settings and the runner for error against run time, and the stability suite.
/// @{
namespace joints::bench {

/// The result that a scene is made for, as a number, and its value without any error.
struct Finding {
  std::string what{};    ///< in words without a comma, with its unit
  double expected = 0;
  std::function<double(const Scene&)> value{};  ///< at the end of a run; empty: no finding
};

/// A scene of the benchmark: equal chains side by side, and a tip whose motion is compared. All
/// bodies start at rest unless stated otherwise.
struct BenchScene : Scene {
  int chains = 1;                    ///< number of equal chains side by side
  int tip = 0;                       ///< slot of the body whose position is compared
  double tip_time = 1;               ///< when it is compared [s]
  glm::dvec3 tip_reference{0};       ///< its position then, from a far finer computation [m]
  glm::dvec3 tip_mask{1};            ///< 1 for the coordinates that are compared
  glm::dvec3 forbidden{0};           ///< unit direction in which no body can move; 0: none
  Finding finding{};
};

/// Makes a scene: every run needs a new one.
using MakeScene = std::function<BenchScene()>;

/// Joins two bodies at their present poses and adds a mark. \param anchor [m, world]
void join_by_ball(Scene& scene, BodyId id1, BodyId id2, const vec3& anchor);
/// \param axis unit, world
HingeJoint& join_by_hinge(Scene& scene, BodyId id1, BodyId id2, const vec3& anchor,
                          const vec3& axis);

// ---- chains -------------------------------------------------------------------------------------

/// S1b: chains of `length` cubes side by side, of edge 1 m and 100 kg, 1.5 m apart, initially
/// level, the first of each static; ball joints at the centre of the previous cube.
BenchScene cubes_on_balls(int chains, int length);
/// S1: the same on hinges, whose axis is level and perpendicular to the chain; S5 is one chain of
/// 4.
BenchScene cubes_on_hinges(int chains, int length);
/// S6: one chain of 11 cubes on hinges, gravity not quite along their plane.
BenchScene loaded_axes();
/// S7: ten chains of 100 on hinges, gravity far out of their plane: the axes carry the whole load.
BenchScene sideways_gravity();
/// S2: a chain of 20 cubes of 1 kg on ball joints with a ball of `ratio` kg at its end.
/// \param ratio one of 1, 10, 100, 1000, 10000: the masses for which a reference is known
BenchScene heavy_end(double ratio);
/// The same for any positive ratio; there is no reference for the tip.
BenchScene heavy_end_unreferenced(double ratio);
/// A static cube and cubes of these masses [kg], all of edge 0.4 m and 1 m apart, with ball joints
/// midway. \param along unit, direction from one to the next
BenchScene chain_of_masses(const std::vector<double>& masses, const vec3& along);

// ---- a bridge and a crane -----------------------------------------------------------------------

/// S3 on hinges, S3b on balls: 40 boxes of 1 kg between two static ones along a quarter of a
/// circle, the middle one of 100 kg.
BenchScene hanging_bridge(bool hinges);
/// S4: a cube of 100 kg, 1.5 m beside a static one, on a hinge through that one's centre.
BenchScene crane(const vec3& axis);
BenchScene motor();             ///< S4m: axis upright, target speed 3 rad/s, 500 N m
BenchScene limit();             ///< S4l: axis level, limits at 60 degrees either way
BenchScene motor_into_limit();  ///< S4ml: S4m with those limits
/// The hinge of a crane.
HingeJoint& hinge_of(Scene& scene);

}  // namespace joints::bench
/// @}
