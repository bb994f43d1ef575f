// The adapters of published engines: each builds the world that ours is, before a time counts.
#include "bench/accuracy.h"
#include "bench/peers/entries.h"
#include "bench/peers/peer.h"
#include "bench/tasks.h"
#include "contacts/ground_contact.h"
#include "direct/direct_solver.h"
#include "joints/slider_joint.h"
#include "tests/checker/catch.h"
#include "tests/oracle/beside.h"

using namespace joints;
using namespace joints::testing;

namespace {

constexpr bool in_double = sizeof(real) == 8;

std::string named(const bench::PeerSetting& peer, const std::string& scene) {
  return peer.engine + " " + peer.version + ", " + peer.name + ", " + scene;
}

// The scene after these steps of a peer.
bench::BenchScene after(const bench::PeerSetting& peer, const bench::MakeScene& make, double h,
                        int steps) {
  bench::BenchScene scene = make();
  const auto world = peer.make(bench::peer_scene(scene.world));
  for (int n = 0; n < steps; ++n) world->step(h);
  world->show(scene.world.bodies);
  return scene;
}

bench::BenchScene slide() {
  bench::BenchScene scene;
  const BodyId rail = scene.box(0, vec3(1), vec3(0));
  const BodyId sled = scene.box(3, vec3(real(0.5), 1, 1), vec3(1, 2, 0));
  scene.world.add<SliderJoint>(rail, sled, vec3(1, 2, 0), vec3(1, 1, 0));
  return scene;
}

bool reduced(const bench::PeerSetting& peer) {
  return peer.reduced;
}

bool iterates_on(const bench::PeerSetting& peer, const bench::PeerScene& scene) {
  const bool has_rows = scene.is_driven() || !bench::trees_of(scene).loops.empty();
  return !peer.exact || (reduced(peer) && has_rows);
}

bool one_euler_step(const bench::PeerSetting& peer) {
  return peer.name.find("substeps") == std::string::npos &&
         peer.name.find("Runge") == std::string::npos && peer.name != "Verlet";
}

}  // namespace

TEST_CASE("the first step of every peer that does not iterate has the exact acceleration") {
  std::vector<bench::PeerEntry> entries = bench::peer_entries(true);
  entries.push_back({.name = "slider", .make = slide});
  // In float feedback divides the rounding of an anchor by the step, which hides accelerations.
  for (const bench::AccuracyScene& scene : bench::accuracy_scenes())
    if (in_double && scene.key != "wheel on an axle" && scene.key != "top")  // at rest
      entries.push_back({.name = scene.key, .make = scene.make});
  int compared = 0;
  for (const bench::PeerEntry& entry : entries) {
    bench::BenchScene exact = entry.make();
    const bench::PeerScene scene = bench::peer_scene(exact.world);
    if (scene.touches() || scene.joints.size() > 200) continue;
    for (const bench::PeerSetting& peer : bench::peer_settings()) {
      if (!peer.takes(scene) || iterates_on(peer, scene) || !one_euler_step(peer)) continue;
      INFO(named(peer, entry.name));
      // The rows of ODE are a little soft, the more so the shorter the step is. The others show
      // their velocities at the new poses.
      const bool soft = peer.engine == "ODE";
      const double h = soft ? 1.0 / 60 : 1e-4, share = !in_double ? 4e-2 : soft ? 2e-2 : 2e-5;
      exact = entry.make();
      DirectSolver solver = DirectSolver::velocities_only();
      begin_step(exact.world, solver, real(h));
      solver.solve(exact.world.bodies);
      const std::vector<Body> unmoved(exact.world.bodies.begin(), exact.world.bodies.end());
      end_step(exact.world, solver, real(h));
      const bench::BenchScene there = after(peer, entry.make, h, 1);
      // A drive has its speed at once: of that, rounding and the way to the new poses.
      const double fastest = speeds_apart(exact.world, entry.make().world);
      // A body that a drive sets rotating may show its velocity before or after it has moved.
      CHECK(std::min(speeds_apart(there.world, exact.world), speeds_apart(there.world, unmoved)) <
            share * 9.81 * h + tolerance(1e-7, 4e-4) * fastest);
      ++compared;
    }
  }
  CHECK(compared >= 20);
}

TEST_CASE("the Runge-Kutta steps of the peers come to the references of the accuracy scenes") {
  for (const bench::AccuracyScene& scene : bench::accuracy_scenes())
    for (const bench::PeerSetting& peer : bench::peer_settings()) {
      if (!scene.is_tree || peer.name.find("Runge") == std::string::npos || !in_double) continue;
      INFO(named(peer, scene.key));
      const bench::BenchScene exact = scene.make();
      const int steps = int(std::lround(480 * exact.tip_time));
      const bench::BenchScene there = after(peer, scene.make, 1.0 / 480, steps);
      const glm::dvec3 tip(there.world.bodies.at(exact.tip).x);
      // On a ball joint that rotates fast their steps are of order 2.
      CHECK(glm::length(tip - exact.tip_reference) < (scene.key == "top" ? 2e-3 : 1e-5));
    }
}

TEST_CASE("every peer's pendulum swings as the exact one does") {
  const bench::MakeScene make = [] { return bench::cubes_on_hinges(1, 2); };
  bench::BenchScene exact = make();
  DirectSolver solver = DirectSolver::velocities_only();
  solver.newton = 8;
  exact.world.set_beta(1);
  for (int n = 0; n < 1000; ++n)
    step(exact.world, solver, real(1e-3), {.leapfrog = true});
  for (const bench::PeerSetting& peer : bench::peer_settings()) {
    INFO(named(peer, "pendulum"));
    const bench::BenchScene there = after(peer, make, 1e-3, 1000);
    const vec3 off = there.world.bodies.at(1).x - exact.world.bodies.at(1).x;
    CHECK(double(length(off)) < 8e-3);  // semi-implicit Euler itself is off by g h t / 2 = 5 mm
  }
}

TEST_CASE("every peer's motor turns the way it should and keeps its torque, and limits stop") {
  for (const bench::PeerSetting& peer : bench::peer_settings()) {
    if (peer.name.find("implicit") != std::string::npos) continue;  // it forgets the bound
    if (peer.trees_only) continue;                                  // no drives
    INFO(named(peer, "motor and limit"));
    const auto found = [&](const bench::MakeScene& make, double h, double time) {
      const bench::BenchScene scene = after(peer, make, h, int(std::lround(time / h)));
      return scene.finding.value(scene) / scene.finding.expected;
    };
    CHECK(found(bench::driven_crane, 1e-3, 1) == Approx(1).margin(0.01));
    CHECK(found(bench::stopped_crane, 1e-3, 8) == Approx(1).margin(0.02));
  }
}

TEST_CASE("every peer's box holds on a slope of 20 degrees and slides with less friction") {
  const double angle = 0.35, time = 0.3;
  const double expected =
      9.81 * (std::sin(angle) - 0.1 * std::cos(angle)) * time * time / 2;
  for (const bench::PeerSetting& peer : bench::peer_settings()) {
    if (peer.name == "Lemke" || peer.trees_only) continue;  // it loses a box with friction
    INFO(named(peer, "box on a slope"));
    for (const bench::PeerEntry& entry : bench::peer_entries(true)) {
      if (entry.name != "box on a slope") continue;
      for (const double friction : {0.5, 0.1}) {
        bench::BenchScene scene = entry.make();
        auto& contact = dynamic_cast<GroundContact&>(*scene.world.joints().front());
        contact.friction = real(friction);
        const auto world = peer.make(bench::peer_scene(scene.world));
        for (int n = 0; n < 300; ++n) world->step(1e-3);
        world->show(scene.world.bodies);
        const double slid = length(glm::dvec3(scene.world.bodies.at(1).x) -
                                   glm::dvec3(entry.make().world.bodies.at(1).x));
        if (friction == 0.5) CHECK(slid < 0.02);
        else CHECK(slid == Approx(expected).margin(0.02));
      }
    }
  }
}

TEST_CASE("ragdolls in drawn poses stay on the ground and gain no energy with every peer") {
  for (const unsigned seed : {1u, 2u}) {
    const bench::MakeScene make = [=] { return bench::random_ragdolls(24, seed, 1.6); };
    const bench::BenchScene start = make();
    const bench::PeerScene scene = bench::peer_scene(start.world);
    const auto energy_of = [](const World& world) {
      return energy(all_of(world.bodies), world.gravity);
    };
    CHECK(start.finding.value(start) == 0);  // no limb is in the ground
    for (const bench::PeerSetting& peer : bench::peer_settings()) {
      // One step of Euler a frame is too long for reduced coordinates.
      const bool too_long = reduced(peer) && one_euler_step(peer) && peer.name != "implicit";
      if (!peer.takes(scene) || !peer.quick || too_long) continue;
      INFO(named(peer, "ragdolls") << ", seed " << seed);
      const bench::BenchScene there = after(peer, make, 1.0 / 60, 90);
      CHECK(there.finding.value(there) < 200);  // [mm]
      CHECK(energy_of(there.world) < 0.5 * energy_of(start.world));
    }
  }
}
