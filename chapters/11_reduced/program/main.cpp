// Chapter 11's program: a chain of bars by your recursion, beside the same chain on rows; how its
// error depends on the step; how heavy a chain is. Read it; there is nothing to edit here.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "chapters/11_reduced/program/chain.h"
#include "engine/instruments/options.h"
#include "engine/instruments/scene.h"
#include "joints/hinge_joint.h"

using namespace joints;
using namespace joints::chapter11;

namespace {

// The same chain on rows: five rows a hinge, solved by sequential impulses.
struct OnRows {
  World world;
  SequentialImpulses solver;
  std::vector<HingeJoint*> hinges;
  std::vector<BodyId> ids;

  OnRows(const Chain& like, int iterations) {
    solver.iterations = iterations;
    for (const Body& body : like.bodies()) ids.push_back(world.add(body));
    for (std::size_t k = 1; k < like.links.size(); ++k) {
      const TreeLink& link = like.links[k];
      hinges.push_back(&world.add<HingeJoint>(ids[k - 1], ids[k], link.centre - link.c, link.a));
    }
  }
  void step(real h) { joints::step(world, solver, h); }
  // The largest gap of a hinge [m]: both bars should meet in one point.
  double gap() const {
    double most = 0;
    for (std::size_t k = 1; k < ids.size(); ++k) {
      const Body &one = world.bodies[ids[k - 1]], &two = world.bodies[ids[k]];
      const real end = k == 1 ? real(0) : bar_size.x / 2;
      most = std::max(most, double(length(world_point(one, vec3(end, 0, 0)) -
                                          world_point(two, vec3(-bar_size.x / 2, 0, 0)))));
    }
    return most;
  }
  vec3 tip() const { return world_point(world.bodies[ids.back()], vec3(bar_size.x / 2, 0, 0)); }
};

// ---- two chains side by side --------------------------------------------------------------------

void side_by_side(const Settings& settings, std::vector<Summary>& lines) {
  const int bars = 5;
  const real h = real(1) / 60;
  const vec3 behind(0, 0, real(-1.2));
  Chain chain(bars, vec3(0));
  OnRows rows(Chain(bars, behind), settings.iterations);
  std::vector<Body> of_rows;
  const auto look = [&] {
    of_rows.clear();
    for (const BodyId id : rows.ids) of_rows.push_back(rows.world.bodies[id]);
  };
  std::vector<Body> of_chain;
  const double scale = 9.81 * bars * bars / 2;  // [J]
  const Experiment angles{.step = [&] { chain.runge_kutta(h); },
                          .bodies = [&] {
                            of_chain = chain.bodies();
                            return std::span<const Body>(of_chain);
                          },
                          .gaps = [](GapMeter& meter) { meter.add(0); },
                          .energy_scale = scale};
  const Experiment on_rows{.step = [&] { rows.step(h); },
                           .bodies = [&] {
                             look();
                             return std::span<const Body>(of_rows);
                           },
                           .gaps = [&](GapMeter& meter) { meter.add(rows.gap()); },
                           .energy_scale = scale};
  std::printf("chain: %d bars, %d hinges: %d angles, or %d rows\n", bars, bars, bars, 5 * bars);
  CsvFile table(settings.out + "/chain.csv", {"time_s", "apart_m", "gap_m", "energy_change",
                                              "energy_change_rows"});
  Motion motion("chain", double(h));
  for (const char* label : {"angles", "rows"}) {
    motion.body({"ball", {0.15, 0.15, 0.15}, label});
    for (int k = 0; k < bars; ++k) motion.body({"box", {bar_size.x, bar_size.y, bar_size.z}});
  }
  Run one(angles), two(on_rows);
  for (int n = 0; n <= steps_in(settings.seconds, h); ++n) {
    if (n > 0) one.step(), two.step();
    const double apart = double(length(rows.tip() - behind - chain.tip()));
    table.row({n * double(h), apart, rows.gap(), one.now().energy_drift, two.now().energy_drift});
    look();
    std::vector<Body> frame = chain.bodies();
    frame.insert(frame.end(), of_rows.begin(), of_rows.end());
    motion.frame(frame.data(), {reading_of(angles, "angles"), reading_of(on_rows, "rows")});
  }
  lines.push_back({one.measures(), "chain", "angles"});
  lines.push_back({two.measures(), "chain", "rows"});
  motion.write(settings.out + "/chain.motion.json");
}

// ---- the error after a second -------------------------------------------------------------------

// How far the free end is from where it should be after one second, by the steps a second.
void order(const Settings& settings) {
  CsvFile table(settings.out + "/order.csv", {"method", "steps", "error_m"});
  const int bars = 5;
  const auto after = [](auto moved, int steps, auto step) {
    for (int n = 0; n < steps; ++n) step(moved, real(1) / real(steps));
    return moved.tip();
  };
  const auto fourth = [](Chain& chain, real h) { chain.runge_kutta(h); };
  const Chain start(bars, vec3(0));
  const vec3 right = after(start, 7680, fourth);
  for (int steps = 30; steps <= 1920; steps *= 2) {
    const auto row = [&](const char* method, const vec3& tip) {
      const double error = double(length(tip - right));
      table.row({method}, {double(steps), error});
      if (steps == 60 || steps == 120)
        std::printf("%s, %d steps: %.2g m off after a second\n", method, steps, error);
    };
    row("Runge-Kutta", after(start, steps, fourth));
    row("Euler", after(start, steps, [](Chain& chain, real h) { chain.euler(h); }));
    OnRows rows(start, settings.iterations);
    for (int n = 0; n < steps; ++n) rows.step(real(1) / real(steps));
    row("rows", rows.tip());
  }
}

// ---- how heavy is a chain? ----------------------------------------------------------------------

// What a hand feels that holds the first bar of a straight chain at its end and accelerates it: the
// mass along the chain, and across it in the plane in which all hinges turn.
void weight(const Settings& settings) {
  CsvFile table(settings.out + "/weight.csv", {"bars", "along_kg", "across_kg"});
  double along = 0, across = 0, of_three = 0;
  for (int bars = 1; bars <= 30; ++bars) {
    Chain chain(bars, vec3(0));
    chain.gravity = vec3(0);
    for (TreeLink& link : chain.links) {
      if (link.parent < 0) continue;
      link.axis_local = vec3(0, 0, 1);
      link.start_axis = quat(0, 0, 0, 1);
    }
    chain.pose();
    chain.accelerations();
    const mat3& M = chain.links[1].M;
    along = double(M[0][0]), across = double(M[1][1]);
    table.row({double(bars), along, across});
    if (bars == 3) of_three = across;
  }
  std::printf("30 bars of 1 kg: %.4g kg along, %.4g kg across; 3 bars: %.4g kg across\n", along,
              across, of_three);
}

}  // namespace

int main(int argc, char** argv) {
  return run_program([&] {
    Settings settings;
    if (!read(settings, "Chapter 11: a chain by angles, beside rows; its error; its weight", "10",
              "how long the two chains swing", argc, argv))
      return;
    std::vector<Summary> lines;
    side_by_side(settings, lines);
    order(settings);
    weight(settings);
    report(lines, settings.out);
  });
}
