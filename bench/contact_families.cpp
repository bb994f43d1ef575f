// The families with contacts: ragdolls, piles, boxes that are dropped at any tilt.
#include "bench/families.h"

#include "bench/draw.h"
#include "chapters/08_ground/program/ragdoll.h"

namespace joints::bench {

namespace {

Drawn with_contacts(Scene scene = {.name = {}, .energy_scale = 0}) {
  Drawn out;
  static_cast<Scene&>(out) = std::move(scene);
  out.keeps_energy = false;
  return out;
}

Drawn ragdoll(Draw draw) {
  chapter8::Ragdoll doll({}, real(draw.number(1.5, 4)), draw.rotation());
  return with_contacts(std::move(doll.scene));
}

// Boxes on each other, alike or not.
Drawn pile(Draw draw) {
  Drawn scene = with_contacts();
  BodyId below = chapter8::add_ground(scene, 10);
  vec3 of_below(10, real(0.2), 10);
  double top = 0;
  const bool alike = draw.chance(0.5);
  for (int k = draw.whole(2, 10); k > 0; --k) {
    const double edge = alike ? 1 : draw.number(0.7, 1.3);
    const vec3 edges(real(edge), real(alike ? 1 : draw.number(0.5, 1)), real(edge));
    top += double(edges.y) / 2;
    const vec3 x(0, real(top), 0);
    const BodyId next = scene.box(real(alike ? 10 : draw.scale(1, 100)), edges, x);
    scene.world.add<GroundContact>(below, next, box_top(of_below), box_outline(edges));
    top += double(edges.y) / 2;
    scene.energy_scale += 9.81 * top / double(scene.world.bodies[next].inverse_mass);
    below = next, of_below = edges;
  }
  return scene;
}

// A box of any shape that falls at any tilt, with any restitution and friction. Its energy is given
// by the height of its centre over the ground.
Drawn tilted_box(Draw draw) {
  Drawn scene = with_contacts();
  scene.between_steps = true, scene.most_gain = 0.01;
  const BodyId ground = scene.box(0, vec3(1000, real(0.2), 1000), vec3(0, real(-0.1), 0));
  const vec3 edges(real(draw.scale(0.2, 2)), real(draw.scale(0.2, 2)), real(draw.scale(0.2, 2)));
  const quat q = draw.rotation();
  const double drop = draw.number(0.2, 3);
  const real mass = real(draw.scale(1, 100));
  const BodyId box = scene.box(mass, edges, vec3(0), q);
  double reach = 0;
  const Outline outline = box_outline(edges);
  for (const vec3& corner : outline.corners) reach = std::max(reach, -double((q * corner).y));
  scene.world.bodies[box].x.y = real(reach + drop);
  auto& contact = scene.world.add<GroundContact>(
      ground, box, Top{.height = real(0.1)}, outline);
  contact.restitution = real(draw.number(0, 1));
  contact.friction = real(draw.number(0, 1));
  scene.energy_scale = double(mass) * 9.81 * (reach + drop);
  return scene;
}

}  // namespace

std::vector<Family> contact_families() {
  const auto of = [](auto make) { return [make](unsigned seed) { return make(Draw(seed)); }; };
  return {{"ragdolls", 40, of(ragdoll)},
          {"piles", 24, of(pile)},
          {"tilted boxes", 1000, of(tilted_box)}};
}

}  // namespace joints::bench
