// The inertia that is added to the links of taut chains.
#pragma once

#include "direct/joint_islands.h"
#include "direct/solver_memory.h"

/// \addtogroup chapter9
/// @{
namespace joints {

/// The inertia that is added to bodies for one step, so that it can follow their zigzag (Eq. 9-13).
/// Forces of joints in closed loops with at most one degree of freedom add none, nor do those of an
/// island with one moving body: a small top would lose its energy.
class AddedInertia {
 public:
  /// Begins a step without added inertia. \param kappa of Eq. 9-14; 0: none will be added
  /// \param h step [s]
  void begin(int slots, real kappa, real h);
  bool used() const { return kappa_ > 0; }  ///< some may be added in this step
  /// Finds the loops of an island with at most one degree of freedom: their links cannot zigzag. It
  /// overwrites the factor.
  void find_tight_loops(Island& island) const;
  /// Adds what the forces of the last step require.
  void add(const Bodies& bodies, const Blocks& blocks, JointIslands& islands,
           SolverMemory& memory);
  /// Finds what the present impulses require.
  void find_next(const Bodies& bodies, const Blocks& blocks, JointIslands& islands);
  /// True if the present impulses require more than twice the inertia of a body. This happens after
  /// a blow and in the first step, which has no earlier forces.
  bool jumped(const Body& body, int slot) const;
  /// Adds to a body what its present impulses require.
  void add_next(const Body& body, int slot, const SolverMemory& memory);
  /// Stores the least moments that the step could follow.
  void remember(SolverMemory& memory) const;

  /// Sets the masses of an island's bodies.
  void set_masses(Island& island, const Bodies& bodies) const;
  /// Sets the inertia of all bodies.
  void set_inertia(Bodies& bodies) const;
  /// Sets the angular velocity of a body to what Eq. 9-14 leaves.
  void set_velocity(Body& body, int slot) const {
    if (adds(slot)) body.w = now_[slot].slowed.w;
  }

  /// True if nothing holds an island.
  static bool is_free(const Island& island);
  static bool is_lone(const Island& island);  ///< at most one of its bodies moves
  /// Gives an island that nothing holds the angular momentum that it had before the impulses, by a
  /// rotation of the whole: no joint in it opens. The others are left as they are.
  /// \param before the bodies, with the poses and velocities of that time
  void keep_momentum(const Island& island, const std::vector<Body>& before, Bodies& bodies) const;

 private:
  struct Pulled {          // a body
    vec3 force_lever{0};  // the sum over its joints, about each of its axes [N m]
    Slowed slowed{};       // the body with added inertia
  };
  bool adds(int slot) const { return used() && now_[slot].force_lever != vec3(0); }
  void find(real acted, const Bodies& bodies, const Blocks& blocks, JointIslands& islands,
            std::vector<Pulled>& of);
  void slow_down(const Body& body, int slot, const SolverMemory& memory);

  std::vector<Pulled> now_, next_;  // of each slot: of the step, and as its impulses require
  real kappa_ = 0, h_ = 0;
};

}  // namespace joints
/// @}
