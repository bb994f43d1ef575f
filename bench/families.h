// Families of scenes, drawn by seeds: what a promise is made for. Nobody has tuned a solver to any
// one of them.
#pragma once

#include "bench/named.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// A scene that a seed has drawn.
struct Drawn : BenchScene {
  double seconds = 10;        ///< how long it runs
  bool keeps_energy = true;   ///< no limit, contact or motor takes energy
  bool driven = false;        ///< motors do work: a gain of energy is no fault
  bool any_step = false;      ///< every step has another length, from 1/240 to 1/24 s
};

/// A family, and how many of its scenes a table takes.
struct Family {
  std::string name{};
  int draws = 0;
  std::function<Drawn(unsigned seed)> draw{};
};
/// All of them.
std::vector<Family> families();

/// How a scene was held.
struct Outcome {
  double gap = 0;     ///< the largest error of a row that holds a position, ever [m or rad]
  double past = 0;    ///< the furthest that a limit or a contact was passed [m or rad]
  double gain = 0;    ///< the largest gain of energy, ever [energy_scale]
  double loss = 0;    ///< the energy lost at the end [energy_scale]
  bool finite = true;
  /// No gap of 1 mm (in float 5 mm), and no gain of 10 %. \param most the gap [m]
  bool held(double most = sizeof(real) == 4 ? 5e-3 : 1e-3) const {
    return finite && gap < most && gain < 0.1;
  }
};
/// Runs a scene. \param setting a word of setting_named() \param h step [s]
Outcome run_drawn(Drawn scene, const std::string& setting, double h = 1.0 / 60);

}  // namespace joints::bench
/// @}
