// Chains and trees drawn by a seed, for which no solver was tuned, and many islands of all kinds.
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
/// Chains of `links` cubes of 1 to 10 kg on hinges, 1.5 m apart, released from a level line. Each
/// chain's hinges have limits, between 0.1 and 0.6 rad either way, which come and go as it swings.
/// Finding: how far a hinge is beyond its limits at the end.
BenchScene limited_chains(int chains, int links, unsigned seed);
/// At least `bodies` that can move, in islands side by side: ragdolls in any pose above the ground,
/// boxes that fall on it, chains with limits of 2 to 20 links, random_chain() and random_tree()
/// with masses up to 10 kg, and cubes on a hinge with a motor.
BenchScene mixed_islands(int bodies, unsigned seed);

}  // namespace joints::bench
/// @}
