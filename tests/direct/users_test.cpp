// The settings of docs/which_method.md, which quotes most of them, on scenes that a seed draws.
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "bench/draw.h"
#include "bench/families.h"
#include "bench/random_chains.h"
#include "bench/tasks.h"
#include "chapters/08_ground/program/program.h"
#include "engine/simd/packed.h"
#include "tests/checker/catch.h"
#include "tests/direct/rigs.h"

using namespace joints;
using namespace joints::bench;
using namespace joints::testing;

namespace {

// A crowd of ragdolls on the ground: iterations on lanes.
void play_crowd(World& world, int steps) {
  world.set_beta(real(0.1));
  PackedImpulses solver;
  solver.iterations = 10;
  for (int n = 0; n < steps; ++n)
    step(world, solver, real(1) / 60, {.warm_start = true});
}

// The default: a hoist whose links carry 1,000 times their mass, arms, cylinders, wheels.
void play(World& world, int steps) {
  DirectSolver solver;
  for (int n = 0; n < steps; ++n)
    step(world, solver, real(1) / 60, {.leapfrog = true});
}

// An arm whose drives move a tool to within 0.1 mm: the default in two substeps.
void play_arm(World& world, int steps) {
  DirectSolver solver;
  for (int n = 0; n < steps; ++n)
    step(world, solver, real(1) / 60, {.substeps = 2, .leapfrog = true});
}

// Chains, arms, ragdolls and boxes in one scene: four substeps, warm, soft contacts.
void play_everything(World& world, int steps) {
  for (const auto& joint : world.joints())
    if (auto* contact = dynamic_cast<GroundContact*>(joint.get()))
      contact->frequency = 60, contact->damping = 10;
  DirectSolver solver;
  for (int n = 0; n < steps; ++n)
    step(world, solver, real(1) / 60, {.warm_start = true, .substeps = 4});
}

// A rod from centre to centre becomes a spring of k [N/m] with a damper of c [N s/m].
void make_spring(CentreDistanceJoint& rod, const Bodies& bodies, double k, double c) {
  const double K = double(bodies[rod.body1].inverse_mass + bodies[rod.body2].inverse_mass);
  const double omega = std::sqrt(k * K);
  rod.frequency = real(omega / (2 * std::numbers::pi));
  rod.damping = real(c * K / (2 * omega));
}

// Six links of 0.1 to 0.6 m and 1 to 8 kg, each with a drive of up to 90 degrees per second. The
// reference of the tip is where the angles of the drives put the centre of the last link after 1 s.
BenchScene drawn_arm(unsigned seed) {
  Draw draw(seed);
  BenchScene scene;
  BodyId before = scene.box(0, vec3(real(0.2)), vec3(real(-0.1), 0, 0));
  glm::dvec3 place(0), end(0);
  glm::dquat turned(1, 0, 0, 0);  // by all drives so far, after 1 s
  for (int k = 0; k < 6; ++k) {
    const double size = draw.number(0.1, 0.6), speed = draw.number(-1.57, 1.57);
    glm::dvec3 axis(0);
    axis[draw.whole(0, 2)] = 1;
    const glm::dvec3 along(size, 0, 0);
    const BodyId link = scene.box(real(draw.number(1, 8)), vec3(real(size), real(0.1), real(0.1)),
                                  vec3(place + 0.5 * along));
    join_by_hinge(scene, before, link, vec3(place), vec3(axis)).set_motor(real(speed), 100000);
    turned = turned * glm::angleAxis(speed, axis);
    place += along, end += turned * along;
    before = link;
  }
  scene.tip = int(before.slot);
  scene.tip_reference = end - turned * (place - glm::dvec3(scene.world.bodies[before].x));
  return scene;
}

double off_reference(const BenchScene& scene) {
  return length(glm::dvec3(scene.world.bodies.at(scene.tip).x) - scene.tip_reference);
}

// A load of 1 t on 4 to 20 links of 1 kg, which hang at an angle below a carriage with a motor.
BenchScene drawn_hoist(unsigned seed) {
  Draw draw(seed);
  BenchScene scene;
  const int links = draw.whole(4, 20);
  const double size = draw.number(0.2, 1), angle = draw.number(0.05, 0.3);
  const vec3 along(real(std::sin(angle)), real(-std::cos(angle)), 0);
  const BodyId post = scene.box(0, vec3(real(0.2)), vec3(0, 1, 0));
  const BodyId carriage = scene.box(50, vec3(real(0.3)), vec3(0));
  auto& lift = scene.world.add<SliderJoint>(post, carriage, vec3(0),
                                            vec3(0, 1, 0));
  lift.set_motor(real(draw.number(0.2, 1)), 100000);
  BodyId before = carriage;
  for (int k = 0; k <= links; ++k) {
    const vec3 top = real(size * k) * along, x = real(size * (k + 0.5)) * along;
    const BodyId link = scene.box(k == links ? 1000 : 1, vec3(real(size / 2)), x);
    join_by_ball(scene, before, link, top);
    before = link;
  }
  return scene;
}

// A square curtain of balls on ball joints. It hangs by every fourth ball of its upper edge, and
// all others are blown to one side, the lower ones faster than the upper ones.
BenchScene drawn_curtain(unsigned seed, int balls) {
  Draw draw(seed);
  BenchScene scene;
  const double apart = draw.scale(0.02, 0.5);
  const double wind = draw.number(0, 0.5) * std::sqrt(9.81 * apart / balls);
  std::vector<BodyId> ids;
  for (int k = 0; k < balls * balls; ++k) {
    const int row = k / balls, column = k % balls;
    const bool held = row == 0 && column % 4 == 0;
    const vec3 x(real(apart * column), real(-apart * row), 0);
    const Body loose = ball(real(draw.scale(0.02, 0.1)), real(0.4 * apart), x);
    ids.push_back(scene.world.add(held ? static_body(x) : loose));
    if (!held) scene.world.bodies[ids.back()].v = vec3(0, 0, real(wind * row));
    for (const int before : {column > 0 ? k - 1 : -1, k - balls})
      if (before >= 0) {
        const BodyId other = ids[std::size_t(before)];
        join_by_ball(scene, other, ids.back(), (scene.world.bodies[other].x + x) / real(2));
      }
  }
  scene.world.set_beta(1);
  return scene;
}

// A boom on a hinge, raised or lowered by a cylinder: a barrel and a rod with a driven slider.
// \return by how much the cylinder's length is wrong after 3 s [m], at a number of steps per second
double cylinder_off(unsigned seed, int hertz) {
  Draw draw(seed);
  BenchScene scene;
  World& world = scene.world;
  const double reach = draw.number(2, 5), arm = draw.number(0.3, 0.6) * reach;
  const double slope = draw.number(0.2, 1);
  const vec3 pin(0), foot(real(draw.number(0.4, 0.8)), real(draw.number(-0.9, -0.5)), 0);
  const vec3 along(real(std::cos(slope)), real(std::sin(slope)), 0), eye = real(arm) * along;
  const vec3 pull = normalize(eye - foot), middle = (foot + eye) / real(2);
  const auto rod = [&](double mass, const vec3& from, const vec3& to) {
    return world.add(box(real(mass), vec3(length(to - from), real(0.2), real(0.2)),
                         (from + to) / real(2),
                         rotation(vec3(0, 0, std::atan2(to.y - from.y, to.x - from.x)))));
  };
  const BodyId base = scene.box(0, vec3(real(0.2)), pin);
  const BodyId boom = rod(draw.number(300, 1500), pin, real(reach) * along);
  const BodyId barrel = rod(50, foot, middle), piston = rod(25, middle, eye);
  const vec3 z(0, 0, 1);
  join_by_hinge(scene, base, boom, pin, z);
  join_by_hinge(scene, base, barrel, foot, z);
  join_by_hinge(scene, piston, boom, eye, z);
  auto& slider = world.add<SliderJoint>(barrel, piston, middle, pull);
  const double speed = draw.number(0.02, 0.06) * (draw.chance(0.5) ? 1 : -1);
  slider.set_motor(real(speed), 1e7);
  world.set_beta(1);
  DirectSolver solver = with(8, 8);
  for (int n = 0; n < 3 * hertz; ++n) step(world, solver, real(1) / real(hertz), second_order);
  return std::abs(double(slider.position(world.bodies)) - 3 * speed);
}

}  // namespace

TEST_CASE("a crowd of ragdolls comes to rest with closed joints") {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    INFO("seed " << seed);
    BenchScene scene = random_ragdolls(10, seed);
    double widest = 0;
    for (int n = 0; n < 300; ++n) {
      play_crowd(scene.world, 1);
      widest = std::max(widest, widest_gap(scene));
    }
    CHECK(widest < 0.1);  // at the impact
    CHECK(widest_gap(scene) < 0.002);
    CHECK(scene.finding.value(scene) < 1);  // the deepest corner [mm]
  }
}

TEST_CASE("newton holds ragdolls, boxes, chains with limits, trees and motors side by side") {
  for (unsigned seed = 1; seed <= 12; ++seed)
    for (const real added : {real(0), real(8)}) {
      CAPTURE(seed, added);
      BenchScene scene = mixed_islands(40, seed);
      feed_back_all(scene.world);
      DirectSolver solver = with(8, added);
      double widest = 0;
      for (int n = 0; n < 180; ++n) {
        step(scene.world, solver, sixtieth, second_order);
        widest = std::max(widest, widest_gap(scene));
      }
      CHECK(widest < (sizeof(real) == 8 ? 1e-6 : 1e-3));
    }
}

// Plays a scene for three seconds. Returns the widest gap of a joint and the deepest corner [m].
// \param from the first step in which corners count
static std::array<double, 2> widest_and_deepest(BenchScene scene,
                                                const std::function<void(World&)>& play,
                                                int from = 0) {
  std::array<double, 2> out{};
  for (int n = 0; n < 180; ++n) {
    play(scene.world);
    out[0] = std::max(out[0], widest_gap(scene));
    if (n >= from) out[1] = std::max(out[1], chapter8::penetration(scene.world));
  }
  return out;
}

TEST_CASE("four substeps and soft contacts hold scenes of everything, hardly in the ground") {
  const double closed = sizeof(real) == 8 ? 1e-6 : 1e-3;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    const auto [gap, deep] = widest_and_deepest(
        mixed_islands(40, seed), [](World& world) { play_everything(world, 1); },
        60);  // some limbs begin in the ground
    CHECK(gap < closed);
    CHECK(deep < 0.01);
  }
}

TEST_CASE("dolls that land enter the ground less in four substeps with soft contacts") {
  double worst[] = {0, 0};
  int dry = 0;  // in the ground by less than 1 cm
  for (const Family& family : contact_families())
    for (unsigned seed = 101; family.name == "limited dolls" && seed <= 160; ++seed) {
      CAPTURE(seed);
      DirectSolver solver;
      const auto soft = widest_and_deepest(family.draw(seed),
                                           [](World& world) { play_everything(world, 1); });
      const auto single = widest_and_deepest(family.draw(seed), [&](World& world) {
        step(world, solver, sixtieth, second_order);
      });
      dry += soft[1] < 0.01;
      worst[0] = std::max(worst[0], soft[1]), worst[1] = std::max(worst[1], single[1]);
      CHECK(std::max(soft[0], single[0]) < (sizeof(real) == 8 ? 1e-6 : 1e-3));
    }
  CAPTURE(worst[0], worst[1], dry);
  CHECK(dry >= 54);
  CHECK(worst[0] < 0.02);
  CHECK(worst[1] > 0.04);
}

TEST_CASE("an arm with six drives has its tool within a tenth of a millimetre") {
  int in_one_step = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    INFO("seed " << seed);
    BenchScene scene = drawn_arm(seed), coarse = drawn_arm(seed);
    play_arm(scene.world, 60);
    CHECK(off_reference(scene) < (sizeof(real) == 8 ? 1e-4 : 1e-3));
    play(coarse.world, 60);
    in_one_step += off_reference(coarse) < 1e-4;
    CHECK(off_reference(coarse) < (sizeof(real) == 8 ? 4e-4 : 3e-3));
  }
  if (sizeof(real) == 8) CHECK((in_one_step > 80 && in_one_step < 100));
}

TEST_CASE("a hoist lifts a ton on links of a kilogram, and no joint opens by a micrometre") {
  int lost = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    INFO("seed " << seed);
    BenchScene scene = drawn_hoist(seed), iterated = drawn_hoist(seed);
    const auto& lift = static_cast<const SliderJoint&>(*scene.world.joints()[0]);
    const double speed = double(lift.motor().speed);
    for (int n = 0; n < 600; ++n) {
      play(scene.world, 1);
      REQUIRE(widest_gap(scene) < (sizeof(real) == 8 ? 1e-6 : 1e-4));
    }
    CHECK(std::abs(double(scene.world.bodies.at(1).x.y) - 10 * speed) < 0.01 * 10 * speed);
    SequentialImpulses solver;
    solver.iterations = 30;
    for (int n = 0; n < 600 && widest_gap(iterated) < 1; ++n)
      step(iterated.world, solver, sixtieth);
    lost += widest_gap(iterated) >= 1;
  }
  CHECK(lost == 20);
}

TEST_CASE("a spring of given k and c sags by m g / k and oscillates as its equation says") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    INFO("seed " << seed);
    Draw draw(seed);
    const double m1 = draw.scale(1, 100), m2 = draw.scale(1, 100), K = 1 / m1 + 1 / m2;
    const double k = draw.scale(100, 1e5), omega = std::sqrt(k * K);
    const double zeta = draw.number(0.05, 0.9), c = 2 * zeta * omega / K, begin = 0.05;
    SequentialImpulses solver;

    World free;
    free.gravity = vec3(0);
    const BodyId a = free.add(ball(real(m1), real(0.2), vec3(0)));
    const BodyId b = free.add(ball(real(m2), real(0.2), vec3(0, real(1 + begin), 0)));
    make_spring(free.add<CentreDistanceJoint>(a, b, CentreDistance{1}), free.bodies, k, c);
    const double h = 1e-3 / omega, damped = omega * std::sqrt(1 - zeta * zeta);
    for (int n = 1; n <= 6000; ++n) {
      step(free, solver, real(h));
      const double t = n * h, C = double(length(free.bodies[b].x - free.bodies[a].x)) - 1;
      const double exact = begin * std::exp(-zeta * omega * t) *
                           (std::cos(damped * t) + zeta * omega / damped * std::sin(damped * t));
      REQUIRE(std::abs(C - exact) < 0.005 * begin);
    }

    World loaded;
    const BodyId wheel = loaded.add(static_body(vec3(0)));
    const BodyId car = loaded.add(ball(real(m2), real(0.2), vec3(0, 100, 0)));
    make_spring(loaded.add<CentreDistanceJoint>(wheel, car, CentreDistance{100}), loaded.bodies, k,
                c);
    for (int n = 0; n < 3000; ++n) step(loaded, solver, sixtieth);
    const double sag = 100 - double(loaded.bodies[car].x.y), expected = m2 * 9.81 / k;
    CHECK(std::abs(sag - expected) < 1e-3 * expected + (sizeof(real) == 8 ? 0 : 1e-4));
  }
}

TEST_CASE("a curtain of 40 by 40 balls is held by substeps, and is too dear to eliminate",
          "[slow]") {
  for (unsigned seed = 9; seed <= 12; ++seed) {
    INFO("seed " << seed);
    BenchScene scene = drawn_curtain(seed, 40);
    PackedImpulses solver;
    solver.iterations = 2;
    double widest = 0;
    for (int n = 0; n < 120; ++n) {
      step(scene.world, solver, sixtieth, {.substeps = 16});
      widest = std::max(widest, widest_gap(scene));
    }
    CHECK(widest < 0.01);
  }
  for (const int balls : {20, 40}) {
    CAPTURE(balls);
    BenchScene scene = drawn_curtain(1, balls);
    DirectSolver solver;
    step(scene.world, solver, sixtieth);
    CHECK(solver.report().iterated == (balls == 40));
  }
}

TEST_CASE("the length of a driven cylinder has an error of a tenth of a millimetre, and half of it "
          "with half the step") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    INFO("seed " << seed);
    const double coarse = cylinder_off(seed, 60);
    CHECK(coarse < (sizeof(real) == 8 ? 1e-4 : 1e-3));
    if (sizeof(real) == 8) CHECK(std::abs(cylinder_off(seed, 120) / coarse - 0.5) < 0.01);
  }
}
