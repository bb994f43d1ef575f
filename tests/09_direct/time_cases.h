// Exercise 9.5: worlds that are stepped a few times as a table.
#pragma once

#include "chapters/09_direct/direct.h"
#include "engine/sequential_impulses.h"
#include "joints/ball_joint.h"
#include "joints/hinge_joint.h"
#include "tests/checker/padded.h"

namespace joints::testing {

struct TimeCase {
  std::string words;
  Call<void(World&)> build;
  std::vector<real> steps;  ///< three of them
};

inline Body tumbling(const vec3& x) {
  Body body = body_with(2, vec3(real(0.2), real(0.5), real(0.6)), x,
                        rotation(vec3(real(0.4), real(-0.2), real(0.7))));
  body.v = vec3(1, real(0.5), -1);
  body.w = vec3(3, real(-4), real(2.5));
  return body;
}
inline void fall(World& world) {
  world.gravity = vec3(0, -10, 0);
  world.add(ball(1, real(0.5), vec3(0)));
}
inline void tumble(World& world) {
  world.gravity = vec3(0);
  world.add(tumbling(vec3(0)));
}
/// A tumbling body on a ball joint, pushed and twisted from outside.
inline void hang(World& world, bool swings = true) {
  world.gravity = vec3(1, -9, 2);
  Body body = tumbling(vec3(1, 0, real(0.2)));
  if (!swings) body.v = body.w = vec3(0);
  body.force = vec3(3, 0, 1);
  body.torque = vec3(real(0.5), -1, 2);
  const BodyId wall = world.add(static_body(vec3(0))), id = world.add(body);
  world.add<BallJoint>(wall, id, point_at(world.bodies[wall], world.bodies[id], vec3(0)));
}
/// Two bodies, a hinge with a motor, a ball joint.
inline void machine(World& world) {
  hang(world);
  const BodyId id = world.add(tumbling(vec3(2, 0, 0)));
  auto& hinge = world.add<HingeJoint>(world.bodies.id(1), id,
                                      vec3(real(1.5), 0, 0), vec3(0, 1, real(0.3)));
  hinge.set_motor(3, 2000);  // more than it needs
}
/// A hinge whose limit presses from the first step on.
inline void beyond(World& world) {
  const BodyId wall = world.add(static_body(vec3(0))), id = world.add(tumbling(vec3(1, 0, 0)));
  world.add<HingeJoint>(wall, id, vec3(0), vec3(0, 1, real(0.3)))
      .set_limits(real(0.5), 3);
}
inline std::vector<TimeCase> time_cases() {
  const real h = real(0.1);
  return {{"a ball that falls", fall, {h, h, h}},
          {"a ball that falls, steps of several lengths", fall, {h, h / 2, 2 * h}},
          {"a free body that tumbles", tumble, {h / 2, h / 2, h / 2}},
          {"a body on a ball joint, at rest", [](World& world) { hang(world, false); },
           {h / 5, h / 5, h / 5}},
          {"a body on a ball joint, steps of several lengths", [](World& world) { hang(world); },
           {h / 5, h / 10, h / 4}},
          {"two bodies and a motor", machine, {h / 5, h / 5, h / 10}},
          {"a hinge beyond its limit", beyond, {h / 5, h / 5, h / 10}}};
}

inline constexpr std::size_t numbers_of_time = 200;

/// State, impulses and lengths after each step. \param advance one step
template <class Advance>
Numbers stepped(const TimeCase& c, const Advance& advance) {
  World world;
  c.build(world);
  SequentialImpulses solver;
  solver.iterations = 12;
  Numbers out;
  for (const real h : c.steps) {
    advance(world, solver, h);
    for (int k = 0; k < world.bodies.slots(); ++k) {
      const Body& b = world.bodies.at(k);
      for (const vec3& a : {b.x, b.v, b.w})
        for (int i = 0; i < 3; ++i) out.push_back(double(a[i]));
      for (const real a : {b.q.w, b.q.x, b.q.y, b.q.z}) out.push_back(double(a));
    }
    out.push_back(double(world.last_h));
    out.push_back(double(world.blocks.list.size()));
    for (const auto& joint : world.joints()) {
      out.push_back(double(joint->last_h()));
      if (const auto* one = dynamic_cast<const BallJoint*>(joint.get()))
        for (int i = 0; i < 3; ++i) out.push_back(double(one->impulse()[std::size_t(i)]));
    }
  }
  return padded(out, numbers_of_time);
}
/// A solver that is asked by the engine's step() and begin_step(), and by none of their parts,
/// whether its settings are valid.
class AskedSolver : public SequentialImpulses {
 public:
  mutable int asked = 0;
  void check() const override { ++asked; }
};
inline constexpr Subject time_subject{"9.5", "a step of second order"};
inline void check_parts() {
  World world;
  fall(world);
  AskedSolver solver;
  second_order_step(world, solver, real(0.1));
  const double calls = solver.asked;
  expect(time_subject, "calls of the engine's step", calls, 0, 0,
         {{calls, "#engine-step the engine's step does it: the exercise is to write it. Call its "
                  "parts instead, which the table in Code names"}});
}

inline std::vector<std::string> time_names(const TimeCase& c) {
  World world;
  c.build(world);
  std::vector<std::string> out;
  for (int n = 1; n <= int(c.steps.size()); ++n) {
    const std::string after = " after step " + std::to_string(n);
    for (int k = 0; k < world.bodies.slots(); ++k)
      for (const char* what : {"x.x", "x.y", "x.z", "v.x", "v.y", "v.z", "w.x", "w.y", "w.z",
                               "q.w", "q.x", "q.y", "q.z"})
        out.push_back(std::string(what) + " of body " + std::to_string(k) + after);
    out.push_back("world.last_h" + after);
    out.push_back("number of blocks" + after);
    for (std::size_t k = 0; k < world.joints().size(); ++k) {
      const std::string joint = " of joint " + std::to_string(k) + after;
      out.push_back("last_h" + joint);
      if (dynamic_cast<const BallJoint*>(world.joints()[k].get()))
        for (int i = 0; i < 3; ++i)
          out.push_back("impulse[" + std::to_string(i) + "]" + joint);
    }
  }
  return out;
}

inline CaseTable<TimeCase> time_table() {
  auto table = padded_table<TimeCase>(time_subject, numbers_of_time, time_names);
  table.tolerance = 10 * rounding;
  table.cases = time_cases();
  judge(table, second_order_step, [](auto step, const TimeCase& c) { return stepped(c, step); });
  table.right = [](const TimeCase& c) {
    return stepped(c, [](World& world, Solver& solver, real h) {
      step(world, solver, h, {.leapfrog = true});
    });
  };
  tell_where_it_holds(table);
  return table;
}

/// For a test of another kind: the table's mistakes explain whatever is wrong.
inline void expect_time(const std::string& entry, double yours, double right, double tolerance) {
  const bool same = std::abs(yours - right) <= tolerance;
  expect(time_subject, entry, yours, right, tolerance,
         same ? std::vector<Suspect>{} : time_table().explain(yours));
}

}  // namespace joints::testing
