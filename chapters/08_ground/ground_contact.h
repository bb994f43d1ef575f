// A contact with the ground as a joint of the engine: given, there is nothing to edit here.
#pragma once

#include <algorithm>

#include "chapters/08_ground/ground.h"
#include "engine/joint.h"

/// \addtogroup chapter8
/// @{
namespace joints {

/// Where a body can stand on the ground: its corners, or the centre of a ball and its radius.
struct Outline {
  std::array<vec3, 8> corners{};  ///< [m, body space]
  int count = 0;                  ///< how many of them
  real radius = 0;                ///< about each of them [m]
};
/// \param size the edges [m] \throws std::invalid_argument unless they are positive and finite
inline Outline box_outline(const vec3& size) {
  require(finite(size) && size.x > 0 && size.y > 0 && size.z > 0,
          "size: the edges of a box must be positive and finite [m]");
  Outline out{.count = 8};
  for (int k = 0; k < 8; ++k)
    out.corners[k] = real(0.5) * size * vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
  return out;
}
/// \throws std::invalid_argument unless the radius is positive and finite [m]
inline Outline ball_outline(real radius) {
  require(finite(radius) && radius > 0, "radius: of a ball must be positive and finite [m]");
  return {.count = 1, .radius = radius};
}

/// The top of a body: a plane at right angles to the body's own y axis, or a part of one.
struct Top {
  real height = 0;          ///< above the body's centre [m]
  real half_x = unbounded;  ///< how far it reaches either way along the body's own x axis [m]
  real half_z = unbounded;  ///< and along its z axis [m]
  real depth = unbounded;   ///< a corner deeper than this is beside the body, not under its top [m]
};
/// The upper face of a box. \param size its edges [m]
inline Top box_top(const vec3& size) {
  return {size.y / 2, size.x / 2, size.z / 2, size.y / 2};
}

/// Keeps body 2 above the top of body 1. Each corner that touches, or will within this step, has
/// three rows, a block each: friction along t1, friction along t2, then the normal row, which has
/// the last word. The friction is bounded in each direction by itself: a square in the plane of
/// friction, with an edge across the sliding, in place of a circle. At most four corners have rows
/// at the same time. Only corners of body 2 are looked at: an edge of the top does not carry a face
/// that lies across it.
class GroundContact : public Joint {
 public:
  Top top;                ///< the surface, on body 1
  const Outline outline;  ///< what of body 2 can touch it
  real friction = real(0.5);   ///< coefficient mu [1], not negative
  real restitution = 0;        ///< share of the impact speed with which it rebounds [1]
  real threshold = real(0.5);  ///< no rebound from an impact slower than this [m/s]
  bool turned_tangents = true;  ///< t1 looks where the corner slides; false: it stays as it is

  static constexpr int most_corners = 4;  ///< that have rows at the same time
  static constexpr real at_rest = real(0.01);  ///< a slower corner does not slide [m/s]

  /// \param ground body 1, most often a static one
  /// \throws std::invalid_argument for a body with itself, or an outline without corners
  GroundContact(BodyId ground, BodyId body, const Top& top, const Outline& outline)
      : Joint(ground, body), top(top), outline(outline) {
    require(outline.count >= 1 && outline.count <= 8, "outline: needs one to eight corners");
    for (int k = 0; k < outline.count; ++k)
      reach_ = std::max(reach_, length(outline.corners[std::size_t(k)]) + outline.radius);
  }

  /// Chooses the corners that have rows in this step, and their directions of friction.
  /// \throws std::invalid_argument for a friction that is negative or not finite
  inline void choose_rows(const Bodies& bodies, real h) override;
  void drop_rows() override { points_ = {}, live_ = 0, near_ = false; }
  /// Friction, friction, normal, of each corner that has rows.
  inline void append(const Bodies& bodies, Blocks& blocks) const override;
  /// Adds a corner that a neighbour has driven into the ground after all.
  inline void late_limits(const Bodies& bodies, real h, Blocks& blocks) override;
  int most_rows() const override { return 3 * most_corners; }

  /// How many corners have rows in this step.
  int touching() const { return live_; }
  /// Room between the deepest corner over the top and the ground [m]; negative: penetration.
  real room(const Bodies& bodies) const;

 private:
  // A corner: its room and rates are those of the step's beginning, forces included.
  struct ContactPoint {
    bool live = false;        // has rows in this step
    real C = 0, rate = 0;     // room [m] and J V of the normal row [m/s]
    real last_rate = 0;       // J V at the end of the last step, if that was looked at
    bool followed = false;    // was it?
    real bounce = 0;          // an impact in the last step: how fast it leaves in this one [m/s]
    real target = 0;          // the speed that its normal row wants now [m/s]
    std::array<vec3, 2> t{};  // directions of friction
    std::array<real, 3> impulse{};  // friction along t[0], along t[1], normal [N s]
    real room_after(real h) const { return C + h * rate; }  // if nothing holds it [m]
  };

  Corner corner(int k) const {
    return {outline.corners[std::size_t(k)], outline.radius, top.height};
  }
  // The least room that any corner can have after so long, with the velocities of now [m].
  real least_room(const Body& body1, const Body& body2, real time) const;
  real normal_rate(int k, const Body& body1, const Body& body2) const;
  bool over_top(int k, const Body& body1, const Body& body2) const;
  void look_at_impact(ContactPoint& point, real h) const;
  ContactPoint& farthest_live(real h);
  void turn_friction(int k, const Body& body1, const Body& body2);
  void append_point(int k, const Bodies& bodies, Blocks& blocks) const;

  mutable std::array<ContactPoint, 8> points_{};  // the solver writes the impulses
  int live_ = 0;
  real reach_ = 0;     // from the centre of body 2 to its farthest point [m]
  bool near_ = false;  // were the corners looked at in this step?
};

// ---- which corners have rows --------------------------------------------------------------------

inline void GroundContact::choose_rows(const Bodies& bodies, real h) {
  require(finite(friction) && friction >= 0, "friction: must be finite and not negative [1]");
  const Body &a = bodies[body1], &b = bodies[body2];
  const bool was_near = near_;
  const real reserve = real(0.1) * h;
  // A rebound has to know the rate of the step before the impact: look three steps ahead.
  near_ = least_room(a, b, restitution > 0 ? 3 * h : h) < reserve;
  live_ = 0;
  if (!near_) {
    if (was_near) points_ = {};
    return;
  }
  for (int k = 0; k < outline.count; ++k) {
    ContactPoint& point = points_[std::size_t(k)];
    point.C = corner(k).error(a, b);
    point.rate = normal_rate(k, a, b);
    point.live = point.room_after(h) < reserve && over_top(k, a, b);  // Eq. 8-4
    live_ += point.live;
  }
  for (; live_ > most_corners; --live_) farthest_live(h).live = false;
  for (int k = 0; k < outline.count; ++k) {
    ContactPoint& point = points_[std::size_t(k)];
    if (point.live) {
      look_at_impact(point, h);
      turn_friction(k, a, b);
    } else {
      point.impulse = {};
      point.bounce = point.target = 0;
    }
  }
}

// The live corner that will have the most room left.
inline GroundContact::ContactPoint& GroundContact::farthest_live(real h) {
  ContactPoint* farthest = nullptr;
  for (ContactPoint& point : points_)
    if (point.live && (!farthest || point.room_after(h) > farthest->room_after(h)))
      farthest = &point;
  return *farthest;
}

inline void GroundContact::append(const Bodies& bodies, Blocks& blocks) const {
  for (int k = 0; k < outline.count; ++k)
    if (points_[std::size_t(k)].live) append_point(k, bodies, blocks);
}

inline void GroundContact::late_limits(const Bodies& bodies, real h, Blocks& blocks) {
  const Body &a = bodies[body1], &b = bodies[body2];
  if (!near_) {
    if (least_room(a, b, h) >= 0) return;
    near_ = true;  // a neighbour brings it here
    for (int k = 0; k < outline.count; ++k) points_[std::size_t(k)].C = corner(k).error(a, b);
  }
  for (int k = 0; k < outline.count; ++k) {
    ContactPoint& point = points_[std::size_t(k)];
    const real rate = normal_rate(k, a, b);
    point.last_rate = rate;
    point.followed = true;
    if (point.live || live_ == most_corners || point.C + h * rate >= 0 || !over_top(k, a, b))
      continue;
    point.live = true;
    ++live_;
    turn_friction(k, a, b);
    append_point(k, bodies, blocks);
  }
}

inline real GroundContact::room(const Bodies& bodies) const {
  const Body &a = bodies[body1], &b = bodies[body2];
  real least = unbounded;
  for (int k = 0; k < outline.count; ++k)
    if (over_top(k, a, b)) least = std::min(least, corner(k).error(a, b));
  return least;
}

// ---- one corner ---------------------------------------------------------------------------------

// The centre comes nearer with one rate, and no corner is faster than its lever allows.
inline real GroundContact::least_room(const Body& body1, const Body& body2, real time) const {
  const vec3 n = Corner::up(body1), d = body2.x - body1.x;
  const real rate = dot(n, body2.v - body1.v - cross(body1.w, d));
  return dot(n, d) - top.height - reach_ + time * (rate - reach_ * length(body2.w - body1.w));
}

inline real GroundContact::normal_rate(int k, const Body& body1, const Body& body2) const {
  const Row J = corner(k).jacobian(body1, body2);
  return dot(J.v1, body1.v) + dot(J.w1, body1.w) + dot(J.v2, body2.v) + dot(J.w2, body2.w);
}

inline bool GroundContact::over_top(int k, const Body& body1, const Body& body2) const {
  const vec3 p = to_local(body1, corner(k).point(body1, body2) - body1.x);
  return std::abs(p.x) <= top.half_x && std::abs(p.z) <= top.half_z &&
         p.y - top.height >= -top.depth;
}

// A rebound takes two steps: in the first the corner comes to the ground and no further, and the
// speed that it had is remembered; in the second it leaves.
inline void GroundContact::look_at_impact(ContactPoint& point, real h) const {
  const real kick =
      point.followed ? point.rate - point.last_rate : real(0);  // by forces, this step
  point.target = 0;
  if (point.bounce > 0) {
    point.target = std::max(real(0), point.bounce + kick / 2);  // Eq. 8-10
    point.bounce = 0;
  } else if (restitution > 0 && point.C + h * point.rate < 0) {
    const real speed = impact_speed(point.C, point.rate, kick, h);
    if (speed > threshold) point.bounce = restitution * speed;  // Eq. 8-10
  }
}

// New directions of friction; what was remembered of the old ones is an arrow, and stays one. t1
// looks where the corner slides; where it rests, along the friction that holds it, so that this has
// the bound mu lambda_n, too. (The velocity of a corner at rest is what the iterations left
// unfinished. Bounds that turn with that move at random, and a corner near its bound creeps.)
inline void GroundContact::turn_friction(int k, const Body& body1, const Body& body2) {
  ContactPoint& point = points_[std::size_t(k)];
  const vec3 arrow = point.impulse[0] * point.t[0] + point.impulse[1] * point.t[1];
  const vec3 p = corner(k).point(body1, body2), n = Corner::up(body1);
  vec3 sliding(0);
  if (turned_tangents) {
    sliding = point_velocity(body2, p - body2.x) - point_velocity(body1, p - body1.x);
    const real held = length(arrow);
    if (length(sliding - dot(n, sliding) * n) < at_rest)
      sliding = held > 0 ? -arrow / held : vec3(0);
  }
  point.t = tangents(n, sliding);
  point.impulse[0] = dot(arrow, point.t[0]);
  point.impulse[1] = dot(arrow, point.t[1]);
}

inline void GroundContact::append_point(int k, const Bodies& bodies, Blocks& blocks) const {
  ContactPoint& point = points_[std::size_t(k)];
  const Body &a = bodies[body1], &b = bodies[body2];
  const Corner part = corner(k);
  for (const int i : {0, 1}) {
    if (friction == 0) break;
    blocks.append(bodies, body1, body2, to_jacobian(part.along(point.t[std::size_t(i)], a, b)), {0},
                  {.holds_position = false, .follows = 2 - i, .upper = friction},  // Eq. 8-6
                  &point.impulse[std::size_t(i)]);
  }
  blocks.append(bodies, body1, body2, part, {.beta = beta, .rate = point.target, .lower = 0},
                &point.impulse[2]);
}

}  // namespace joints
/// @}
