// Random chains and trees of bodies whose masses are far apart: what nobody has tuned a solver for.
#pragma once

#include "bench/scenes.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// A chain of 5 to 40 cubes of 0.4 m from a static one on, 0.5 m apart, bent at random; ball joints
/// and hinges midway. Masses are log-uniform from 1 kg to `ratio` kg. All begin at rest.
BenchScene random_chain(unsigned seed, double ratio);
/// The same, but each cube hangs on one of those before it.
BenchScene random_tree(unsigned seed, double ratio);

}  // namespace joints::bench
/// @}
