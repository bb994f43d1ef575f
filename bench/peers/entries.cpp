// The scenes on which peers are measured.
#include "bench/peers/entries.h"

#include <algorithm>

#include "bench/random_chains.h"
#include "bench/tasks.h"
#include "chapters/05_fixed/program/hung_ragdoll.h"
#include "chapters/08_ground/program/program.h"

namespace joints::bench {

namespace {

BenchScene hung_ragdoll() {
  BenchScene scene;
  static_cast<Scene&>(scene) =
      std::move(chapter5::HungRagdoll({.iterations = 30, .out = ""}).scene);
  scene.tip_mask = glm::dvec3(0);
  return scene;
}

// A box of 10 kg on a slab that is turned by an angle [rad], friction 0.5: it holds below 27
// degrees. Its mark says how far it has gone from its place.
BenchScene box_on_slope(double angle) {
  BenchScene scene;
  scene.name = "box on a slope";
  scene.tip_mask = glm::dvec3(0);
  const quat turn = rotation(vec3(0, 0, real(angle)));
  const BodyId slab = scene.box(0, vec3(10, real(0.2), 10), turn * vec3(0, real(-0.1), 0), turn);
  const BodyId crate = scene.box(10, vec3(1), turn * vec3(0, real(0.5), 0), turn);
  chapter8::stand(scene, slab, crate, vec3(1), real(0.5));
  scene.mark(slab, crate, turn * vec3(0));
  scene.energy_scale = 10 * 9.81;
  return scene;
}

}  // namespace

std::vector<PeerEntry> peer_entries(bool quick) {
  const Span ten_seconds{.steps = 600, .timed = 80}, one_second{.steps = 60, .timed = 60};
  constexpr double clear = 1.6;  // [m]: no limb of a ragdoll starts inside the ground
  const std::string all = "si30 beta1 4x8 16x2 omega velocity shake velocity/8 shake/8",
                    inertia = all + " inertia",
                    contacts = "si30 4x8 16x2 rows10 lanes10 velocity velocity/4";
  std::vector<PeerEntry> list = {
      {.name = "S1", .make = [] { return cubes_on_hinges(10, 100); },
       .ours = "si30 beta1 4x8 lanes chapter7 velocity shake inertia velocity/4 shake/4 rk4",
       .slow = true},
      {.name = "S2 R=1", .make = [] { return heavy_end(1); }, .ours = inertia, .quick = false},
      {.name = "S2 R=100", .make = [] { return heavy_end(100); }, .ours = inertia},
      {.name = "S2 R=1000", .make = [] { return heavy_end(1000); }, .ours = inertia},
      {.name = "S3", .make = [] { return hanging_bridge(true); }, .ours = inertia},
      {.name = "S3b", .make = rope_bridge, .ours = inertia},
      {.name = "S4m", .make = driven_crane, .span = one_second, .ours = inertia + " plain placed"},
      {.name = "S4l", .make = stopped_crane, .span = ten_seconds, .ours = inertia},
      {.name = "S5", .make = [] { return cubes_on_hinges(1, 4); }, .ours = all + " rk4"},
      {.name = "S6", .make = loaded_axes, .ours = all + " rk4"},
      {.name = "S7", .make = sideways_gravity,
       .ours = "si30 beta1 4x8 lanes velocity shake inertia velocity/4 shake/4 rk4"},
      {.name = "hung chain with 1 t", .make = [] { return hung_chain(10, 1000); },
       .span = ten_seconds, .ours = inertia},
      {.name = "chains with limits", .make = [] { return limited_chains(10, 10, 1); },
       .ours = "si30 4x8 16x2 rows10 lanes10 velocity shake velocity/8"},
      {.name = "hung ragdoll", .make = hung_ragdoll, .span = ten_seconds,
       .ours = inertia + " split"},
      {.name = "beam of 20", .make = [] { return welded_beam(20); }, .ours = inertia},
      {.name = "arm", .make = arm, .span = one_second, .ours = inertia + " split plain placed"},
      {.name = "box at rest", .make = [] { return box_on_slope(0); }, .ours = contacts},
      {.name = "box on a slope", .make = [] { return box_on_slope(0.35); }, .ours = contacts},
      {.name = "planks", .make = loaded_planks, .span = ten_seconds, .ours = contacts},
      {.name = "ragdolls 100", .make = [] { return random_ragdolls(100, 1, clear); },
       .span = {.steps = 150}, .ours = contacts, .falls = true}};
  if (sizeof(real) == 8)  // in float they would take minutes more
    list.push_back({.name = "ragdolls 5000",
                    .make = [] { return random_ragdolls(5000, 1, clear); },
                    .span = {.steps = 60}, .ours = "rows10 lanes10 velocity", .quick = false,
                    .basic = true, .falls = true});
  for (const int chains : {1, 10, 101, 1010})
    list.push_back({.name = std::to_string(99 * chains) + " hinges",
                    .make = [=] { return cubes_on_hinges(chains, 100); },
                    .span = {.steps = chains < 100 ? 60 : 26, .timed = chains < 100 ? 60 : 26},
                    .ours = "si30 lanes velocity", .quick = chains < 100, .basic = true});
  if (quick) std::erase_if(list, [](const PeerEntry& one) { return !one.quick; });
  return list;
}

}  // namespace joints::bench
