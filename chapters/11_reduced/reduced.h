// Chapter 11: reduced coordinates. A link of a tree, and the functions that reduced.cpp has to
// define. Read README.md in this folder first. Given: there is nothing to edit here.
#pragma once

#include "engine/body.h"

/// \defgroup chapter11 Chapter 11: reduced coordinates
/// \brief The articulated-body algorithm as functions of one link and its parent.
/// @{
namespace joints {

/// How a link moves relative to its parent.
enum class Freedom : char {
  fixed,   ///< the root of a tree: a static or kinematic body
  free,    ///< the root of a tree: six degrees of freedom
  weld,    ///< not at all
  hinge,   ///< rotation about an axis of the parent
  slider,  ///< displacement along an axis of the parent
  ball     ///< rotation about a point of the parent
};

/// A body and the joint that connects it to its parent. All vectors and matrices are in world axes
/// unless their names end in `_local`. A 6-vector is a pair: angular part, then linear part at the
/// anchor A, the point of the link that its joint holds. (For a root, A is its centre.) Then S, the
/// motion per unit of the coordinate's rate, is (a, 0) for a hinge, (0, a) for a slider and (E, 0)
/// for a ball joint, and quantities only have to be translated to the parent's anchor, by d.
template <class Number>
struct TreeLinkOf {
  using real = Number;                  ///< one number; on lanes, one of each of several trees
  using vec3 = glm::vec<3, Number>;     ///< three of them
  using mat3 = glm::mat<3, 3, Number>;  ///< nine
  using quat = glm::qua<Number>;        ///< four
  Freedom freedom = Freedom::weld;  ///< relative to the parent
  bool held = false;   ///< `acceleration` of the joint is known instead of its force `tau`
  bool rotates_inertia = false;  ///< false if all principal moments are equal
  int parent = -1;     ///< index of a link that precedes this one; -1 for a root
  int slot = -1;       ///< of the body; -1 for a massless link inside a joint
  vec3 axis_local{0};  ///< unit, in the parent's space
  vec3 from_parent_local{0};  ///< from the parent's A to the joint at coordinate 0 [m, its space]
  vec3 centre_local{0};       ///< from A to the centre of mass [m, own space]
  quat start{1, 0, 0, 0};     ///< orientation in the parent at coordinate 0
  quat start_axis{0, 0, 0, 0};  ///< axis_local times `start`, for a hinge
  real mass = 0;       ///< [kg]
  vec3 inertia_local{0};  ///< principal moments [kg m^2]

  real x = 0;          ///< the coordinate [rad or m]
  real rate = 0;       ///< its rate [rad/s or m/s]
  vec3 centre{0};      ///< the centre of mass [m]; of a free root this is a coordinate
  quat q{1, 0, 0, 0};  ///< orientation; of a ball joint or a free root this is a coordinate
  vec3 w{0};           ///< angular velocity [rad/s]; of those two a velocity of the coordinates
  vec3 v{0};           ///< velocity of the centre [m/s]; the same of a free root

  mat3 R{1};           ///< of q
  vec3 a{0};           ///< the axis
  vec3 c{0};           ///< from A to the centre [m]
  vec3 d{0};           ///< from the parent's A to A [m]
  mat3 inertia{0};     ///< about the centre [kg m^2]
  vec3 force{0};       ///< external force at the centre, with the weight [N]
  vec3 torque{0};      ///< external torque [N m]

  // The inertia of the subtree at A, [J H; H^T M]; after eliminate(), as far as the parent feels it
  // through the joint. For a ball joint, which passes on only M: J^-1 and J^-1 H.
  mat3 J{0};           ///< [kg m^2]
  mat3 H{0};           ///< [kg m]
  mat3 M{0};           ///< [kg]
  vec3 n{0};           ///< bias torque of the subtree at A [N m]
  vec3 f{0};           ///< bias force of the subtree [N]
  vec3 zeta{0};        ///< angular acceleration from velocities alone [rad/s^2]
  vec3 gamma{0};       ///< acceleration of A from velocities alone [m/s^2]
  vec3 Uw{0};          ///< [J H; H^T M] S, the torque [kg m^2 or kg m]
  vec3 Uv{0};          ///< the same, the force [kg m or kg]
  real D = 0;          ///< S^T U, inertia along the coordinate [kg m^2 or kg]
  real over_D = 0;     ///< 1 / (D + added) or 0 for a subtree without mass
  real added = 0;      ///< inertia added along the coordinate, by implicit springs [like D]
  real tau = 0;        ///< force of the joint along its coordinate [N m or N]; a guess if held
  real k = 0;          ///< tau - S^T (n, f) [N m or N]
  real acceleration = 0;  ///< of the coordinate [rad/s^2 or m/s^2]
  vec3 alpha{0};       ///< angular acceleration of the body [rad/s^2]
  vec3 a_A{0};         ///< acceleration of its point at A [m/s^2]
};
using TreeLink = TreeLinkOf<real>;  ///< of one tree

#ifndef JOINTS_LIBRARY  // exercises, which programs that link the library do not see
// ---- outward: poses and velocities --------------------------------------------------------------

/// Exercise 11.1: the pose of a child from its coordinate, Eq. 11-1 and 11-2: q, R, a, d, c, and
/// the inertia about its centre. A hinge rotates by x about a, a slider displaces A by x a, and a
/// ball joint has its own q. Of the parent it reads q and R.
void place(TreeLink& link, const TreeLink& parent);
/// Exercise 11.1: the angular velocity of a child, Eq. 11-3, and the accelerations that velocities
/// alone cause, Eq. 11-4 and 11-5. Of the parent it reads w.
void move(TreeLink& link, const TreeLink& parent);
/// The linear state of a child: centre [m] and v [m/s], of those of its parent.
void locate(TreeLink& link, const TreeLink& parent);

// ---- inward: inertia and bias -------------------------------------------------------------------

/// Exercise 11.2: the inertia of the body alone at A, Eq. 11-6: Newton and Euler about the centre,
/// with the acceleration of the centre a_A + alpha x c + .. and the torque about A, which adds
/// c x force.
void begin_inertia(TreeLink& link);
/// Exercise 11.2: the bias of the body alone at A, Eq. 11-7: the force and the torque at A that
/// keep alpha = a_A = 0, less external ones.
void begin_bias(TreeLink& link);
/// Exercise 11.3: U, D, and the inertia that the parent feels, Eq. 11-8 and 11-9:
/// S^T times the force on the child is tau - added times the coordinate's acceleration, which
/// determines the latter; substituting it leaves the inertia less U U^T / (D + added). A held
/// joint, and a weld, pass on all.
void eliminate(TreeLink& link);
/// The same for a ball joint, which passes on no torque: M by Eq. 11-10, and from here on J and H
/// hold J^-1 and J^-1 H.
void eliminate_ball(TreeLink& link);
/// Exercise 11.3: adds the inertia of a child, after eliminate(), at the parent's anchor,
/// Eq. 11-11: an acceleration a + alpha x d of the child's point, and a force that has the lever d.
void add_inertia(const TreeLink& link, TreeLink& parent);
/// Exercise 11.3: adds its bias there, Eq. 11-12. Computes k; for a held joint `acceleration` has
/// to be set.
void add_bias(TreeLink& link, TreeLink& parent);

// ---- outward: accelerations ---------------------------------------------------------------------

/// Exercise 11.4: alpha and a_A of a child and its `acceleration`, Eq. 11-13 and 11-14; or for a
/// held joint the force `tau` that the known acceleration needs, Eq. 11-16.
void accelerate(TreeLink& link, const TreeLink& parent);
/// alpha and a_A of a free root, from the 6 x 6 inertia of the whole tree, Eq. 11-15.
void accelerate_root(TreeLink& root);
#endif

/// skew(d) A, column by column: what a lever makes of a matrix.
inline mat3 crossed(const vec3& d, const mat3& A) {
  return mat3(cross(d, A[0]), cross(d, A[1]), cross(d, A[2]));
}
/// The inverse of a symmetric positive matrix of any size of numbers; 0 for the zero matrix.
mat3 inverse_of(const mat3& A);

}  // namespace joints
/// @}
