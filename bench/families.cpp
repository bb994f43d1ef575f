// The families of joints alone: chains with heavy ends, chains of all kinds, loops, hubs, arms.
#include "bench/families.h"

#include <algorithm>
#include <numbers>

#include "bench/chapters/09_direct/linkages.h"
#include "bench/draw.h"
#include "bench/random_chains.h"
#include "joints/slider_joint.h"

namespace joints::bench {

namespace {

constexpr double g = 9.81;
const vec3 down(0, -1, 0), level(1, 0, 0), across(0, 0, 1);

Drawn drawn(Scene scene = {.name = {}, .energy_scale = 0}) {
  Drawn out;
  static_cast<Scene&>(out) = std::move(scene);
  return out;
}

// ---- chains -------------------------------------------------------------------------------------

enum class Kind { ball, hinge, slider };

// Bodies in a row: each new one hangs on the last.
struct Row {
  Drawn& scene;
  BodyId last = scene.box(0, vec3(real(0.2)), vec3(0));
  double reach = 0;  // from the first body to the last [m]

  void end(BodyId wall, Kind kind, const vec3& anchor) {
    if (kind == Kind::ball) join_by_ball(scene, last, wall, anchor);
    else join_by_hinge(scene, last, wall, anchor, across);
  }
  void hang(BodyId next, Kind kind, const vec3& anchor, const vec3& axis, double travel = 0) {
    const Bodies& bodies = scene.world.bodies;
    reach += double(length(bodies[next].x - bodies[last].x)) + travel;
    if (kind == Kind::ball) join_by_ball(scene, last, next, anchor);
    if (kind == Kind::hinge) join_by_hinge(scene, last, next, anchor, axis);
    if (kind == Kind::slider) scene.world.add<SliderJoint>(last, next, anchor, axis);
    scene.energy_scale += g * reach / double(bodies[next].inverse_mass);
    last = next;
  }
};

// All bodies turn about the first one's centre, at this rate [rad/s].
void turn_all(Drawn& scene, const vec3& w) {
  for (int slot = 1; slot < scene.world.bodies.slots(); ++slot) {
    Body& body = scene.world.bodies.at(slot);
    body.w = w;
    body.v = cross(w, body.x);
  }
}

// Balls of m r^2 / I from 0.5 to 500, on balls or hinges; they hang, are let go level or whipped.
Drawn beads(Draw draw, double heaviest = 1e4) {
  Drawn scene = drawn();
  const int count = draw.whole(2, 60), start = draw.whole(0, 2);
  const double distance = draw.number(0.1, 1), inertia = draw.scale(0.5, 500);
  const double radius = distance / 2 / std::sqrt(0.4 * inertia), end = draw.scale(1, heaviest);
  const Kind kind = draw.chance(0.3) ? Kind::hinge : Kind::ball;
  const vec3 along = start == 0 ? down : level;
  Row row{scene};
  for (int k = 1; k <= count; ++k) {
    const vec3 x = real(k * distance) * along;
    row.hang(scene.ball(real(k == count ? end : 1), real(radius), x), kind,
             x - real(distance / 2) * along, across);
  }
  if (start == 2) turn_all(scene, real(draw.number(-2, 2) * std::sqrt(g / row.reach)) * across);
  for (int slot = 1; start == 0 && slot <= count; ++slot)
    scene.world.bodies.at(slot).v = real(1e-3) * cross(across, draw.direction());
  return scene;
}

// Cubes with an end of up to a million of them, let go level or below; or above, then the end falls
// freely until the chain stops it with a jerk.
Drawn heavy_ends(Draw draw, bool falls, double heaviest = 1e6) {
  Drawn scene = drawn();
  const int count = draw.whole(2, 30), kinds = draw.whole(0, 2);
  const double step = draw.number(0.3, 1), edge = step * draw.number(0.3, 0.9);
  const double end = draw.scale(1, heaviest);
  const double angle = falls ? draw.number(0, 1) : draw.number(-1, 0);
  const vec3 along(real(std::cos(angle)), real(std::sin(angle)), 0);
  Row row{scene};
  for (int k = 1; k <= count; ++k) {
    const vec3 x = real(k * step) * along;
    const bool hinge = kinds == 1 || (kinds == 2 && draw.chance(0.5));
    row.hang(k == count ? scene.ball(real(end), real(step / 2), x)
                        : scene.box(1, vec3(real(edge)), x),
             hinge ? Kind::hinge : Kind::ball, x - real(step / 2) * along, across);
  }
  return scene;
}

// One to four joints of any kind, bent anyhow, between boxes whose masses are anything up to
// `ratio`. \param sliders at least one of the joints is a slider, and all of them have limits
Drawn open_chain(Draw draw, double ratio, bool sliders) {
  Drawn scene = drawn();
  scene.keeps_energy = false;
  const int count = draw.whole(1, 4), one = draw.whole(1, count);
  Row row{scene};
  vec3 x(0);
  for (int k = 1; k <= count; ++k) {
    const vec3 step = real(draw.number(0.3, 1)) * draw.direction();
    const vec3 edges(real(draw.number(0.1, 0.5)), real(draw.number(0.1, 0.5)),
                     real(draw.number(0.1, 0.5)));
    Kind kind = Kind(draw.whole(0, 2));
    if (sliders && k == one) kind = Kind::slider;
    const bool limited = kind == Kind::slider || draw.chance(0.3);
    const double below = draw.number(0.05, 1), above = draw.number(0.05, 1);
    const BodyId next = scene.box(real(draw.scale(1, ratio)), edges, x + step,
                                  draw.rotation());
    row.hang(next, kind, x + real(draw.number(0, 1)) * step, draw.direction(),
             kind == Kind::slider ? above : 0);
    x += step;
    Joint& joint = *scene.world.joints().back();
    if (auto* slider = dynamic_cast<SliderJoint*>(&joint); slider && limited)
      slider->set_limits(real(-below), real(above));
    if (auto* hinge = dynamic_cast<HingeJoint*>(&joint); hinge && limited)
      hinge->set_limits(real(-below), real(above));
  }
  return scene;
}

// A chain between two walls, of balls or hinges, with a load in its middle.
Drawn bridge(Draw draw) {
  Drawn scene = drawn();
  const int count = 2 * draw.whole(2, 20) + 1;
  const double half = draw.number(0.3, 1.4), load = draw.scale(1, 1000);
  const double radius = count / (2 * half), edge = draw.number(0.3, 0.9);
  const Kind kind = draw.chance(0.5) ? Kind::hinge : Kind::ball;
  const auto at = [&](int k) {
    const double angle = half * (2.0 * k / (count + 1) - 1);
    return real(radius) * vec3(real(std::sin(angle)), real(-std::cos(angle)), 0) - real(radius) *
           vec3(real(std::sin(-half)), real(-std::cos(half)), 0);
  };
  Row row{scene};
  for (int k = 1; k <= count + 1; ++k) {
    const double mass = k > count ? 0 : 2 * k == count + 1 ? load : 1;
    const BodyId next = scene.box(real(mass), vec3(real(edge)), at(k));
    if (k > count) row.end(next, kind, (at(k) + at(k - 1)) / real(2));
    else row.hang(next, kind, (at(k) + at(k - 1)) / real(2), across);
  }
  return scene;
}

// Hinges that bend by 0.05 to 1 rad at most.
Drawn limited_hinges(Draw draw) {
  Drawn scene = drawn();
  scene.keeps_energy = false;
  const int count = draw.whole(2, 20);
  const double most = draw.number(0.05, 1), ratio = draw.scale(1, 100);
  const bool parallel = draw.chance(0.5);
  Row row{scene};
  for (int k = 1; k <= count; ++k) {
    const vec3 x = real(0.5 * k) * level;
    const vec3 axis = parallel ? across : normalize(across + real(0.7) * draw.direction());
    row.hang(scene.box(real(draw.scale(1, ratio)), vec3(real(0.4)), x), Kind::hinge,
             x - real(0.25) * level, axis);
    dynamic_cast<HingeJoint&>(*scene.world.joints().back()).set_limits(real(-most), real(most));
  }
  return scene;
}

// Hinges with motors, some with limits, and a tool at the end.
Drawn driven_arm(Draw draw) {
  Drawn scene = drawn();
  scene.keeps_energy = false, scene.driven = true;
  const int count = draw.whole(3, 10);
  const vec3 axes[] = {level, -down, across};
  Row row{scene};
  vec3 x(0);
  for (int k = 1; k <= count; ++k) {
    const double size = draw.number(0.1, 0.6), strength = draw.scale(10, 1e5);
    const vec3 along = real(size) * axes[draw.whole(0, 2)];
    const BodyId link = chapter9::rod(scene, x, x + along, real(draw.number(1, 10)));
    row.hang(link, Kind::hinge, x, axes[draw.whole(0, 2)]);
    HingeJoint& hinge = dynamic_cast<HingeJoint&>(*scene.world.joints().back());
    hinge.set_motor(real(draw.number(-2, 2)), real(strength));
    if (draw.chance(0.3)) hinge.set_limits(real(draw.number(-2, 0)), real(draw.number(0, 2)));
    x += along;
  }
  return scene;
}

// Chains of cubes on hinges, heavy ends and beads, in steps of any length.
Drawn any_step(Draw draw) {
  const int kind = draw.whole(0, 2);
  Drawn scene = kind == 0   ? drawn(cubes_on_hinges(1, draw.whole(2, 10)))
                : kind == 1 ? heavy_ends(draw, draw.chance(0.5), 1e3)
                            : beads(draw, 100);
  scene.any_step = true;
  return scene;
}

// ---- trees, nets, hubs --------------------------------------------------------------------------

Drawn tree(unsigned seed) {
  return drawn(random_tree(seed, Draw(seed + 1000).scale(1, 1e4)));
}

Drawn net(Draw draw) {
  Drawn scene = drawn(chapter9::net(draw.whole(2, 6)));
  scene.world.gravity = real(g) * draw.direction();
  scene.world.gravity.y = -real(g);  // askew
  return scene;
}

// A ball that hangs, and arms about it, each on a joint of any kind but sliders.
Drawn hub(Draw draw) {
  Drawn scene = drawn();
  const int arms = draw.whole(3, 22);
  const double ratio = draw.scale(1, 100);
  const BodyId top = scene.box(0, vec3(real(0.2)), vec3(0, 1, 0));
  const BodyId centre = scene.ball(real(draw.scale(1, 100)), real(0.5), vec3(0));
  join_by_ball(scene, top, centre, vec3(0, real(0.5), 0));
  for (int k = 0; k < arms; ++k) {
    const vec3 out = draw.direction(), anchor = real(0.5) * out;
    const double mass = draw.scale(1, ratio), size = draw.number(0.3, 1.5);
    const BodyId arm = chapter9::rod(scene, anchor, anchor + real(size) * out, real(mass));
    const int kind = draw.whole(0, 2);
    if (kind == 0) chapter9::welded(scene, centre, arm, anchor);
    else if (kind == 1) join_by_ball(scene, centre, arm, anchor);
    else join_by_hinge(scene, centre, arm, anchor, draw.direction());
    scene.energy_scale += mass * g * (1 + size);
  }
  return scene;
}

// ---- closed loops -------------------------------------------------------------------------------

Drawn equal_bars(Draw draw) {
  const double speed = draw.number(0.3, 2);
  Drawn scene = drawn(chapter9::four_bars(draw.whole(2, 40)));
  for (int slot = 0; slot < scene.world.bodies.slots(); ++slot) {
    Body& body = scene.world.bodies.at(slot);
    body.v *= real(speed), body.w *= real(speed);
  }
  return scene;
}

// Uprights of any lengths that lean anyhow, with a rod between the ends of each two.
Drawn unequal_bars(Draw draw) {
  Drawn scene = drawn();
  const int loops = draw.whole(1, 10);
  const BodyId ground = scene.box(0, vec3(1, real(0.05), real(0.05)), vec3(0));
  BodyId coupler{};
  vec3 before(0);
  for (int k = 0; k <= loops; ++k) {
    const double lean = draw.number(-0.5, 0.5), size = draw.number(0.6, 1.4);
    const vec3 low(real(k), 0, 0);
    const vec3 high = low + real(size) * vec3(real(std::sin(lean)), real(std::cos(lean)), 0);
    if (k > 0) {
      coupler = chapter9::rod(scene, before, high);
      join_by_hinge(scene, scene.world.bodies.id(2 * k - 1), coupler, before, across);
    }
    const BodyId upright = chapter9::rod(scene, low, high);
    join_by_hinge(scene, ground, upright, low, across);
    if (k > 0) join_by_hinge(scene, coupler, upright, high, across);
    scene.energy_scale += g * (k > 0 ? 1.5 : 0.5) * size;
    before = high;
  }
  return scene;
}

// Bricard's linkage of any size, turned anyhow, in a pose that it has reached in a while.
Drawn bricard(Draw draw) {
  Drawn scene = drawn(chapter9::bricard());
  const quat q = draw.rotation();
  World& world = scene.world;
  world.gravity = real(g) * draw.direction();
  DirectSolver solver = DirectSolver::velocities_only();
  solver.newton = 8;
  const int steps = draw.whole(0, 960);
  for (int n = 0; n < steps; ++n) step(world, solver, real(1) / 960, {.leapfrog = true});
  for (int slot = 0; slot < world.bodies.slots(); ++slot) {
    Body& body = world.bodies.at(slot);
    body.x = q * body.x, body.q = normalize(q * body.q);
    body.v = body.w = vec3(0);
  }
  world.gravity = real(g) * down;
  world.last_h = 0;
  return scene;
}

// Rods in a ring that hangs by a ball joint; hinges that are parallel, or point anywhere. Not
// loose: with at most one motion of its own, so that rows depend on others.
Drawn ring(Draw draw, bool loose) {
  Drawn scene = drawn();
  const bool parallel = draw.chance(0.6);
  const int tight = parallel ? 4 : 6;
  const int count = loose ? draw.whole(tight + 1, 12) : draw.whole(3, tight);
  const double size = draw.number(0.3, 1);
  const auto corner = [&](int k) {
    const double angle = 2 * std::numbers::pi * k / count;
    return real(size) * vec3(real(std::cos(angle)), real(std::sin(angle)), 0);
  };
  const BodyId wall = scene.box(0, vec3(real(0.1)), corner(0));
  std::vector<BodyId> rods;
  for (int k = 0; k < count; ++k)
    rods.push_back(chapter9::rod(scene, corner(k), corner(k + 1), real(draw.scale(1, 10))));
  join_by_ball(scene, wall, rods[0], corner(0));
  for (int k = 0; k < count; ++k) {
    const vec3 axis = parallel ? across : draw.direction();
    join_by_hinge(scene, rods[std::size_t(k)], rods[std::size_t((k + 1) % count)], corner(k + 1),
                  axis);
    const double mass = 1 / double(scene.world.bodies[rods[std::size_t(k)]].inverse_mass);
    scene.energy_scale += 2 * g * size * mass;
  }
  return scene;
}

// A crank, a rod and a block on a rail; where rod and crank are alike they may part ways.
Drawn slider_crank(Draw draw) {
  Drawn scene = drawn();
  const double crank = draw.number(0.2, 0.5), angle = draw.number(0.3, 2.5);
  const double size = crank * (draw.chance(0.25) ? 1 : draw.number(1.1, 3));
  const double up = crank * std::sin(angle);
  const vec3 pin = real(crank) * vec3(real(std::cos(angle)), real(std::sin(angle)), 0);
  const vec3 end = vec3(real(crank * std::cos(angle) + std::sqrt(size * size - up * up)), 0, 0);
  const BodyId ground = scene.box(0, vec3(real(0.1)), vec3(0));
  const BodyId turning = chapter9::rod(scene, vec3(0), pin, real(draw.scale(1, 10)));
  const BodyId joining = chapter9::rod(scene, pin, end);
  const BodyId block = scene.box(real(draw.scale(1, 100)), vec3(real(0.2)), end);
  join_by_hinge(scene, ground, turning, vec3(0), across);
  join_by_hinge(scene, turning, joining, pin, across);
  join_by_hinge(scene, joining, block, end, across);
  scene.world.add<SliderJoint>(ground, block, end, level);
  scene.energy_scale = g * crank * 10;
  return scene;
}

}  // namespace

std::vector<Family> joint_families() {
  const auto of = [](auto make) { return [make](unsigned seed) { return make(Draw(seed)); }; };
  return {{"beads", 144, of([](Draw draw) { return beads(draw); })},
          {"heavy ends", 240, of([](Draw draw) { return heavy_ends(draw, false); })},
          {"falling ends", 120, of([](Draw draw) { return heavy_ends(draw, true); })},
          {"trees", 48, tree},
          {"bridges", 96, of(bridge)},
          {"nets", 12, of(net)},
          {"hubs", 120, of(hub)},
          {"equal four-bars", 24, of(equal_bars)},
          {"unequal four-bars", 96, of(unequal_bars)},
          {"Bricard", 80, of(bricard)},
          {"rings", 60, of([](Draw draw) { return ring(draw, false); })},
          {"loose rings", 60, of([](Draw draw) { return ring(draw, true); })},
          {"slider-cranks", 80, of(slider_crank)},
          {"open chains", 680, of([](Draw draw) { return open_chain(draw, 1e6, false); })},
          {"limited sliders", 240, of([](Draw draw) { return open_chain(draw, 1e4, true); })},
          {"limited hinges", 160, of(limited_hinges)},
          {"driven arms", 120, of(driven_arm)},
          {"any step", 96, of(any_step)}};
}

}  // namespace joints::bench
