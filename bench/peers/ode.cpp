// ODE: bodies in maximal coordinates, its iterative and its dense step.
#include "bench/peers/peer.h"

#include <numbers>

#include <ode/ode.h>
#include <ode/version.h>

namespace joints::bench {

namespace {

// What is set in it.
struct Choice {
  int iterations = 20;  // of the iterative step; 0: the dense one
  int substeps = 1;
  double erp = 0.2;     // fraction of the error fed back in a step
  double layer = 0;     // depth that is not corrected [m]
  double push = 0;      // greatest speed of the correction of a contact [m/s]; 0: unbounded
  double cfm = -1;      // softness of all rows; -1: its default
};

class OdeWorld : public Peer {
 public:
  OdeWorld(const PeerScene& scene, const Choice& choice) : choice_(choice) {
    dRandSetSeed(0);  // its iterations change the order of the rows at random
    world_ = dWorldCreate();
    space_ = dHashSpaceCreate(nullptr);
    contacts_ = dJointGroupCreate(0);
    dWorldSetGravity(world_, scene.gravity.x, scene.gravity.y, scene.gravity.z);
    dWorldSetERP(world_, choice.erp);
    dWorldSetContactSurfaceLayer(world_, choice.layer);
    if (choice.push > 0) dWorldSetContactMaxCorrectingVel(world_, choice.push);
    if (choice.cfm >= 0) dWorldSetCFM(world_, choice.cfm);
    dWorldSetQuickStepNumIterations(world_, std::max(1, choice.iterations));
    for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
      bodies_.push_back(add(scene.bodies[k]));
      add(scene.shapes[k], bodies_.back(), scene.bodies[k], scene.heap);
    }
    for (const PeerJoint& joint : scene.joints) add(joint);
  }
  ~OdeWorld() override {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }
  OdeWorld(const OdeWorld&) = delete;
  OdeWorld& operator=(const OdeWorld&) = delete;

  void step(double h) override {
    for (int n = 0; n < choice_.substeps; ++n) {
      if (dSpaceGetNumGeoms(space_) > 0) dSpaceCollide(space_, this, touch);
      const double part = h / choice_.substeps;
      for (const auto& [body, w] : torques_) dBodyAddTorque(body, w.x, w.y, w.z);
      choice_.iterations > 0 ? dWorldQuickStep(world_, part) : dWorldStep(world_, part);
      dJointGroupEmpty(contacts_);
    }
  }
  void show(Bodies& bodies) override {
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      if (!bodies_[k]) continue;
      Body& body = bodies.at(int(k));
      const dReal* q = dBodyGetQuaternion(bodies_[k]);
      body.x = vector(dBodyGetPosition(bodies_[k]));
      body.q = quat(real(q[0]), real(q[1]), real(q[2]), real(q[3]));
      body.v = vector(dBodyGetLinearVel(bodies_[k]));
      body.w = vector(dBodyGetAngularVel(bodies_[k]));
    }
  }

 private:
  static vec3 vector(const dReal* a) { return vec3(real(a[0]), real(a[1]), real(a[2])); }

  dBodyID add(const Body& body) {
    if (body.is_static()) return nullptr;  // the world itself
    const dBodyID id = dBodyCreate(world_);
    dMass mass;
    const glm::dvec3 inertia = 1.0 / glm::dvec3(body.inverse_inertia_local);
    dMassSetParameters(&mass, 1 / double(body.inverse_mass), 0, 0, 0, inertia.x, inertia.y,
                       inertia.z, 0, 0, 0);
    dBodySetMass(id, &mass);
    const dQuaternion q{double(body.q.w), double(body.q.x), double(body.q.y), double(body.q.z)};
    dBodySetPosition(id, double(body.x.x), double(body.x.y), double(body.x.z));
    dBodySetQuaternion(id, q);
    dBodySetLinearVel(id, double(body.v.x), double(body.v.y), double(body.v.z));
    dBodySetAngularVel(id, double(body.w.x), double(body.w.y), double(body.w.z));
    dBodySetAutoDisableFlag(id, 0);
    if (body.torque != vec3(0)) torques_.emplace_back(id, glm::dvec3(body.torque));
    return id;
  }
  void add(const PeerShape& shape, dBodyID id, const Body& body, bool heap) {
    dGeomID geom = nullptr;
    if (shape.kind == PeerShape::Kind::plane) {
      const glm::dvec3 up(to_world(body, vec3(0, 1, 0)));
      geom = dCreatePlane(space_, up.x, up.y, up.z, dot(up, glm::dvec3(body.x)) + shape.height);
    } else if (shape.kind == PeerShape::Kind::box) {
      geom = dCreateBox(space_, 2 * shape.half.x, 2 * shape.half.y, 2 * shape.half.z);
    } else if (shape.kind == PeerShape::Kind::ball) {
      geom = dCreateSphere(space_, shape.half.x);
    } else if (shape.kind == PeerShape::Kind::capsule) {
      geom = dCreateCapsule(space_, shape.half.x, 2 * shape.half.y);
    } else {
      return;
    }
    if (id) {
      dGeomSetBody(geom, id);
      dMatrix3 turn;  // a capsule of ODE is parallel to z
      dRFromAxisAndAngle(turn, 1, 0, 0, -std::numbers::pi / 2);
      if (shape.kind == PeerShape::Kind::capsule) dGeomSetOffsetRotation(geom, turn);
    } else if (shape.kind != PeerShape::Kind::plane) {
      const dQuaternion q{double(body.q.w), double(body.q.x), double(body.q.y), double(body.q.z)};
      dGeomSetPosition(geom, double(body.x.x), double(body.x.y), double(body.x.z));
      dGeomSetQuaternion(geom, q);
    }
    dGeomSetCategoryBits(geom, shape.is_ground ? 1 : 2);
    dGeomSetCollideBits(geom, heap ? 3 : shape.is_ground ? 2 : 1);
    frictions_.push_back(shape.friction);
    dGeomSetData(geom, reinterpret_cast<void*>(frictions_.size() - 1));
  }
  // Rates are those of the first body against the second: ours is the other way round.
  void add(const PeerJoint& joint) {
    const dBodyID first = bodies_[std::size_t(joint.body2)],
                  second = bodies_[std::size_t(joint.body1)];
    const glm::dvec3 &p = joint.anchor, &a = joint.axis;
    dJointID id = nullptr;
    switch (joint.kind) {
      case PeerJoint::Kind::ball:
        id = dJointCreateBall(world_, nullptr);
        dJointAttach(id, first, second);
        dJointSetBallAnchor(id, p.x, p.y, p.z);
        break;
      case PeerJoint::Kind::hinge:
        id = dJointCreateHinge(world_, nullptr);
        dJointAttach(id, first, second);
        dJointSetHingeAnchor(id, p.x, p.y, p.z);
        dJointSetHingeAxis(id, a.x, a.y, a.z);
        drive(joint, [id](int what, double value) { dJointSetHingeParam(id, what, value); });
        break;
      case PeerJoint::Kind::slider:
        id = dJointCreateSlider(world_, nullptr);
        dJointAttach(id, first, second);
        dJointSetSliderAxis(id, a.x, a.y, a.z);
        drive(joint, [id](int what, double value) { dJointSetSliderParam(id, what, value); });
        break;
      case PeerJoint::Kind::fixed:
        id = dJointCreateFixed(world_, nullptr);
        dJointAttach(id, first, second);
        dJointSetFixed(id);
        break;
    }
  }
  template <class Set>
  static void drive(const PeerJoint& joint, Set set) {
    if (joint.limited()) {
      set(dParamLoStop, double(joint.limits.lower));
      set(dParamHiStop, double(joint.limits.upper));
    }
    if (joint.motor.strength > 0) {
      set(dParamVel, double(joint.motor.speed));
      set(dParamFMax, double(joint.motor.strength));
    }
  }
  static void touch(void* self, dGeomID a, dGeomID b) {
    auto& world = *static_cast<OdeWorld*>(self);
    const dBodyID first = dGeomGetBody(a), second = dGeomGetBody(b);
    if (first && second && dAreConnectedExcluding(first, second, dJointTypeContact)) return;
    constexpr int most = 8;
    dContact contacts[most];
    const int count = dCollide(a, b, most, &contacts[0].geom, sizeof(dContact));
    const auto friction = [&](dGeomID geom) {
      return world.frictions_[reinterpret_cast<std::size_t>(dGeomGetData(geom))];
    };
    for (int k = 0; k < count; ++k) {
      contacts[k].surface.mode = dContactApprox1;
      contacts[k].surface.mu = friction(a) * friction(b);
      const dJointID id = dJointCreateContact(world.world_, world.contacts_, &contacts[k]);
      dJointAttach(id, first, second);
    }
  }

  Choice choice_;
  dWorldID world_ = nullptr;
  dSpaceID space_ = nullptr;
  dJointGroupID contacts_ = nullptr;
  std::vector<dBodyID> bodies_;
  std::vector<std::pair<dBodyID, glm::dvec3>> torques_;  // from outside
  std::vector<double> frictions_;  // of the geometries
};

PeerSetting ode_setting(const std::string& name, const Choice& choice) {
  static const bool started = dInitODE2(0) != 0 && dAllocateODEDataForThread(dAllocateMaskAll) != 0;
  if (!started) refuse("ODE: does not start");
  return {.engine = "ODE", .version = dODE_VERSION,
          .number = sizeof(dReal) == 8 ? "double" : "float", .name = name,
          .exact = choice.iterations == 0, .substeps = choice.substeps,
          .make = [choice](const PeerScene& scene) {
            return std::make_unique<OdeWorld>(scene, choice);
          }};
}

}  // namespace

std::vector<PeerSetting> ode_heap_settings() {
  std::vector<PeerSetting> out{ode_setting("20 iterations (its default)", {})};
  for (const auto& [substeps, iterations] : {std::pair{1, 50}, {4, 10}, {4, 50}, {16, 50}})
    out.push_back(ode_setting(std::to_string(substeps) + " substeps of " +
                                  std::to_string(iterations) + " with a layer",
                              {.iterations = iterations, .substeps = substeps, .layer = 1e-3,
                               .push = 0.8, .cfm = 1e-5}));
  return out;
}

std::vector<PeerSetting> ode_settings(bool search) {
  std::vector<PeerSetting> out;
  const auto add = [&](const std::string& name, const Choice& choice, bool quick,
                       int most_joints = 5000) {
    out.push_back(ode_setting(name, choice));
    out.back().quick = quick, out.back().most_joints = most_joints;
  };
  if (search) {
    for (const int substeps : {1, 4, 16})
      for (const int iterations : {0, 60 / substeps, 240 / substeps})
        for (const double erp : {0.2, 0.5, 0.8, 1.0}) {
          const std::string words = iterations ? std::to_string(iterations) + " iterations"
                                               : std::string("dense");
          add(std::to_string(substeps) + " x " + words + " erp " + std::to_string(erp).substr(0, 3),
              {iterations, substeps, erp}, true, iterations ? 5000 : 100);
        }
    return out;
  }
  const int few = 1000;  // joints: a dense step takes time as their cube
  add("20 iterations (its default)", {}, true, 0);
  out.back().basic = true;
  add("10 iterations", {.iterations = 10}, true);
  add("60 iterations", {.iterations = 60}, true);
  add("200 iterations", {.iterations = 200}, false);
  add("16 substeps of 4 iterations", {.iterations = 4, .substeps = 16}, false);
  add("16 substeps of 4 iterations erp 1", {.iterations = 4, .substeps = 16, .erp = 1}, true);
  add("16 substeps of 15 iterations erp 1", {.iterations = 15, .substeps = 16, .erp = 1}, false);
  add("dense", {.iterations = 0}, false, few);
  out.back().slow = true;
  add("dense erp 1", {.iterations = 0, .erp = 1}, true, 100);
  add("60 iterations erp 1", {.iterations = 60, .erp = 1}, false);
  out.back().swept = true;
  add("dense 4 substeps erp 1", {.iterations = 0, .substeps = 4, .erp = 1}, false, 100);
  add("dense 16 substeps", {.iterations = 0, .substeps = 16}, true, 100);
  return out;
}

}  // namespace joints::bench
