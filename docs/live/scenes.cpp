// Which scenes the live page has. They are made elsewhere; here stands how they begin.
#include "docs/live/scenes.h"

#include "bench/scenes.h"
#include "chapters/01_distance/distance_joint.h"
#include "chapters/01_distance/program/scenes.h"
#include "chapters/03_hinge/program/door.h"
#include "chapters/04_slider/program/piston.h"
#include "chapters/05_fixed/program/hung_ragdoll.h"
#include "chapters/06_baumgarte/program/between_walls.h"
#include "chapters/06_baumgarte/program/cube_chain.h"
#include "chapters/08_ground/program/bridge.h"
#include "chapters/08_ground/program/one_box.h"
#include "chapters/08_ground/program/wheels.h"

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

LiveScene pendulum() {
  const chapter1::LinkScene from = chapter1::pendulum();
  const auto holder = std::make_shared<Held<Scene>>();
  Scene& scene = holder->scene;
  scene.energy_scale = from.energy_scale;
  std::vector<BodyId> ids;
  for (const Body& body : from.bodies) {
    ids.push_back(scene.world.add(body));
    scene.shapes.push_back(from.shape);
  }
  std::vector<const CentreDistanceJoint*> rods;
  for (const Link& link : from.links) {
    const BodyId id1 = ids[std::size_t(link.body1)], id2 = ids[std::size_t(link.body2)];
    rods.push_back(&scene.world.add<CentreDistanceJoint>(id1, id2, CentreDistance{link.length}));
    scene.segments.push_back({link.body1, link.body2, {}, {}});
  }
  scene.gaps = [&scene, rods](GapMeter& meter) {
    const Bodies& bodies = scene.world.bodies;
    for (const CentreDistanceJoint* rod : rods)
      meter.add(std::abs(double(rod->part.error(bodies[rod->body1], bodies[rod->body2]))));
  };
  LiveScene live = held(holder);
  live.heavy = 1;
  return live;
}

LiveScene chain() {
  auto holder = std::make_shared<chapter6::CubeChain>("chain", 12, real(1), vec3(1, 0, 0),
                                                      usual.beta);
  LiveScene live = held(holder);
  live.heavy = 12;
  return live;
}

LiveScene heavy() {
  auto holder = std::make_shared<Held<bench::BenchScene>>();
  holder->scene = bench::heavy_end_unreferenced(1);
  LiveScene live = held(holder);
  live.heavy = holder->scene.tip;
  live.ratio = 100;
  live.stiffness = 8;
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

}  // namespace

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all{
      {"pendulum", "pendulum", 1, "One rod, one row. With beta 0 the rod drifts; above 2 it tears.",
       pendulum},
      {"chain", "chain of 12", 2, "Gauss-Seidel passes the load on link by link: watch the gap.",
       chain},
      {"heavy", "heavy end", 9,
       "A ball of 100 times a link's mass: iterations stretch the chain, the direct solver does "
       "not.", heavy},
      {"bridge", "bridge", 8, "Ten planks, eleven hinges that rub, and a crate that falls on them.",
       bridge},
      {"door", "door", 3, "Pushed open, held by a limit at 110 degrees, closed by a motor.", door},
      {"piston", "piston", 4, "A motor drives it between two limits, beside its centre.", piston},
      {"ragdoll", "ragdoll", 5, "Hung by one hand: four balls, one weld, one grip.", ragdoll},
      {"between", "between walls", 6,
       "Three blows at a chain that has hardly room to move: a loop of joints.", between},
      {"box", "box", 8, "It falls, tips, slides and comes to rest: rows that only push.", box},
      {"wheels", "wheels", 8, "Fourteen cubes on two motors. With a warm start and fewer than 80 "
       "iterations they fly apart.", wheels}};
  return all;
}

}  // namespace joints::live
