// The benchmark scenes: bodies, joints, the marks by which they are measured, a tip to follow.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/measure.h"
#include "engine/world.h"

/// \defgroup bench Benchmark
/// \brief Scenes, settings and the runner for error against run time.
/// @{
namespace joints::bench {

/// A scene ready to run. All bodies start at rest.
struct Scene {
  std::string name;
  World world;
  std::vector<Mark> marks;           ///< one a joint
  int chains = 1;                    ///< how many alike stand side by side
  double energy_scale = 1;           ///< sum of m g times the distance from the fixed end [J]
  int tip = 0;                       ///< slot of the body whose place is compared
  glm::dvec3 tip_reference{0};       ///< where it is after 1 s, from a far finer computation [m]
  glm::dvec3 tip_mask{1};            ///< 1 for the coordinates that the reference gives
};

/// How a scene is made: every run needs a fresh one.
using MakeScene = std::function<Scene()>;

/// Chains of `length` cubes side by side, of edge 1 m and 100 kg, 1.5 m apart, held out level, the
/// first of each static; ball joints at the centre of the cube before.
Scene cubes_on_balls(int chains, int length);
/// A chain of 20 cubes of 1 kg on ball joints with a ball of `ratio` kg at its end.
/// \param ratio one of 1, 10, 100, 1000, 10000: the masses for which a reference is known
Scene heavy_end(double ratio);

}  // namespace joints::bench
/// @}
