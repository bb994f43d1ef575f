// Where the bodies of a scene move: a reference on two roads, and how far a method is from it.
#pragma once

#include "bench/runner.h"
#include "comparison/track.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// What is known of a scene's motion, without any method that is to be measured.
struct KnownMotion {
  Reference reference{};    ///< by reduced coordinates, Runge-Kutta on rows, else the direct solver
  std::string roads{};      ///< which of them, the best one last
  double until = 0;         ///< two references agree to a tenth of a millimetre [s]
  double agree_first = 0;   ///< how far they are apart in the first second, at most [m]
  double agree = 0;         ///< and until then [m]
  double grown = 0;         ///< distance of two runs at the end if gravity differs by 1e-9 [m]
  bool lost = false;        ///< the last of them gave up on the way
  /// "followed" to its end; else "chaotic", if 1e-9 of the gravity grows to a tenth of a
  /// millimetre; else "given up"; else "hurried", for want of patience; else "impacts": no chaos,
  /// but steps that are no shorter find another motion.
  std::string kind(double seconds) const;
};
/// Two references of a scene. \param patience processor time [s]
KnownMotion motion_of(const MakeScene& make_scene, const Span& span, double patience);

/// How far a method is from the reference of a scene, and what it finds.
struct Astray {
  double first = 0;   ///< greatest distance of a body in the first second [m]
  double all = 0;     ///< as long as there is a reference [m]
  double found = std::numeric_limits<double>::quiet_NaN();  ///< BenchScene::finding
  double range = std::numeric_limits<double>::quiet_NaN();  ///< half of what 1e-9 of gravity moves
  bool refused = false;  ///< the method does not accept the scene
};
/// Runs a method with the start that all have in common (start.h). \param uncertain also with
/// slightly different gravity, for the range of what is found
Astray astray(const MakeScene& make_scene, const Setting& setting, const Span& span,
              const KnownMotion& motion, bool uncertain);

}  // namespace joints::bench
/// @}
