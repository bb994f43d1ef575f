// The benchmark scenes: bodies, joints, the marks by which they are measured, a tip to follow.
#pragma once

#include "chapters/03_hinge/hinge_joint.h"
#include "engine/instruments/scene.h"

/// \defgroup bench Benchmark
/// \brief Scenes, settings and the runner for error against run time, and the stability suite.
/// @{
namespace joints::bench {

/// What a scene is for, as a number, and what it would be without any error.
struct Finding {
  std::string what{};    ///< in words without a comma, with its unit
  double expected = 0;
  std::function<double(const Scene&)> value{};  ///< at the end of a run; empty: nothing is found
};

/// A scene of the benchmark: alike chains side by side, a tip to follow. All bodies start at rest
/// unless it says otherwise.
struct BenchScene : Scene {
  int chains = 1;                    ///< how many alike stand side by side
  int tip = 0;                       ///< slot of the body whose place is compared
  glm::dvec3 tip_reference{0};       ///< where it is after 1 s, from a far finer computation [m]
  glm::dvec3 tip_mask{1};            ///< 1 for the coordinates that the reference gives
  glm::dvec3 forbidden{0};           ///< unit direction in which no body can move; 0 where none
  Finding finding{};
};

/// How a scene is made: every run needs a fresh one.
using MakeScene = std::function<BenchScene()>;

/// Joins two bodies as they stand now, and marks the place. \param anchor [m, world]
void join_by_ball(Scene& scene, BodyId id1, BodyId id2, const vec3& anchor);
/// \param axis unit, world
HingeJoint& join_by_hinge(Scene& scene, BodyId id1, BodyId id2, const vec3& anchor,
                          const vec3& axis);

// ---- chains -------------------------------------------------------------------------------------

/// S1b: chains of `length` cubes side by side, of edge 1 m and 100 kg, 1.5 m apart, held out level,
/// the first of each static; ball joints at the centre of the cube before.
BenchScene cubes_on_balls(int chains, int length);
/// S1: the same on hinges, whose axis is level and across the chain; S5 is one chain of 4.
BenchScene cubes_on_hinges(int chains, int length);
/// S6: one chain of 11 cubes on hinges, gravity not quite along their plane.
BenchScene loaded_axes();
/// S7: ten chains of 100 on hinges, gravity far out of their plane: the axes carry it all.
BenchScene sideways_gravity();
/// S2: a chain of 20 cubes of 1 kg on ball joints with a ball of `ratio` kg at its end.
/// \param ratio one of 1, 10, 100, 1000, 10000: the masses for which a reference is known
BenchScene heavy_end(double ratio);
/// The same for any positive ratio; the tip is compared with nothing.
BenchScene heavy_end_unreferenced(double ratio);
/// Cubes of edge 0.4 m and these masses [kg] on ball joints midway, 1 m apart from a static one
/// on. \param along unit, the way from one to the next
BenchScene chain_of_masses(const std::vector<double>& masses, const vec3& along);

// ---- a bridge and a crane -----------------------------------------------------------------------

/// S3 on hinges, S3b on balls: 40 boxes of 1 kg between two static ones along a quarter of a
/// circle, the middle one of 100 kg.
BenchScene hanging_bridge(bool hinges);
/// S4: a cube of 100 kg, 1.5 m beside a static one, on a hinge through that one's centre.
BenchScene crane(const vec3& axis);
BenchScene motor();             ///< S4m: axis upright, 3 rad/s wanted, 500 N m
BenchScene limit();             ///< S4l: axis level, limits at 60 degrees either way
BenchScene motor_into_limit();  ///< S4ml: S4m with those limits
/// The hinge of a crane.
HingeJoint& hinge_of(Scene& scene);

}  // namespace joints::bench
/// @}
