// The machines of chapter 8 on the ground: a doll that falls and lies still, wheels that roll.
#include "bench/chapters/08_ground/ragdoll.h"
#include "bench/chapters/08_ground/wheels.h"
#include "tests/oracle/test.h"

using namespace joints::chapter8;

namespace {

Choice chosen(int iterations) {
  Choice choice;
  choice.iterations = iterations;
  return choice;
}

void run(Scene& scene, double seconds) {
  for (int n = 0; n < int(seconds / double(h) + 0.5); ++n)
    step(scene.world, scene.solver, h, scene.stepping);
}

}  // namespace

TEST_CASE("a ragdoll that falls lies still after ten seconds and for a minute more") {
  for (const int iterations : {10, 30}) {
    CAPTURE(iterations);
    Ragdoll doll(chosen(iterations));
    run(doll.scene, 10);
    CHECK(doll.scene.world.bodies[doll.torso].x.y < 0.6);  // it did fall
    double fastest = 0, fastest_turn = 0, gap = 0;
    const vec3 before = doll.scene.world.bodies[doll.torso].x;
    for (int n = 0; n < 3600; ++n) {
      run(doll.scene, double(h));
      fastest = std::max(fastest, doll.fastest());
      fastest_turn = std::max(fastest_turn, doll.fastest_turn());
      gap = std::max(gap, widest(doll.scene));
    }
    CHECK(fastest < 1e-3);
    CHECK(fastest_turn < 1e-3);
    CHECK(gap < 1e-3);
    CHECK(penetration(doll.scene.world) < 1e-3);
    CHECK(double(length(doll.scene.world.bodies[doll.torso].x - before)) < 1e-3);
  }
}

TEST_CASE("a ragdoll holds together in its fall and loses nothing but energy") {
  Ragdoll doll(chosen(30));
  const double start = energy(all_of(doll.scene.world.bodies), doll.scene.world.gravity);
  double gap = 0, highest = start;
  for (int n = 0; n < 300; ++n) {
    run(doll.scene, double(h));
    gap = std::max(gap, widest(doll.scene));
    highest = std::max(highest, energy(all_of(doll.scene.world.bodies), doll.scene.world.gravity));
    REQUIRE(all_finite(doll.scene.world));
  }
  CHECK(gap < 0.05);
  CHECK(highest - start < 0.02 * doll.scene.energy_scale);  // nothing but rounding and steps
}

TEST_CASE("nine dolls out of ten that fall as they happen to lie still after ten seconds") {
  Random random(8);
  int still = 0;
  const int dolls = 20;  // the others swing: a limb about shoulder and hand has no friction
  for (int k = 0; k < dolls; ++k) {
    Ragdoll doll(chosen(30), 2, random.turn());
    run(doll.scene, 10);
    REQUIRE(all_finite(doll.scene.world));
    still += doll.rests();
  }
  CHECK(still >= 18);
}

TEST_CASE("wheels of cubes roll as far as a round wheel of the same girth, and come back") {
  Wheels wheels(chosen(Wheels::iterations));
  wheels.drive(Wheels::speed, Wheels::strength);
  double gap = 0;
  int flying = 0;
  const auto drive = [&] {
    for (int n = 0; n < 600; ++n) {
      run(wheels.scene, double(h));
      gap = std::max(gap, widest(wheels.scene));
      flying += wheels.flying();
    }
  };
  drive();
  const double rolled = wheels.turned() * Wheels::rolling_radius(), place = wheels.place();
  CHECK(rolled > 0.7 * 10 * double(Wheels::speed) * Wheels::rolling_radius());  // it went
  CHECK(std::abs(place - rolled) < 0.05 * rolled);
  CHECK(std::abs(double(wheels.scene.world.bodies[wheels.beam].x.z)) < 0.02 * place);  // straight
  wheels.drive(-Wheels::speed, Wheels::strength);
  drive();
  CHECK(std::abs(wheels.place()) < 0.15 * place);
  CHECK(gap < 0.02);
  CHECK(flying < 60);
}

TEST_CASE("a motor that is too weak to lift the wheels over a corner does not move them") {
  const auto way = [](double share) {
    Wheels wheels(chosen(Wheels::iterations));
    wheels.drive(Wheels::speed, real(share * Wheels::needed()));
    run(wheels.scene, 10);
    return wheels.place();
  };
  CHECK(std::abs(way(0.9)) < 0.2);
  CHECK(way(1.1) > Wheels::chord());
}
