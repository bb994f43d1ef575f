// The scenes of the live page: those of the chapters' programs and of the benchmark, each with what
// the page may change.
#pragma once

#include <functional>
#include <memory>

#include "engine/instruments/scene.h"

/// \defgroup live Live page
/// \brief The engine, the solutions and the scenes in a page.
/// @{
namespace joints::live {

/// A scene that runs, and what of it can be changed while it does.
struct LiveScene {
  std::shared_ptr<void> holder;  ///< owns the scene
  Scene* scene = nullptr;        ///< with the settings that it begins with
  real beta = real(0.2);         ///< that it begins with [1]
  int heavy = 0;                 ///< slot of the body whose mass can be changed
  real ratio = 1;                ///< that its mass is multiplied by at the beginning [1]
  real stiffness = 0;            ///< more inertia for the direct solver, where it needs it (Eq. 9-14)
  std::function<void(real speed, real strength)> drive{};  ///< sets the motors; empty: it has none
  real speed = 0, strength = 0;  ///< of the motors at the beginning [rad/s, N m; m/s, N]
  std::function<void(double time)> before{};  ///< called before each step with its time [s]
};

/// How a scene is called, and how it is made.
struct Entry {
  const char* name;     ///< in the address
  const char* title;    ///< on the page
  int chapter;          ///< whose exercises it is made of
  const char* watch;    ///< what to look at, a sentence
  LiveScene (*make)();  ///< a fresh one
};
/// All scenes, in the order of the page.
const std::vector<Entry>& entries();

}  // namespace joints::live
/// @}
