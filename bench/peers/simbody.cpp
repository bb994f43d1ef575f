// Simbody: reduced coordinates, with steps of equal length of three of its integrators. Trees
// without drives and contacts alone.
#include "bench/peers/peer.h"
#include "bench/peers/simbody_tree.h"

namespace joints::bench {

namespace {

std::size_t at(int slot) { return std::size_t(slot); }

class SimbodyWorld : public Peer {
 public:
  SimbodyWorld(const PeerScene& scene, SimbodyMethod method) {
    const Trees trees = trees_of(scene);
    std::vector<int> number(scene.bodies.size(), -1);  // of the slots; static ones are the ground
    std::vector<SimbodyLink> links;
    for (const int slot : trees.order) {
      const Body& body = scene.bodies[at(slot)];
      if (body.is_static()) continue;
      number[at(slot)] = int(links.size());
      slots_.push_back(slot);
      links.push_back({.mass = 1 / double(body.inverse_mass),
                       .inertia = 1.0 / glm::dvec3(body.inverse_inertia_local),
                       .x = glm::dvec3(body.x), .q = glm::dquat(body.q), .v = glm::dvec3(body.v),
                       .w = glm::dvec3(body.w), .torque = glm::dvec3(body.torque)});
      const int k = trees.joint[at(slot)];
      if (k < 0) continue;
      const PeerJoint& joint = scene.joints[at(k)];
      SimbodyLink& link = links.back();
      link.parent = number[at(trees.parent[at(slot)])];
      link.anchor = joint.anchor;
      link.axis = joint.body2 == slot ? joint.axis : -joint.axis;
      switch (joint.kind) {
        case PeerJoint::Kind::ball: link.joint = SimbodyLink::Joint::ball; break;
        case PeerJoint::Kind::hinge: link.joint = SimbodyLink::Joint::hinge; break;
        case PeerJoint::Kind::slider: link.joint = SimbodyLink::Joint::slider; break;
        case PeerJoint::Kind::fixed: link.joint = SimbodyLink::Joint::weld; break;
      }
    }
    tree_ = std::make_unique<SimbodyTree>(links, scene.gravity, method);
  }
  void step(double h) override { tree_->step(h); }
  void show(Bodies& bodies) override {
    const std::vector<SimbodyLink> links = tree_->now();
    for (std::size_t k = 0; k < links.size(); ++k) {
      Body& body = bodies.at(slots_[k]);
      body.x = vec3(links[k].x), body.q = quat(links[k].q);
      body.v = vec3(links[k].v), body.w = vec3(links[k].w);
    }
  }

 private:
  std::vector<int> slots_;  // of the links
  std::unique_ptr<SimbodyTree> tree_;
};

}  // namespace

std::vector<PeerSetting> simbody_settings(bool search) {
  std::vector<PeerSetting> out;
  if (search) return out;
  for (const auto& [name, method] :
       {std::pair{"Runge-Kutta-Merson", SimbodyMethod::runge_kutta},
        {"Verlet", SimbodyMethod::verlet}, {"semi-explicit Euler", SimbodyMethod::euler}})
    out.push_back({.engine = "Simbody", .version = SimbodyTree::version(), .number = "double",
                   .name = name, .quick = true, .most_joints = 1000, .exact = true,
                   .substeps = method == SimbodyMethod::euler ? 1 : 0, .reduced = true,
                   .trees_only = true, .make = [method = method](const PeerScene& scene) {
                     return std::make_unique<SimbodyWorld>(scene, method);
                   }});
  return out;
}

}  // namespace joints::bench
