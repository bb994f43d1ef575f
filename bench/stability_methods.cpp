// What all cases of the stability suite share: the list of them, lines, methods, the iteration
// rate.
#include <algorithm>
#include <cmath>
#include <random>

#include "bench/stability.h"

namespace joints::bench {

std::vector<Case> cases() {
  return {{"X1", "mass ratio, 20 links and an end of R kg", mass_ratios},
          {"X2", "beta of one joint: error ratio a step", feedback_of_one},
          {"X2", "beta of a chain of 20 hinges", feedback_of_many},
          {"X3", "step, chain of 20 hinges", steps},
          {"X3", "step, one hinge, down to rounding", truncation},
          {"X4", "length of a chain of hinges", lengths},
          {"X5", "points that coincide", coincident_points},
          {"X6", "two static bodies", static_bodies},
          {"X7", "hinge bent up to 180 degrees", bent_hinges},
          {"X8", "fast spin of a box", spinning},
          {"X8", "of a hinge", spinning_hinge},
          {"X9", "long levers, far from the origin", far_away},
          {"X10", "masses 1e-6 to 1e9 kg, a needle", masses_apart},
          {"X11", "limits hit fast and yanked", limits_hit},
          {"X12", "a motor's strength", motors},
          {"X13", "a motor pushes into a limit", motors_into_limits},
          {"X14", "redundant rows", redundant},
          {"X15", "Gauss-Seidel rates", iteration_rates},
          {"X16", "bad input", bad_input},
          {"X17", "a door, 1e6 steps", a_long_time}};
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
  const bool calm = line.status == "ok" || line.status == "soft" || line.status == "torn";
  if ((calm || line.status == "energy+") && result.energy_peak > 1) line.status = "exploded";
  else if (calm && result.energy_peak > 0.02) line.status = "energy+";
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
          {.name = "cold 30, apart", .whole = false}};
}

Setting setting_of(const Method& method) {
  Setting setting{"sequential impulses", method.name, method.iterations, method.warm, {}, {}};
  setting.make = [method] {
    SequentialImpulses solver;
    solver.iterations = method.iterations;
    const Stepping stepping{.warm_start = method.warm, .substeps = method.substeps,
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

namespace {

struct Change {
  double size;    // of what an iteration changed
  double lambda;  // the largest impulse
};

// Compares the impulses with those before, and remembers them.
Change change_of(const Blocks& blocks, std::vector<double>& before) {
  double sum = 0, largest = 0;
  std::size_t at = 0;
  for (const Block& block : blocks.list)
    for (int i = 0; i < block.rows; ++i, ++at) {
      const double now = double(block.impulse[i]);
      if (at == before.size()) before.push_back(0);
      sum += (now - before[at]) * (now - before[at]);
      largest = std::max(largest, std::abs(now));
      before[at] = now;
    }
  return {std::sqrt(sum), largest};
}

}  // namespace

void kick(Scene& scene, bool planar) {
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

double iteration_rate(World& world, int most) {
  SequentialImpulses solver;
  begin_step(world, solver, real(1) / 60);
  std::vector<double> before, sizes;
  while (int(sizes.size()) < most) {
    solver.iterate(world.bodies);
    const Change change = change_of(world.blocks, before);
    if (change.size <= 200 * double(epsilon) * change.lambda) break;
    sizes.push_back(change.size);
  }
  const std::size_t last = sizes.size();
  if (last < 2) return 0;  // solved at once
  const std::size_t first = std::min(last - 2, last - 1 - last / 10);
  return std::pow(sizes[last - 1] / sizes[first], 1.0 / double(last - 1 - first));
}

Rates rates_of(const MakeScene& make) {
  const auto rate = [&](bool planar) {
    Scene scene = make();
    kick(scene, planar);
    return iteration_rate(scene.world, 3000);
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
