// Random worlds with every kind of joint and solver, and now and then a number, a body or a joint
// in them that is bad: a step refuses and changes nothing, or it overflows and says so, or all is
// finite. ./wb check --long plays ten times as many worlds.
#include <cstdlib>
#include <functional>

#include "bench/runge_kutta.h"
#include "direct/direct_solver.h"
#include "engine/simd/packed.h"
#include "tests/fuzz/numbers.h"
#include "tests/oracle/picture.h"
#include "tests/oracle/test.h"

namespace {

// ---- drawing ------------------------------------------------------------------------------------

class Draw : public Random {
 public:
  using Random::Random;
  bool chance(double share) { return double(uniform(0, 1)) < share; }
  int whole(int from, int to) { return std::min(to, from + int(uniform(0, real(to - from + 1)))); }
  real size(double from, double to) {  // all orders of magnitude alike
    return std::exp(uniform(real(std::log(from)), real(std::log(to))));
  }
  template <class Item>
  const Item& of(const std::vector<Item>& items) {
    return items[std::size_t(whole(0, int(items.size()) - 1))];
  }
  // Zero, too large, too small, or none at all.
  real nasty() {
    using Limits = std::numeric_limits<real>;
    return of(std::vector<real>{Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), 0, -1,
                                2, Limits::max(), -Limits::max(), std::sqrt(Limits::max()),
                                Limits::min(), Limits::denorm_min(), real(1e19), real(-1e12)});
  }
  vec3 nasty_vector(const vec3& good) {
    vec3 bad = good;
    bad[whole(0, 2)] = nasty();
    return bad;
  }
};

// ---- the world ----------------------------------------------------------------------------------

struct Settings {
  real h = real(1) / 60;
  StepOptions how;
  SequentialImpulses sequential;
  PackedImpulses packed;
  DirectSolver direct;
  RungeKutta kutta;
  int kind = 0;

  explicit Settings(Draw& draw) : kind(draw.whole(0, 3)) {
    h = draw.chance(0.8) ? real(1) / real(draw.whole(30, 480)) : draw.size(1e-8, 1e9);
    how = {.warm_start = draw.chance(0.7),
           .substeps = draw.chance(0.7) ? 1 : draw.whole(2, 3),
           .projections = draw.chance(0.7) ? 0 : draw.whole(1, 2),
           .leapfrog = draw.chance(0.3),
           .frequency = draw.chance(0.8) ? real(0) : draw.size(0.1, 100)};
    sequential.iterations = packed.iterations = draw.whole(1, 8);
    sequential.relaxation = packed.relaxation = draw.chance(0.5) ? real(1) : draw.uniform(1, 2);
    direct.newton = draw.chance(0.5) ? 0 : 8;
    direct.added_inertia = draw.chance(0.7) ? real(0) : real(8);
    direct.most_work = draw.chance(0.9) ? 3000 : 1;
  }
  void step(World& world) {
    if (kind == 3) return kutta.step(world, h);
    Solver* const solvers[] = {&sequential, &packed, &direct};
    joints::step(world, *solvers[kind], h, how);
  }
  std::vector<real*> numbers() {
    return {&h, &how.frequency, &how.damping, &sequential.relaxation, &packed.relaxation,
            &direct.added_inertia};
  }
};

// One of the numbers that anybody may change between two steps.
real& any_number(Draw& draw, World& world, Settings& settings) {
  Addresses numbers;
  const int what = draw.whole(0, 9);
  if (what < 4) {
    take(numbers, world.bodies.at(draw.whole(0, world.bodies.slots() - 1)));
  } else if (what < 8 && !world.joints().empty()) {
    Joint& joint = *world.joints()[std::size_t(draw.whole(0, int(world.joints().size()) - 1))];
    take(numbers, joint);
  } else if (what == 8) {
    numbers = settings.numbers();
  } else {
    take(numbers, world.gravity), take(numbers, world.last_h);
  }
  return *draw.of(numbers);
}

// ---- the game -----------------------------------------------------------------------------------

struct Counts {
  int steps = 0, refused = 0, overflowed = 0, refused_calls = 0;
};

class Game {
 public:
  Game(unsigned seed, Counts& counts) : draw_(seed), settings_(draw_), counts_(counts) {
    for (int k = draw_.whole(1, 8); k > 0; --k) add_body(false);
    for (int k = draw_.whole(0, 10); k > 0; --k) add_joint(false);
  }

  void play() {
    for (int n = draw_.whole(5, 25); n > 0; --n) {
      if (draw_.chance(0.15)) change_world();
      if (draw_.chance(0.25)) step_with_bad_number();
      step();
    }
  }

 private:
  bool is_finite(int slot) const {
    const Body& b = world_.bodies.at(slot);
    return finite(b.x) && finite(b.q) && finite(b.v) && finite(b.w);
  }
  bool all_finite() const {
    for (int slot = 0; slot < world_.bodies.slots(); ++slot)
      if (!is_finite(slot)) return false;
    return true;
  }

  // What a call that may be refused says; "" where it is accepted. Refused, it changes nothing.
  std::string try_it(const std::function<void()>& call) {
    const std::string before = bits_of(world_), words = refusal(call);
    if (words == "accepted") return "";
    const bool unchanged = bits_of(world_) == before;
    INFO(words);
    REQUIRE(unchanged);
    ++counts_.refused_calls;
    return words;
  }

  // A step. "" where it was made, or overflowed and said so.
  std::string try_step() {
    bool overflowed = false;
    ++counts_.steps;
    const std::string words = try_it([&] {
      try {
        settings_.step(world_);
      } catch (const std::overflow_error&) {
        overflowed = true;
      } catch (const std::runtime_error&) {  // the Runge-Kutta method, which has not moved then
      }
    });
    if (!words.empty()) return words;
    REQUIRE(overflowed != all_finite());
    if (overflowed) clear_away();
    return words;
  }
  void clear_away() {
    ++counts_.overflowed;
    for (const BodyId id : ids_)
      if (world_.bodies.alive(id) && !is_finite(int(id.slot))) world_.remove(id);
    REQUIRE(all_finite());
    std::erase_if(ids_, [&](BodyId id) { return !world_.bodies.alive(id); });
    if (ids_.empty()) add_body(false);
  }

  // Nothing is bad: only the Runge-Kutta method may refuse, and only what has bounds; and sliders
  // and welds refuse what has gone farther than their numbers reach.
  void step() {
    const std::string words = try_step();
    INFO(words);
    REQUIRE((words.empty() || (settings_.kind == 3 && words.starts_with("world: ")) ||
             words.find("cannot tell its rows apart") != std::string::npos));
  }
  void step_with_bad_number() {
    real& number = any_number(draw_, world_, settings_);
    const real good = number;
    number = draw_.nasty();
    if (try_step().empty()) return keep_or_mend();
    ++counts_.refused;
    number = good;
  }
  // What was accepted stays, settings excepted: a step of 1e9 s makes the world a dull one.
  void keep_or_mend() {
    const int kind = settings_.kind;
    settings_ = Settings(draw_);
    settings_.kind = kind;
  }

  BodyId any_body() { return draw_.of(ids_); }

  void change_world() {
    switch (draw_.whole(0, 5)) {
      case 0: return add_body(draw_.chance(0.5));
      case 1: case 2: return add_joint(draw_.chance(0.5));
      case 3: return remove_body();
      case 4: return lose_body();
      case 5: return remove_joint();
    }
  }
  void remove_body() {
    if (ids_.size() < 2) return;
    const std::size_t k = std::size_t(draw_.whole(0, int(ids_.size()) - 1));
    world_.remove(ids_[k]);
    ids_.erase(ids_.begin() + long(k));
  }
  // Removes a body without its joints: then no step is accepted until they are gone.
  void lose_body() {
    if (ids_.size() < 2) return;
    const BodyId lost = ids_.back();
    ids_.pop_back();
    world_.bodies.remove(lost);
    const auto holds = [&](const auto& joint) {
      return joint->body1 == lost || joint->body2 == lost;
    };
    for (;;) {
      const auto& joints = world_.joints();
      const auto holding = std::find_if(joints.begin(), joints.end(), holds);
      if (holding == joints.end()) return;
      REQUIRE(!try_step().empty());
      world_.remove(**holding);
    }
  }
  void remove_joint() {
    if (!world_.joints().empty()) world_.remove(*draw_.of(pointers()));
  }
  std::vector<const Joint*> pointers() const {
    std::vector<const Joint*> out;
    for (const auto& joint : world_.joints()) out.push_back(joint.get());
    return out;
  }

  void add_body(bool bad) {
    const vec3 x = draw_.vector(4);
    const vec3 size{draw_.size(0.1, 3), draw_.size(0.1, 3), draw_.size(0.1, 3)};
    const quat q = draw_.turn();
    Body body = draw_.chance(0.3) ? static_body(x, q) : box(draw_.size(0.01, 1e4), size, x, q);
    if (!body.is_static()) {
      body.v = draw_.vector(5);
      body.w = draw_.vector(5);
      if (draw_.chance(0.2)) body.torque = draw_.vector(10);
    }
    Addresses numbers;
    take(numbers, body);
    if (bad) *draw_.of(numbers) = draw_.nasty();
    try_it([&] { ids_.push_back(world_.add(body)); });
  }

  void add_joint(bool bad) {
    const BodyId a = any_body(), b = bad && draw_.chance(0.2) ? BodyId{9, 9} : any_body();
    const bool whole = draw_.chance(0.7);
    const vec3 good = draw_.vector(4), axis = draw_.vector(1);
    const real length = draw_.size(0.1, 5);
    const int spoilt = bad ? draw_.whole(0, 2) : -1;  // bad or not, a may be b
    const vec3 anchor = spoilt == 0 ? draw_.nasty_vector(good) : good;
    const vec3 along = spoilt == 1 ? draw_.nasty_vector(axis) : axis;
    const real far = spoilt == 2 ? draw_.nasty() : length;
    const int kind = draw_.whole(0, 8);
    try_it([&] {
      Bodies& bodies = world_.bodies;
      switch (kind) {
        case 0: world_.add<CentreDistanceJoint>(a, b, CentreDistance{far}); break;
        case 1: world_.add<DistanceJoint>(a, b, Distance{anchor, along, far}); break;
        case 2: world_.add<CentreRopeJoint>(a, b, Rope<CentreDistance>{{far}}); break;
        case 3: world_.add<RopeJoint>(a, b, Rope<Distance>{{anchor, along, far}}); break;
        case 4: world_.add<BallJoint>(a, b, point_at(bodies[a], bodies[b], anchor)); break;
        case 5: drive(world_.add<HingeJoint>(a, b, anchor, along), whole); break;
        case 6: drive(world_.add<SliderJoint>(a, b, anchor, along), whole); break;
        case 7: world_.add<FixedJoint>(a, b, anchor).whole = whole; break;
        case 8: {
          const Outline outline = far == length ? box_outline(vec3(1)) : Outline{{}, 1, far};
          Top top{.height = anchor.y};
          if (whole) top.depth = far;
          auto& contact = world_.add<GroundContact>(a, b, top, outline);
          contact.restitution = draw_.uniform(0, 1);
        }
      }
    });
    if (!world_.joints().empty() && draw_.chance(0.3))
      world_.joints().back()->beta = draw_.uniform(0, real(draw_.chance(0.1) ? 10 : 1));
  }
  template <class Driven>
  void drive(Driven& joint, bool whole) {
    joint.whole = whole;
    if (draw_.chance(0.5)) {
      const real lower = draw_.uniform(-2, 1);
      joint.set_limits(lower, lower + draw_.uniform(0, 2));
    }
    const real speed = draw_.uniform(-5, 5), strength = draw_.size(0.1, 1e4);
    if (draw_.chance(0.4)) joint.set_motor(speed, strength);
    const real a = draw_.nasty(), b = draw_.nasty();
    if (draw_.chance(0.1)) try_it([&] { joint.set_limits(a, b); });
    if (draw_.chance(0.1)) try_it([&] { joint.set_motor(a, b); });
  }

  Draw draw_;
  Settings settings_;
  Counts& counts_;
  World world_;
  std::vector<BodyId> ids_;
};

}  // namespace

TEST_CASE("a step of any world refuses and changes nothing, overflows aloud or is finite") {
  const unsigned worlds = std::getenv("WORKBOOK_LONG") ? 250000 : 25000;
  Counts counts;
  for (unsigned seed = 0; seed < worlds; ++seed) {
    INFO("seed " << seed);
    Game(seed, counts).play();
  }
  CAPTURE(counts.steps, counts.refused, counts.overflowed, counts.refused_calls);
  CHECK(counts.steps > int(10 * worlds));
  CHECK(counts.refused > int(worlds));  // all of it has been met
  CHECK(counts.overflowed > int(worlds / 20));
}
