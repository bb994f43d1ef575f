// A step of a world by an answer: its bodies are sent; its joints and its solver stay where they
// are and are asked.
#pragma once

#include <array>

#include "engine/solver.h"
#include "engine/world.h"
#include "tests/remote/function.h"

namespace joints::by_hand {

using namespace joints::testing::remote;

inline std::vector<Body> list(const Bodies& bodies) {
  return {bodies.data(), bodies.data() + bodies.slots()};
}
inline void set(Bodies& bodies, const std::vector<Body>& all) {
  if (int(all.size()) != bodies.slots()) throw std::runtime_error("other bodies came back");
  std::copy(all.begin(), all.end(), bodies.data());
}

/// What the step asks for, of which joint, with which numbers.
enum class Wish : int { begin_step, append, missed_limits, check, prepare, warm_start, solve };
struct Question {
  Wish wish;
  int which = 0;             ///< the joint, or the first block
  real h = 0, duration = 0;  ///< [s]; the ratio of a warm start
};

using Joined = std::vector<std::array<int, 2>>;  // the slots of each joint
using Step = Function<void(std::vector<Body>&, const Joined&, const vec3& gravity, real& last_h,
                           int& blocks, real h)>;

// ---- the side of the tests ----------------------------------------------------------------------

inline void reply_to(const Question& q, World& world, Solver& solver) {
  Bodies& bodies = world.bodies;
  const auto joint = [&]() -> Joint& { return *world.joints().at(std::size_t(q.which)); };
  if (q.wish == Wish::begin_step) joint().begin_step(bodies, q.h, q.duration);
  if (q.wish == Wish::append) joint().append(bodies, world.blocks);
  if (q.wish == Wish::missed_limits) joint().activate_missed_limits(bodies, q.h, world.blocks);
  if (q.wish == Wish::check) solver.check();
  if (q.wish == Wish::prepare) solver.prepare(bodies, world.blocks, q.which, q.h);
  if (q.wish == Wish::warm_start) solver.warm_start(bodies, q.h);
  if (q.wish == Wish::solve) solver.solve(bodies);
}

inline void step_elsewhere(const char* id, const char* name, World& world, Solver& solver, real h) {
  const auto cut = [&](int count) {  // what the answer has removed
    if (count < int(world.blocks.list.size())) world.blocks.truncate(std::max(0, count));
  };
  const Asked asked = [&](Bytes& question, Bytes& reply) {
    set(world.bodies, got<std::vector<Body>>(question));
    cut(got<int>(question));
    reply_to(got<Question>(question), world, solver);
    put(reply, list(world.bodies));
    put(reply, int(world.blocks.list.size()));
  };
  std::vector<Body> all = list(world.bodies);
  Joined joined;
  for (const auto& one : world.joints())
    joined.push_back({int(one->body1.slot), int(one->body2.slot)});
  int blocks = int(world.blocks.list.size());
  Step::call(id, name, asked, all, joined, world.gravity, world.last_h, blocks, h);
  set(world.bodies, all);
  cut(blocks);
}

// ---- the side of the answer ---------------------------------------------------------------------

/// Asks the tests; bodies and number of blocks become theirs.
inline void wish(const Question& q, const Bodies& bodies, const Blocks& blocks) {
  Bytes question;
  put(question, list(bodies));
  put(question, int(blocks.list.size()));
  put(question, q);
  Bytes reply = ask(question);
  set(const_cast<Bodies&>(bodies), got<std::vector<Body>>(reply));
  const_cast<Blocks&>(blocks).list.resize(std::size_t(got<int>(reply)));
}

class JointElsewhere : public Joint {
 public:
  JointElsewhere(BodyId body1, BodyId body2, int which, const Blocks& blocks)
      : Joint(body1, body2), which_(which), blocks_(blocks) {}
  void append(const Bodies& bodies, Blocks& blocks) const override {
    wish({Wish::append, which_}, bodies, blocks);
  }
  void activate_missed_limits(const Bodies& bodies, real h, Blocks& blocks) override {
    wish({Wish::missed_limits, which_, h}, bodies, blocks);
  }

 protected:
  void update_active_rows(const Bodies& bodies, real h) override {
    wish({Wish::begin_step, which_, h, impulse_duration()}, bodies, blocks_);
  }

 private:
  int which_;
  const Blocks& blocks_;
};

class SolverElsewhere : public Solver {
 public:
  explicit SolverElsewhere(World& world) : world_(world) {}
  void check() const override { wish({Wish::check}, world_.bodies, world_.blocks); }
  void prepare(const Bodies& bodies, const Blocks& blocks, int first, real h) override {
    wish({Wish::prepare, first, h}, bodies, blocks);
  }
  void warm_start(Bodies& bodies, real ratio) override {
    wish({Wish::warm_start, 0, ratio}, bodies, world_.blocks);
  }
  void solve(Bodies& bodies) override { wish({Wish::solve}, bodies, world_.blocks); }

 private:
  World& world_;
};

inline void serve_step(const char* name, void (*step)(World&, Solver&, real)) {
  Step::serve(name, [=](std::vector<Body>& all, const Joined& joined, const vec3& gravity,
                        real& last_h, int& blocks, real h) {
    World world;
    for (const Body& one : all) world.add(one);
    set(world.bodies, all);  // add() has normalised q
    for (const auto& [one, two] : joined)
      world.add<JointElsewhere>(world.bodies.id(one), world.bodies.id(two),
                                int(world.joints().size()), world.blocks);
    world.gravity = gravity;
    world.last_h = last_h;
    world.blocks.list.resize(std::size_t(blocks));
    SolverElsewhere solver(world);
    step(world, solver, h);
    all = list(world.bodies);
    last_h = world.last_h;
    blocks = int(world.blocks.list.size());
  });
}

}  // namespace joints::by_hand
