// A contact with the ground as a joint of the engine: given, there is nothing to edit here.
#pragma once

#include <algorithm>

#include "contacts/point_contacts.h"

/// \addtogroup chapter8
/// @{
namespace joints {

/// The points of a body that can touch the ground: its corners, or a ball's centre and radius.
struct Outline {
  std::array<vec3, 8> corners{};  ///< [m, body space]
  int count = 0;                  ///< the number of corners in use
  real radius = 0;                ///< of a sphere about each corner [m]
};
/// That of a box. \param size edges [m] \throws std::invalid_argument unless positive and finite
inline Outline box_outline(const vec3& size) {
  check_size(size);
  Outline out{.count = 8};
  for (int k = 0; k < 8; ++k)
    out.corners[k] = real(0.5) * size * vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
  return out;
}
/// A ball. \throws std::invalid_argument unless the radius is positive and finite [m]
inline Outline ball_outline(real radius) {
  require(finite(radius) && radius > 0, "radius: of a ball must be positive and finite [m]");
  return {.count = 1, .radius = radius};
}

/// Validates it. \throws std::invalid_argument unless it has one to eight corners, all finite, and
/// its radius is finite and not negative
inline void check(const Outline& outline) {
  require(outline.count >= 1 && outline.count <= 8, "outline: needs one to eight corners");
  for (int k = 0; k < outline.count; ++k)
    require_finite("outline.corners", outline.corners[std::size_t(k)], "must be finite [m]");
  require(finite(outline.radius) && outline.radius >= 0, "outline.radius", outline.radius,
          "must be finite and not negative [m]");
}

/// The top of a body: a plane perpendicular to the body's own y axis, or a part of one.
struct Top {
  real height = 0;          ///< above the body's centre [m]
  real half_x = unbounded;  ///< half its extent along the body's own x axis [m]
  real half_z = unbounded;  ///< half its extent along the z axis [m]
  real depth = unbounded;   ///< a corner deeper than this is beside the body, not under its top [m]
};
/// Validates it. \throws std::invalid_argument unless height is finite, nothing else < 0
inline void check(const Top& top) {
  require_finite("top.height", top.height, "must be finite [m]");
  require(top.half_x >= 0, "top.half_x", top.half_x, "must not be negative [m]");
  require(top.half_z >= 0, "top.half_z", top.half_z, "must not be negative [m]");
  require(top.depth >= 0, "top.depth", top.depth, "must not be negative [m]");
}
/// The upper face of a box. \param size its edges [m]
/// \throws std::invalid_argument unless they are positive and finite
inline Top box_top(const vec3& size) {
  check_size(size);
  return {size.y / 2, size.x / 2, size.z / 2, size.y / 2};
}

/// Keeps body 2 above the top of body 1. Each corner that touches, or will within this step, has
/// three rows, one block each: friction along t1, friction along t2, then the normal row, so that
/// non-penetration is solved last. The friction pyramid bounds each direction by itself: a square
/// with an edge perpendicular to the sliding, instead of a circle. At most four corners have rows
/// at the same time. Only corners of body 2 are tested: an edge of the top does not carry a face
/// that lies across it.
class GroundContact : public PointContacts {
 public:
  Top top;                ///< the surface, on body 1
  const Outline outline;  ///< the points of body 2 that can touch it

  static constexpr int most_corners = 4;  ///< the most corners with rows at the same time

  /// Of a body. \param ground body 1, most often a static one \throws std::invalid_argument for a
  /// body with itself, or from the outline's check
  GroundContact(BodyId ground, BodyId body, const Top& top, const Outline& outline)
      : PointContacts(ground, body), top(top), outline(outline) {
    check(outline);
    for (int k = 0; k < outline.count; ++k)
      reach_ = std::max(reach_, length(outline.corners[std::size_t(k)]) + outline.radius);
  }

  /// The bodies, beta, the coefficients and the top.
  void check_input(const Bodies& bodies) const override {
    PointContacts::check_input(bodies);
    check(top);
  }
  /// Chooses the corners that have rows in this step and their directions of friction.
  inline void update_active_rows(const Bodies& bodies, real h) override;
  void deactivate() override { points_ = {}, live_ = 0, near_ = false; }
  std::span<const ContactPoint> points() const override { return points_; }
  /// Appends friction, friction, normal of each corner that has rows.
  inline void append(const Bodies& bodies, Blocks& blocks) const override;
  /// Appends rows for corners that would penetrate the ground with the new velocities.
  inline void activate_missed_limits(const Bodies& bodies, real h, Blocks& blocks) override;

  /// The number of corners that have rows in this step.
  int touching() const { return live_; }
  /// The least gap of the corners over the top [m]; negative: penetration.
  real gap(const Bodies& bodies) const;

 protected:
  void serialize(StateStream& stream) override {
    stream(near_);
    serialize_rebounded(stream);
    live_ = 0;
    for (int k = 0; k < outline.count; ++k) {
      points_[std::size_t(k)].serialize(stream);
      live_ += points_[std::size_t(k)].live;
    }
  }

 private:
  // Gap and rate of every corner at once: both are linear in corner_local. With d = x2 - x1 and
  // p = x2 + R2 corner_local - radius n, Eq. 8-1 is n.d - radius - height + (R2^T n).corner_local,
  // and its rate is n.(v2 - v1) - (n x w1).d + (R2^T (n x (w2 - w1))).corner_local.
  struct Slopes {
    vec3 n;            // up, world
    vec3 gap, rate;    // factors of corner_local
    real gap0, rate0;  // of the centre [m] and [m/s]
    real gap_of(const vec3& corner) const { return gap0 + dot(gap, corner); }
    real rate_of(const vec3& corner) const { return rate0 + dot(rate, corner); }
  };
  Slopes slopes(const Body& body1, const Body& body2) const {
    const vec3 n = Corner::up(body1), d = body2.x - body1.x;
    return {n, to_local(body2, n), to_local(body2, cross(n, body2.w - body1.w)),
            dot(n, d) - outline.radius - top.height,
            dot(n, body2.v - body1.v) - dot(cross(n, body1.w), d)};
  }

  Corner corner(int k) const {
    return {outline.corners[std::size_t(k)], outline.radius, top.height};
  }
  // A lower bound of every corner's gap [m] after `time` [s] at the present velocities.
  real least_gap(const Body& body1, const Body& body2, real time) const;
  bool over_top(int k, real C, const Body& body1, const Body& body2) const;
  ContactPoint& farthest_live(real h);

  mutable std::array<ContactPoint, 8> points_{};  // the solver writes the impulses
  int live_ = 0;
  real reach_ = 0;     // from the centre of body 2 to its farthest point [m]
  bool near_ = false;  // the corners were tested in this step
};

// ---- which corners have rows --------------------------------------------------------------------

inline void GroundContact::update_active_rows(const Bodies& bodies, real h) {
  const Body &a = bodies[body1], &b = bodies[body2];
  const bool was_near = near_;
  const real reserve = real(0.1) * h;
  // A rebound needs the rate of the step before the impact: look three steps ahead, too.
  near_ = least_gap(a, b, h) < reserve ||
          (restitution > 0 && least_gap(a, b, 3 * h) < reserve);
  live_ = 0;
  if (!near_) {
    if (was_near) points_ = {};
    return;
  }
  const Slopes now = slopes(a, b);
  for (int k = 0; k < outline.count; ++k) {
    ContactPoint& point = points_[std::size_t(k)];
    point.C = now.gap_of(outline.corners[std::size_t(k)]);
    point.rate = now.rate_of(outline.corners[std::size_t(k)]);
    set_kick(point);
    point.live = point.gap_after(h) < reserve && over_top(k, point.C, a, b);  // Eq. 8-4
    live_ += point.live;
  }
  for (; live_ > most_corners; --live_) farthest_live(h).live = false;
  begin_points();
  for (int k = 0; k < outline.count; ++k) {
    ContactPoint& point = points_[std::size_t(k)];
    begin_point(point, h);
    if (point.live) update_tangents(point, now.n, corner(k).point(a, b), a, b);
  }
}

// The live corner with the largest gap at the end of the step.
inline ContactPoint& GroundContact::farthest_live(real h) {
  ContactPoint* farthest = nullptr;
  for (ContactPoint& point : points_)
    if (point.live && (!farthest || point.gap_after(h) > farthest->gap_after(h)))
      farthest = &point;
  return *farthest;
}

inline void GroundContact::append(const Bodies& bodies, Blocks& blocks) const {
  for (int k = 0; k < outline.count; ++k)
    if (ContactPoint& point = points_[std::size_t(k)]; point.live)
      append_point(point, corner(k), bodies, blocks);
}

inline void GroundContact::activate_missed_limits(const Bodies& bodies, real h, Blocks& blocks) {
  const Body &a = bodies[body1], &b = bodies[body2];
  if (!near_ && least_gap(a, b, h) >= 0) return;
  near_ = true;  // if it was not: a neighbour's impulse has changed the velocities
  const Slopes now = slopes(a, b);
  for (int k = 0; k < outline.count; ++k) {
    ContactPoint& point = points_[std::size_t(k)];
    point.C = now.gap_of(outline.corners[std::size_t(k)]);
    const real rate = now.rate_of(outline.corners[std::size_t(k)]);
    point.last_rate = rate;
    point.has_last = true;
    if (point.live || live_ == most_corners || point.C + h * rate >= 0 ||
        !over_top(k, point.C, a, b))
      continue;
    point.live = true;
    ++live_;
    update_tangents(point, now.n, corner(k).point(a, b), a, b);
    append_point(point, corner(k), bodies, blocks);
  }
}

inline real GroundContact::gap(const Bodies& bodies) const {
  const Body &a = bodies[body1], &b = bodies[body2];
  real least = unbounded;
  for (int k = 0; k < outline.count; ++k)
    if (const real C = corner(k).error(a, b); over_top(k, C, a, b)) least = std::min(least, C);
  return least;
}

// ---- one corner ---------------------------------------------------------------------------------

// The centre's rate, less the most that a rotation can add at the farthest point.
inline real GroundContact::least_gap(const Body& body1, const Body& body2, real time) const {
  const vec3 n = Corner::up(body1), d = body2.x - body1.x;
  const real rate = dot(n, body2.v - body1.v - cross(body1.w, d));
  return dot(n, d) - top.height - reach_ + time * (rate - reach_ * length(body2.w - body1.w));
}

// C: its gap.
inline bool GroundContact::over_top(int k, real C, const Body& body1, const Body& body2) const {
  if (C < -top.depth) return false;
  if (top.half_x == unbounded && top.half_z == unbounded) return true;
  const vec3 p = to_local(body1, corner(k).point(body1, body2) - body1.x);
  const real rim = real(1.01);  // so that a corner on the rim stays over the top
  return std::abs(p.x) <= rim * top.half_x && std::abs(p.z) <= rim * top.half_z;
}

}  // namespace joints
/// @}
