// Bullet's multibodies: reduced coordinates, a multibody for each tree of joints.
#include "bench/peers/bullet.h"

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointLimitConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <BulletDynamics/Featherstone/btMultiBodyPoint2Point.h>

namespace joints::bench {

namespace {

std::size_t at(int slot) { return std::size_t(slot); }

class BulletTrees : public Peer {
 public:
  BulletTrees(const PeerScene& scene, const BulletChoice& choice)
      : choice_(choice), scene_(scene), trees_(trees_of(scene)), links_(scene.bodies.size()),
        with_colliders_(scene.touches() || scene.is_driven() || !trees_.loops.empty()) {
    world_ = std::make_unique<btMultiBodyDynamicsWorld>(&parts_.dispatcher, &parts_.broadphase,
                                                        &solver_, &parts_.configuration);
    world_->setGravity(to_bullet(scene.gravity));
    world_->getSolverInfo().m_numIterations = choice.iterations;
    world_->getSolverInfo().m_erp = btScalar(choice.erp);
    world_->getSolverInfo().m_splitImpulse = choice.split;
    for (std::size_t k = 0; k < trees_.order.size();) {
      std::size_t end = k + 1;
      while (end < trees_.order.size() && trees_.parent[at(trees_.order[end])] >= 0) ++end;
      add_tree(k, end);
      k = end;
    }
    for (const int k : trees_.loops) close(scene_.joints[at(k)]);
  }
  ~BulletTrees() override {
    for (const auto& one : constraints_) world_->removeMultiBodyConstraint(one.get());
    for (const auto& one : colliders_) world_->removeCollisionObject(one.get());
    for (const auto& one : multibodies_) world_->removeMultiBody(one.get());
    for (const auto& one : statics_) world_->removeRigidBody(one.get());
  }

  void step(double h) override {
    const auto part = btScalar(h / choice_.substeps);
    for (const auto& [motor, strength] : motors_)
      motor->setMaxAppliedImpulse(btScalar(strength) * part);
    for (int n = 0; n < choice_.substeps; ++n) {
      for (const auto& [link, torque] : torques_)
        if (link.number < 0) link.multibody->addBaseTorque(torque);
        else link.multibody->addLinkTorque(link.number, torque);
      world_->stepSimulation(part, 0);
    }
  }
  void show(Bodies& bodies) override {
    btAlignedObjectArray<btQuaternion> to_local;
    btAlignedObjectArray<btVector3> origin, w, v;
    for (const auto& one : multibodies_) {
      const int count = one->getNumLinks() + 1;
      to_local.resize(count), origin.resize(count), w.resize(count), v.resize(count);
      one->forwardKinematics(to_local, origin);
      one->compTreeLinkVelocities(&w[0], &v[0]);
      const auto& slots = slots_[at(one->getUserIndex())];
      for (int k = 0; k < count; ++k) {
        Body& body = bodies.at(slots[at(k)]);
        if (body.is_static()) continue;
        const btQuaternion q = to_local[k].inverse();
        body.x = from_bullet(origin[k]);
        body.q = from_bullet(q);
        body.v = from_bullet(quatRotate(q, v[k]));
        body.w = from_bullet(quatRotate(q, w[k]));
      }
    }
  }

 private:
  // Where a body is in its multibody: -1 for the base.
  struct Link {
    btMultiBody* multibody = nullptr;
    int number = -1;
  };

  // Bodies from place k of the order to before the end.
  void add_tree(std::size_t k, std::size_t end) {
    const int root = trees_.order[k];
    const Body& base = scene_.bodies[at(root)];
    if (base.is_static() && end == k + 1) return add_static(root);
    multibodies_.push_back(std::make_unique<btMultiBody>(
        int(end - k) - 1, mass_of(base), inertia_of(base), base.is_static(), false));
    btMultiBody& tree = *multibodies_.back();
    tree.setUserIndex(int(slots_.size()));
    slots_.push_back({trees_.order.begin() + std::ptrdiff_t(k),
                      trees_.order.begin() + std::ptrdiff_t(end)});
    tree.setBasePos(to_bullet(glm::dvec3(base.x)));
    tree.setWorldToBaseRot(to_bullet(glm::dquat(base.q)).inverse());
    links_[at(root)] = {&tree, -1};
    for (std::size_t n = k + 1; n < end; ++n) add_link(tree, int(n - k) - 1, trees_.order[n]);
    tree.finalizeMultiDof();
    if (!base.is_static()) {
      tree.setBaseVel(to_bullet(glm::dvec3(base.v)));
      tree.setBaseOmega(to_bullet(glm::dvec3(base.w)));
    }
    for (std::size_t n = k + 1; n < end; ++n) {
      const btVector3 rate = to_bullet(start_rate(scene_, trees_, trees_.order[n]));
      tree.setJointVelMultiDof(int(n - k) - 1, static_cast<const btScalar*>(rate));
    }
    for (std::size_t n = k; n < end; ++n)
      if (const vec3& torque = scene_.bodies[at(trees_.order[n])].torque; torque != vec3(0))
        torques_.emplace_back(links_[at(trees_.order[n])], to_bullet(glm::dvec3(torque)));
    tree.setHasSelfCollision(false);
    tree.setLinearDamping(0);
    tree.setAngularDamping(0);
    tree.setMaxCoordinateVelocity(btScalar(1e9));
    tree.useRK4Integration(choice_.runge_kutta);
    world_->addMultiBody(&tree);
    if (with_colliders_)
      for (std::size_t n = k; n < end; ++n) add_collider(trees_.order[n]);
    for (std::size_t n = k + 1; n < end; ++n) drive(trees_.order[n]);
  }
  void add_link(btMultiBody& tree, int number, int slot) {
    const PeerJoint& joint = scene_.joints[at(trees_.joint[at(slot)])];
    const int parent_slot = trees_.parent[at(slot)];
    const Body &body = scene_.bodies[at(slot)], &parent = scene_.bodies[at(parent_slot)];
    links_[at(slot)] = {&tree, number};
    const int before = links_[at(parent_slot)].number;
    const btQuaternion q = to_bullet(glm::dquat(body.q)), p = to_bullet(glm::dquat(parent.q));
    const btQuaternion turn = q.inverse() * p;
    const btVector3 anchor = to_bullet(joint.anchor);
    const btVector3 to_pivot = quatRotate(p.inverse(), anchor - to_bullet(glm::dvec3(parent.x)));
    const btVector3 from_pivot = quatRotate(q.inverse(), to_bullet(glm::dvec3(body.x)) - anchor);
    // Coordinates grow where this body moves positively against its parent.
    const double sign = joint.body2 == slot ? 1 : -1;
    const btVector3 axis = quatRotate(q.inverse(), to_bullet(sign * joint.axis));
    const btScalar mass = mass_of(body);
    const btVector3 inertia = inertia_of(body);
    switch (joint.kind) {
      case PeerJoint::Kind::ball:
        tree.setupSpherical(number, mass, inertia, before, turn, to_pivot, from_pivot, true);
        break;
      case PeerJoint::Kind::hinge:
        tree.setupRevolute(number, mass, inertia, before, turn, axis, to_pivot, from_pivot, true);
        break;
      case PeerJoint::Kind::slider:
        tree.setupPrismatic(number, mass, inertia, before, turn, axis, to_pivot, from_pivot, true);
        break;
      case PeerJoint::Kind::fixed:
        tree.setupFixed(number, mass, inertia, before, turn, to_pivot, from_pivot);
        break;
    }
  }
  void add_collider(int slot) {
    const Link link = links_[at(slot)];
    const Body& body = scene_.bodies[at(slot)];
    const PeerShape& shape = scene_.shapes[at(slot)];
    colliders_.push_back(std::make_unique<btMultiBodyLinkCollider>(link.multibody, link.number));
    btMultiBodyLinkCollider* collider = colliders_.back().get();
    collider->setCollisionShape(parts_.add(shape));
    collider->setWorldTransform(pose_of(body));
    collider->setFriction(btScalar(shape.friction));
    world_->addCollisionObject(collider, BulletParts::group(shape), BulletParts::mask(shape));
    if (link.number < 0) link.multibody->setBaseCollider(collider);
    else link.multibody->getLink(link.number).m_collider = collider;
  }
  void drive(int slot) {
    const PeerJoint& joint = scene_.joints[at(trees_.joint[at(slot)])];
    const Link link = links_[at(slot)];
    if (joint.limited())
      add(std::make_unique<btMultiBodyJointLimitConstraint>(link.multibody, link.number,
                                                            btScalar(joint.limits.lower),
                                                            btScalar(joint.limits.upper)));
    if (joint.motor.strength == 0) return;
    auto motor = std::make_unique<btMultiBodyJointMotor>(link.multibody, link.number,
                                                         btScalar(joint.motor.speed), btScalar(0));
    motors_.emplace_back(motor.get(), double(joint.motor.strength));
    add(std::move(motor));
  }
  void add(std::unique_ptr<btMultiBodyConstraint> constraint) {
    constraint->finalizeMultiDof();
    world_->addMultiBodyConstraint(constraint.get());
    constraints_.push_back(std::move(constraint));
  }
  void add_static(int slot) {
    const PeerShape& shape = scene_.shapes[at(slot)];
    btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, parts_.add(shape));
    info.m_startWorldTransform = pose_of(scene_.bodies[at(slot)]);
    info.m_friction = btScalar(shape.friction);
    statics_.push_back(std::make_unique<btRigidBody>(info));
    world_->addRigidBody(statics_.back().get(), BulletParts::group(shape),
                         BulletParts::mask(shape));
  }
  // A loop of a ball closes at a point, one of a hinge at two points of its axis.
  void close(const PeerJoint& joint) {
    const bool is_hinge = joint.kind == PeerJoint::Kind::hinge;
    for (const double side : {0.5, -0.5}) {
      const btVector3 point = to_bullet(joint.anchor + (is_hinge ? side : 0) * joint.axis);
      const Link a = links_[at(joint.body1)], b = links_[at(joint.body2)];
      const btVector3 on_a = pose_of(scene_.bodies[at(joint.body1)]).invXform(point),
                      on_b = pose_of(scene_.bodies[at(joint.body2)]).invXform(point);
      if (a.multibody && b.multibody)
        add(std::make_unique<btMultiBodyPoint2Point>(a.multibody, a.number, b.multibody, b.number,
                                                     on_a, on_b));
      else  // the other one is static: a place of the world
        add(std::make_unique<btMultiBodyPoint2Point>(
            a.multibody ? a.multibody : b.multibody, a.multibody ? a.number : b.number,
            static_cast<btRigidBody*>(nullptr), a.multibody ? on_a : on_b, point));
      if (!is_hinge) break;
    }
  }

  BulletChoice choice_;
  PeerScene scene_;
  Trees trees_;
  std::vector<Link> links_;  // of the slots
  bool with_colliders_;
  BulletParts parts_;
  btMultiBodyConstraintSolver solver_;
  std::unique_ptr<btMultiBodyDynamicsWorld> world_;
  std::vector<std::unique_ptr<btMultiBody>> multibodies_;
  std::vector<std::vector<int>> slots_;  // of each: base, then its links
  std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders_;
  std::vector<std::unique_ptr<btMultiBodyConstraint>> constraints_;
  std::vector<std::pair<btMultiBodyJointMotor*, double>> motors_;  // with their strength
  std::vector<std::unique_ptr<btRigidBody>> statics_;
  std::vector<std::pair<Link, btVector3>> torques_;  // from outside
};

}  // namespace

std::unique_ptr<Peer> bullet_trees(const PeerScene& scene, const BulletChoice& choice) {
  return std::make_unique<BulletTrees>(scene, choice);
}

}  // namespace joints::bench
