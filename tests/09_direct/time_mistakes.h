// Exercise 9.5: the steps of the usual mistakes.
#pragma once

#include "checker/report.h"
#include "tests/09_direct/time_cases.h"
#include "tests/checker/pieces.h"

namespace joints::testing {

inline const char* const told_poses_before_solve =
    "#poses-before-solve the bodies move before solve(): by the new velocities, behind it";

/// The parts of a step, each of which a mistake may change.
struct TimeReference {
  TimeCase c;
  Call<real(real last, real h)> kick_length = [](real last, real h) {
    return (last + h) / 2;
  };
  bool keeps_h = true, kicks = true, clears = true, begins = true, appends = true;
  bool warms = true, poses_first = false, kick_last = false;
  real begin_h = 1, prepare_h = 1, pose_h = 1, ratio = 0;
  bool begin_mean = false, prepare_mean = false;
  int solves = 1, poses = 1;
  real kick_at_end = 0;  ///< share of h
  bool keeps_mean = false, gravity_alone = false, earth = false, poses_at_once = false;
  bool only_y = false, appends_first = false;
  bool poses_before_solve = false;

  void step(World& world, Solver& solver, real h) const {
    Bodies& bodies = world.bodies;
    const real length = kick_length(world.last_h, h);
    if (poses_at_once) integrate_poses(bodies, h);
    const vec3 gravity = earth    ? vec3(0, real(-9.81), 0)
                         : only_y ? vec3(0, world.gravity.y, 0)
                                  : world.gravity;
    if (gravity_alone)
      for (int k = 0; k < bodies.slots(); ++k)
        bodies.at(k).v += (bodies.at(k).is_static() ? 0 : length) * gravity;
    else if (kicks && !kick_last) integrate_forces(bodies, gravity, length);
    if (keeps_h) world.last_h = keeps_mean ? length : h;
    if (poses_first) integrate_poses(bodies, h);
    if (clears) world.blocks.clear();
    if (appends_first)
      for (const auto& joint : world.joints()) joint->append(bodies, world.blocks);
    if (begins)
      for (const auto& joint : world.joints())
        joint->begin_step(bodies, begin_mean ? length : begin_h * h);
    if (appends && !appends_first)
      for (const auto& joint : world.joints()) joint->append(bodies, world.blocks);
    solver.prepare(bodies, world.blocks, 0, prepare_mean ? length : prepare_h * h);
    if (warms) solver.warm_start(bodies, ratio);
    if (poses_before_solve) integrate_poses(bodies, h);
    for (int n = 0; n < solves; ++n) solver.solve(bodies);
    if (kick_last) integrate_forces(bodies, world.gravity, length);
    if (!poses_first && !poses_at_once && !poses_before_solve)
      for (int n = 0; n < poses; ++n) integrate_poses(bodies, pose_h * h);
    if (kick_at_end > 0) integrate_forces(bodies, gravity, kick_at_end * h);
  }
};

inline Pieces<TimeReference> wrong_times() {
  using T = TimeReference;
  const auto length = [](auto of) { return [=](T& t) { t.kick_length = of; }; };
  return {
      {"#kick-full-h forces act for the whole of h: for the mean of the last step and this one. "
       "Is world.last_h set before them?",
       length([](real, real h) { return h; })},
      {"#kick-half-h forces act for half of h: for the mean of the last step and this one",
       length([](real, real h) { return h / 2; })},
      {"#kick-last-step forces act for the last step: for the mean of it and this one",
       length([](real last, real) { return last; })},
      {"#kick-sum forces act for the last step and this one: for their mean, the half of that",
       length([](real last, real h) { return last + h; })},
      {"#brackets-forgotten half of this step only: (last_h + h) / 2 needs its brackets",
       length([](real last, real h) { return last + h / 2; })},
      {"half of the last step only: (last_h + h) / 2 needs its brackets",
       length([](real last, real h) { return last / 2 + h; })},
      {"#first-step-full-kick in the first step forces act for all of h: nothing came before it, "
       "last_h is 0 then",
       length([](real last, real h) { return last == 0 ? h : (last + h) / 2; })},
      {"#fixed-step-length 1/60 s in the place of h: each step has a length of its own",
       length([](real last, real) { return (last + real(1) / 60) / 2; })},
      {"#kick-longer the longer of both steps: their mean",
       length([](real last, real h) { return std::max(last, h); })},
      {"#kick-h-later half of h in the first step and h in the later ones: the mean of the last "
       "step and this one",
       length([](real last, real h) { return last == 0 ? h / 2 : h; })},
      {"#append-before-begin append() comes before begin_step(), which chooses the rows: first "
       "begin_step() of all joints",
       [](T& t) { t.appends_first = true; }},
      {"#only-y-gravity only the y of gravity acts: world.gravity is a vector",
       [](T& t) { t.only_y = true; }},
      {"#no-kick no forces act: integrate_forces()",
       [](T& t) { t.kicks = false; }},
      {"#kick-behind-solve the forces act after solve(): they must act before the impulses",
       [](T& t) { t.kick_last = true; }},
      {"#last-h-gets-mean the mean is kept in world.last_h: h, the length of this step",
       [](T& t) { t.keeps_mean = true; }},
      {"#another-half-kick-end forces act again at the end: only once, for the mean of the last "
       "step and this one",
       [](T& t) { t.kick_at_end = real(0.5); }},
      {"forces act twice for half of h: once, for the mean of the last step and this one",
       [](T& t) {
         t.kick_at_end = real(0.5);
         t.kick_length = [](real, real h) { return h / 2; };
       }},
      {"#gravity-alone force and torque of the bodies are forgotten: integrate_forces() has all of "
       "it",
       [](T& t) { t.gravity_alone = true; }},
      {"#earth-s-gravity gravity is another one: world.gravity", [](T& t) { t.earth = true; }},
      {"#last-h-not-kept h is not kept in world.last_h: the next step's mean needs it",
       [](T& t) { t.keeps_h = false; }},
      {"#blocks-not-cleared the blocks of the last step are still there: world.blocks.clear()",
       [](T& t) { t.clears = false; }},
      {"#begin-step-joints-missing begin_step() of the joints is missing: they choose their rows "
       "there",
       [](T& t) { t.begins = false; }},
      {"#begin-append-half-h begin_step() of the joints has half of h: all of it",
       [](T& t) { t.begin_h = real(0.5); }},
      {"#append-missing no joint appends its blocks: the bodies move as if free",
       [](T& t) { t.appends = false; }},
      {"#prepare-half-h prepare() has half of h: all of it",
       [](T& t) { t.prepare_h = real(0.5); }},
      {"#prepare-mean prepare() has the mean of the last step and this one: only the forces act "
       "for the mean, prepare() needs h",
       [](T& t) { t.prepare_mean = true; }},
      {"#begin-step-mean begin_step() of the joints has the mean of the last step and this one: "
       "only the forces act for the mean, begin_step() needs h",
       [](T& t) { t.begin_mean = true; }},
      {"#warm-start a warm start: the ratio is 0, the impulses of the last step are not used",
       [](T& t) { t.ratio = 1; }},
      {"a warm start with half of the impulses: the ratio is 0",
       [](T& t) { t.ratio = real(0.5); }},
      {"#warm-start-missing warm_start() is missing: the impulses of the last step must become 0",
       [](T& t) { t.warms = false; }},
      {"#solve-missing solve() is missing: no joint holds", [](T& t) { t.solves = 0; }},
      {"#solve-twice solve() twice: once", [](T& t) { t.solves = 2; }},
      {"#poses-missing the bodies do not move: integrate_poses()",
       [](T& t) { t.poses = 0; }},
      {"the bodies move twice: integrate_poses() once", [](T& t) { t.poses = 2; }},
      {"#poses-half-h the bodies move for half of h: for all of it",
       [](T& t) { t.pose_h = real(0.5); }},
      {told_poses_before_solve,
       [](T& t) { t.poses_before_solve = true; }},
      {"#poses-at-first the bodies move at first: by the new velocities, behind solve()",
       [](T& t) { t.poses_at_once = true; }},
      {told_poses_before_solve,
       [](T& t) { t.poses_first = true; }}};
}

inline CaseTable<TimeCase> time_table() {
  using T = TimeReference;
  auto table = padded_table<TimeCase>(time_subject, numbers_of_time, time_names);
  table.tolerance = 10 * rounding;
  table.cases = time_cases();
  table.yours = [](const TimeCase& c) { return stepped(c, second_order_step); };
  const auto answer = [](const T& t) {
    return stepped(t.c, [&](World& world, Solver& solver, real h) { t.step(world, solver, h); });
  };
  table.right = [](const TimeCase& c) {
    return stepped(c, [](World& world, Solver& solver, real h) {
      step(world, solver, h, {.leapfrog = true});
    });
  };
  add_pieces(table, [](const TimeCase& c) { return T{c}; }, answer, wrong_times());
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
