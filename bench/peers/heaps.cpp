// Heaps: the scenes, our own contacts, and a run.
#include "bench/peers/heaps.h"

#include <bullet_contacts.h>

#include <ctime>

#include "bench/draw.h"
#include "engine/simd/packed.h"
#include "engine/steps/step.h"
#include "joints/ball_joint.h"
#include "joints/fixed_joint.h"

namespace joints::bench {

namespace {

// ---- the scenes ---------------------------------------------------------------------------------

Heap on_ground(const std::string& name, double seconds) {
  Heap heap{.name = name, .seconds = seconds};
  heap.scene.gravity = {0, -9.81, 0};
  heap.scene.heap = true;
  heap.scene.bodies.push_back(static_body(vec3(0, -1, 0)));
  heap.scene.shapes.push_back({.kind = PeerShape::Kind::box, .half = {500, 1, 500},
                               .friction = std::sqrt(0.5)});  // 0.5 of every two bodies
  return heap;
}

int add(PeerScene& scene, const Body& body, PeerShape::Kind kind, const glm::dvec3& half) {
  scene.bodies.push_back(body);
  scene.shapes.push_back({.kind = kind, .half = half, .friction = std::sqrt(0.5)});
  return int(scene.bodies.size()) - 1;
}

int add_box(PeerScene& scene, double mass, const vec3& size, const vec3& x,
            const quat& q = quat(1, 0, 0, 0)) {
  return add(scene, joints::box(real(mass), size, x, q), PeerShape::Kind::box,
             glm::dvec3(size) / 2.0);
}

int add_capsule(PeerScene& scene, double mass, double radius, double length, const vec3& x,
                const quat& q) {
  const real wide = real(2 * radius);
  return add(scene, joints::box(real(mass), vec3(wide, real(length) + wide, wide), x, q),
             PeerShape::Kind::capsule, {radius, length / 2, 0});
}

Heap stack(const std::string& name, int count, double turn) {
  Heap heap = on_ground(name, 60);
  heap.stacked = true;
  for (int k = 0; k < count; ++k)
    add_box(heap.scene, 10, vec3(1), vec3(0, real(k + 0.5), 0),
            rotation(vec3(0, real(k * turn), 0)));
  return heap;
}

// Thirty stacks of 2 to 10 boxes of any size, each turned anyhow and a little off the one below.
Heap drawn_stacks() {
  Heap heap = on_ground("thirty drawn stacks", 30);
  heap.stacked = true;
  Draw draw(30);
  const auto number = [&](double from, double to) { return real(draw.number(from, to)); };
  for (int n = 0; n < 30; ++n) {
    vec3 top(real(5 * (n % 6 - 3)), 0, real(5 * (n / 6 - 3)));
    for (int k = draw.whole(2, 10); k > 0; --k) {
      const vec3 size{number(0.7, 1.4), number(0.4, 1.1), number(0.7, 1.4)};
      const double mass = draw.number(5, 20);
      const quat q = rotation(vec3(0, number(0, 6.3), 0));
      add_box(heap.scene, mass, size, top + vec3(0, size.y / 2, 0), q);
      top += vec3{number(-0.05, 0.05), size.y, number(-0.05, 0.05)};
    }
  }
  return heap;
}

// Boxes that are thrown along the ground, so far apart that they do not meet.
Heap thrown() {
  Heap heap = on_ground("ten thrown boxes", 4);
  Draw draw(10);
  for (int k = 0; k < 10; ++k) {
    const int id = add_box(heap.scene, 10, vec3(1, real(0.6), real(0.8)),
                           vec3(-20, 1, real(5 * k - 25)), draw.rotation());
    heap.scene.bodies[std::size_t(id)].v = vec3(10, 0, 0);
  }
  return heap;
}

Heap capsules() {
  Heap heap = on_ground("eight capsules", 20);
  for (int k = 0; k < 8; ++k)
    add_capsule(heap.scene, 3, 0.2, 0.8, vec3(real(k), real(1.5), 0),
                rotation(vec3(0, 0, real(0.2 * (k + 1)))));
  return heap;
}

// A torso, a head, two arms and two legs.
void add_doll(PeerScene& scene, const vec3& x) {
  const int torso = add_box(scene, 40, vec3(real(0.6), 1, real(0.4)), x);
  const auto limb = [&](double mass, const vec3& size, const vec3& at, const vec3& joint,
                        PeerJoint::Kind kind) {
    const int id = add_box(scene, mass, size, x + at);
    scene.joints.push_back({.kind = kind, .body1 = torso, .body2 = id,
                            .anchor = glm::dvec3(x + joint)});
  };
  limb(6, vec3(real(0.35)), vec3(0, real(0.7), 0), vec3(0, real(0.5), 0), PeerJoint::Kind::fixed);
  for (const real side : {real(1), real(-1)}) {
    limb(5, vec3(real(0.8), real(0.2), real(0.2)), vec3(side * real(0.75), real(0.4), 0),
         vec3(side * real(0.35), real(0.4), 0), PeerJoint::Kind::ball);
    limb(10, vec3(real(0.25), 1, real(0.25)), vec3(side * real(0.17), real(-1.05), 0),
         vec3(side * real(0.17), real(-0.5), 0), PeerJoint::Kind::ball);
  }
}

Heap dolls() {
  Heap heap = on_ground("ragdoll on ragdoll", 10);
  add_doll(heap.scene, vec3(0, 2, 0));
  add_doll(heap.scene, vec3(real(0.3), 5, real(0.1)));
  return heap;
}

// Eight layers of 25 bodies fall on each other.
Heap many() {
  Heap heap = on_ground("200 bodies", 20);
  Draw draw(200);
  for (int k = 0; k < 200; ++k) {
    const auto place = [&](int n) { return real(0.9 * n + draw.number(-0.05, 0.05)); };
    const vec3 x(place(k % 5 - 2), place(k / 25 + 1), place(k / 5 % 5 - 2));
    const double mass = draw.scale(1, 10);
    const auto size = [&] { return real(draw.number(0.2, 0.5)); };
    if (k % 3 == 0) {
      add_box(heap.scene, mass, vec3(size(), size(), size()), x, draw.rotation());
    } else if (k % 3 == 1) {
      const double radius = draw.number(0.1, 0.3);
      add(heap.scene, ball(real(mass), real(radius), x), PeerShape::Kind::ball, {radius, 0, 0});
    } else {
      add_capsule(heap.scene, mass, 0.15, 0.4, x, draw.rotation());
    }
  }
  return heap;
}

// ---- ours ---------------------------------------------------------------------------------------

// The bodies and shapes of a scene in a world of ours.
struct Shaped {
  World world;
  std::vector<BodyId> ids;
  BulletContacts contacts;
  // h: how far ahead the points are found [s]
  Shaped(const PeerScene& scene, int substeps, real h, bool all = true)
      : contacts(world, h, substeps) {
    if (!all) contacts.stay = 0;
    contacts.contacts.configure = [substeps](ContactJoint& joint) {
      joint.frequency = real(15 * substeps);
    };
    world.gravity = vec3(scene.gravity);
    for (const Body& body : scene.bodies) ids.push_back(world.add(body));
    for (std::size_t k = 0; k < ids.size(); ++k) {
      const PeerShape& shape = scene.shapes[k];
      const vec3 half(shape.half);
      if (shape.kind == PeerShape::Kind::ball) contacts.add_ball(ids[k], half.x);
      else if (shape.kind == PeerShape::Kind::capsule)
        contacts.add_capsule(ids[k], half.x, 2 * half.y);
      else contacts.add_box(ids[k], real(2) * half);
    }
    for (const PeerJoint& joint : scene.joints)
      contacts.contacts.skip(ids[std::size_t(joint.body1)], ids[std::size_t(joint.body2)]);
  }
};

class Ours : public Peer {
 public:
  Ours(const PeerScene& scene, int substeps, bool ahead, bool all)
      : shaped_(scene, substeps, ahead ? real(1) / 60 : real(1e-9), all), substeps_(substeps) {
    for (const PeerJoint& joint : scene.joints) {
      const BodyId a = shaped_.ids[std::size_t(joint.body1)],
                   b = shaped_.ids[std::size_t(joint.body2)];
      require(joint.kind == PeerJoint::Kind::ball || joint.kind == PeerJoint::Kind::fixed,
              "joint: heaps have balls and fixed joints alone");
      if (joint.kind == PeerJoint::Kind::ball)
        shaped_.world.add<BallJoint>(a, b, vec3(joint.anchor));
      else shaped_.world.add<FixedJoint>(a, b, vec3(joint.anchor));
    }
    solver_.iterations = 4;
  }
  void step(double h) override {
    shaped_.contacts.update();
    joints::step(shaped_.world, solver_, real(h), {.warm_start = true, .substeps = substeps_});
  }
  void show(Bodies& bodies) override {
    for (std::size_t k = 0; k < shaped_.ids.size(); ++k)
      if (!bodies.at(int(k)).is_static()) bodies.at(int(k)) = shaped_.world.bodies[shaped_.ids[k]];
  }

 private:
  Shaped shaped_;
  int substeps_;
  PackedImpulses solver_;
};

// ---- measures -----------------------------------------------------------------------------------

// The largest penetration at these poses.
double depth(const PeerScene& scene, const Bodies& bodies) {
  PeerScene still = scene;
  still.gravity = glm::dvec3(0);
  for (std::size_t k = 0; k < still.bodies.size(); ++k) {
    still.bodies[k] = bodies.at(int(k));
    still.bodies[k].v = still.bodies[k].w = vec3(0);
  }
  Shaped shaped(still, 1, real(1e-9));
  shaped.contacts.update();
  double out = 0;
  for (const auto& joint : shaped.world.joints())
    out = std::max(out,
                   -double(dynamic_cast<const ContactJoint&>(*joint).gap(shaped.world.bodies)));
  return out;
}

double widest_gap(const PeerScene& scene, const Bodies& bodies) {
  double out = 0;
  for (const PeerJoint& joint : scene.joints) {
    const auto at = [&](int slot) {
      const Body& first = scene.bodies[std::size_t(slot)];
      return world_point(bodies.at(slot), to_local(first, vec3(joint.anchor) - first.x));
    };
    out = std::max(out, double(length(at(joint.body2) - at(joint.body1))));
  }
  return out;
}

}  // namespace

std::vector<Heap> heaps() {
  return {stack("ten cubes", 10, 0), stack("ten turned cubes", 10, 0.3),
          stack("twenty cubes", 20, 0), drawn_stacks(), thrown(), capsules(), dolls(), many()};
}

PeerSetting our_contacts(int substeps, bool ahead, bool all) {
  return {.engine = "ours", .version = "", .number = "double",
          .name = std::to_string(substeps) + " substeps of 4" +
                  (ahead ? "" : " with points at the present poses") +
                  (all ? "" : " with the points of one step"),
          .make = [substeps, ahead, all](const PeerScene& scene) {
            return std::make_unique<Ours>(scene, substeps, ahead, all);
          }};
}

Heaped run_heap(const Heap& heap, const PeerSetting& who, double seconds) {
  const int steps = int(std::lround(60 * (seconds > 0 ? seconds : heap.seconds)));
  World seen;
  for (const Body& body : heap.scene.bodies) seen.add(body);
  const std::unique_ptr<Peer> world = who.make(heap.scene);
  Heaped out;
  std::vector<vec3> settled;
  for (int n = 0; n < steps; ++n) {
    const std::clock_t began = std::clock();
    world->step(1.0 / 60);
    out.seconds += double(std::clock() - began) / CLOCKS_PER_SEC;
    const bool ends = n == steps - 1;
    if (n % 6 && !ends && heap.seconds > 5) continue;
    world->show(seen.bodies);
    out.gap = std::max(out.gap, widest_gap(heap.scene, seen.bodies));
    out.deepest = std::max(out.deepest, out.depth = depth(heap.scene, seen.bodies));
    int moving = 0;
    for (int k = 1; k < seen.bodies.slots(); ++k) {
      const Body& body = seen.bodies.at(k);
      const double speed = length(body.v);
      moving += speed > 0.05;
      if (n >= steps - 60) out.fastest = std::max(out.fastest, speed);
      if (n == 600) settled.push_back(body.x);
    }
    out.moving = moving;
  }
  for (int k = 1; k < seen.bodies.slots(); ++k) {
    const vec3 x = seen.bodies.at(k).x, first = heap.scene.bodies[std::size_t(k)].x;
    out.fallen += !(x.y > 0) || (heap.stacked && !(x.y > first.y - real(0.2)));
    if (!settled.empty())
      out.drift = std::max(out.drift, double(length(x - settled[std::size_t(k - 1)])));
  }
  return out;
}

}  // namespace joints::bench
