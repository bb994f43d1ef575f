// Trees of joints in reduced coordinates. Given, there is nothing to edit here.
#pragma once

#include <array>
#include <string>
#include <utility>

#include "reduced/pack.h"

/// \addtogroup reduced
/// @{
namespace joints {

class SixDofJoint;

/// Moves a world whose joints form trees, with one number per degree of freedom instead of rows: a
/// hinge has an angle, a slider a displacement, a ball joint an orientation. So no joint can ever
/// open, and a step takes time in proportion to the number of bodies.
///
///     Reduced tree(world);
///     tree.step(world, h);
///
/// It accepts hinges, sliders, ball and fixed joints, universal joints, and joints with six degrees
/// of freedom as far as each of them is free or locked; with motors, servos, friction, limits and
/// springs on the coordinates of hinges and sliders. Each tree hangs on a static or kinematic body,
/// or floats freely. Loops, soft joints and all other joints are rejected: use DirectSolver for
/// them. Bodies, joints and settings may be changed between steps, and drives and limits tell
/// their positions and forces as with rows: a program changes one line. By Runge-Kutta springs tell
/// none.
///
/// It never allocates in a step after the first, unless the program has added, removed or moved a
/// body or a joint, or a step is divided.
/// Sources: Featherstone, "Rigid Body Dynamics Algorithms", 2008, chapters 7 and 9.
class Reduced {
 public:
  /// How time advances. Runge-Kutta steps of trees of equal shape are done together, on SIMD lanes.
  enum class Method : char {
    leapfrog,    ///< second order and symmetric: the energy does not drift
    runge_kutta  ///< order 4; rejects motors, servos, friction, limits and bounded springs
  };
  Method method = Method::leapfrog;  ///< how time advances
  /// Least number of iterations for the velocity-dependent forces of a step by leapfrog, from 1 to
  /// 50. Each one makes their error smaller by about h times the angular velocity. A step does more
  /// of them while they still change its accelerations by a hundredth: with spinning tops.
  int iterations = 2;

  /// Recognises the trees of a world. \param most_gap greatest error of a joint in the present
  /// poses: of its angles [rad], and of its anchors as a fraction of their levers [1]. The first
  /// step removes it.
  /// \throws std::invalid_argument naming the joint, if it closes a loop, if it is of another kind,
  /// or if its error is larger
  explicit Reduced(const World& world, real most_gap = real(1e-3));

  /// Advances the world by one step. \param h [s] \throws std::invalid_argument as the constructor,
  /// or for an h that is not positive and finite; nothing has changed then
  /// A tree whose forces change too much within the step, as those of a top on a ball joint whose
  /// nutation takes less than about three steps, does it in up to 64 parts.
  /// \throws std::runtime_error if that does not suffice; nothing has moved then
  /// \throws std::overflow_error if a number of a body has overflowed
  void step(World& world, real h);

  /// What the last step could not hold.
  struct Report {
    /// Largest fraction by which the energy of a tree has changed, except by forces and drives, of
    /// its kinetic energy, or of the one that a fall within the step brings if that is more [1].
    double changed = 0;
    int wrong = 0;  ///< drives of a tree on the wrong side of a bound at the end, the most of any
    std::vector<std::string> sentences() const;  ///< and what to do about it; none if it was held
  };
  Report report() const;  ///< of the last step, over all trees

  /// Writes the poses and velocities with which the next step begins: they satisfy the joints. The
  /// velocities are changed as impulses of the joints would.
  /// \throws std::invalid_argument as step()
  void satisfy(World& world);

  /// The number of degrees of freedom of all trees.
  int degrees_of_freedom() const;
  /// The number of trees; a body without joints is one, too.
  int trees() const { return int(trees_.size()); }
  /// The acceleration of a body.
  struct Acceleration {
    vec3 v{0};  ///< of its centre [m/s^2]
    vec3 w{0};  ///< angular [rad/s^2]
  };
  /// The accelerations of all bodies, by slot, at their present poses and velocities. Only springs
  /// act on the coordinates. \throws std::invalid_argument as step()
  std::vector<Acceleration> accelerations(const World& world);

  /// The force on body 2 of a joint and the torque on it about its anchor, at the end of the last
  /// step: of all that the joint does, rigid parts, drives and springs.
  /// \throws std::invalid_argument for a joint between static bodies or of another world
  Reaction load(const Joint& joint);

 private:
  struct Place {
    std::size_t tree, first, last;  // of the links of a joint
  };
  Place find(const Joint& joint) const;
  static constexpr int most_parts = 64;
  void leapfrog(Tree& tree, const World& world, real h);
  void build(const World& world);
  void refresh(const World& world);
  std::vector<Tree> trees_;
  std::vector<Pack> packs_;
  std::vector<std::pair<const SixDofJoint*, std::array<Range, 6>>> locks_;  // which may change
  real most_gap_ = 0;
  std::size_t joint_count_ = 0;
  std::uint64_t last_joint_ = 0;
  int bodies_ = 0;  // used slots
};

}  // namespace joints
/// @}
