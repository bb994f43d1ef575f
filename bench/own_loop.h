// Chapter 7's loop over hinges alone, on the benchmark's scenes. Its implementation is in
// own_loop.cpp, which is compiled for the processor of the building machine.
#pragma once

#include <memory>
#include <string>

#include "engine/world.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// The order of the hinges, and whether they are on lanes.
enum class Visits {
  chain_order,    ///< one hinge after the other, as they were added
  interleaved,    ///< the first of every chain, then the second of every one
  chain_a_lane,   ///< the same on lanes
  coloured_lanes  ///< colour after colour, on lanes
};

/// Bodies and hinges copied from a world and simulated without it.
class OwnLoop {
 public:
  virtual ~OwnLoop() = default;
  virtual void step(real h) = 0;                ///< \param h step [s]
  virtual void show(World& world) const = 0;    ///< copies the bodies back
};

/// \param world hinges and no other joints \param iterations per step
/// \param relaxation factor of every impulse [1]
std::unique_ptr<OwnLoop> own_loop(const World& world, int iterations, Visits visits,
                                  real relaxation = 1);

/// The instruction set for which the loop was compiled and its number of lanes: "AVX2, 8 lanes".
std::string own_instructions();

}  // namespace joints::bench
/// @}
