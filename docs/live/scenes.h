// The scenes of the live page: those of the chapters' programs and of the benchmark, each with the
// settings that the page may change.
#pragma once

#include <functional>
#include <memory>

#include "engine/instruments/scene.h"

/// \defgroup live Live page
/// \brief The engine, the solutions and the scenes in a page.
/// @{
namespace joints::live {

/// What the page sets, as numbers; the names are those of the address.
struct PageSettings {
  double beta = 0;        ///< of all joints [1]
  double iterations = 0;  ///< a step
  double h = 0;           ///< the step [s]
  double substeps = 1;    ///< of each step
  double warm = 0;        ///< 1: begin with the impulses of the last step
  double projections = 0;  ///< iterations of position projection after a step
  double relaxation = 1;  ///< over-relaxation [1]
  double frequency = 0;   ///< of the soft rows [Hz]; 0: hard
  double damping = 1;     ///< of the soft rows [1]
  double direct = 0;      ///< 1: the direct solver
  double newton = 0;      ///< iterations of the direct solver on the positions, at most
  double added_inertia = 0;   ///< more inertia, for the direct solver (Eq. 9-14)
  double leapfrog = 0;    ///< 1: second order in time (Eq. 9-9)
  double ratio = 1;       ///< the mass of the scene's heavy body by its own [1]; only for a new run
  double tilt = 0;        ///< of gravity from straight down, towards +x [degrees]
  double speed = 0;       ///< of the motors [rad/s or m/s]
  double strength = 0;    ///< of the motors [N m or N]
  double own = 0;         ///< 1: the loop of the chapter's exercises in place of the engine's step
};
/// The names of its members, in their order.
inline constexpr const char* setting_names[] = {
    "beta", "iterations", "h", "substeps", "warm", "projections", "relaxation", "frequency",
    "damping", "direct", "newton", "added_inertia", "leapfrog", "ratio", "tilt", "speed",
    "strength", "own"};
static_assert(sizeof(PageSettings) == sizeof(setting_names) / sizeof(char*) * sizeof(double));

/// A scene that runs, and the parts of it that can be changed meanwhile.
struct LiveScene {
  std::shared_ptr<void> holder;  ///< owns the scene
  Scene* scene = nullptr;        ///< with the settings that it begins with
  real beta = real(0.2);         ///< that it begins with [1]
  int heavy = 0;                 ///< slot of the body whose mass can be changed
  real ratio = 1;                ///< that its mass is multiplied by at the beginning [1]
  real added_inertia = 0;  ///< more inertia, should the direct solver be chosen (Eq. 9-14)
  std::function<void(real speed, real strength)> drive{};  ///< sets the motors; empty: it has none
  real speed = 0, strength = 0;  ///< of the motors at the beginning [rad/s, N m; m/s, N]
  std::function<void(double time)> before{};  ///< called before each step with its time [s]
  /// A step by the loop of the chapter's exercises, on the bodies of the world; empty: it has none.
  std::function<void(Bodies&, const PageSettings&, const vec3& gravity)> own{};
};

/// How a scene is called, and how it is made.
struct Entry {
  const char* name;                ///< in the address
  const char* title;               ///< on the page
  std::vector<std::string> opens;  ///< the pages of these chapters and exercises begin with it
  LiveScene (*make)();             ///< a fresh one
  const char* watch;               ///< what to look at, a sentence
};
/// All scenes, in the order of the page.
const std::vector<Entry>& entries();

}  // namespace joints::live
/// @}
