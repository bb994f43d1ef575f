// The scenes whose tips are moved by their joints.
#include "bench/accuracy.h"

#include <cmath>
#include <numbers>

#include "joints/ball_joint.h"
#include "joints/slider_joint.h"

namespace joints::bench {

namespace accuracy {  // all files of this folder are compiled as one

namespace {

const vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
constexpr real thick = real(0.06);  // of a rod [m]

// A point of the plane at a distance and an angle [rad] from another.
vec3 away(const vec3& from, real distance, real angle) {
  return from + distance * vec3(std::cos(angle), std::sin(angle), 0);
}
real degrees(real angle) { return angle * std::numbers::pi_v<real> / 180; }

// A rod in the plane z = 0 from one point to another.
BodyId rod(BenchScene& scene, real mass, const vec3& from, const vec3& to) {
  const vec3 along = to - from;
  return scene.box(mass, vec3(length(along), thick, thick), real(0.5) * (from + to),
                   rotation(std::atan2(along.y, along.x) * z));
}

// The name, the body that is followed, and its place after so many seconds.
BenchScene followed(BenchScene scene, const std::string& name, BodyId tip, double time,
                    const glm::dvec3& place) {
  scene.name = name;
  scene.tip = int(tip.slot);
  scene.tip_time = time;
  scene.tip_reference = place;
  scene.energy_scale = 0;
  for (const Body& body : scene.world.bodies)
    if (!body.is_static()) scene.energy_scale += 9.81 / double(body.inverse_mass);
  return scene;
}

// Three rods that are released from a bent line beside their hook.
BenchScene triple_pendulum() {
  BenchScene scene;
  BodyId before = scene.box(0, vec3(real(0.1)), vec3(0));
  vec3 place(0);
  const real lengths[] = {real(0.5), real(0.4), real(0.3)}, masses[] = {2, real(1.5), 1},
             angles[] = {0, -30, 30};
  for (int k = 0; k < 3; ++k) {
    const vec3 end = away(place, lengths[k], degrees(angles[k]));
    const BodyId id = rod(scene, masses[k], place, end);
    join_by_hinge(scene, before, id, place, z);
    before = id;
    place = end;
  }
  return followed(std::move(scene), "triple pendulum", before, 1,
                  {-0.8928252022, -0.1616093108, 0});
}

// A boom on an upright hinge that a constant torque drives, a jib and a load that swing on it.
BenchScene driven_arm() {
  BenchScene scene;
  const BodyId post = scene.box(0, vec3(real(0.2)), vec3(0));
  const BodyId boom = scene.box(20, vec3(2, real(0.1), real(0.1)), x);
  const BodyId jib = scene.box(5, vec3(1, real(0.1), real(0.1)), real(2.5) * x);
  const BodyId load = scene.box(3, vec3(real(0.2), real(0.5), real(0.2)),
                                vec3(3, real(-0.25), 0));
  join_by_hinge(scene, post, boom, vec3(0), y);
  join_by_hinge(scene, boom, jib, real(2) * x, z);
  join_by_hinge(scene, jib, load, real(3) * x, x);
  scene.world.bodies[boom].torque = vec3(0, 60, 0);
  return followed(std::move(scene), "driven arm", load, 1.5,
                  {0.1752044247, -1.0209945850, -1.8952522851});
}

// Eight level rods: they fall, and then the last ones are thrown round.
BenchScene whip() {
  BenchScene scene;
  BodyId before = scene.box(0, vec3(real(0.1)), vec3(0));
  const real size = real(0.3);
  for (int k = 0; k < 8; ++k) {
    const BodyId id = rod(scene, 1, real(k) * size * x, real(k + 1) * size * x);
    join_by_hinge(scene, before, id, real(k) * size * x, z);
    before = id;
  }
  return followed(std::move(scene), "whip", before, 1.5,
                  {-2.0479903960, -0.2320137658, 0});
}

// A plate that rotates at the end of an axle, which is held at its other end: it nutates.
BenchScene wheel() {
  BenchScene scene;
  const BodyId pillar = scene.box(0, vec3(real(0.2)), vec3(0, -1, 0));
  const BodyId yoke = scene.box(1, vec3(real(0.1)), vec3(0));
  const BodyId axle = scene.box(real(0.5), vec3(real(0.6), thick, thick), real(0.3) * x);
  const BodyId plate = scene.box(3, vec3(real(0.05), real(0.6), real(0.6)), real(0.5) * x);
  join_by_hinge(scene, pillar, yoke, vec3(0), y);
  join_by_hinge(scene, yoke, axle, vec3(0), z);
  join_by_hinge(scene, axle, plate, real(0.5) * x, x);
  scene.world.bodies[plate].w = real(30) * x;
  return followed(std::move(scene), "wheel on an axle", plate, 1,
                  {-0.2085634489, -0.2072349740, -0.4044192791});
}

// A plate that rotates about a tilted axis and stands on a point of it.
BenchScene top() {
  BenchScene scene;
  const BodyId floor = scene.box(0, vec3(real(0.2)), vec3(0, real(-0.1), 0));
  const quat tilt = rotation(degrees(30) * z);
  const vec3 axis = tilt * y;
  const BodyId plate =
      scene.box(1, vec3(real(0.3), real(0.04), real(0.3)), real(0.3) * axis, tilt);
  join_by_ball(scene, floor, plate, vec3(0));
  scene.world.bodies[plate].w = real(80) * axis;
  return followed(std::move(scene), "top", plate, 1,
                  {0.1881722306, 0.2095297906, 0.1033850980});
}

// Crank and rocker on hinges, and between them a coupler on balls, so that no row is redundant.
BenchScene four_bar() {
  BenchScene scene;
  const BodyId frame = scene.box(0, vec3(1, real(0.05), real(0.05)), real(0.5) * x);
  const vec3 a = away(vec3(0), real(0.5), degrees(60)), b = away(x, real(0.8), degrees(80));
  const BodyId crank = rod(scene, 1, vec3(0), a), coupler = rod(scene, 2, a, b),
               rocker = rod(scene, real(1.5), x, b);
  join_by_hinge(scene, frame, crank, vec3(0), z);
  join_by_ball(scene, crank, coupler, a);
  join_by_hinge(scene, frame, rocker, x, z);
  join_by_ball(scene, rocker, coupler, b);
  return followed(std::move(scene), "four-bar linkage", coupler, 1,
                  {0.1213539579, 0.5256782175, 0});
}

// A crank that a constant torque drives, a rod on balls, and a block that slides.
BenchScene slider_crank() {
  BenchScene scene;
  const BodyId frame = scene.box(0, vec3(real(0.1)), vec3(0));
  const vec3 a = away(vec3(0), real(0.2), degrees(60));
  const vec3 b(a.x + std::sqrt(real(0.36) - a.y * a.y), 0, 0);
  const BodyId crank = rod(scene, 2, vec3(0), a), bar = rod(scene, 1, a, b),
               block = scene.box(1, vec3(real(0.1)), b);
  join_by_hinge(scene, frame, crank, vec3(0), z);
  join_by_ball(scene, crank, bar, a);
  scene.world.add<SliderJoint>(frame, block, b, x);
  join_by_ball(scene, bar, block, b);
  scene.world.bodies[crank].torque = vec3(0, 0, 1);
  return followed(std::move(scene), "slider-crank", bar, 1,
                  {0.1591002868, -0.0754515231, 0});
}

}  // namespace

}  // namespace accuracy

std::vector<AccuracyScene> accuracy_scenes() {
  using namespace accuracy;
  return {{"S5", "three hinges", [] { return cubes_on_hinges(1, 4); }},
          {"triple pendulum", "triple pendulum", triple_pendulum},
          {"driven arm", "arm driven by a torque", driven_arm},
          {"whip", "whip of eight rods", whip},
          {"wheel on an axle", "wheel on an axle", wheel},
          {"top", "top on a point", top},
          {"four-bar linkage", "four-bar linkage", four_bar, false},
          {"slider-crank", "slider-crank", slider_crank, false}};
}

}  // namespace joints::bench
