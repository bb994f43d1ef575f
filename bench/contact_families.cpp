// The families with contacts: ragdolls, piles, boxes that are dropped at any tilt.
#include "bench/families.h"

#include "bench/chapters/08_ground/ragdoll.h"
#include "bench/draw.h"
#include "joints/driven_joints.h"

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

// A doll of ten boxes, from 10 cm to 2 m tall: cones and twists in neck, shoulders and hips, hinges
// that bend one way in elbows and knees.
Drawn limited_doll(Draw draw) {
  Drawn scene = with_contacts();
  World& world = scene.world;
  const BodyId ground = chapter8::add_ground(scene, 1000);
  const double size = draw.scale(0.1, 2);
  const quat q = draw.rotation();
  const vec3 middle(0, real(size * draw.number(0.8, 2)), 0);
  const auto at = [&](double x, double y) {
    return middle + q * vec3(real(size * x), real(size * (y - 0.5)), 0);
  };
  const auto part = [&](const vec3& edges, double x, double y) {
    const double volume = std::pow(size, 3) * double(edges.x * edges.y * edges.z);
    const double mass = draw.number(500, 1500) * volume;
    const BodyId id = scene.box(real(mass), real(size) * edges, at(x, y), q);
    chapter8::stand(scene, ground, id, real(size) * edges, real(draw.number(0.2, 1)));
    scene.energy_scale += 9.81 * mass * double(world.bodies[id].x.y);
    return id;
  };
  const auto cone = [&](BodyId a, BodyId b, double x, double y, const vec3& along) {
    auto& joint = world.add<ConeTwistJoint>(a, b, at(x, y), q * along, q * vec3(0, 0, 1),
                                            real(draw.number(0.5, 1.4)));
    const real twist = real(draw.number(0.3, 1));
    joint.twist().set_limits(-twist, twist);
    scene.mark(a, b, at(x, y));
  };
  const auto bend = [&](BodyId a, BodyId b, double x, double y, const vec3& axis) {
    world.add<HingeJoint>(a, b, at(x, y), q * axis)
        .set_limits(real(-0.03), real(draw.number(1.5, 2.5)));
    scene.mark(a, b, at(x, y));
  };
  const auto slim = [](double x, double y, double z) { return vec3(real(x), real(y), real(z)); };
  const BodyId torso = part(slim(0.2, 0.32, 0.12), 0, 0.66);
  cone(torso, part(slim(0.1, 0.13, 0.1), 0, 0.92), 0, 0.83, vec3(0, 1, 0));
  for (const int side : {-1, 1}) {
    const vec3 out(real(side), 0, 0), down(0, -1, 0);
    const BodyId upper = part(slim(0.18, 0.05, 0.05), side * 0.2, 0.79);
    cone(torso, upper, side * 0.11, 0.79, out);
    bend(upper, part(slim(0.16, 0.045, 0.045), side * 0.38, 0.79), side * 0.295, 0.79,
         vec3(0, real(-side), 0));
    const BodyId thigh = part(slim(0.08, 0.24, 0.08), side * 0.06, 0.37);
    cone(torso, thigh, side * 0.06, 0.5, down);
    bend(thigh, part(slim(0.06, 0.24, 0.06), side * 0.06, 0.12), side * 0.06, 0.245,
         vec3(1, 0, 0));
  }
  return scene;
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
          {"limited dolls", 80, of(limited_doll)},
          {"piles", 24, of(pile)},
          {"tilted boxes", 1000, of(tilted_box)}};
}

}  // namespace joints::bench
