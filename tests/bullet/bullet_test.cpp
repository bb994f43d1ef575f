// Contacts that Bullet's collision part finds: stacks, capsules, ragdolls and a heap of 200 bodies.
#include <bullet_contacts.h>

#include "bench/draw.h"
#include "chapters/05_fixed/fixed_joint.h"
#include "engine/simd/packed.h"
#include "engine/step.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;
using bench::Draw;

// Bodies over a static slab whose top is at the height 0.
struct Heap {
  World world;
  BulletContacts shapes{world, h};
  PackedImpulses solver;
  BodyId ground = world.add(static_body(vec3(0, -1, 0)));
  Heap() {
    shapes.add_box(ground, vec3(100, 2, 100));
    solver.iterations = 4;
  }
  BodyId box(real mass, const vec3& size, const vec3& x, const quat& q = quat(1, 0, 0, 0)) {
    const BodyId id = world.add(joints::box(mass, size, x, q));
    shapes.add_box(id, size);
    return id;
  }
  void run(double seconds) {
    for (int n = 0; n < int(seconds * 60); ++n) {
      shapes.update();
      step(world, solver, h, {.warm_start = true, .substeps = 4});
    }
  }
  double fastest() const {
    double out = 0;
    for (int slot = 1; slot < world.bodies.slots(); ++slot)
      out = std::max(out, double(length(world.bodies.at(slot).v)));
    return out;
  }
  // The least gap of all contacts [m].
  double least_gap() const {
    double out = 0;
    for (const auto& joint : world.joints())
      if (const auto* contact = dynamic_cast<const ContactJoint*>(joint.get()))
        out = std::min(out, double(contact->gap(world.bodies)));
    return out;
  }
};

// A torso, a head, two arms and two legs.
std::vector<BodyId> add_doll(Heap& heap, const vec3& x) {
  World& world = heap.world;
  const BodyId torso = heap.box(40, vec3(real(0.6), 1, real(0.4)), x);
  std::vector<BodyId> out{torso};
  const auto limb = [&](real mass, const vec3& size, const vec3& at, const vec3& joint, bool weld) {
    const BodyId id = heap.box(mass, size, x + at);
    if (weld) world.add<FixedJoint>(torso, id, x + joint);
    else world.add<BallJoint>(torso, id,
                              point_at(world.bodies[torso], world.bodies[id], x + joint));
    out.push_back(id);
  };
  limb(6, vec3(real(0.35)), vec3(0, real(0.7), 0), vec3(0, real(0.5), 0), true);
  for (const real side : {real(1), real(-1)}) {
    limb(5, vec3(real(0.8), real(0.2), real(0.2)), vec3(side * real(0.75), real(0.4), 0),
         vec3(side * real(0.35), real(0.4), 0), false);
    limb(10, vec3(real(0.25), 1, real(0.25)), vec3(side * real(0.17), real(-1.05), 0),
         vec3(side * real(0.17), real(-0.5), 0), false);
  }
  return out;
}

double widest_gap(const World& world) {
  double widest = 0;
  Blocks blocks;
  blocks.errors_only = true;
  for (const auto& joint : world.joints())
    if (!joint->transient()) joint->append(world.bodies, blocks);
  for (const real C : blocks.C) widest = std::max(widest, std::abs(double(C)));
  return widest;
}

}  // namespace

TEST_CASE("ten boxes stand for a minute; turned against each other they creep, and stand") {
  for (const real turn : {real(0), real(0.3)}) {
    Heap heap;
    std::vector<BodyId> boxes;
    for (int k = 0; k < 10; ++k)
      boxes.push_back(heap.box(10, vec3(1), vec3(0, real(k) + real(0.5), 0),
                               rotation(vec3(0, real(k) * turn, 0))));
    heap.run(10);
    std::vector<vec3> settled;
    for (const BodyId id : boxes) settled.push_back(heap.world.bodies[id].x);
    heap.run(50);
    double drift = 0;
    for (std::size_t k = 0; k < boxes.size(); ++k)
      drift = std::max(drift, double(length(heap.world.bodies[boxes[k]].x - settled[k])));
    std::printf("bullet: ten boxes, turn %.1f: drift %.3f mm\n", double(turn), 1000 * drift);
    CAPTURE(turn, drift);
    CHECK(drift < (turn == 0 ? 1e-3 : 0.2));
  }
}

TEST_CASE("capsules roll out and come to rest lying") {
  Heap heap;
  for (int k = 0; k < 8; ++k) {
    const real radius = real(0.2), length = real(0.8);
    const BodyId id = heap.world.add(
        box(3, vec3(2 * radius, length + 2 * radius, 2 * radius), vec3(real(k), real(1.5), 0),
            rotation(vec3(0, 0, real(0.2) * real(k + 1)))));
    heap.shapes.add_capsule(id, radius, length);
  }
  heap.run(20);
  std::printf("bullet: capsules: fastest %.4f m/s, least gap %.3f mm\n", heap.fastest(),
              1000 * heap.least_gap());
  for (int slot = 1; slot < heap.world.bodies.slots(); ++slot)
    CHECK(double(heap.world.bodies.at(slot).x.y) == Approx(0.2).margin(0.02));
}

TEST_CASE("a ragdoll lands on a ragdoll, and both hold together and come to rest") {
  Heap heap;
  add_doll(heap, vec3(0, 2, 0));
  add_doll(heap, vec3(real(0.3), 5, real(0.1)));
  heap.shapes.contacts.skip_joined();
  double gap = 0;
  for (int n = 0; n < 100; ++n) {
    heap.run(0.1);
    gap = std::max(gap, widest_gap(heap.world));
  }
  std::printf("bullet: ragdolls: gap %.2f mm, fastest at the end %.4f m/s, least gap %.2f mm\n",
              1000 * gap, heap.fastest(), 1000 * heap.least_gap());
  CHECK(gap < 0.1);
  CHECK(heap.fastest() < 0.1);
}

TEST_CASE("200 bodies are poured on a heap: none falls through, and the heap comes to rest") {
  Heap heap;
  Draw draw(200);
  double deepest = 0;
  for (int k = 0; k < 200; ++k) {
    heap.run(0.1);
    deepest = std::min(deepest, heap.least_gap());
    const double side = k % 2 ? 0.8 : -0.8, front = k % 4 < 2 ? 0.8 : -0.8;  // they do not overlap
    const vec3 x(real(side + draw.number(-0.3, 0.3)), 5, real(front + draw.number(-0.3, 0.3)));
    const int kind = k % 3;
    if (kind == 0) {
      heap.box(real(draw.scale(1, 10)),
               vec3(real(draw.number(0.2, 0.6)), real(draw.number(0.2, 0.6)),
                    real(draw.number(0.2, 0.6))), x, draw.rotation());
    } else if (kind == 1) {
      const real radius = real(draw.number(0.1, 0.3));
      heap.shapes.add_ball(heap.world.add(ball(real(draw.scale(1, 10)), radius, x)), radius);
    } else {
      const BodyId id = heap.world.add(box(2, vec3(real(0.3), real(0.7), real(0.3)), x,
                                           draw.rotation()));
      heap.shapes.add_capsule(id, real(0.15), real(0.4));
    }
  }
  for (int n = 0; n < 200; ++n) {
    heap.run(0.1);
    deepest = std::min(deepest, heap.least_gap());
  }
  int below = 0, moving = 0;
  for (int slot = 1; slot < heap.world.bodies.slots(); ++slot) {
    below += heap.world.bodies.at(slot).x.y < 0;
    moving += double(length(heap.world.bodies.at(slot).v)) > 0.05;
  }
  std::printf("bullet: 200 bodies: %d pairs, deepest %.1f mm, %d below, %d faster than 5 cm/s\n",
              heap.shapes.contacts.count(), -1000 * deepest, below, moving);
  CHECK(below == 0);
  CHECK(deepest > -0.15);
}
