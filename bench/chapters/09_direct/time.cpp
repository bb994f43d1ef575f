// Time: the order of a step, and Newton's method on the positions.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bench/chapters/09_direct/experiments.h"
#include "bench/runge_kutta.h"

namespace joints::chapter9 {

namespace {

// Three slabs on hinges with different axes. At first all of them rotate about the first axis with
// 3 rad/s, which every hinge allows; then they tumble.
Scene three_slabs() {
  Scene scene{.name = "three slabs"};
  const vec3 size(1, real(0.4), real(0.15));
  const vec3 axes[] = {vec3(0, 0, 1), vec3(1, real(0.5), 0), vec3(0, 1, 1)};
  BodyId before = scene.box(0, vec3(real(0.2)), vec3(0));
  for (int k = 0; k < 3; ++k) {
    const BodyId id = scene.box(2, size, vec3(real(k) + real(0.5), 0, 0));
    on_hinge(scene, before, id, vec3(real(k), 0, 0), axes[k]);
    Body& body = scene.world.bodies[id];
    body.w = vec3(0, 0, 3), body.v = cross(body.w, body.x);
    before = id;
  }
  return scene;
}

// A straight chain of rods on ball joints from wall to wall, which cannot sag.
Scene taut_chain(int rods) {
  Scene scene{.name = "taut"};
  const auto wall = [&](real x) { return scene.box(0, vec3(real(0.2)), vec3(x, 0, 0)); };
  BodyId before = wall(0);
  for (int k = 0; k < rods; ++k) {
    const BodyId id = rod(scene, vec3(real(k), 0, 0), vec3(real(k + 1), 0, 0));
    on_ball(scene, before, id, vec3(real(k), 0, 0));
    before = id;
  }
  on_ball(scene, before, wall(real(rods)), vec3(real(rods), 0, 0));
  return scene;
}

constexpr double until = 1;  // [s]

// Positions of the slabs after a second. \param advance makes one step
std::vector<vec3> slabs_after(real h, const std::function<void(World&, real)>& advance) {
  Scene scene = three_slabs();
  for (int n = 0; n < steps_in(until, h); ++n) advance(scene.world, h);
  std::vector<vec3> out;
  for (const Body& body : all_of(scene.world.bodies)) out.push_back(body.x);
  return out;
}

}  // namespace

void time_steps(const Choice& choice) {
  CsvFile table(choice.out + "/convergence.csv", {"step", "h_s", "error_m", "order"});
  const int finest = 960;  // steps per second
  RungeKutta reference;
  const std::vector<vec3> truth = slabs_after(
      real(1) / real(finest), [&](World& world, real h) { reference.step(world, h); });
  for (const bool second : {false, true}) {
    const std::string name = second ? "leapfrog" : "plain";
    DirectSolver direct = with_positions();
    const auto advance = [&](World& world, real h) {
      second ? second_order_step(world, direct, h) : step(world, direct, h);
    };
    double before = 0, order = 0, first = 0, error = 0;
    for (int rate = 30; rate <= finest; rate *= 2) {
      const std::vector<vec3> found = slabs_after(real(1) / real(rate), advance);
      error = 0;
      for (std::size_t k = 0; k < found.size(); ++k)
        error = std::max(error, double(length(found[k] - truth[k])));
      order = before > 0 ? std::log2(before / error) : NAN;
      if (rate == 60) first = error;
      table.row({name}, {1.0 / rate, error, before > 0 ? order : 0});
      before = error;
    }
    std::printf("%-8s step: order %.2f; off by %.3g m after a second with h = 1/60 s\n",
                name.c_str(), order, first);
  }
}

void newton(const Choice& choice) {
  CsvFile gaps(choice.out + "/gap_over_h.csv", {"positions", "h_s", "gap_m"});
  for (const int most : {0, 8})
    for (int rate = 15; rate <= 480; rate *= 2) {
      Scene scene = three_slabs();
      DirectSolver direct = DirectSolver::velocities_only();
      direct.newton = most;
      scene.h = real(1) / real(rate);
      const Summary line = play(scene, "", until, "", [](double) {}, leaps(scene, direct));
      gaps.row({most == 0 ? "velocities alone" : "Newton"}, {1.0 / rate, line.gap_max});
    }
  CsvFile table(choice.out + "/newton.csv", {"scene", "h_s", "iteration", "error"});
  const auto show = [&](Scene&& scene, int rate, int steps_before) {
    DirectSolver before, direct;  // a new solver has no predicted correction
    before.added_inertia = direct.added_inertia = 0;
    scene.h = real(1) / real(rate);
    for (int n = 0; n < steps_before; ++n) leaps(scene, before)();
    leaps(scene, direct)();
    const std::vector<double>& met = direct.errors_met();
    for (std::size_t n = 0; n < met.size(); ++n)
      table.row({scene.name}, {1.0 / rate, double(n), met[n]});
    std::printf("%s, h = 1/%d s: an error of %.2g becomes %.2g m or rad after %zu iteration%s\n",
                scene.name.c_str(), rate, met.front(), met.back(), met.size() - 1,
                met.size() == 2 ? "" : "s");
  };
  for (const int rate : {15, 60, 240}) show(three_slabs(), rate, rate / 2);
  show(taut_chain(10), 60, 0);
  Scene taut = taut_chain(10);
  DirectSolver direct = with_positions();
  const double gap = play(taut, "", choice.seconds, "", [](double) {}, leaps(taut, direct)).gap_max;
  std::printf("taut, for %g s: a gap of %.2g m at most\n", choice.seconds, gap);
}

}  // namespace joints::chapter9
