// One tree of links: its recursion, its steps, its momentum. Given, there is nothing to edit here.
#pragma once

#include <vector>

#include "engine/kept/reaction.h"
#include "engine/world.h"
#include "reduced/drives.h"

/// \addtogroup reduced
/// @{
namespace joints {

/// A coordinate of a joint, whatever its kind.
struct CoordinateSource {
  const void* free = nullptr;  ///< the FreeCoordinate
  const Joint* joint = nullptr;  ///< to which it belongs
  std::size_t number = 0;        ///< of that joint, for messages
  real (*position)(const void*, const Bodies&) = nullptr;  ///< its value [rad or m]
  bool (*read)(const void*, DriveSettings&) = nullptr;     ///< false if nothing acts on it
  /// Tells it its value and the impulses of Drive at the end of a step.
  void (*tell)(const void*, real, const std::array<real, 4>&) = nullptr;
};

/// The coordinates of a link and their rates; also their derivative.
template <class Link>
struct StateOf {
  typename Link::real x{0};         ///< [rad or m]
  typename Link::real rate{0};      ///< [rad/s or m/s]
  typename Link::vec3 centre{0};    ///< [m]
  typename Link::vec3 v{0};         ///< of the centre [m/s]
  typename Link::vec3 w{0};         ///< [rad/s]
  typename Link::quat q{0, 0, 0, 0};  ///< orientation
};

/// A root and all links that depend on it, parents before their children.
class Tree {
 public:
  std::vector<TreeLink> links;  ///< the root first
  std::vector<CoordinateSource> sources;  ///< of each link; a root has none

  /// Reads poses and velocities of the bodies; those of the velocities that the joints do not
  /// permit are removed as impulses of the joints would. \param most_gap see Reduced
  /// \throws std::invalid_argument for poses that do not satisfy a joint
  void read(const Bodies& bodies, real most_gap);
  /// True if the bodies are as write() has left them. \param changed set if a mass has changed
  bool unchanged(const Bodies& bodies, bool& changed) const;
  /// Reads the external forces, and what acts on the coordinates. \return true if anything does
  bool read_forces(const Bodies& bodies, const vec3& gravity);
  /// True if springs without a bound are all that acts on the coordinates.
  bool only_springs() const;
  /// Writes poses and velocities to the bodies. \throws std::overflow_error unless they are finite
  void write(Bodies& bodies) const;
  /// Tells the joints what has acted on their coordinates. \param h step [s]
  void tell_joints(real h) const;

  /// The symmetric step of second order: half a kick, a drift, half a kick. The force at a pose
  /// depends on the velocities, so the first half kick is implicit. \param h [s]
  /// \param iterations of the first half kick, at least
  /// \return false if the forces change too much within the step; the state is then undefined
  bool leapfrog(real h, int iterations);
  /// The largest fraction by which a step has changed the energy, except by forces and drives, of
  /// the kinetic energy; at least of the one that a fall within a step brings [1].
  double changed() const { return changed_; }
  int wrong() const { return wrong_; }  ///< drives on the wrong side of a bound in a step
  /// Sums of impulses begin anew, and so do changed() and wrong().
  void begin_impulses() {
    changed_ = wrong_ = 0;
    for (Drive& drive : drives_) drive.impulse = {};
  }
  /// The Runge-Kutta method of order 4. No drives but springs without a bound. \param h [s]
  void runge_kutta(real h);
  /// True if no drive, no external force but weight and no motion of the root acts on the tree: a
  /// Runge-Kutta step may be done elsewhere, between the next two functions.
  bool plain() const;
  void begin_step(real h);       ///< notes momentum and energy \param h [s]
  void end_runge_kutta(real h);  ///< all that follows from the coordinates and rates \param h [s]
  /// Computes the accelerations at the present state; drives are off, but for springs.
  void find_accelerations();
  /// The forces that hold a link, at the present state and with what its coordinates do now: on
  /// the link, about A, from the motion of the subtree by Newton and Euler.
  Reaction reaction(std::size_t link);

 private:
  struct Momentum {
    real mass = 0;
    vec3 centre{0}, linear{0}, angular{0}, torque{0};  // the latter two about the centre
    mat3 inertia{0};
  };
  struct Energy {  // [J]
    double kinetic = 0, total = 0, fall = 0;
  };
  struct Masses {
    real inverse_mass = 0;
    vec3 inverse_inertia{0};
  };
  struct Change {  // of angular, then of linear velocities
    std::array<real, 2> moved{}, size{}, top{};
  };
  bool is_free() const { return links[0].freedom == Freedom::free; }
  void place_all();
  void locate_all();
  void recursion(bool inertia, bool moving = true);
  bool half_kick(real h, bool first, int iterations, Change& change);
  Change end_kick(real half);
  bool correct_places(real half, int pass, bool& inertia);
  void end_step(real h, bool angular);
  void set_explicit_springs();
  Momentum momentum() const;
  void keep_momentum(const Momentum& before, real h, bool angular);
  Energy energy(real h) const;
  void add_work(real time);
  void compare_energy(const Energy& before, real h);

  std::vector<Drive> drives_;
  std::vector<StateOf<TreeLink>> base_, sum_;  // at the beginning of a step; weighted slopes
  std::vector<Masses> masses_;
  std::vector<real> base_rates_;
  std::vector<vec3> base_w_;
  vec3 base_v_{0};
  int fewest_wrong_ = 0, passes_without_gain_ = 0, wrong_ = 0;
  Momentum momentum_before_;
  Energy energy_before_;
  double work_ = 0, changed_ = 0;
  real gravity_ = 0;      // its magnitude [m/s^2]
  bool forced_ = false;   // a body has an external force or torque
  bool fresh_ = true;     // accelerations of the last half kick are not those of this pose
};

}  // namespace joints
/// @}
