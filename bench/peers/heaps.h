// Scenes in which any bodies touch each other, for our contacts with Bullet's collision part and
// for the published engines.
#pragma once

#include "bench/peers/peer.h"

/// \addtogroup peers
/// @{
namespace joints::bench {

/// A scene on a level ground at the height 0; its first body is the ground.
struct Heap {
  std::string name{};
  PeerScene scene{};
  double seconds = 60;
  bool stacked = false;  ///< every body begins on the ground or on another one
};
/// Stacks of cubes, one of them with each cube turned against the one below; thirty stacks of drawn
/// boxes; boxes that are thrown along the ground; capsules; a ragdoll that falls on another; 200
/// boxes, balls and capsules that fall on each other.
std::vector<Heap> heaps();

/// What became of it, from the poses alone. Penetrations are those that Bullet's collision part
/// finds at the poses.
struct Heaped {
  double drift = 0;    ///< largest displacement of a centre after the first ten seconds [m]
  double gap = 0;      ///< largest gap of a joint at any time [m]
  double deepest = 0;  ///< largest penetration at any time; in long scenes seen every 0.1 s [m]
  double depth = 0;    ///< largest penetration at the end [m]
  double fastest = 0;  ///< largest speed of a centre in the last second [m/s]
  double seconds = 0;  ///< of the processor, without the measurements
  int moving = 0;      ///< bodies faster than 5 cm/s in the last second
  int fallen = 0;  ///< centres below the ground; boxes of stacks 0.2 m below their place
};
/// Runs it with an engine. \param seconds 0: as long as it lasts
Heaped run_heap(const Heap& heap, const PeerSetting& who, double seconds = 0);

/// Ours: ContactJoints at the points of Bullet's collision part with the guide's setting for
/// stacks. \param substeps of 4 iterations
/// \param ahead false: the points are those of the present poses instead of one step ahead
/// \param all false: the points that Bullet returns in one step, without earlier ones that stay
PeerSetting our_contacts(int substeps = 4, bool ahead = true, bool all = true);

}  // namespace joints::bench
/// @}
