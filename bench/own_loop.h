// Chapter 7's loop over hinges alone, on the benchmark's scenes. What it is made of stays in
// own_loop.cpp: that file is compiled for the processor that builds it.
#pragma once

#include <memory>
#include <string>

#include "engine/world.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// Who is solved when.
enum class Visits {
  chain_order,    ///< one hinge after the other, as they were added
  interleaved,    ///< the first of every chain, then the second of every one
  chain_a_lane,   ///< the same on lanes
  coloured_lanes  ///< colour after colour, on lanes
};

/// Bodies and hinges taken over from a world, moved on without it.
class OwnLoop {
 public:
  virtual ~OwnLoop() = default;
  virtual void step(real h) = 0;                ///< \param h step [s]
  virtual void show(World& world) const = 0;    ///< gives the bodies back
};

/// \param world hinges and nothing else \param iterations of a step
/// \param relaxation factor of every impulse [1]
std::unique_ptr<OwnLoop> own_loop(const World& world, int iterations, Visits visits,
                                  real relaxation = 1);

/// For which processors the loop was compiled, and how many lanes it has: "AVX2, 8 lanes".
std::string own_instructions();

}  // namespace joints::bench
/// @}
