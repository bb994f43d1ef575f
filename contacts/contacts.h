// Contacts between any two bodies, at points that a collision library finds. docs/contacts.md
// describes how to use them.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "contacts/point_contacts.h"
#include "engine/world.h"

/// \addtogroup chapter8
/// @{
namespace joints {

/// Where two bodies touch or may touch within a step. C = n.(p2 - p1) >= 0, the gap [m]; n is fixed
/// in body 1, so J = (-n, -(r1 x n), n, r2 x n) with both levers to p2 is exact (Eq. 8-2).
struct ContactPlace {
  vec3 place1{0};   ///< p1 [m], body space of body 1
  vec3 place2{0};   ///< p2 [m], body space of body 2
  vec3 normal{0};   ///< n, unit, body space of body 1; from body 1 to body 2
  int id = -1;      ///< the same in the next step for the same point; -1: it is found by its place

  static constexpr int rows = 1;           ///< while the bodies touch
  static constexpr bool one_sided = true;  ///< it only pushes
  static constexpr Form form = Form::any;  ///< the form of the rows
  /// C, the gap [m]; negative: penetration.
  real error(const Body& body1, const Body& body2) const {
    return dot(to_world(body1, normal), world_point(body2, place2) - world_point(body1, place1));
  }
  /// The row of C.
  Row jacobian(const Body& body1, const Body& body2) const {
    return along(to_world(body1, normal), body1, body2);
  }
  /// The row of sliding or separation along a direction. \param direction unit, world
  Row along(const vec3& direction, const Body& body1, const Body& body2) const {
    return Corner{place2}.along(direction, body1, body2);
  }
};

/// Keeps two bodies apart at points that are supplied before each step. Its impulses are kept by
/// the points' ids, or by their places on body 1. New points begin with the normal impulses of
/// those that have vanished. Source: Catto 2005 for the cached impulses.
class ContactJoint : public PointContacts {
 public:
  real same_place = real(0.02);  ///< points without id are the same if they are this near [m]

  using PointContacts::PointContacts;
  /// Replaces the points. \param places at any poses of the bodies, such as those one step ahead
  /// \throws std::invalid_argument unless they are finite and the normals unit vectors
  inline void set_places(std::span<const ContactPlace> places);
  /// The points that were supplied.
  const std::vector<ContactPlace>& places() const { return places_; }
  /// True if two points are the same in different steps, by their ids or by their places on body 1.
  bool same(const ContactPlace& one, const ContactPlace& other) const {
    if (one.id >= 0 || other.id >= 0) return one.id == other.id;
    return length(one.place1 - other.place1) < same_place;
  }
  bool transient() const override { return true; }
  std::span<const ContactPoint> points() const override { return points_; }

  inline void update_active_rows(const Bodies& bodies, real h) override;
  void deactivate() override { points_.assign(places_.size(), {}); }
  inline void append(const Bodies& bodies, Blocks& blocks) const override;
  inline void activate_missed_limits(const Bodies& bodies, real h, Blocks& blocks) override;

  /// The number of points that have rows in this step.
  int touching() const {
    return int(std::count_if(points_.begin(), points_.end(),
                             [](const ContactPoint& point) { return point.live; }));
  }
  /// The least gap of the points [m]; negative: penetration; infinite without points.
  real gap(const Bodies& bodies) const {
    real least = unbounded;
    for (const ContactPlace& place : places_)
      least = std::min(least, place.error(bodies[body1], bodies[body2]));
    return least;
  }

 protected:
  void serialize(StateStream& stream) override {
    serialize_rebounded(stream);
    for (ContactPoint& point : points_) point.serialize(stream);
  }

 private:
  // Sets a point's gap and rate.
  void measure(std::size_t k, const Body& a, const Body& b) const {
    const Row J = places_[k].jacobian(a, b);
    points_[k].C = places_[k].error(a, b);
    points_[k].rate = row_velocity(J, a, b);
  }
  inline const ContactPoint* known(const ContactPlace& place) const;

  std::vector<ContactPlace> places_;
  mutable std::vector<ContactPoint> points_;  // the solver writes the impulses
};

/// The ContactJoints of a world. It adds one for every pair that touches and removes it when the
/// pair separates. Its settings hold stacks (docs/which_method.md); `configure` may change them.
/// Between two steps call begin(), touch() for each pair, end().
class Contacts {
 public:
  std::function<void(ContactJoint&)> configure{};  ///< called for each new joint

  /// Finds them. \param h step [s] \param substeps StepOptions::substeps
  Contacts(World& world, real h, int substeps = 4)
      : world_(world), h_(h), frequency_(real(substeps) / (4 * h)) {
    require(h > 0 && substeps > 0, "h, substeps: must be positive");
  }
  /// A pair that never touches, such as two bodies with a joint.
  void skip(BodyId a, BodyId b) { skipped_.insert(key(a, b)); }
  /// Skips all pairs that a joint of the world connects now.
  void skip_joined() {
    for (const auto& joint : world_.joints())
      if (!joint->transient()) skip(joint->body1, joint->body2);
  }
  /// True for a pair that skip() has named, and for two static bodies.
  bool skips(BodyId a, BodyId b) const {
    return (world_.bodies[a].is_static() && world_.bodies[b].is_static()) ||
           skipped_.contains(key(a, b));
  }
  /// The body one step ahead. Points that are found there and evaluated at the present pose act
  /// before the bodies touch.
  Body ahead(BodyId id) const {
    Body body = world_.bodies[id];
    if (!body.is_static()) body.v += h_ * world_.gravity;
    integrate_pose(body, h_);
    return body;
  }
  /// Begins to collect. Pairs of removed bodies are forgotten.
  void begin() {
    std::erase_if(joints_, [&](const auto& entry) {  // their joints were removed with the bodies
      const auto& [one, other] = entry.first;
      return !world_.bodies.alive({one.first, one.second}) ||
             !world_.bodies.alive({other.first, other.second});
    });
    for (auto& [pair, entry] : joints_) entry.touched = false;
  }
  /// The points of a pair, always in the same order of its bodies. \return its joint, valid until
  /// the pair no longer touches
  ContactJoint& touch(BodyId a, BodyId b, std::span<const ContactPlace> places) {
    Entry& entry = joints_[key(a, b)];
    if (!entry.joint) entry.joint = &add(a, b);
    require(entry.joint->body1 == a, "a, b: must keep their order");
    entry.touched = true;
    entry.joint->set_places(places);
    return *entry.joint;
  }
  /// The joint of a pair, or null.
  const ContactJoint* find(BodyId a, BodyId b) const {
    const auto found = joints_.find(key(a, b));
    return found == joints_.end() ? nullptr : found->second.joint;
  }
  /// Removes the joints of pairs that touch() has not named since begin().
  void end() {
    std::erase_if(joints_, [&](const auto& entry) {
      if (!entry.second.touched) world_.remove(*entry.second.joint);
      return !entry.second.touched;
    });
  }
  int count() const { return int(joints_.size()); }  ///< pairs that touch

  /// The data for restore(), in addition to the world's own State.
  struct Saved {
    /// A pair with its points and their numbers.
    struct Pair {
      BodyId a{}, b{};                     ///< the bodies
      std::vector<ContactPlace> places{};  ///< its points
      std::vector<real> numbers{};         ///< their impulses and rates
    };
    std::vector<Pair> pairs{};  ///< in the order of their joints
  };
  /// The contacts between two steps.
  inline Saved save() const;
  /// Restores them: removes the joints that were added since then and adds those that were removed.
  /// Call it after restore() of the world (state.h).
  inline void restore(const Saved& saved);

 private:
  using Slot = std::pair<std::uint32_t, std::uint32_t>;  // with its generation
  using Key = std::pair<Slot, Slot>;
  static Key key(BodyId a, BodyId b) {
    const Slot first{a.slot, a.generation}, second{b.slot, b.generation};
    return first < second ? Key{first, second} : Key{second, first};
  }
  struct Entry {
    ContactJoint* joint = nullptr;
    bool touched = false;
  };
  ContactJoint& add(BodyId a, BodyId b) {
    auto& joint = world_.add<ContactJoint>(a, b);
    joint.frequency = frequency_, joint.damping = 10;
    if (configure) configure(joint);
    return joint;
  }

  World& world_;
  real h_, frequency_;
  std::map<Key, Entry> joints_;
  std::set<Key> skipped_;
};

// ---- the joint ----------------------------------------------------------------------------------

// The same point of the last step; the nearest, if there are several.
inline const ContactPoint* ContactJoint::known(const ContactPlace& place) const {
  const ContactPoint* nearest = nullptr;
  real least = unbounded;
  for (std::size_t k = 0; k < places_.size(); ++k) {
    const real far = length(places_[k].place1 - place.place1);
    if (same(places_[k], place) && far < least) least = far, nearest = &points_[k];
  }
  return nearest;
}

inline void ContactJoint::set_places(std::span<const ContactPlace> places) {
  std::vector<ContactPoint> points;
  real lost = 0;  // normal impulse of the points that have vanished
  for (const ContactPoint& point : points_) lost += point.impulse[2];
  std::vector<std::size_t> fresh;
  for (const ContactPlace& place : places) {
    require(finite(place.place1) && finite(place.place2), "place1, place2: must be finite [m]");
    require_unit("normal", place.normal);
    const ContactPoint* const old = known(place);
    if (old) lost -= old->impulse[2];
    else fresh.push_back(points.size());
    points.push_back(old ? *old : ContactPoint{});
  }
  for (const std::size_t k : fresh)
    points[k].impulse[2] = std::max(real(0), lost) / real(fresh.size());
  points_ = std::move(points);
  places_.assign(places.begin(), places.end());
}

inline void ContactJoint::update_active_rows(const Bodies& bodies, real h) {
  const Body &a = bodies[body1], &b = bodies[body2];
  for (std::size_t k = 0; k < places_.size(); ++k) {
    measure(k, a, b);
    set_kick(points_[k]);
    points_[k].live = points_[k].gap_after(h) < real(0.1) * h;  // Eq. 8-4
  }
  begin_points();
  for (std::size_t k = 0; k < places_.size(); ++k) {
    begin_point(points_[k], h);
    if (points_[k].live)
      update_tangents(points_[k], to_world(a, places_[k].normal), world_point(b, places_[k].place2),
                      a, b);
  }
}

inline void ContactJoint::append(const Bodies& bodies, Blocks& blocks) const {
  for (std::size_t k = 0; k < places_.size(); ++k)
    if (points_[k].live) append_point(points_[k], places_[k], bodies, blocks);
}

inline void ContactJoint::activate_missed_limits(const Bodies& bodies, real h, Blocks& blocks) {
  const Body &a = bodies[body1], &b = bodies[body2];
  for (std::size_t k = 0; k < places_.size(); ++k) {
    ContactPoint& point = points_[k];
    measure(k, a, b);
    point.last_rate = point.rate, point.has_last = true;
    if (point.live || point.gap_after(h) >= 0) continue;
    point.live = true;
    update_tangents(point, to_world(a, places_[k].normal), world_point(b, places_[k].place2), a, b);
    append_point(point, places_[k], bodies, blocks);
  }
}

// ---- save and restore ---------------------------------------------------------------------------

inline Contacts::Saved Contacts::save() const {
  Saved out;
  for (const auto& joint : world_.joints()) {
    const auto entry = joints_.find(key(joint->body1, joint->body2));
    if (entry == joints_.end() || entry->second.joint != joint.get()) continue;
    Saved::Pair pair{joint->body1, joint->body2, entry->second.joint->places()};
    StateStream numbers(pair.numbers);
    serialize(*joint, numbers);
    out.pairs.push_back(std::move(pair));
  }
  return out;
}

inline void Contacts::restore(const Saved& saved) {
  begin();
  end();
  for (const Saved::Pair& pair : saved.pairs) {
    ContactJoint& joint = touch(pair.a, pair.b, pair.places);
    StateStream numbers(pair.numbers.data());
    serialize(joint, numbers);
  }
}

}  // namespace joints
/// @}
