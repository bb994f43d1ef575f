// Where the bodies of a run were, step by step, and a reference of their motion.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "engine/world.h"

/// \addtogroup compare
/// @{
namespace joints {

/// The centres of mass of all slots of a world [m]; an empty slot is at the origin.
using Centres = std::vector<vec3>;
/// Where the bodies of a world are.
Centres centres_of(const World& world);

/// A run.
struct Track {
  std::vector<Centres> frames{};  ///< at the start and at the end of every step
  double us = 0;                 ///< processor time of all steps [us]
};
/// How far any body of one track is from that of another in their first frames, at most [m].
double apart(const Track& one, const Track& other, std::size_t frames);

/// Two runs of a scene with short steps, the better one last.
struct Reference {
  Track before{};          ///< the last but one
  Track track{};           ///< the last
  std::size_t frames = 0;  ///< of these at the beginning they agree
  bool hurried = false;    ///< there was no time for better ones
};
/// Makes runs, each better than the one before, until two agree in all frames or it has lasted too
/// long. \param run the n-th of them, or nothing if there is none \param frames of a whole run
/// \param most how far bodies may be apart where two runs agree [m] \param patience processor time
/// [s]
Reference refine(const std::function<std::optional<Track>(int n)>& run, std::size_t frames,
                 double most, double patience);

}  // namespace joints
/// @}
