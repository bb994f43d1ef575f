// Random chains and trees of bodies with large mass ratios, for which no solver was tuned.
#pragma once

#include "bench/scenes.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// A chain of 5 to 40 cubes of 0.4 m, the first of them static, 0.5 m apart, randomly bent; ball
/// joints and hinges midway. Masses are log-uniform from 1 kg to `ratio` kg. All begin at rest.
BenchScene random_chain(unsigned seed, double ratio);
/// The same, but each cube is connected to a random one of those before it.
BenchScene random_tree(unsigned seed, double ratio);

}  // namespace joints::bench
/// @}
