// Bullet: bodies in maximal coordinates, with all of its solvers; and all of its settings.
#include "bench/peers/bullet.h"

#include <BulletDynamics/ConstraintSolver/btNNCGConstraintSolver.h>
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btLemkeSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>

namespace joints::bench {

namespace {

class BulletWorld : public Peer {
 public:
  BulletWorld(const PeerScene& scene, const BulletChoice& choice) : choice_(choice) {
    solver_ = solver(choice);
    world_ = std::make_unique<btDiscreteDynamicsWorld>(&parts_.dispatcher, &parts_.broadphase,
                                                       solver_.get(), &parts_.configuration);
    world_->setGravity(to_bullet(scene.gravity));
    btContactSolverInfo& info = world_->getSolverInfo();
    info.m_numIterations = choice.iterations;
    info.m_erp = btScalar(choice.erp);
    if (dense_) info.m_minimumSolverBatchSize = 1;  // one matrix an island, as its manual advises
    for (std::size_t k = 0; k < scene.bodies.size(); ++k)
      add(scene.bodies[k], scene.shapes[k], scene.heap);
    for (const PeerJoint& joint : scene.joints) add(joint, scene);
  }
  ~BulletWorld() override {
    for (const auto& joint : joints_) world_->removeConstraint(joint.get());
    for (const auto& body : bodies_) world_->removeRigidBody(body.get());
  }

  void step(double h) override {
    const auto part = btScalar(h / choice_.substeps);
    for (const auto& [hinge, motor] : motors_)  // its bound is an impulse, and its sign the other
      hinge->enableAngularMotor(true, -btScalar(motor.speed), btScalar(motor.strength) * part);
    for (int n = 0; n < choice_.substeps; ++n) {
      for (const auto& [body, torque] : torques_) body->applyTorque(torque);
      world_->stepSimulation(part, 0);
    }
  }
  void show(Bodies& bodies) override {
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      if (bodies_[k]->isStaticObject()) continue;
      Body& body = bodies.at(int(k));
      const btTransform& pose = bodies_[k]->getWorldTransform();
      body.x = from_bullet(pose.getOrigin());
      body.q = from_bullet(pose.getRotation());
      body.v = from_bullet(bodies_[k]->getLinearVelocity());
      body.w = from_bullet(bodies_[k]->getAngularVelocity());
    }
  }

 private:
  std::unique_ptr<btConstraintSolver> solver(const BulletChoice& choice) {
    switch (choice.solver) {
      case BulletChoice::Solver::conjugate: return std::make_unique<btNNCGConstraintSolver>();
      case BulletChoice::Solver::dantzig: dense_ = std::make_unique<btDantzigSolver>(); break;
      case BulletChoice::Solver::lemke: dense_ = std::make_unique<btLemkeSolver>(); break;
      default: return std::make_unique<btSequentialImpulseConstraintSolver>();
    }
    return std::make_unique<btMLCPSolver>(dense_.get());
  }
  void add(const Body& body, const PeerShape& shape, bool heap) {
    btRigidBody::btRigidBodyConstructionInfo info(mass_of(body), nullptr, parts_.add(shape),
                                                  inertia_of(body));
    info.m_startWorldTransform = pose_of(body);
    info.m_friction = btScalar(shape.friction);
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    bodies_.back()->setActivationState(DISABLE_DEACTIVATION);
    if (!body.is_static()) {
      bodies_.back()->setLinearVelocity(to_bullet(glm::dvec3(body.v)));
      bodies_.back()->setAngularVelocity(to_bullet(glm::dvec3(body.w)));
      if (body.torque != vec3(0))
        torques_.emplace_back(bodies_.back().get(), to_bullet(glm::dvec3(body.torque)));
    }
    world_->addRigidBody(bodies_.back().get(), BulletParts::group(shape),
                         BulletParts::mask(shape, heap));
  }
  void add(const PeerJoint& joint, const PeerScene& scene) {
    const auto at = [](int slot) { return std::size_t(slot); };
    btRigidBody &a = *bodies_[at(joint.body1)], &b = *bodies_[at(joint.body2)];
    const Body &body1 = scene.bodies[at(joint.body1)], &body2 = scene.bodies[at(joint.body2)];
    switch (joint.kind) {
      case PeerJoint::Kind::ball:
        joints_.push_back(std::make_unique<btPoint2PointConstraint>(
            a, b, pose_of(body1).invXform(to_bullet(joint.anchor)),
            pose_of(body2).invXform(to_bullet(joint.anchor))));
        break;
      case PeerJoint::Kind::hinge: add_hinge(joint, a, b, body1, body2); break;
      case PeerJoint::Kind::slider: add_slider(joint, a, b, body1, body2); break;
      case PeerJoint::Kind::fixed:
        joints_.push_back(std::make_unique<btFixedConstraint>(
            a, b, frame_at(joint, body1, btVector3(1, 0, 0)),
            frame_at(joint, body2, btVector3(1, 0, 0))));
        break;
    }
    world_->addConstraint(joints_.back().get(), true);
  }
  void add_hinge(const PeerJoint& joint, btRigidBody& a, btRigidBody& b, const Body& body1,
                 const Body& body2) {
    const btVector3 z(0, 0, 1);
    auto hinge = std::make_unique<btHingeConstraint>(a, b, frame_at(joint, body1, z),
                                                     frame_at(joint, body2, z));
    // The last number is a restitution, which is 1 unless it is set.
    if (joint.limited())
      hinge->setLimit(-btScalar(joint.limits.upper), -btScalar(joint.limits.lower),
                      btScalar(0.9), btScalar(0.3), 0);
    if (joint.motor.strength > 0) motors_.emplace_back(hinge.get(), joint.motor);
    joints_.push_back(std::move(hinge));
  }
  void add_slider(const PeerJoint& joint, btRigidBody& a, btRigidBody& b, const Body& body1,
                  const Body& body2) {
    const btVector3 x(1, 0, 0);
    auto slider = std::make_unique<btSliderConstraint>(a, b, frame_at(joint, body1, x),
                                                       frame_at(joint, body2, x), true);
    slider->setLowerLinLimit(joint.limited() ? btScalar(joint.limits.lower) : btScalar(1));
    slider->setUpperLinLimit(joint.limited() ? btScalar(joint.limits.upper) : btScalar(-1));
    slider->setLowerAngLimit(0);
    slider->setUpperAngLimit(0);
    if (joint.motor.strength > 0) {
      slider->setPoweredLinMotor(true);
      slider->setTargetLinMotorVelocity(btScalar(joint.motor.speed));
      slider->setMaxLinMotorForce(btScalar(joint.motor.strength));
    }
    joints_.push_back(std::move(slider));
  }

  BulletChoice choice_;
  BulletParts parts_;
  std::unique_ptr<btMLCPSolverInterface> dense_;
  std::unique_ptr<btConstraintSolver> solver_;
  std::unique_ptr<btDiscreteDynamicsWorld> world_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<std::unique_ptr<btTypedConstraint>> joints_;
  std::vector<std::pair<btHingeConstraint*, Motor>> motors_;
  std::vector<std::pair<btRigidBody*, btVector3>> torques_;  // from outside
};

std::string version() {
  return std::to_string(BT_BULLET_VERSION / 100) + "." + std::to_string(BT_BULLET_VERSION % 100);
}

PeerSetting bullet_setting(const std::string& name, const BulletChoice& choice) {
  return {.engine = "Bullet", .version = version(),
          .number = sizeof(btScalar) == 8 ? "double" : "float", .name = name,
          .exact = choice.solver >= BulletChoice::Solver::dantzig, .substeps = choice.substeps,
          .make = [choice](const PeerScene& scene) {
            return std::make_unique<BulletWorld>(scene, choice);
          }};
}

}  // namespace

std::vector<PeerSetting> bullet_heap_settings() {
  std::vector<PeerSetting> out{bullet_setting("10 iterations (its default)", {})};
  for (const auto& [substeps, iterations] : {std::pair{1, 50}, {4, 10}, {16, 4}, {16, 10}})
    out.push_back(bullet_setting(std::to_string(substeps) + " substeps of " +
                                     std::to_string(iterations),
                                 {.iterations = iterations, .substeps = substeps}));
  return out;
}

std::vector<PeerSetting> bullet_settings(bool search) {
  using Solver = BulletChoice::Solver;
  std::vector<PeerSetting> out;
  const auto add = [&](const std::string& name, const BulletChoice& choice, bool quick,
                       int most_joints = 5000) {
    out.push_back(bullet_setting(name, choice));
    out.back().quick = quick, out.back().most_joints = most_joints;
  };
  const auto add_trees = [&](const std::string& name, const BulletChoice& choice, bool quick,
                             int most_joints = 5000) {
    add("multibody" + name, choice, quick, most_joints);
    out.back().exact = out.back().reduced = true;
    if (choice.runge_kutta) out.back().substeps = 0;
    out.back().make = [choice](const PeerScene& scene) { return bullet_trees(scene, choice); };
  };
  if (search) {
    for (const int substeps : {1, 4, 16})
      for (const int iterations : {60 / substeps, 240 / substeps})
        for (const double erp : {0.2, 0.5, 0.8, 1.0})
          for (const Solver solver : {Solver::impulses, Solver::conjugate})
            add(std::to_string(substeps) + " x " + std::to_string(iterations) +
                    (solver == Solver::conjugate ? " conjugate" : "") + " erp " +
                    std::to_string(erp).substr(0, 3),
                {.solver = solver, .iterations = iterations, .substeps = substeps, .erp = erp},
                true);
    return out;
  }
  const int few = 500;  // joints: a dense step takes time as their cube, 0.13 s on S1
  add("10 iterations (its default)", {}, true, 0);
  out.back().basic = true;
  add("60 iterations", {.iterations = 60}, true);
  add("200 iterations", {.iterations = 200}, false);
  add("16 substeps of 4 iterations", {.iterations = 4, .substeps = 16}, false);
  add("16 substeps of 4 iterations erp 1", {.iterations = 4, .substeps = 16, .erp = 1}, true);
  add("16 substeps of 15 iterations erp 1", {.iterations = 15, .substeps = 16, .erp = 1}, false);
  add("conjugate 60 iterations", {.solver = Solver::conjugate, .iterations = 60}, false);
  add("Dantzig", {.solver = Solver::dantzig}, false, few);
  add("Dantzig erp 1", {.solver = Solver::dantzig, .erp = 1}, true, 100);
  add("60 iterations erp 1", {.iterations = 60, .erp = 1}, false);
  out.back().swept = true;
  add("Lemke", {.solver = Solver::lemke}, false, 50);
  out.back().contacts = false;
  add_trees("", {}, true, 0);
  out.back().basic = true;
  add_trees(" 8 substeps", {.substeps = 8}, true);
  add_trees(" Runge-Kutta", {.runge_kutta = true}, true);
  add_trees(" without split impulses", {.split = false}, true);
  return out;
}

}  // namespace joints::bench
