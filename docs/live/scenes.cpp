// Which scenes the live page has. They are made elsewhere; here stands how they begin.
#include "docs/live/scenes.h"

#include "bench/chapters/06_baumgarte/between_walls.h"
#include "bench/chapters/06_baumgarte/cube_chain.h"
#include "bench/chapters/08_ground/bridge.h"
#include "bench/chapters/08_ground/own_ground.h"
#include "bench/chapters/08_ground/wheels.h"
#include "bench/scenes.h"
#include "chapters/01_distance/program/scenes.h"
#include "chapters/02_ball/ball.h"
#include "chapters/03_hinge/program/door.h"
#include "chapters/04_slider/program/piston.h"
#include "chapters/05_fixed/program/hung_ragdoll.h"
#include "chapters/05_fixed/program/trolley.h"
#include "chapters/06_baumgarte/program/chain_loop.h"
#include "chapters/07_performance/hinge_loop.h"
#include "chapters/08_ground/program/one_box.h"
#include "chapters/10_own/program/machine.h"
#include "joints/distance_joint.h"

namespace joints::live {

namespace {

// A scene that lies in an object of its own.
template <class Holder>
LiveScene held(std::shared_ptr<Holder> holder) {
  LiveScene live;
  live.scene = &holder->scene;
  live.holder = std::move(holder);
  return live;
}
// A scene by itself, as such an object.
template <class S>
struct Held {
  S scene;
};

const Settings usual;
const chapter8::Choice usual8;

// All bodies of an array, for a loop that has an array of its own; and back.
std::vector<Body> taken(const Bodies& bodies) {
  const std::span<const Body> all = all_of(bodies);
  return {all.begin(), all.end()};
}
void give_back(const std::vector<Body>& from, Bodies& bodies) {
  for (std::size_t k = 0; k < from.size() && int(k) < bodies.slots(); ++k)
    bodies.at(int(k)) = from[k];
}

LiveScene linked(const chapter1::LinkScene& from) {
  const auto holder = std::make_shared<Held<Scene>>();
  Scene& scene = holder->scene;
  scene.energy_scale = from.energy_scale;
  std::vector<BodyId> ids;
  for (const Body& body : from.bodies) {
    ids.push_back(scene.world.add(body));
    scene.shapes.push_back(from.shape);
  }
  for (const Link& link : from.links) {
    const BodyId id1 = ids[std::size_t(link.body1)], id2 = ids[std::size_t(link.body2)];
    const CentreDistance rod{link.length};
    if (link.rope)
      scene.world.add<CentreRopeJoint>(id1, id2, Rope<CentreDistance>{rod});
    else
      scene.world.add<CentreDistanceJoint>(id1, id2, rod);
    scene.segments.push_back({link.body1, link.body2, {}, {}});
  }
  scene.gaps = [&scene, links = from.links](GapMeter& meter) {
    const Bodies& bodies = scene.world.bodies;
    for (const Link& link : links)
      meter.add(chapter1::gap(link, bodies.at(link.body1), bodies.at(link.body2)));
  };
  LiveScene live = held(holder);
  live.heavy = int(ids.size()) / 2;
  live.own = [links = from.links](Bodies& bodies, const PageSettings& page, const vec3& gravity) {
    std::vector<Body> all = taken(bodies);
    step(all, links, {gravity, real(page.h), int(page.iterations), real(page.beta)});
    give_back(all, bodies);
  };
  return live;
}

LiveScene pendulum() { return linked(chapter1::pendulum()); }

// A plank on three rods whose ends are beside the centres.
LiveScene swing() {
  const auto holder = std::make_shared<Held<Scene>>();
  Scene& scene = holder->scene;
  scene.energy_scale = 10;
  const BodyId beam = scene.box(0, vec3(real(1.6), real(0.1), real(0.5)), vec3(0, 1, 0),
                                rotation(vec3(0, real(0.3), 0)));
  const BodyId plank = scene.box(3, vec3(real(1.2), real(0.15), real(0.6)), vec3(0, real(-0.3), 0),
                                 rotation(vec3(real(0.2), real(-0.2), real(0.15))));
  scene.world.bodies[plank].w = vec3(0, real(1.5), real(0.5));
  const Bodies& bodies = scene.world.bodies;
  for (const vec3& corner : {vec3(real(0.55), 0, real(0.2)), vec3(real(-0.55), 0, real(0.2)),
                             vec3(real(0.1), 0, real(-0.25))}) {
    scene.world.add<DistanceJoint>(beam, plank, world_point(bodies[beam], corner),
                                   world_point(bodies[plank], corner));
    const std::array<double, 3> end{double(corner.x), double(corner.y), double(corner.z)};
    scene.segments.push_back({int(beam.slot), int(plank.slot), end, end});
  }
  scene.gaps = [&scene](GapMeter& meter) {
    for (const auto& joint : scene.world.joints()) {
      const auto& rod = static_cast<const DistanceJoint&>(*joint);
      meter.add(std::abs(double(rod.part.error(scene.world.bodies[rod.body1],
                                               scene.world.bodies[rod.body2]))));
    }
  };
  LiveScene live = held(holder);
  live.heavy = int(plank.slot);
  return live;
}

// A box that nothing holds: it tumbles about its middle axis.
LiveScene tumbler() {
  const auto holder = std::make_shared<Held<Scene>>();
  Scene& scene = holder->scene;
  scene.world.gravity = vec3(0);
  const BodyId id = scene.box(2, vec3(real(1.4), real(0.25), real(0.7)), vec3(0),
                              rotation(vec3(real(0.3), real(0.5), real(-0.2))));
  Body& box = scene.world.bodies[id];
  box.w = to_world(box, vec3(real(0.1), real(0.2), 4));
  LiveScene live = held(holder);
  live.own = [](Bodies& bodies, const PageSettings& page, const vec3&) {
    tumble(bodies.at(0), real(page.h));
  };
  return live;
}

LiveScene ropes() { return linked(chapter1::bridge()); }

LiveScene chain() {
  auto holder = std::make_shared<chapter6::CubeChain>("chain", 12, real(1), vec3(1, 0, 0),
                                                      usual.beta);
  LiveScene live = held(holder);
  live.heavy = 12;
  live.own = [&world = holder->scene.world, loop = ChainLoop(), impulses = std::vector<vec3>()](
                 Bodies& bodies, const PageSettings& page, const vec3& gravity) mutable {
    loop.chain.bodies = taken(bodies);
    loop.chain.joints.clear();
    for (const auto& joint : world.joints())
      loop.chain.joints.push_back(static_cast<const BallJoint&>(*joint).part);
    loop.settings = {real(page.beta), page.warm != 0, int(page.projections),
                     int(page.iterations)};
    loop.gravity = gravity;
    impulses.resize(loop.chain.joints.size());
    if (page.frequency > 0)
      soft_step(loop.chain, impulses, {real(page.frequency), real(page.damping),
                                       int(page.substeps)}, gravity, real(page.h));
    else
      loop.step(real(page.h));
    give_back(loop.chain.bodies, bodies);
  };
  return live;
}

LiveScene hinges() {
  auto holder = std::make_shared<Held<bench::BenchScene>>();
  holder->scene = bench::cubes_on_hinges(1, 12);
  LiveScene live = held(holder);
  live.heavy = 11;
  live.own = [&world = holder->scene.world](Bodies& bodies, const PageSettings& page,
                                            const vec3& gravity) {
    HingeLoop<real> loop;
    loop.bodies = taken(bodies);
    for (const auto& joint : world.joints()) {
      const auto& hinge = static_cast<const HingeJoint&>(*joint);
      loop.links.push_back({int(hinge.body1.slot), int(hinge.body2.slot)});
      loop.hinges.push_back({hinge.first, hinge.second, real(page.beta)});
    }
    loop.gravity = gravity;
    loop.iterations = int(page.iterations);
    loop.relaxation = real(page.relaxation);
    loop.arrange(one_by_one(int(loop.links.size())));
    loop.step(real(page.h));
    give_back(loop.bodies, bodies);
  };
  return live;
}

LiveScene heavy() {
  auto holder = std::make_shared<Held<bench::BenchScene>>();
  holder->scene = bench::heavy_end_unreferenced(1);
  LiveScene live = held(holder);
  live.heavy = holder->scene.tip;
  live.ratio = 100;
  live.added_inertia = 8;
  return live;
}

LiveScene bridge() {
  auto holder = std::make_shared<chapter8::Bridge>(usual8.iterations);
  LiveScene live = held(holder);
  live.beta = holder->hinges.front()->beta;
  live.heavy = int(holder->crate.slot);
  return live;
}

LiveScene door() {
  auto holder = std::make_shared<Held<Scene>>();
  HingeJoint& hinge = chapter3::add_door(holder->scene, vec3(0), 5, usual, usual.whole);
  LiveScene live = held(holder);
  live.heavy = 1;
  live.drive = [&hinge](real speed, real strength) { hinge.set_motor(speed, strength); };
  live.speed = -1;
  live.strength = 20;
  return live;
}

// A wheel whose motor turns round every 1.5 s, with a load that is always the same.
LiveScene flywheel() {
  const auto holder = std::make_shared<Held<Scene>>();
  Scene& scene = holder->scene;
  scene.energy_scale = 100;
  const BodyId axle = scene.box(0, vec3(real(0.1), real(0.1), real(0.6)), vec3(0));
  const BodyId wheel = scene.box(10, vec3(1, 1, real(0.2)), vec3(0));
  auto& hinge = scene.world.add<HingeJoint>(axle, wheel, vec3(0), vec3(0, 0, 1));
  scene.mark(axle, wheel, vec3(0), vec3(0, 0, 1));
  LiveScene live = held(holder);
  live.heavy = int(wheel.slot);
  const auto motor = std::make_shared<Motor>();
  live.speed = 4;
  live.strength = 10;
  live.drive = [motor](real speed, real strength) { *motor = {speed, strength}; };
  live.before = [motor, &hinge](double time) {
    const real side = int(time / 1.5) % 2 == 0 ? real(1) : real(-1);
    hinge.set_motor(side * motor->speed, motor->strength);
  };
  live.own = [motor, time = 0.0](Bodies& bodies, const PageSettings& page, const vec3&) mutable {
    Body& body = bodies.at(1);
    const real K = body.inverse_inertia_local.z, h = real(page.h);
    const Motor now{int(time / 1.5) % 2 == 0 ? motor->speed : -motor->speed, motor->strength};
    time += page.h;
    body.w.z -= 3 * h * K;  // the load, 3 N m
    real sum = 0;
    for (int k = 0; k < int(page.iterations); ++k)
      body.w.z += K * motor_impulse(body.w.z, K, now, h, sum);
    integrate_pose(body, h);
  };
  return live;
}

LiveScene piston() {
  auto holder = std::make_shared<chapter4::Piston>(usual, usual.whole);
  LiveScene live = held(holder);
  live.heavy = 1;
  live.drive = [&piston = *holder](real speed, real strength) {
    piston.speed = speed;
    piston.strength = strength;
  };
  live.before = [&piston = *holder](double time) { piston.turn_round(time); };
  live.speed = holder->speed;
  live.strength = holder->strength;
  return live;
}

LiveScene trolley() {
  auto holder = std::make_shared<chapter5::Trolley>(usual);
  LiveScene live = held(holder);
  live.heavy = 1;
  live.before = [&trolley = *holder](double) { trolley.pull(); };
  live.own = [&trolley = *holder](Bodies& bodies, const PageSettings& page, const vec3& gravity) {
    trolley.step(bodies, gravity, int(page.iterations), real(page.beta), real(page.h));
  };
  return live;
}

LiveScene ragdoll() { return held(std::make_shared<chapter5::HungRagdoll>(usual)); }

LiveScene between() {
  auto holder = std::make_shared<chapter6::BetweenWalls>(real(0.2), usual.beta);
  LiveScene live = held(holder);
  live.heavy = int(holder->ids[1].slot);
  live.before = [&between = *holder](double time) { between.kick(time); };
  return live;
}

// It is let go tilted, half a metre above the ground.
LiveScene box() {
  auto holder = std::make_shared<chapter8::OneBox>("box", usual8, vec3(1, real(0.6), real(0.8)));
  Body& body = holder->body();
  body.x.y += real(0.8);
  body.q = rotation(vec3(real(0.3), 0, real(0.5)));
  LiveScene live = held(holder);
  live.heavy = int(holder->box.slot);
  live.own = [&one = *holder](Bodies& bodies, const PageSettings& page, const vec3& gravity) {
    OwnGround loop;
    loop.ground = bodies[one.ground];
    loop.body = bodies[one.box];
    for (int k = 0; k < one.contact->outline.count; ++k)
      loop.corners.push_back({one.contact->outline.corners[std::size_t(k)], 0,
                              one.contact->top.height});
    loop.friction = one.contact->friction;
    loop.beta = real(page.beta);
    loop.iterations = int(page.iterations);
    loop.gravity = gravity;
    loop.step(real(page.h));
    bodies[one.box] = loop.body;
  };
  return live;
}

LiveScene wheels() {
  chapter8::Choice choice;
  choice.iterations = chapter8::Wheels::iterations;
  auto holder = std::make_shared<chapter8::Wheels>(choice);
  LiveScene live = held(holder);
  live.heavy = int(holder->beam.slot);
  live.drive = [&wheels = *holder](real speed, real strength) { wheels.drive(speed, strength); };
  live.speed = chapter8::Wheels::speed;
  live.strength = chapter8::Wheels::strength;
  return live;
}

// Two shafts that meet at 30 degrees.
LiveScene machine() {
  auto holder = std::make_shared<chapter10::Machine>(usual, real(0.5236), real(4));
  LiveScene live = held(holder);
  live.heavy = 1;
  live.drive = [&drive = *holder->drive](real speed, real strength) {
    drive.set_motor(speed, strength);
  };
  live.speed = 4;
  live.strength = 500;
  return live;
}

}  // namespace

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all{
      {"pendulum", "pendulum", {"1"}, pendulum,
       "One rod, one row. With beta 0 the rod drifts; above 2 it tears."},
      {"ropes", "rope bridge", {"1.5"}, ropes,
       "The thesis' bridge: eight cubes on nine ropes, which only pull."},
      {"swing", "swing", {"1.6"}, swing, "A plank on three rods, held beside its centre."},
      {"chain", "chain of 12", {"2", "6"}, chain,
       "Each iteration passes the load on from link to link: watch the gap."},
      {"tumbler", "tumbler", {"2.5"}, tumbler,
       "Nothing holds this box. About its middle axis it cannot rotate for long."},
      {"hinges", "hinges", {"7"}, hinges, "Twelve cubes on hinges: five rows a joint."},
      {"heavy", "heavy end", {"9"}, heavy,
       "A heavy ball, at first of 100 times a link's mass: iterations stretch the chain, the "
       "direct solver does not."},
      {"bridge", "planks", {}, bridge,
       "Ten planks, eleven hinges that rub, and a crate that falls on them."},
      {"door", "door", {"3"}, door,
       "Pushed open, held by a limit at 110 degrees, closed by a motor."},
      {"flywheel", "flywheel", {"3.5"}, flywheel,
       "A motor of at most 10 N m turns it to and fro. In the chapter's own loop a load of 3 N m "
       "pulls as well."},
      {"piston", "piston", {"4"}, piston,
       "A motor, at first of 80 N, moves 5 kg up and down between two limits. It cannot lift a "
       "weight above its strength."},
      {"trolley", "trolley", {"5"}, trolley,
       "Welded arms on a sleeve that a spring pulls. In the chapter's own loop what is loaded too "
       "much breaks and keeps its pin."},
      {"ragdoll", "ragdoll", {}, ragdoll, "Hung by one hand: four balls, one weld, one grip."},
      {"between", "walls", {}, between,
       "Three blows at a chain that has hardly room to move: a loop of joints."},
      {"box", "box", {"8"}, box, "It falls, tips and comes to rest: rows that only push, and rub."},
      {"wheels", "wheels", {}, wheels,
       "Six cubes a wheel, a motor in each hub. With 60 iterations, not 300, they fly apart."},
      {"machine", "machine", {"10"}, machine,
       "A motor, a universal joint, a gear and a screw: the second shaft turns unevenly."}};
  return all;
}

}  // namespace joints::live
