// Common code of all cases of the stability suite: their list, lines, methods, rates.
#include <cmath>
#include <random>

#include "bench/stability.h"
#include "engine/instruments/rate.h"

namespace joints::bench {

std::vector<Case> cases() {
  return {{"X1", "mass ratio, 20 links and an end of R kg", mass_ratios},
          {"X2", "beta of one joint: error ratio a step", feedback_of_one},
          {"X2", "beta of a chain of 20 hinges", feedback_of_many},
          {"X3", "step, chain of 20 hinges", steps},
          {"X3", "step, one hinge, down to rounding", truncation},
          {"X4", "length of a chain of hinges", lengths},
          {"X5", "points that coincide", coincident_points, true},
          {"X6", "two static bodies", static_bodies, true},
          {"X7", "hinge bent up to 180 degrees", bent_hinges, true},
          {"X8", "fast spin of a box", spinning},
          {"X8", "of a hinge", spinning_hinge, true},
          {"X9", "long levers, far from the origin", far_away, true},
          {"X10", "masses 1e-6 to 1e9 kg, a needle", masses_apart, true},
          {"X11", "limits hit fast and yanked", limits_hit, true},
          {"X12", "a motor's strength", motors, true},
          {"X13", "a motor pushes into a limit", motors_into_limits, true},
          {"X14", "redundant rows", redundant, true},
          {"X15", "Gauss-Seidel rates", iteration_rates},
          {"X16", "bad input", bad_input},
          {"X17", "a door, 1e6 steps", a_long_time, true}};
}

// ---- lines --------------------------------------------------------------------------------------

Line compared(Line line, double expected, double measured, double tolerance) {
  line.expected = expected;
  return judged(line, measured, std::abs(measured - expected) <= tolerance);
}

Line judged(Line line, double measured, bool holds) {
  line.measured = measured;
  line.status = !std::isfinite(measured) ? "nan" : holds ? "ok" : "off";
  return line;
}

Line of_run(Line line, const Result& result) {
  line.status = result.status;
  line.measured = line.gap_max = result.gap_max;
  line.gap_rms = result.gap_rms;
  line.energy_drift = result.energy_drift;
  line.energy_peak = result.energy_peak;
  return line;
}

// ---- methods ------------------------------------------------------------------------------------

std::vector<Method> methods() {
  return {{.name = "cold 10", .iterations = 10},
          {.name = "cold 30"},
          {.name = "cold 100", .iterations = 100},
          {.name = "warm 10", .iterations = 10, .warm = true},
          {.name = "warm 30", .warm = true},
          {.name = "warm 100", .iterations = 100, .warm = true},
          {.name = "cold 30, beta 1", .beta = 1},
          {.name = "cold 30, beta 1, projection 1", .beta = 1, .projections = 1},
          {.name = "warm 30, projection 1", .warm = true, .beta = 0, .projections = 1},
          {.name = "warm 30, projection 4", .warm = true, .beta = 0, .projections = 4},
          {.name = "cold 30, projection 1", .beta = 0, .projections = 1},
          {.name = "cold 30, projection 4", .beta = 0, .projections = 4},
          {.name = "4 substeps of 8, beta 1", .iterations = 8, .beta = 1, .substeps = 4},
          {.name = "16 substeps of 2", .iterations = 2, .substeps = 16},
          {.name = "16 substeps of 2, beta 1", .iterations = 2, .beta = 1, .substeps = 16},
          {.name = "16 substeps of 4", .iterations = 4, .substeps = 16},
          {.name = "64 substeps of 1", .iterations = 1, .substeps = 64},
          {.name = "direct", .beta = 1, .direct = true},
          {.name = "direct, SHAKE", .beta = 1, .direct = true, .newton = 8},
          {.name = "direct, SHAKE, added inertia 8", .beta = 1, .direct = true, .newton = 8,
           .added_inertia = 8},
          {.name = "cold 30, apart", .whole = false}};
}

Setting setting_of(const Method& method) {
  Setting setting{method.direct ? "direct" : "sequential impulses", method.name,
                  method.iterations, method.warm, {}, {}, {}, method.direct};
  setting.make = [method]() -> Step {
    if (method.direct) {
      DirectSolver solver = DirectSolver::velocities_only();
      solver.newton = method.newton;
      solver.added_inertia = method.added_inertia;
      return [=](World& world, real h) mutable {
        joints::step(world, solver, h, {.leapfrog = true});
      };
    }
    SequentialImpulses solver;
    solver.iterations = method.iterations;
    const StepOptions stepping{.warm_start = method.warm, .substeps = method.substeps,
                            .projections = method.projections};
    return [=](World& world, real h) mutable { joints::step(world, solver, h, stepping); };
  };
  setting.prepare = [method](World& world) {
    for (const auto& joint : world.joints()) {
      joint->beta = method.beta;
      if (auto* hinge = dynamic_cast<HingeJoint*>(joint.get())) hinge->whole = method.whole;
    }
  };
  return setting;
}

void kick(BenchScene& scene, bool planar) {
  std::mt19937 random(1);
  const auto number = [&] { return real(double(random()) / 4294967296.0 - 0.5); };
  const vec3 f(scene.forbidden);
  planar = planar && f != vec3(0);
  for (int slot = 0; slot < scene.world.bodies.slots(); ++slot) {
    Body& body = scene.world.bodies.at(slot);
    if (body.is_static()) continue;
    for (int i = 0; i < 3; ++i) body.v[i] = number(), body.w[i] = number();
    if (planar) body.v -= dot(body.v, f) * f, body.w = dot(body.w, f) * f;
  }
}

Rates rates_of(const MakeScene& make) {
  const auto rate = [&](bool planar) {
    BenchScene scene = make();
    kick(scene, planar);
    return contraction_rate(scene.world, 3000);
  };
  return {rate(true), rate(false)};
}

void add_criterion(Line& line, const Method& method, const Rates& rates) {
  if (!method.warm) return;
  line.rho = rates.possible;
  line.rho_any = rates.any;
  const double kept = std::pow(line.rho, method.iterations) * (1 + double(method.beta));
  line.criterion = kept < 1 ? 1 : 0;
}

}  // namespace joints::bench
