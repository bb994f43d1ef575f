// A scene that a chapter's program runs, watches and records. The engine does not include it.
#pragma once

#include "engine/instruments/record.h"
#include "engine/sequential_impulses.h"
#include "engine/step.h"
#include "engine/instruments/summary.h"

/// \addtogroup measuring
/// @{
namespace joints {

/// A world with its solver, what it is measured by and how it looks.
struct Scene {
  std::string name;               ///< for the plan, the summary and the recording
  World world{};                  ///< bodies and joints
  SequentialImpulses solver{};    ///< with its settings
  Stepping stepping{};            ///< how a step advances
  std::vector<Mark> marks{};      ///< one a joint: what should stay together
  std::vector<Shape> shapes{};    ///< one a body, in their order
  std::vector<Segment> segments{};  ///< lines of the recording, beside those of the marks
  std::function<void(GapMeter&)> gaps{};  ///< in place of the marks': adds every gap as it is
  double energy_scale = 1;        ///< what the change of the energy is divided by [J]
  real h = real(1) / 60;          ///< the step [s]

  /// Adds a box of uniform density. \param mass [kg], 0 for a static one \param size edges [m]
  BodyId box(real mass, const vec3& size, const vec3& x, const quat& q = quat(1, 0, 0, 0));
  /// Adds a ball of uniform density. \param mass [kg] \param radius [m]
  BodyId ball(real mass, real radius, const vec3& x);
  /// Remembers a place and a direction of the world that a joint holds together.
  /// \param axis zero where there is none
  void mark(BodyId id1, BodyId id2, const vec3& anchor, const vec3& axis = vec3(0));
  /// One step.
  void step() { joints::step(world, solver, h, stepping); }
  /// Prints what the first step has to do in one line.
  void print_plan();
};

/// What the programs of scenes can be told on the command line.
struct Settings {
  int iterations = 30;      ///< iterations a step
  real beta = real(0.2);    ///< share of the error fed back in a step [1]
  bool whole = true;        ///< whole joints, not a block for each part
  double seconds = 0;       ///< how long to run [s]
  std::string out;          ///< folder of tables and recordings
};
/// Reads them. \param program what `--help` says first \param seconds default of `--seconds`
/// \param what_runs what `--help` says of the seconds \return false when --help was asked for
/// \throws std::invalid_argument for options without sense
bool read(Settings& settings, const std::string& program, const std::string& seconds,
          const std::string& what_runs, int argc, const char* const* argv);

/// A scene as an experiment: its step, the gaps of its marks, its energy.
Experiment experiment_of(Scene& scene, int steps);
/// Draws the lines of some marks, from the centre of each body to its anchor.
/// \param first number of the body that slot 0 of the marks is in the recording
void draw(Motion& motion, const std::vector<Mark>& marks, int first = 0);

/// Runs a scene and measures it. \param look called with the time [s] before the first step and
/// after each one \param motion_path where the recording goes; "" for none
/// \param step in place of the scene's own
Summary play(Scene& scene, const std::string& setting, double seconds,
             const std::string& motion_path = "",
             const std::function<void(double)>& look = [](double) {},
             const std::function<void()>& step = {});

}  // namespace joints
/// @}
