// The cost of a joint: rows, memory and instructions, for every kind of joint and a box at rest,
// also with a limit out of reach and an idle motor, and in two scenes of several islands.
// `./wb bench --cost` calls it under valgrind, which counts.
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <new>

#include "bench/counted.h"
#include "bench/settings.h"
#include "bench/tasks.h"
#include "contacts/ground_contact.h"
#include "engine/instruments/options.h"
#include "engine/instruments/plan.h"
#include "joints/fixed_joint.h"
#include "joints/hinge_joint.h"
#include "joints/slider_joint.h"

using namespace joints;
using namespace joints::bench;

// ---- the heap -----------------------------------------------------------------------------------

namespace {

long long held = 0;                 // bytes that were asked for and not given back
constexpr std::size_t header = 64;  // in front of each piece: its size, and room to keep it aligned

void* take(std::size_t size) {
  void* const all = std::aligned_alloc(header, (size + 2 * header - 1) / header * header);
  if (!all) throw std::bad_alloc();
  *static_cast<std::size_t*>(all) = size;
  held += static_cast<long long>(size);
  return static_cast<char*>(all) + header;
}

void give_back(void* piece) noexcept {
  if (!piece) return;
  void* const all = static_cast<char*>(piece) - header;
  held -= static_cast<long long>(*static_cast<std::size_t*>(all));
  std::free(all);
}

}  // namespace

void* operator new(std::size_t size) { return take(size); }
void* operator new(std::size_t size, std::align_val_t) { return take(size); }
void operator delete(void* piece) noexcept { give_back(piece); }
void operator delete(void* piece, std::size_t) noexcept { give_back(piece); }
void operator delete(void* piece, std::align_val_t) noexcept { give_back(piece); }
void operator delete(void* piece, std::size_t, std::align_val_t) noexcept { give_back(piece); }

namespace {

// ---- the cases ----------------------------------------------------------------------------------

constexpr int bodies = 100;  // of a chain

// What a solver takes, each one also what stands before it.
enum class Takes { plain_hinges, equality_rows, trees, any_rows };

// A kind of joint: how two bodies of a chain are joined by it. Or a whole scene.
struct Case {
  const char* name;
  std::function<void(World& world, BodyId a, BodyId b, const vec3& anchor)> join;
  Takes needs = Takes::any_rows;
  std::function<BenchScene()> scene{};
  int before = 2;  // steps before the counted ones
};

HingeJoint& hinge(World& world, BodyId a, BodyId b, const vec3& anchor) {
  return world.add<HingeJoint>(a, b, anchor, vec3(1, 0, 0));
}

std::vector<Case> cases() {
  return {
      {"none", [](World&, BodyId, BodyId, const vec3&) {}, Takes::plain_hinges},
      {"ball",
       [](World& world, BodyId a, BodyId b, const vec3& anchor) {
         world.add<BallJoint>(a, b, point_at(world.bodies[a], world.bodies[b], anchor));
       },
       Takes::equality_rows},
      {"hinge",
       [](World& world, BodyId a, BodyId b, const vec3& anchor) { hinge(world, a, b, anchor); },
       Takes::plain_hinges},
      {"hinge + inactive limit",
       [](World& world, BodyId a, BodyId b, const vec3& anchor) {
         hinge(world, a, b, anchor).set_limits(-3, 3);  // [rad], far from both
       },
       Takes::trees},
      {"hinge + idle motor",
       [](World& world, BodyId a, BodyId b, const vec3& anchor) {
         hinge(world, a, b, anchor).set_motor(1, 0);  // has a speed, is switched off
       },
       Takes::trees},
      {"hinge + motor",
       [](World& world, BodyId a, BodyId b, const vec3& anchor) {
         hinge(world, a, b, anchor).set_motor(1, 500);
       },
       Takes::trees},
      {"slider",
       [](World& world, BodyId a, BodyId b, const vec3& anchor) {
         world.add<SliderJoint>(a, b, anchor, vec3(1, 0, 0));
       },
       Takes::equality_rows},
      {"fixed",
       [](World& world, BodyId a, BodyId b, const vec3& anchor) {
         world.add<FixedJoint>(a, b, anchor);
       },
       Takes::equality_rows},
      {"box at rest", [](World& world, BodyId, BodyId b, const vec3&) {
         const BodyId ground = world.bodies.id(0);  // its top lies under all others
         world.add<GroundContact>(ground, b, Top{.height = real(-0.5)}, box_outline(vec3(1)));
       }},
      {"box out of reach", [](World& world, BodyId, BodyId b, const vec3&) {
         const BodyId ground = world.bodies.id(0);
         world.add<GroundContact>(ground, b, Top{.height = real(-30)}, box_outline(vec3(1)));
       }},
      {"hinge in ten chains", {}, Takes::plain_hinges, [] { return cubes_on_hinges(10, 10); }},
      {"random ragdolls that land", {}, Takes::any_rows,
       [] { return random_ragdolls(16, 1); }, 40}};
}

// The thesis' chain: cubes of edge 1 m and 100 kg, 1.5 m apart, held out level by the first.
World world_of(const Case& what) {
  if (what.scene) return std::move(what.scene().world);
  World world;
  BodyId before;
  for (int i = 0; i < bodies; ++i) {
    const vec3 place(0, 0, real(1.5) * real(i));
    const BodyId id = world.add(i == 0 ? static_body(place) : box(100, vec3(1), place));
    if (i > 0) what.join(world, before, id, place - vec3(0, 0, real(1.5)));
    before = id;
  }
  return world;
}

// ---- the solvers --------------------------------------------------------------------------------

constexpr real h = real(1) / 60;

struct Candidate {
  const char* name;
  Way way;
  Takes takes = Takes::any_rows;
};
const Candidate candidates[] = {
    {"engine rows", {.loop = Loop::rows}},
    {"engine packed", {.loop = Loop::packed}},
    {"library default", {.loop = Loop::lanes}},
    {"direct", {.loop = Loop::direct, .beta = 1, .leapfrog = true}},
    {"direct newton 8", {.loop = Loop::direct, .beta = 1, .leapfrog = true, .newton = 8}},
    {"Runge-Kutta", {.loop = Loop::runge_kutta}, Takes::equality_rows},
    {"reduced", {.loop = Loop::tree}, Takes::trees},
    {"reduced Runge-Kutta", {.loop = Loop::tree_runge_kutta}, Takes::equality_rows},
    {"textbook", {.loop = Loop::textbook}, Takes::plain_hinges},  // the tables' unit of time
    {"chapter 7", {.loop = Loop::hinges, .visits = Visits::chain_order}, Takes::plain_hinges}};

// ---- rows and memory ----------------------------------------------------------------------------

// Joints, rows and bytes of a run that is in its first counted step.
struct Size {
  int joints = 0, rows = 0;
  long long bytes = 0;
};

Size size_of(const Candidate& candidate, const Case& what) {
  const long long before = held;
  World world = world_of(what);
  const Step step = candidate.way.setting(10).make();
  for (int n = 0; n <= what.before; ++n) step(world, h);
  const int joints = what.join ? bodies - 1 : int(world.joints().size());
  int rows = world.blocks.rows();
  if (candidate.takes == Takes::plain_hinges) {  // its bodies and hinges are its own
    rows = 5 * int(world.joints().size());
    world = World();
  }
  return {joints, rows, held - before};
}

// One line and two counts for each case. The memory of a joint: the bytes that the heap holds more
// with the joints of a chain than without them, or all bytes of a scene, divided by their number.
void all(const Candidate& candidate) {
  const std::vector<Case> list = cases();
  const Size none = size_of(candidate, list.front());
  for (const Case& what : list) {
    if (what.needs > candidate.takes) continue;
    const Counted counted{.before = what.before};
    const auto [joints, rows, all_bytes] = size_of(candidate, what);
    const long long bytes = all_bytes - (what.scene ? 0 : none.bytes);
    std::printf("%s,%g,%.1f,%s,%s,%d,%d,%d,%d\n", what.name, double(rows) / joints,
                double(bytes) / joints, candidate.name, sizeof(real) == 8 ? "double" : "float",
                joints, counted.steps, counted.few, counted.many);
    count(
        [&](int iterations) -> std::function<void()> {
          const auto world = std::make_shared<World>(world_of(what));
          return [world, step = candidate.way.setting(iterations).make()] { step(*world, h); };
        },
        counted);
  }
}

}  // namespace

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("What a joint costs", {});
    if (!options.read(argc, argv)) return;
    std::puts("case,rows,bytes_per_joint,solver,real,joints,steps,few,many");
    for (const Candidate& candidate : candidates) all(candidate);
  });
}
