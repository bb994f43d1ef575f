// Scenes that the comparison does not know, drawn by a seed: mechanisms with and without loops,
// dolls, piles and balls on the ground, hubs, spinning things, from 1 mm to 100 m.
#pragma once

#include "bench/draw.h"
#include "comparison/compare.h"
#include "contacts/ground_contact.h"
#include "joints/ball_joint.h"
#include "joints/hinge_joint.h"
#include "joints/slider_joint.h"

namespace joints {

struct DrawnScene {
  const char* kind;
  double size;  // of a body [m]
  std::function<World()> make;
  Wish wish;
};

// Bodies of a density, in units of the scene's size.
struct Builder {
  bench::Draw draw;
  real size, h;
  World world{};
  bool soft = draw.chance(0.5);
  BodyId wall = world.add(static_body(vec3(0)));

  real mass_of(double volume) { return real(draw.number(500, 2000) * volume) * size * size * size; }
  BodyId box(const vec3& edges, const vec3& x, real factor = 1) {
    const real mass = factor * mass_of(double(edges.x * edges.y * edges.z));
    return world.add(joints::box(mass, size * edges, size * x));
  }
  BodyId ball(real radius, const vec3& x, real factor = 1) {
    const real mass = factor * mass_of(4 * double(radius * radius * radius));
    return world.add(joints::ball(mass, size * radius, size * x));
  }
  HingeJoint& hinge(BodyId a, BodyId b, const vec3& at, const vec3& axis = vec3(0, 0, 1)) {
    return world.add<HingeJoint>(a, b, size * at, axis);
  }
  void pin(BodyId a, BodyId b, const vec3& at) { world.add<BallJoint>(a, b, size * at); }
  void stand(BodyId below, BodyId body, const Top& top, const Outline& outline) {
    auto& contact = world.add<GroundContact>(below, body, top, outline);
    contact.friction = real(draw.number(0.2, 1));
    if (soft) contact.frequency = 1 / h, contact.damping = 10;
  }
};

// Eight kinds in turn, each of another size.
inline DrawnScene drawn_scene(unsigned seed) {
  const int which = int(seed % 8);
  const char* const kinds[] = {"chain with a load", "four-bar", "slider-crank",
                               "doll on the ground", "pile", "balls on the ground", "hub",
                               "spinning wheel"};
  bench::Draw draw(seed);
  const double size = draw.scale(1e-3, 100);
  const real h = real(std::sqrt(std::min(size, 1.0)) / 60);  // small things move fast
  const auto make = [=] {
    Builder b{.draw = bench::Draw(seed + 1000), .size = real(size), .h = h};
    auto& draw = b.draw;
    const vec3 up(0, 1, 0), beam(1, real(0.2), real(0.2));
    if (which == 0) {
      BodyId last = b.wall;
      const int count = draw.whole(2, 12);
      const real load = real(draw.scale(0.1, 300));
      for (int k = 1; k <= count; ++k) {
        const BodyId next = b.box(beam, vec3(real(k) - real(0.5), 0, 0), k == count ? load : 1);
        const vec3 at(real(k - 1), 0, 0);
        if (draw.chance(0.5)) b.hinge(last, next, at);
        else b.pin(last, next, at);
        last = next;
      }
    } else if (which == 1) {  // two posts, a long rod, or several such cells beside each other
      BodyId post = b.box(vec3(real(0.2), 1, real(0.2)), vec3(0, real(0.5), 0));
      b.hinge(b.wall, post, vec3(0));
      for (int k = 0, cells = draw.whole(1, 4); k < cells; ++k) {
        const BodyId rod = b.box(beam, vec3(real(k) + real(0.5), 1, 0), real(draw.scale(0.1, 10)));
        const BodyId next = b.box(vec3(real(0.2), 1, real(0.2)),
                                  vec3(real(k + 1), real(0.5), 0));
        b.hinge(post, rod, vec3(real(k), 1, 0));
        b.hinge(rod, next, vec3(real(k + 1), 1, 0));
        b.hinge(b.wall, next, vec3(real(k + 1), 0, 0));
        post = next;
      }
      b.world.gravity = vec3(3, real(-9.3), 0);  // all posts fall to one side
    } else if (which == 2) {
      const real crank = real(draw.number(0.3, 0.8));
      const BodyId arm = b.box(vec3(real(0.1), crank, real(0.1)), vec3(0, crank / 2, 0));
      const real reach = std::sqrt(4 - crank * crank);
      const vec3 top(0, crank, 0), end(reach, 0, 0);
      const BodyId rod = b.world.add(joints::box(
          b.mass_of(0.02), b.size * vec3(2, real(0.1), real(0.1)),
          b.size * real(0.5) * (top + end), rotation(vec3(0, 0, -std::asin(crank / 2)))));
      const BodyId piston = b.box(vec3(real(0.3)), end, real(draw.scale(0.1, 30)));
      b.hinge(b.wall, arm, vec3(0))
          .set_motor(real(draw.number(1, 6)) / (60 * h), 1000 * b.mass_of(10) * b.size);
      b.hinge(arm, rod, top);
      b.pin(rod, piston, end);
      b.world.add<SliderJoint>(b.wall, piston, b.size * end, vec3(1, 0, 0));
    } else if (which == 3) {  // a torso, a head and four limbs of two parts
      const real y = real(draw.number(3, 5));
      const BodyId torso = b.box(vec3(1, real(1.5), real(0.6)), vec3(0, y, 0));
      b.stand(b.wall, torso, {}, box_outline(b.size * vec3(1, real(1.5), real(0.6))));
      const BodyId head = b.ball(real(0.35), vec3(0, y + real(1.15), 0));
      b.pin(torso, head, vec3(0, y + real(0.78), 0));
      b.stand(b.wall, head, {}, ball_outline(b.size * real(0.35)));
      for (const int side : {-1, 1})
        for (const int low : {0, 1}) {
          const vec3 out = low ? vec3(0, -1, 0) : vec3(real(side), 0, 0);
          const vec3 at(real(side) * real(low ? 0.3 : 0.5), y + real(low ? -0.75 : 0.6), 0);
          const vec3 edges = low ? vec3(real(0.3), 1, real(0.3)) : vec3(1, real(0.25), real(0.25));
          const BodyId upper = b.box(edges, at + real(0.5) * out);
          const BodyId lower = b.box(edges, at + real(1.5) * out);
          b.pin(torso, upper, at);
          b.hinge(upper, lower, at + out, low ? vec3(1, 0, 0) : up).set_limits(real(-0.05), 2);
          b.stand(b.wall, upper, {}, box_outline(b.size * edges));
          b.stand(b.wall, lower, {}, box_outline(b.size * edges));
        }
      const quat tilt = draw.rotation();
      const vec3 middle = b.size * vec3(0, y, 0);
      for (int slot = 1; slot < b.world.bodies.slots(); ++slot) {
        Body& body = b.world.bodies.at(slot);
        body.x = middle + tilt * (body.x - middle), body.q = tilt * body.q;
      }
    } else if (which == 4) {
      BodyId below = b.wall;
      Top top{};
      for (int k = 0, count = draw.whole(2, 6); k < count; ++k) {
        const BodyId next = b.box(vec3(1), vec3(0, real(k) + real(0.5), 0));
        b.stand(below, next, top, box_outline(vec3(b.size)));
        below = next, top = box_top(vec3(b.size));
      }
    } else if (which == 5) {
      for (int k = 0, count = draw.whole(2, 8); k < count; ++k) {
        const real radius = real(draw.number(0.2, 0.6));
        const BodyId next = b.ball(radius, vec3(real(2 * k), radius + real(draw.number(0, 2)), 0));
        b.stand(b.wall, next, {}, ball_outline(b.size * radius));
        b.world.bodies[next].w = real(draw.number(0, 5)) / (60 * h) * draw.direction();
      }
    } else if (which == 6) {
      const BodyId hub = b.ball(real(0.2), vec3(0));
      b.pin(b.wall, hub, vec3(0));
      for (int k = 0, count = draw.whole(3, 16); k < count; ++k) {
        const vec3 out = draw.direction();
        const BodyId arm = b.ball(real(0.2), real(1.2) * out, real(draw.scale(0.3, 30)));
        b.pin(hub, arm, real(0.3) * out);
      }
    } else {  // a wheel on the end of an axle that leans out from a pivot
      const BodyId axle = b.box(beam, vec3(real(0.5), 0, 0));
      const BodyId wheel = b.box(vec3(real(0.2), 1, 1), vec3(1, 0, 0));
      b.pin(b.wall, axle, vec3(0));
      b.hinge(axle, wheel, vec3(1, 0, 0), vec3(1, 0, 0));
      b.world.bodies[wheel].w = vec3(real(draw.number(5, 50)) / (60 * h), 0, 0);
    }
    return std::move(b.world);
  };
  return {kinds[which], size, make,
          {.seconds = 60 * double(h), .h = h, .gap = 1e-3 * size, .depth = 1e-2 * size,
           .patience = 5}};
}

}  // namespace joints
