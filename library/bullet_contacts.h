// Contacts from Bullet's collision part: an adapter for programs that link BulletCollision and
// LinearMath. Nothing of the library includes it. docs/contacts.md describes how to use it.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include <btBulletCollisionCommon.h>

#include "contacts/contacts.h"

/// \addtogroup chapter8
/// @{
namespace joints {

/// Finds the contacts of bodies with Bullet's shapes. Call update() before each step.
class BulletContacts : private btOverlapFilterCallback {
 public:
  Contacts contacts;  ///< the pairs and their joints; contacts.skip() excludes a pair
  /// Bullet returns four of the up to eight corners that two faces have in common, and others in
  /// the next step. A point that it drops stays while it slides and separates by less than this
  /// [m].
  real stay = real(0.001);

  /// \param h step [s] \param substeps StepOptions::substeps
  BulletContacts(World& world, real h, int substeps = 4)
      : contacts(world, h, substeps), world_(world) {
    pairs_.getOverlappingPairCache()->setOverlapFilterCallback(this);
  }
  /// Gives a body a shape. Its origin is the body's centre.
  void add(BodyId id, std::unique_ptr<btCollisionShape> shape) {
    auto object = std::make_unique<btCollisionObject>();
    object->setCollisionShape(shape.get());
    object->setUserIndex(int(objects_.size()));
    object->setWorldTransform(transform(world_.bodies[id]));
    objects_.push_back({id, std::move(shape), std::move(object)});
    collisions_.addCollisionObject(objects_.back().object.get());
  }
  /// \param size edges [m]
  void add_box(BodyId id, const vec3& size) {
    add(id, std::make_unique<btBoxShape>(vector(size / real(2))));
  }
  /// \param radius [m]
  void add_ball(BodyId id, real radius) {
    add(id, std::make_unique<btSphereShape>(btScalar(radius)));
  }
  /// Along the body's y axis. \param radius [m] \param length of the cylinder without the caps [m]
  void add_capsule(BodyId id, real radius, real length) {
    add(id, std::make_unique<btCapsuleShape>(btScalar(radius), btScalar(length)));
  }
  /// Finds the contacts at the poses one step ahead. Shapes of removed bodies are dropped.
  void update() {
    for (Object& one : objects_)
      if (one.object && !world_.bodies.alive(one.id)) {
        collisions_.removeCollisionObject(one.object.get());
        one.object.reset();
      }
    for (Object& one : objects_)
      if (one.object) {
        one.ahead = contacts.ahead(one.id);
        one.object->setWorldTransform(transform(one.ahead));
      }
    collisions_.performDiscreteCollisionDetection();
    contacts.begin();
    for (int k = 0; k < dispatcher_.getNumManifolds(); ++k)
      take(*dispatcher_.getManifoldByIndexInternal(k));
    contacts.end();
  }

 private:
  struct Object {
    BodyId id;
    std::unique_ptr<btCollisionShape> shape;
    std::unique_ptr<btCollisionObject> object;
    Body ahead{};
  };
  static btVector3 vector(const vec3& a) { return {btScalar(a.x), btScalar(a.y), btScalar(a.z)}; }
  static vec3 vector(const btVector3& a) { return {real(a.x()), real(a.y()), real(a.z())}; }
  static btTransform transform(const Body& body) {
    const quat& q = body.q;
    return btTransform({btScalar(q.x), btScalar(q.y), btScalar(q.z), btScalar(q.w)},
                       vector(body.x));
  }
  bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override {
    const auto id = [&](const btBroadphaseProxy* proxy) {
      const auto* object = static_cast<const btCollisionObject*>(proxy->m_clientObject);
      return objects_[std::size_t(object->getUserIndex())].id;
    };
    return !contacts.skips(id(a), id(b));
  }
  void take(const btPersistentManifold& manifold) {
    const Object* first = &objects_[std::size_t(manifold.getBody0()->getUserIndex())];
    const Object* second = &objects_[std::size_t(manifold.getBody1()->getUserIndex())];
    const bool turned = first->id.slot > second->id.slot;
    if (turned) std::swap(first, second);
    std::vector<ContactPlace> places;
    for (int k = 0; k < manifold.getNumContacts(); ++k) {
      const btManifoldPoint& point = manifold.getContactPoint(k);
      vec3 on1 = vector(point.getPositionWorldOnA()), on2 = vector(point.getPositionWorldOnB());
      vec3 n = -vector(point.m_normalWorldOnB);  // from A to B
      if (turned) std::swap(on1, on2), n = -n;
      places.push_back({to_local(first->ahead, on1 - first->ahead.x),
                        to_local(second->ahead, on2 - second->ahead.x),
                        normalize(to_local(first->ahead, n))});
    }
    if (places.empty()) return;
    if (const ContactJoint* const joint = contacts.find(first->id, second->id))
      for (const ContactPlace& old : joint->places())
        if (stays(old, first->ahead, second->ahead) &&
            std::ranges::none_of(places, [&](const auto& one) { return joint->same(old, one); }))
          places.push_back(old);
    contacts.touch(first->id, second->id, places);
  }

  bool stays(const ContactPlace& old, const Body& a, const Body& b) const {
    const real gap = old.error(a, b);
    const vec3 apart = world_point(b, old.place2) - world_point(a, old.place1);
    return gap < stay && length(apart - gap * to_world(a, old.normal)) < stay;
  }

  World& world_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase pairs_;
  btCollisionWorld collisions_{&dispatcher_, &pairs_, &configuration_};
  std::vector<Object> objects_;
};

}  // namespace joints
/// @}
