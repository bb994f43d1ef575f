// A rigid body: its state, and its motion without joints.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/real.h"

/// \defgroup bodies Bodies
/// \brief State, mass and free motion of rigid bodies, and the array that holds them.
/// @{
namespace joints {

// A cache, for speed alone: while a step makes its rows, the matrices of each body are computed
// once (HeldMatrices below). A reader may skip these two.

/// The orientation of a body as matrices.
struct BodyMatrices {
  mat3 R;                ///< body space to world
  mat3 inverse_inertia;  ///< [1/(kg m^2)], world; not set if the inertia is isotropic
};
/// The matrices of one body while a step makes its rows (HeldMatrices), else null. They are never
/// copied: the copy of a body may be rotated, and they would be those of another pose.
struct MatricesOfStep {
  const BodyMatrices* now = nullptr;  ///< set by HeldMatrices only
  MatricesOfStep() = default;       ///< null
  MatricesOfStep(const MatricesOfStep&) {}  ///< null
  MatricesOfStep& operator=(const MatricesOfStep&) { return now = nullptr, *this; }  ///< null
};

/// A rigid body. Position and velocities are in world space, inertia in the body's own axes.
/// A body that no force and no joint moves (static) has both inverses exactly zero.
struct Body {
  vec3 x{0};                      ///< centre of mass [m], world
  quat q{1, 0, 0, 0};             ///< orientation, body space to world, unit length
  vec3 v{0};                      ///< velocity of the centre [m/s], world
  vec3 w{0};                      ///< angular velocity [rad/s], world
  real inverse_mass = 0;          ///< [1/kg]; 0 for a static body
  vec3 inverse_inertia_local{0};  ///< inverse principal moments [1/(kg m^2)], body space
  vec3 force{0};                  ///< external force at the centre [N], world; steps keep it
  vec3 torque{0};                 ///< external torque [N m], world; steps keep it
  /// Kinematic: a static body that steps move by v and w, which the program sets. No force and no
  /// joint changes them. A static body that is not kinematic stays where it is, even if v is not
  /// zero: a belt.
  bool kinematic = false;
  // Only steps write these four. From integrate_forces() to integrate_pose(), w of a body with
  // unequal moments is its mean angular velocity over the step, by which it will rotate: so rows
  // that are solved meanwhile hold for the rotation that it will really do (engine/rotation).
  bool w_is_mean = false;  ///< w is that mean rate
  vec3 precession{0};      ///< the mean rate minus I^-1 L, when w was last set [rad/s, world]
  vec3 mean{0};            ///< w as it was last set: another w shows an impulse [rad/s, world]
  MatricesOfStep matrices{};      ///< of q, while a step makes its rows

  /// True if no force and no joint can move this body.
  bool is_static() const { return inverse_mass == 0; }
  /// True if all three principal moments are equal: then no rotation changes the world inertia.
  bool is_isotropic() const {
    return inverse_inertia_local.x == inverse_inertia_local.y &&
           inverse_inertia_local.y == inverse_inertia_local.z;
  }
};

/// Validates it. \throws std::invalid_argument, with member and value, unless all numbers
/// are finite, q has length 1, inverse mass and moments are all zero (static) or all positive, and
/// only a static body is kinematic
void check(const Body& body);
/// Validates its inertia. \throws std::invalid_argument if a moment of inertia is larger than the
/// sum of the other two
void check_moments(const Body& body);

/// Rotates a direction or lever from body space into world space: R(q) local.
inline vec3 to_world(const Body& body, const vec3& local) {
  return body.matrices.now ? body.matrices.now->R * local : body.q * local;
}
/// Rotates a direction or lever from world space into body space.
inline vec3 to_local(const Body& body, const vec3& world) { return conjugate(body.q) * world; }
/// World position [m] of the point with lever `local` [m, body space].
inline vec3 world_point(const Body& body, const vec3& local) {
  return body.x + to_world(body, local);
}
/// Velocity [m/s] of the point of the body at lever `r` [m, world] from its centre.
inline vec3 point_velocity(const Body& body, const vec3& r) { return body.v + cross(body.w, r); }

/// R I_local^-1 R^T by matrix products [1/(kg m^2)]; inverse_inertia() calls it.
mat3 rotated_inverse_inertia(const Body& body);
/// The inverse inertia in world axes, R I_local^-1 R^T [1/(kg m^2)].
inline mat3 inverse_inertia(const Body& body) {
  if (body.is_isotropic()) return mat3(body.inverse_inertia_local.x);
  return body.matrices.now ? body.matrices.now->inverse_inertia : rotated_inverse_inertia(body);
}
/// inverse_inertia(body) * L without a copy of the matrix: the change of the angular velocity
/// caused by an angular impulse `L` [N m s, world].
inline vec3 angular_response(const Body& body, const vec3& L) {
  if (body.is_isotropic()) return body.inverse_inertia_local.x * L;
  return body.matrices.now ? body.matrices.now->inverse_inertia * L
                           : rotated_inverse_inertia(body) * L;
}

/// The angular momentum of a moving body's rotation, I w [N m s, world].
inline vec3 angular_momentum(const Body& body) {
  return body.q * (to_local(body, body.w) / body.inverse_inertia_local);
}

/// Sets w such that the angular momentum is L [N m s, world].
inline void set_angular_momentum(Body& body, const vec3& L) {
  body.w = body.q * (body.inverse_inertia_local * to_local(body, L));
}

/// A body that no force moves. \param x its centre [m] \param q its orientation (normalised here)
/// \throws std::invalid_argument unless x and q are finite and q is not zero
Body static_body(const vec3& x, const quat& q = quat(1, 0, 0, 0));
/// Validates the edges of a box. \param size three edges [m]
/// \throws std::invalid_argument unless they are positive and finite
void check_size(const vec3& size);
/// A solid box of uniform density. \param mass [kg] \param size its three edges [m]
/// \throws std::invalid_argument unless mass and edges are positive and finite, x and q finite
Body box(real mass, const vec3& size, const vec3& x, const quat& q = quat(1, 0, 0, 0));
/// A solid ball of uniform density. \param mass [kg] \param radius [m]
/// \throws std::invalid_argument unless mass and radius are positive and finite
Body ball(real mass, real radius, const vec3& x);
/// A body with the given principal moments of inertia [kg m^2].
/// \throws std::invalid_argument unless mass and moments are positive and finite
Body body_with(real mass, const vec3& inertia_local, const vec3& x,
               const quat& q = quat(1, 0, 0, 0));

/// The rotation by the vector `phi` [rad, world]: the exponential map
/// exp(phi) = (cos |phi|/2, sin(|phi|/2) phi/|phi|), accurate down to |phi| = 0.
quat rotation(const vec3& phi);

// The parts of a step. They are defined in engine/rotation/motion.cpp.

/// The first part of a step: changes the velocities by gravity, external force and torque, and sets
/// w to the mean rate. \param gravity [m/s^2] \param h step [s]
void integrate_forces(Body& body, const vec3& gravity, real h);
/// The largest component of a velocity at the end of a step [m/s or rad/s]. A diverging simulation
/// continues until its impulses overflow, which step() of engine/steps reports.
constexpr real max_speed = real(3e8);
/// Scales finite velocities down to max_speed.
void clamp_speed(Body& body);
/// The last part of a step: clamps the velocities, x += h v, and q is rotated by h w. A body with
/// unequal moments keeps its angular momentum, so its w changes. If no impulse has changed its mean
/// rate in this step, or if it is thin, rotate_freely() of engine/rotation rotates it instead. A
/// kinematic body is moved by its v and w. \param h step [s]
void integrate_pose(Body& body, real h);
/// Identifies a body until it is removed: a slot of the array, and a count by which ids of removed
/// bodies and of other arrays are detected.
struct BodyId {
  std::uint32_t slot = 0;        ///< index into the array
  std::uint32_t generation = 0;  ///< odd for a body; 0 identifies no body
  bool operator==(const BodyId&) const = default;  ///< the same slot and the same generation
};

/// All bodies of a world in one contiguous array. A new body reuses the slot of a removed one. The
/// ids of the removed body are then stale and are rejected. Ids of another array are rejected, too,
/// unless one array is a copy of the other.
class Bodies {
 public:
  Bodies() : first_generation_(new_generation()) {}
  /// Adds a body. If the length of q is 1 within 5e-4, q is normalised.
  /// \throws std::invalid_argument as check() and check_moments()
  BodyId add(const Body& body);
  void remove(BodyId id);        ///< Removes a body. \throws std::invalid_argument for a stale id
  /// True if this id identifies a body of this array.
  bool alive(BodyId id) const {
    return id.slot < generation_.size() && generation_[id.slot] == id.generation &&
           id.generation % 2 == 1;
  }
  /// The slot of a body. \throws std::invalid_argument for a stale id
  int index(BodyId id) const {
    require(alive(id), "body: this id names no body of this world (removed, or of another one)");
    return int(id.slot);
  }

  /// The body with this id. \throws std::invalid_argument for a stale id
  Body& operator[](BodyId id) { return bodies_[index(id)]; }
  /// The same, read-only.
  const Body& operator[](BodyId id) const { return bodies_[index(id)]; }

  int slots() const { return int(bodies_.size()); }  ///< length of the array, empty slots included
  /// The id of the body in a slot. For an empty slot it is an id that is rejected.
  BodyId id(int slot) const { return {std::uint32_t(slot), generation_[std::size_t(slot)]}; }
  bool used(int slot) const { return generation_[slot] % 2 == 1; }  ///< true if not empty
  Body& at(int slot) { return bodies_[slot]; }       ///< by slot; an empty slot is a static body
  const Body& at(int slot) const { return bodies_[slot]; }  ///< the same, read-only
  Body* data() { return bodies_.data(); }  ///< the array itself, for solvers
  const Body* data() const { return bodies_.data(); }  ///< the same, read-only
  auto begin() { return bodies_.begin(); }  ///< the first slot: all slots in order, empty ones too
  auto begin() const { return bodies_.begin(); }  ///< the same, read-only
  auto end() { return bodies_.end(); }            ///< behind the last slot
  auto end() const { return bodies_.end(); }      ///< the same, read-only
  int size() const { return slots() - int(free_.size()); }  ///< number of bodies

 private:
  friend class HeldMatrices;
  static std::uint32_t new_generation();
  std::uint32_t first_generation_;
  std::vector<Body> bodies_;
  std::vector<std::uint32_t> generation_;  // odd while the slot holds a body
  std::vector<std::uint32_t> free_;
  std::vector<BodyMatrices> matrices_;  // those in use, one after the other
};

/// Computes the matrices of all bodies once, for all calls of to_world() and inverse_inertia()
/// while it exists. During that time no body may be rotated, added or removed.
class HeldMatrices {
 public:
  /// For the present poses. \param of for each slot: the matrices of these bodies and of static
  /// ones; null: of all
  explicit HeldMatrices(Bodies& bodies, const std::vector<bool>* of = nullptr);
  ~HeldMatrices();                        ///< Ends their use.
  HeldMatrices(const HeldMatrices&) = delete;  ///< not copied

 private:
  Bodies& bodies_;
};

/// integrate_forces() for all bodies.
inline void integrate_forces(Bodies& bodies, const vec3& gravity, real h) {
  for (Body& body : bodies) integrate_forces(body, gravity, h);
}
/// Sets w to a new mean rate where impulses have changed it by more than a tenth and the body
/// rotates by more than 0.3 rad in a step. \param h step [s] \return true if a w has changed
bool renew_mean_rates(Bodies& bodies, real h);
/// integrate_pose() for all bodies.
inline void integrate_poses(Bodies& bodies, real h) {
  for (Body& body : bodies) integrate_pose(body, h);
}

}  // namespace joints
/// @}
