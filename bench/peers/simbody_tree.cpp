// A tree of Simbody in plain numbers.
#include "bench/peers/simbody_tree.h"

#include <Simbody.h>

#include <stdexcept>

namespace joints::bench {

namespace {

SimTK::Vec3 to_simbody(const glm::dvec3& a) { return {a.x, a.y, a.z}; }
glm::dvec3 from_simbody(const SimTK::Vec3& a) { return {a[0], a[1], a[2]}; }
SimTK::Transform pose_of(const SimbodyLink& link) {
  const glm::dquat& q = link.q;
  return {SimTK::Rotation(SimTK::Quaternion(q.w, q.x, q.y, q.z)), to_simbody(link.x)};
}
// Where the joint is and how its axes are turned, in the world.
SimTK::Transform frame_of(const SimbodyLink& link) {
  SimTK::Rotation turn;
  if (link.axis != glm::dvec3(0)) {
    const bool slides = link.joint == SimbodyLink::Joint::slider;
    turn.setRotationFromOneAxis(SimTK::UnitVec3(to_simbody(link.axis)),
                                slides ? SimTK::CoordinateAxis(SimTK::XAxis)
                                       : SimTK::CoordinateAxis(SimTK::ZAxis));
  }
  return {turn, to_simbody(link.anchor)};
}

SimTK::MobilizedBodyIndex joined(SimbodyLink::Joint joint, SimTK::MobilizedBody& base,
                                 const SimTK::Transform& on_base, const SimTK::Body& body,
                                 const SimTK::Transform& on_body) {
  using SimTK::MobilizedBody;
  switch (joint) {
    case SimbodyLink::Joint::hinge: return MobilizedBody::Pin(base, on_base, body, on_body);
    case SimbodyLink::Joint::slider: return MobilizedBody::Slider(base, on_base, body, on_body);
    case SimbodyLink::Joint::ball: return MobilizedBody::Ball(base, on_base, body, on_body);
    case SimbodyLink::Joint::weld: return MobilizedBody::Weld(base, on_base, body, on_body);
    default: return MobilizedBody::Free(base, on_base, body, on_body);
  }
}

// Its own exceptions, where numbers are no longer finite, as ours.
template <class Act>
void unless_lost(Act act) {
  try {
    act();
  } catch (const std::exception&) {
    throw std::runtime_error("Simbody: it gives up");
  }
}

}  // namespace

struct SimbodyTree::Parts {
  SimbodyMethod method;
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter{system};
  SimTK::GeneralForceSubsystem forces{system};
  std::vector<SimTK::MobilizedBodyIndex> bodies;  // of the links
  SimTK::State start;
  double time = 0;
  std::unique_ptr<SimTK::Integrator> integrator;
  std::unique_ptr<SimTK::TimeStepper> stepper;

  void begin(double h) {
    if (method == SimbodyMethod::euler)
      integrator = std::make_unique<SimTK::SemiExplicitEulerIntegrator>(system, h);
    else if (method == SimbodyMethod::verlet)
      integrator = std::make_unique<SimTK::VerletIntegrator>(system, h);
    else
      integrator = std::make_unique<SimTK::RungeKuttaMersonIntegrator>(system);
    integrator->setFixedStepSize(h);
    stepper = std::make_unique<SimTK::TimeStepper>(system, *integrator);
    stepper->initialize(start);
  }
};

SimbodyTree::SimbodyTree(const std::vector<SimbodyLink>& links, const glm::dvec3& gravity,
                         SimbodyMethod method)
    : parts_(std::make_unique<Parts>()) {
  Parts& my = *parts_;
  my.method = method;
  SimTK::Force::UniformGravity(my.forces, my.matter, to_simbody(gravity));
  for (const SimbodyLink& link : links) {
    const bool grounded = link.parent < 0, free = link.joint == SimbodyLink::Joint::free;
    const SimTK::Transform frame = free ? pose_of(link) : frame_of(link),
                           base = grounded ? SimTK::Transform()
                                           : pose_of(links[std::size_t(link.parent)]);
    const SimTK::Body::Rigid body(SimTK::MassProperties(
        link.mass, SimTK::Vec3(0), SimTK::Inertia(to_simbody(link.inertia))));
    SimTK::MobilizedBody& parent = my.matter.updMobilizedBody(
        grounded ? SimTK::GroundIndex : my.bodies[std::size_t(link.parent)]);
    my.bodies.push_back(joined(link.joint, parent, ~base * frame, body, ~pose_of(link) * frame));
    if (link.torque != glm::dvec3(0))
      SimTK::Force::ConstantTorque(my.forces, my.matter.getMobilizedBody(my.bodies.back()),
                                   to_simbody(link.torque));
  }
  my.start = my.system.realizeTopology();
  my.system.realize(my.start, SimTK::Stage::Position);
  for (std::size_t k = 0; k < links.size(); ++k) {  // the rates of the joints
    const SimbodyLink &link = links[k],
                      parent = link.parent < 0 ? SimbodyLink() : links[std::size_t(link.parent)];
    const SimTK::Transform frame =
        link.joint == SimbodyLink::Joint::free ? pose_of(link) : frame_of(link);
    const glm::dvec3 place = from_simbody(frame.p());
    const auto velocity = [&](const SimbodyLink& of) {
      return of.v + glm::cross(of.w, place - of.x);
    };
    my.matter.getMobilizedBody(my.bodies[k])
        .setUToFitVelocity(my.start,
                           {~frame.R() * to_simbody(link.w - parent.w),
                            ~frame.R() * to_simbody(velocity(link) - velocity(parent))});
  }
}
SimbodyTree::~SimbodyTree() = default;

void SimbodyTree::step(double h) {
  parts_->time += h;
  unless_lost([&] {
    if (!parts_->stepper) parts_->begin(h);
    parts_->stepper->stepTo(parts_->time);
  });
}

std::vector<SimbodyLink> SimbodyTree::now() const {
  const SimTK::State& state = parts_->stepper ? parts_->stepper->getState() : parts_->start;
  unless_lost([&] { parts_->system.realize(state, SimTK::Stage::Velocity); });
  std::vector<SimbodyLink> out;
  for (const SimTK::MobilizedBodyIndex k : parts_->bodies) {
    const SimTK::MobilizedBody& body = parts_->matter.getMobilizedBody(k);
    const SimTK::Transform& pose = body.getBodyTransform(state);
    const SimTK::Quaternion q = pose.R().convertRotationToQuaternion();
    SimbodyLink link;
    link.x = from_simbody(pose.p());
    link.q = glm::dquat(q[0], q[1], q[2], q[3]);
    link.w = from_simbody(body.getBodyAngularVelocity(state));
    link.v = from_simbody(body.getBodyOriginVelocity(state));
    out.push_back(link);
  }
  return out;
}

std::string SimbodyTree::version() {
  int major = 0, minor = 0, build = 0;
  SimTK_version_simbody(&major, &minor, &build);
  return std::to_string(major) + "." + std::to_string(minor) +
         (build > 0 ? "." + std::to_string(build) : "");
}

}  // namespace joints::bench
