// The common part of all contacts of points: friction, rebound, and the rows of a point.
#pragma once

#include <algorithm>
#include <span>

#include "chapters/08_ground/ground.h"
#include "engine/kept/state_stream.h"
#include "engine/solver.h"
#include "engine/world.h"

/// \addtogroup chapter8
/// @{
namespace joints {

/// The state of a point of contact. C and rate are those at the step's beginning, with its forces.
struct ContactPoint {
  bool live = false;        ///< has rows in this step
  real C = 0;               ///< gap [m]
  real rate = 0;            ///< J V of the normal row [m/s]
  real last_rate = 0;       ///< J V after the last step's solve [m/s]
  bool has_last = false;    ///< last_rate is known
  real kick = 0;            ///< change of J V by the forces of a step [m/s]
  real rebound = 0;         ///< rate after an impact in this step [m/s]; 0: no rebound
  real rebound_ratio = 0;   ///< greatest impulse of the rebound over that of the impact [1]
  std::array<vec3, 2> t{};  ///< directions of friction, unit, world
  real across = 0;          ///< factor of the bound along t[1] [1]
  std::array<real, 3> impulse{};  ///< friction along t[0], along t[1], normal [N s]
  /// Saves or restores it.
  void serialize(StateStream& stream) { stream(live, last_rate, has_last, kick, t, impulse); }
  /// The gap at the end of a step if no row holds it [m]. \param h step [s]
  real gap_after(real h) const { return C + h * rate; }
};

/// The end of an impact. The bodies have moved, so the gaps are closed: a first solve stops the
/// rows, a second one reverses those of points with a rebound, with impulses of at most
/// `rebound_ratio` times those that stopped them. This is the lesser of Newton's and Poisson's
/// hypothesis, and adds no energy. The accumulated impulses continue those of the step and stay
/// positive. \param h step [s]
inline void apply_restitution(World& world, Solver& solver, real h);

/// A joint whose rows are those of points of contact. Each has friction along t1, friction along
/// t2, then the normal row.
class PointContacts : public Joint {
 public:
  real friction = real(0.5);   ///< coefficient mu [1], not negative
  real restitution = 0;        ///< rebound speed over impact speed, 0 to 1 [1]
  real threshold = real(0.5);  ///< no rebound from an impact slower than this [m/s]
  bool turned_tangents = true;  ///< t1 follows the direction of sliding; false: t1 is fixed by n
  /// A round cone of friction: t2 gets what t1 left in the last step, so a joint pushes a sliding
  /// body sideways as Coulomb's law requires. false: a square, which brings bodies to rest sooner.
  bool circle = false;
  real slop = 0;  ///< depth that is not corrected [m]

  static constexpr real at_rest = real(0.01);  ///< a point slower than this does not slide [m/s]

  /// Of two bodies; a penetration is corrected at 0.8 m/s at most.
  PointContacts(BodyId body1, BodyId body2) : Joint(body1, body2) { push = real(0.8); }
  /// The bodies, beta and the coefficients.
  void check_input(const Bodies& bodies) const override {
    Joint::check_input(bodies);
    require(finite(friction) && friction >= 0, "friction", friction,
            "must be finite and not negative [1]");
    require(restitution >= 0 && restitution <= 1, "restitution", restitution,
            "must be from 0 to 1 [1]");
    require(threshold >= 0, "threshold", threshold, "must not be negative [m/s]");
    require(slop >= 0, "slop", slop, "must not be negative [m]");
  }
  Stats stats() const override { return {.bounded = true}; }  ///< bounds of contact and friction
  /// All points, live or not.
  virtual std::span<const ContactPoint> points() const = 0;

 protected:
  /// Before the points of a step: no point has a rebound yet.
  void begin_points() { rebounded_ = false; }
  /// The change of a point's rate by the forces of this step. After a rebound it is the one before.
  void set_kick(ContactPoint& point) const {
    if (restitution == 0 || rebounded_) return;
    point.kick = point.has_last ? point.rate - point.last_rate : real(0);
  }
  /// The rebound of a live point, or the end of one that has no rows. \param h step [s]
  void begin_point(ContactPoint& point, real h) {
    point.rebound = 0;
    if (!point.live) point.impulse = {};
    else set_restitution(point, h);
    rebounded_ = rebounded_ || point.rebound > 0;
  }
  /// Chooses new directions of friction and projects the cached friction onto them.
  /// \param n the normal, unit, world \param p the point [m, world]
  inline void update_tangents(ContactPoint& point, const vec3& n, const vec3& p, const Body& body1,
                              const Body& body2) const;
  /// Appends the rows of a point. \param part a Corner, or any type with its functions
  template <class Part>
  void append_point(ContactPoint& point, const Part& part, const Bodies& bodies,
                    Blocks& blocks) const;
  /// Saves or restores whether the last step had a rebound.
  void serialize_rebounded(StateStream& stream) { stream(rebounded_); }

 private:
  // A row of friction as a part.
  template <class Part>
  struct Along {
    const Part& part;
    const vec3& direction;
    static constexpr int rows = 1;
    static constexpr Form form = Form::any;
    real error(const Body&, const Body&) const { return 0; }  // it holds no position
    Row jacobian(const Body& a, const Body& b) const { return part.along(direction, a, b); }
  };
  inline void set_restitution(ContactPoint& point, real h) const;
  bool rebounded_ = false;  // in the last step: its forces are not those of last_rate
};

// The step stops the corner at the ground. The rebound follows once the bodies have moved.
inline void PointContacts::set_restitution(ContactPoint& point, real h) const {
  point.rebound = 0;
  if (restitution == 0 || point.rate >= 0 || point.C + h * point.rate >= 0) return;
  const real speed = impact_speed(point.C, point.rate, point.kick, h);
  if (speed <= threshold) return;
  point.rebound = restitution * speed - point.kick / 2;  // Eq. 8-10
  point.rebound_ratio = -point.rebound / point.rate;
}

inline void apply_restitution(World& world, Solver& solver, real h) {
  Blocks& blocks = world.blocks;
  for (const Block& block : blocks.list) {
    if (!block.settings.one_sided()) continue;
    const int last = block.first + block.rows - 1;
    real& C = blocks.C[std::size_t(last)];
    if (C <= 0)
      C = corrected(block.settings, C,
                    soft_coefficients(block.settings, h, blocks.duration_or(h)).bias_rate);
    C = std::max(real(0), C + h * row_velocity(blocks.J[std::size_t(last)],
                                              world.bodies.at(block.body1),
                                              world.bodies.at(block.body2)));
  }
  solver.prepare(world.bodies, blocks, 0, h);
  solver.solve(world.bodies);

  auto block = blocks.list.begin();  // those of the points, in the same order
  for (const auto& joint : world.joints()) {
    const auto* const contacts = dynamic_cast<const PointContacts*>(joint.get());
    if (!contacts) continue;
    for (const ContactPoint& point : contacts->points()) {
      if (!point.live || point.rebound == 0) continue;
      while (block->impulse != &point.impulse[2]) ++block;
      block->settings.rate = point.rebound;
      block->settings.upper = (1 + point.rebound_ratio) * *block->impulse / blocks.duration_or(h);
    }
  }
  solver.prepare(world.bodies, blocks, 0, h);
  solver.solve(world.bodies);
}

// Chooses new directions of friction and projects the cached friction onto them. t1 is the
// direction of sliding; for a corner at rest it is that of the cached friction, which then has the
// bound mu lambda_n, too. (The velocity of a corner at rest is the residual of the iterations.
// Directions that followed it would change at random, and a corner near its bound would creep.)
inline void PointContacts::update_tangents(ContactPoint& point, const vec3& n, const vec3& p,
                                           const Body& body1, const Body& body2) const {
  const vec3 cached = point.impulse[0] * point.t[0] + point.impulse[1] * point.t[1];
  vec3 sliding(0);
  if (turned_tangents) {
    sliding = point_velocity(body2, p - body2.x) - point_velocity(body1, p - body1.x);
    const real size = length(cached);
    if (length(cross(n, sliding)) < at_rest)
      sliding = size > 0 ? -cached / size : vec3(0);
  }
  point.t = tangents(n, sliding);
  point.impulse[0] = dot(cached, point.t[0]);
  point.impulse[1] = dot(cached, point.t[1]);
  point.across = friction;
  if (circle && point.impulse[2] > 0) {
    const real along = point.impulse[0] / point.impulse[2];
    point.across = std::sqrt(std::max(real(0), friction * friction - along * along));  // Eq. 8-11
  }
}

template <class Part>
void PointContacts::append_point(ContactPoint& point, const Part& part, const Bodies& bodies,
                                 Blocks& blocks) const {
  for (const int i : {0, 1}) {
    if (friction == 0) break;
    blocks.append(bodies, body1, body2, Along<Part>{part, point.t[std::size_t(i)]},
                  {.holds_position = false, .follows = 2 - i,
                   .upper = i == 0 ? friction : point.across},  // Eq. 8-6
                  &point.impulse[std::size_t(i)]);
  }
  RowSettings target = hold(0);
  target.slop = slop;
  blocks.append(bodies, body1, body2, part, target, &point.impulse[2]);
  if (point.rebound > 0) blocks.after_move = apply_restitution;
}

}  // namespace joints
/// @}
