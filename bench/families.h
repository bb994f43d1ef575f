// Families of scenes, drawn by seeds: the promises of the texts are made for these. No solver was
// tuned to a single one of them.
#pragma once

#include <cmath>

#include "bench/named.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// A scene that a seed has drawn.
struct Drawn : BenchScene {
  double seconds = 10;        ///< duration of the run [s]
  bool keeps_energy = true;   ///< no limit, contact or motor removes energy
  bool driven = false;        ///< motors do work: a gain of energy is not an error
  bool any_step = false;      ///< every step has another length, from 1/240 to 1/24 s
  /// The velocities belong to times in the middle of the steps, also without leapfrog: they are
  /// averaged for the energy.
  bool between_steps = false;
  double most_gain = 0.1;     ///< of energy in a run that is held [energy_scale]
  /// Divisor of the change of the angular momentum [kg m^2/s]; 0: forces act from outside.
  double momentum_scale = 0;
  std::function<void(World&, real h)> control{};  ///< moves bodies before each step, if any does
  std::function<double(const World&)> miss{};     ///< an error that no row tells [m], if any
};

/// A family, and the number of its scenes in a table.
struct Family {
  std::string name{};
  int draws = 0;
  std::function<Drawn(unsigned seed)> draw{};
};
std::vector<Family> joint_families();    ///< without contacts
std::vector<Family> motion_families();   ///< what spins, is carried, folds or is held in place
std::vector<Family> contact_families();  ///< with contacts
std::vector<Family> families();          ///< all of them

/// The errors of a scene in a run.
struct Outcome {
  double gap = 0;     ///< largest error of a position row in the run [m or rad], or Drawn::miss
  double past = 0;    ///< largest violation of a limit or a contact [m or rad]
  double gain = 0;    ///< largest gain of energy in the run [energy_scale]
  double loss = 0;    ///< the energy lost at the end [energy_scale]
  double momentum = 0;  ///< largest change of the angular momentum [momentum_scale]
  bool finite = true;
  double most_gain = 0.1;  ///< Drawn::most_gain
  /// True if the gap is below 1 mm (in float 5 mm) and the gain below most_gain.
  /// \param most bound of the gap [m]
  bool held(double most = sizeof(real) == 4 ? 5e-3 : 1e-3) const {
    return finite && gap < most && gain < most_gain;
  }
  /// Its energy at the end is within 5 % of energy_scale of its value at the start.
  bool kept() const { return finite && std::abs(loss) <= 0.05; }
};
/// Runs a scene. \param setting a name for setting_named() \param h step [s]
Outcome run_drawn(Drawn scene, const std::string& setting, double h = 1.0 / 60);
/// Runs a scene in steps of one's own. \param leapfrog its velocities belong to the middle of them
Outcome run_drawn(Drawn scene, const Step& step, bool leapfrog, double h = 1.0 / 60);

}  // namespace joints::bench
/// @}
