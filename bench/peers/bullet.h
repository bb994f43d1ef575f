// Common code of both adapters of Bullet: conversion of numbers, shapes, and pairs that touch.
#pragma once

#include <btBulletDynamicsCommon.h>

#include "bench/peers/peer.h"

namespace joints::bench {

inline btVector3 to_bullet(const glm::dvec3& a) {
  return btVector3(btScalar(a.x), btScalar(a.y), btScalar(a.z));
}
inline btQuaternion to_bullet(const glm::dquat& q) {
  return btQuaternion(btScalar(q.x), btScalar(q.y), btScalar(q.z), btScalar(q.w));
}
inline vec3 from_bullet(const btVector3& a) { return vec3(real(a.x()), real(a.y()), real(a.z())); }
inline quat from_bullet(const btQuaternion& q) {
  return quat(real(q.w()), real(q.x()), real(q.y()), real(q.z()));
}
inline btTransform pose_of(const Body& body) {
  return btTransform(to_bullet(glm::dquat(body.q)), to_bullet(glm::dvec3(body.x)));
}
inline btVector3 inertia_of(const Body& body) {
  return body.is_static() ? btVector3(0, 0, 0)
                          : to_bullet(1.0 / glm::dvec3(body.inverse_inertia_local));
}
inline btScalar mass_of(const Body& body) {
  return body.is_static() ? btScalar(0) : btScalar(1 / double(body.inverse_mass));
}

// A solver and its settings.
struct BulletChoice {
  enum class Solver { impulses, conjugate, dantzig, lemke };
  Solver solver = Solver::impulses;
  int iterations = 10;
  int substeps = 1;
  double erp = 0.2;   // fraction of the error fed back in a step
  bool runge_kutta = false;  // of multibodies
  bool split = true;  // split impulses: with them a multibody does not regain a limit it passed
};

// What every world of Bullet consists of; all shapes that it has.
struct BulletParts {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  std::vector<std::unique_ptr<btCollisionShape>> shapes;

  // A body that touches nothing has a shape all the same.
  btCollisionShape* add(const PeerShape& shape) {
    switch (shape.kind) {
      case PeerShape::Kind::plane:
        shapes.push_back(std::make_unique<btStaticPlaneShape>(btVector3(0, 1, 0),
                                                              btScalar(shape.height)));
        break;
      case PeerShape::Kind::box:
        shapes.push_back(std::make_unique<btBoxShape>(to_bullet(shape.half)));
        break;
      case PeerShape::Kind::capsule:
        shapes.push_back(std::make_unique<btCapsuleShape>(btScalar(shape.half.x),
                                                          btScalar(2 * shape.half.y)));
        break;
      default:
        shapes.push_back(std::make_unique<btSphereShape>(
            btScalar(shape.kind == PeerShape::Kind::ball ? shape.half.x : 0.5)));
    }
    return shapes.back().get();
  }
  // Bits for the collision filter: grounds touch what stands on them, and nothing else touches.
  static int group(const PeerShape& shape) { return shape.is_ground ? 1 : 2; }
  static int mask(const PeerShape& shape, bool heap = false) {
    return shape.kind == PeerShape::Kind::none ? 0 : heap ? 3 : shape.is_ground ? 2 : 1;
  }
};

// A joint at the place of a body: its x axis (slider) or z axis (hinge) along the joint's axis.
inline btTransform frame_at(const PeerJoint& joint, const Body& body, const btVector3& own_axis) {
  btQuaternion turn(0, 0, 0, 1);
  if (joint.axis != glm::dvec3(0)) turn = shortestArcQuat(own_axis, to_bullet(joint.axis));
  return pose_of(body).inverse() * btTransform(turn, to_bullet(joint.anchor));
}

std::unique_ptr<Peer> bullet_trees(const PeerScene& scene, const BulletChoice& choice);

}  // namespace joints::bench
