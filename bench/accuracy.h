// Scenes for error against run time: each has a tip that its joints move in the compared time.
#pragma once

#include "bench/scenes.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// A scene whose motion is known to 1e-9 m, and its name in the tables.
struct AccuracyScene {
  std::string key{}, words{};
  MakeScene make{};
  bool is_tree = true;  ///< no joints close a loop
};
/// Three hinges, a triple pendulum, a driven arm, a whip, a wheel on an axle, a top, a four-bar
/// linkage and a slider-crank. `tests/bench/accuracy_test.cpp` computes each reference on two
/// roads.
std::vector<AccuracyScene> accuracy_scenes();

}  // namespace joints::bench
/// @}
