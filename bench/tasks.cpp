// Scenes as readers have them.
#include "bench/tasks.h"

#include <cmath>
#include <numbers>

#include "bench/chapters/08_ground/bridge.h"
#include "bench/chapters/08_ground/ragdoll.h"
#include "bench/chapters/09_direct/linkages.h"
#include "bench/draw.h"

namespace joints::bench {

namespace {

constexpr double millimetres = 1000;

// A scene of a chapter's program; nothing is known of its tip.
BenchScene of_chapter(Scene scene) {
  BenchScene out;
  static_cast<Scene&>(out) = std::move(scene);
  out.tip_mask = glm::dvec3(0);
  return out;
}

double sum_of_gaps(const Scene& scene) {
  const std::vector<Pose> now = poses(scene.world.bodies);
  double sum = 0;
  for (const Mark& mark : scene.marks) sum += gap(mark, now);
  return sum;
}

}  // namespace

BenchScene hung_chain(int cubes, double load) {
  std::vector<double> masses(std::size_t(cubes), 100.0);
  masses.push_back(load);
  BenchScene scene = chain_of_masses(masses, vec3(0, -1, 0));
  scene.name = "hung chain";
  scene.finding = {"load has sunk [mm]", 0, [tip = scene.tip, depth = cubes + 1](const Scene& now) {
                     return -millimetres * (double(now.world.bodies.at(tip).x.y) + depth);
                   }};
  return scene;
}

BenchScene sprung_chain(int cubes, double frequency) {
  BenchScene scene = hung_chain(cubes, 100);
  const double omega = 2 * std::numbers::pi * frequency;
  for (int k = 0; k <= cubes; ++k) {
    scene.world.joints()[std::size_t(k)]->frequency = real(frequency);
    // Its springs carry cubes + 1 - k masses, and m_eff omega^2 is their stiffness.
    const double load = cubes + 1 - k, m_eff = k == 0 ? 1 : 0.5;
    scene.finding.expected += millimetres * 9.81 * load / (m_eff * omega * omega);
  }
  scene.energy_scale = std::numeric_limits<double>::infinity();  // springs keep some, dampers none
  return scene;
}

BenchScene beads(double inertia) {
  BenchScene scene;
  scene.name = "beads";
  scene.energy_scale = 0;
  scene.tip_mask = glm::dvec3(0);
  const int count = 20;
  BodyId before = scene.box(0, vec3(real(0.2)), vec3(0));
  for (int k = 1; k <= count; ++k) {
    const double mass = k == count ? 10 : 1;
    const vec3 place(real(k), 0, 0);
    const BodyId id = scene.ball(real(mass), real(0.5 / std::sqrt(0.4 * inertia)), place);
    join_by_ball(scene, before, id, place - vec3(real(0.5), 0, 0));
    scene.energy_scale += mass * 9.81 * k;
    before = id;
  }
  return scene;
}

BenchScene rope_bridge() {
  BenchScene scene = hanging_bridge(false);
  scene.finding = {"all links too long by [mm]", 0,
                   [](const Scene& now) { return millimetres * sum_of_gaps(now); }};
  return scene;
}

BenchScene welded_beam(int cubes) {
  BenchScene scene = of_chapter(chapter9::beam(cubes));
  scene.finding = {"tip has sunk [mm]", 0, [cubes](const Scene& now) {
                     return -millimetres * double(now.world.bodies.at(cubes - 1).x.y);
                   }};
  return scene;
}

BenchScene arm() {
  const double degree = std::numbers::pi / 180;
  const struct {
    glm::dvec3 axis;       // unit, world, at the start
    double length, mass;   // [m, kg]; of the link that it turns
    double speed;          // [rad/s]
  } drives[] = {{{0, 1, 0}, 0.3, 8, 40 * degree}, {{0, 0, 1}, 0.6, 6, 25 * degree},
                {{0, 0, 1}, 0.5, 4, -50 * degree}, {{1, 0, 0}, 0.2, 3, 60 * degree},
                {{0, 0, 1}, 0.2, 2, 45 * degree},  {{1, 0, 0}, 0.1, 1, -90 * degree}};
  BenchScene scene;
  scene.name = "arm";
  scene.energy_scale = std::numeric_limits<double>::infinity();  // its drives do work
  BodyId before = scene.box(0, vec3(real(0.2)), vec3(real(-0.1), 0, 0));
  glm::dvec3 place(0);
  glm::dquat turned(1, 0, 0, 0);  // by all drives so far, after 1 s
  glm::dvec3 end(0);              // of the last link, then
  for (const auto& drive : drives) {
    const vec3 size(real(drive.length), real(0.1), real(0.1));
    const glm::dvec3 along(drive.length, 0, 0);
    const BodyId link = scene.box(real(drive.mass), size, vec3(place + 0.5 * along));
    HingeJoint& hinge = join_by_hinge(scene, before, link, vec3(place), vec3(drive.axis));
    hinge.set_motor(real(drive.speed), 100000);  // at speed within a thousandth of the first step
    turned = turned * glm::angleAxis(drive.speed, drive.axis);
    place += along;
    end += turned * along;
    before = link;
  }
  const glm::dvec3 half(0.05, 0, 0);
  const BodyId tool = scene.box(5, vec3(real(0.1)), vec3(place + half));
  scene.world.add<FixedJoint>(before, tool, vec3(place));
  scene.mark(before, tool, vec3(place));
  scene.tip = int(tool.slot);
  scene.tip_reference = end + turned * half;
  scene.finding = {"tool is off after 1 s [mm]", 0,
                   [tip = scene.tip, where = scene.tip_reference](const Scene& now) {
                     return millimetres * length(glm::dvec3(now.world.bodies.at(tip).x) - where);
                   }};
  return scene;
}

BenchScene driven_crane() {
  BenchScene scene = motor();
  scene.energy_scale = std::numeric_limits<double>::infinity();  // so does its motor
  const double inertia = 100.0 / 6 + 100 * 1.5 * 1.5;  // about the hinge [kg m^2]
  scene.finding = {"speed after 1 s [rad/s]", 500 / inertia, [](const Scene& now) {
                     return double(now.world.bodies.at(1).w.y);
                   }};
  return scene;
}

BenchScene stopped_crane() {
  BenchScene scene = limit();
  scene.finding = {"angle at rest [degrees]", 60, [](const Scene& now) {
                     const Body& cube = now.world.bodies.at(1);
                     return std::atan2(double(-cube.x.y), double(cube.x.z)) * 180 /
                            std::numbers::pi;
                   }};
  return scene;
}

BenchScene loaded_planks() {
  chapter8::Bridge bridge(30);
  const BodyId crate = bridge.crate;
  BenchScene scene = of_chapter(std::move(bridge.scene));
  scene.finding = {"crate still moves at [mm/s]", 0, [crate](const Scene& now) {
                     return millimetres * double(length(now.world.bodies[crate].v));
                   }};
  return scene;
}

// Dolls on one ground. \param let_go from the place below a doll to its torso's centre and turn
static BenchScene dolls(int count, const std::function<std::pair<vec3, quat>(vec3 place)>& let_go) {
  BenchScene scene;
  scene.name = "ragdolls";
  scene.tip_mask = glm::dvec3(0);
  scene.energy_scale = 0;
  const int in_a_row = int(std::ceil(std::sqrt(double(count))));
  const BodyId ground = chapter8::add_ground(scene, real(4 * in_a_row));
  for (int k = 0; k < count; ++k) {
    const auto [centre, turn] = let_go(vec3(real(4 * (k % in_a_row)), 0, real(4 * (k / in_a_row))));
    chapter8::add_doll(scene, ground, centre, turn, real(0.2));
  }
  scene.finding = {"deepest corner [mm]", 0, [](const Scene& now) {
                     return millimetres * chapter8::penetration(now.world);
                   }};
  return scene;
}

BenchScene ragdolls(int count) {
  return dolls(count, [](const vec3& place) {
    return std::pair(place + vec3(0, real(0.95), 0), chapter8::tilted);
  });
}

BenchScene random_ragdolls(int count, unsigned seed, double lowest) {
  return dolls(count, [draw = Draw(seed), lowest](const vec3& place) mutable {
    const vec3 up(0, real(draw.number(lowest, lowest + 1.2)), 0);
    return std::pair(place + up, draw.rotation());
  });
}

}  // namespace joints::bench
