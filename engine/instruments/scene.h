// A scene that a chapter's program runs, measures and records. The engine does not include this
// file.
#pragma once

#include "engine/instruments/record.h"
#include "engine/sequential_impulses.h"
#include "engine/steps/step.h"
#include "engine/instruments/run.h"

/// \addtogroup measuring
/// @{
namespace joints {

/// A world with its solver, its measurements and its appearance.
struct Scene {
  std::string name;               ///< for the plan, the summary and the recording
  World world{};                  ///< bodies and joints
  SequentialImpulses solver{};    ///< with its settings
  StepOptions stepping{};            ///< how a step advances
  std::vector<Mark> marks{};      ///< one per joint: points and axes that it should keep together
  std::vector<Shape> shapes{};    ///< one per body, in their order
  std::vector<Segment> segments{};  ///< lines of the recording, beside those of the marks
  std::function<void(GapMeter&)> gaps{};  ///< replaces the marks: adds every present gap
  double energy_scale = 1;        ///< divisor of the change of the energy [J]
  real h = real(1) / 60;          ///< the step [s]

  /// Adds a box of uniform density. \param mass [kg], 0 for a static one \param size edges [m]
  BodyId box(real mass, const vec3& size, const vec3& x, const quat& q = quat(1, 0, 0, 0));
  /// Adds a ball of uniform density. \param mass [kg] \param radius [m]
  BodyId ball(real mass, real radius, const vec3& x);
  /// Adds a mark at a point and a direction of the world that a joint should keep together.
  /// \param axis zero: no axis
  void mark(BodyId id1, BodyId id2, const vec3& anchor, const vec3& axis = vec3(0));
  /// One step.
  void step() { joints::step(world, solver, h, stepping); }
  /// Prints the plan of the first step in one line.
  void print_plan();
};

/// The command-line options of the programs of scenes.
struct Settings {
  int iterations = 30;      ///< iterations per step
  real beta = real(0.2);    ///< fraction of the error fed back per step [1]
  bool whole = true;        ///< one block per joint; false: one block per part
  double seconds = 0;       ///< duration of the run [s]
  std::string out;          ///< folder of tables and recordings
};
/// Reads them. \param program first line of `--help` \param seconds default of `--seconds`
/// \param what_runs description of `--seconds` in `--help` \return false if --help was given
/// \throws std::invalid_argument for invalid options
bool read(Settings& settings, const std::string& program, const std::string& seconds,
          const std::string& what_runs, int argc, const char* const* argv);

/// A scene as an experiment: its step, the gaps of its marks, its energy.
Experiment experiment_of(Scene& scene, int steps);
/// Draws the lines of some marks, from the centre of each body to its anchor.
/// \param first index in the recording of the body in slot 0 of the marks
void draw(Motion& motion, const std::vector<Mark>& marks, int first = 0);

/// Runs a scene and measures it. \param look called with the time [s] before the first step and
/// after each one \param motion_path file of the recording; "" for none
/// \param step replaces the step of the scene
Summary play(Scene& scene, const std::string& setting, double seconds,
             const std::string& motion_path = "",
             const std::function<void(double)>& look = [](double) {},
             const std::function<void()>& step = {});

}  // namespace joints
/// @}
