// A world of ours as plain numbers, and another engine's world as a setting of the runner.
#include "bench/peers/peer.h"

#include <algorithm>

#include "contacts/ground_contact.h"
#include "joints/ball_joint.h"
#include "joints/fixed_joint.h"

namespace joints::bench {

namespace {

void add_contact(const GroundContact& contact, PeerScene& scene) {
  PeerShape &ground = scene.shapes[contact.body1.slot], &body = scene.shapes[contact.body2.slot];
  const Top& top = contact.top;
  ground.is_ground = true;
  if (top.half_x == unbounded) {
    ground.kind = PeerShape::Kind::plane;
    ground.height = double(top.height);
  } else {
    ground.kind = PeerShape::Kind::box;
    ground.half = {double(top.half_x), double(top.height), double(top.half_z)};
  }
  const bool is_box = contact.outline.count == 8;
  body.kind = is_box ? PeerShape::Kind::box : PeerShape::Kind::ball;
  body.half = is_box ? glm::dvec3(contact.outline.corners[7])
                     : glm::dvec3(double(contact.outline.radius));
  body.friction = double(contact.friction);
}

template <class Driven>
void add_drive(const Driven& joint, PeerJoint& out) {
  out.limits = joint.limits();
  out.motor = joint.motor();
}

}  // namespace

bool PeerScene::touches() const {
  return std::any_of(shapes.begin(), shapes.end(),
                     [](const PeerShape& one) { return one.kind != PeerShape::Kind::none; });
}

bool PeerScene::is_driven() const {
  return std::any_of(joints.begin(), joints.end(), [](const PeerJoint& one) {
    return one.limited() || one.motor.strength > 0;
  });
}

PeerScene peer_scene(const World& world) {
  PeerScene scene;
  scene.gravity = glm::dvec3(world.gravity);
  const std::span<const Body> bodies = all_of(world.bodies);
  scene.bodies.assign(bodies.begin(), bodies.end());
  scene.shapes.resize(bodies.size());
  for (const auto& joint : world.joints()) {
    if (const auto* contact = dynamic_cast<const GroundContact*>(joint.get())) {
      add_contact(*contact, scene);
      continue;
    }
    PeerJoint out{.body1 = int(joint->body1.slot), .body2 = int(joint->body2.slot)};
    const Body &body1 = world.bodies[joint->body1], &body2 = world.bodies[joint->body2];
    if (const auto* ball = dynamic_cast<const BallJoint*>(joint.get())) {
      out.anchor = glm::dvec3(world_point(body1, ball->part.anchor1_local));
    } else if (const auto* hinge = dynamic_cast<const HingeJoint*>(joint.get())) {
      out.kind = PeerJoint::Kind::hinge;
      out.anchor = glm::dvec3(world_point(body1, hinge->first.anchor1_local));
      out.axis = glm::dvec3(to_world(body1, hinge->second.a1_local));
      add_drive(*hinge, out);
    } else if (const auto* slider = dynamic_cast<const SliderJoint*>(joint.get())) {
      out.kind = PeerJoint::Kind::slider;
      out.anchor = glm::dvec3(world_point(body2, slider->first.anchor2_local));
      out.axis = glm::dvec3(to_world(body1, slider->coordinate().a1_local));
      add_drive(*slider, out);
    } else if (const auto* fixed = dynamic_cast<const FixedJoint*>(joint.get())) {
      out.kind = PeerJoint::Kind::fixed;
      out.anchor = glm::dvec3(world_point(body1, fixed->weld.first.anchor1_local));
    } else {
      refuse("joint: peers know balls, hinges, sliders, fixed joints and contacts alone");
    }
    scene.joints.push_back(out);
  }
  return scene;
}

Trees trees_of(const PeerScene& scene) {
  const std::size_t count = scene.bodies.size();
  std::vector<std::vector<int>> joints_at(count);
  for (std::size_t k = 0; k < scene.joints.size(); ++k)
    for (const int slot : {scene.joints[k].body1, scene.joints[k].body2})
      joints_at[std::size_t(slot)].push_back(int(k));
  Trees trees;
  trees.joint = trees.parent = trees.root = std::vector<int>(count, -1);
  std::vector<bool> used(scene.joints.size(), false);
  const auto grow = [&](int root) {
    std::size_t next = trees.order.size();
    trees.order.push_back(root);
    trees.root[std::size_t(root)] = root;
    for (; next < trees.order.size(); ++next) {
      const int slot = trees.order[next];
      for (const int k : joints_at[std::size_t(slot)]) {
        if (used[std::size_t(k)]) continue;
        used[std::size_t(k)] = true;
        const PeerJoint& joint = scene.joints[std::size_t(k)];
        const auto other = std::size_t(joint.body1 == slot ? joint.body2 : joint.body1);
        if (trees.root[other] >= 0 || scene.bodies[other].is_static()) {
          trees.loops.push_back(k);
          continue;
        }
        trees.root[other] = root;
        trees.parent[other] = slot;
        trees.joint[other] = k;
        trees.order.push_back(int(other));
      }
    }
  };
  for (const bool fixed : {true, false})
    for (std::size_t k = 0; k < count; ++k)
      if (trees.root[k] < 0 && scene.bodies[k].is_static() == fixed) grow(int(k));
  return trees;
}

glm::dvec3 start_rate(const PeerScene& scene, const Trees& trees, int slot) {
  const auto of = [](int k) { return std::size_t(k); };
  const PeerJoint& joint = scene.joints[of(trees.joint[of(slot)])];
  const Body &body = scene.bodies[of(slot)], &parent = scene.bodies[of(trees.parent[of(slot)])];
  const glm::dvec3 w(body.w - parent.w);
  const glm::dvec3 v(body.v - parent.v - cross(parent.w, body.x - parent.x));
  const glm::dvec3 axis = joint.body2 == slot ? joint.axis : -joint.axis;
  if (joint.kind == PeerJoint::Kind::ball) return conjugate(glm::dquat(body.q)) * w;
  if (joint.kind == PeerJoint::Kind::fixed) return glm::dvec3(0);
  return {dot(axis, joint.kind == PeerJoint::Kind::hinge ? w : v), 0, 0};
}

Setting PeerSetting::setting() const {
  Setting out;
  out.solver = engine;
  out.name = name;
  out.lag = substeps > 0 ? 0.5 / substeps : 0;
  out.satisfy = reduced;
  const auto peer = std::make_shared<std::unique_ptr<Peer>>();
  out.make = [peer, make_peer = make] {
    peer->reset();
    return [=](World& world, real h) {
      if (!*peer) *peer = make_peer(peer_scene(world));
      (*peer)->step(double(h));
    };
  };
  out.show = [peer](World& world) {
    if (*peer) (*peer)->show(world.bodies);
  };
  return out;
}

std::vector<PeerSetting> peer_settings([[maybe_unused]] bool search) {
  std::vector<PeerSetting> all;
  [[maybe_unused]] const auto add = [&](const std::vector<PeerSetting>& some) {
    all.insert(all.end(), some.begin(), some.end());
  };
#ifdef PEER_BULLET
  add(bullet_settings(search));
#endif
#ifdef PEER_ODE
  add(ode_settings(search));
#endif
#ifdef PEER_MUJOCO
  add(mujoco_settings(search));
#endif
#ifdef PEER_SIMBODY
  add(simbody_settings(search));
#endif
  return all;
}

}  // namespace joints::bench
