// The numbers of the answers to the questions, and of Numbers 5.
#include <algorithm>
#include <cmath>

#include "bench/chapters/06_baumgarte/cube_chain.h"
#include "bench/chapters/06_baumgarte/experiments.h"
#include "chapters/06_baumgarte/baumgarte.h"
#include "chapters/06_baumgarte/program/chain_loop.h"

namespace joints::chapter6 {

namespace {

// ---- Numbers 5: the remaining error after each solve -------------------------------------------

void newton(const Choice& choice) {
  CsvFile table(choice.out + "/newton.csv", {"solves", "gap_m"});
  Body wall = static_body(vec3(0)), body = box(2, vec3(1), vec3(1, 0, 0));
  body.inverse_inertia_local = vec3(2);
  const Point point{vec3(0), vec3(-1, real(0.1), 0)};
  for (int solves = 0; solves < 4; ++solves) {
    if (solves > 0) project(point, wall, body);
    table.row({double(solves), double(length(point.error(wall, body)))});
  }
}

// ---- question 1: half the step -----------------------------------------------------------------

// The cube of the thesis, 2 m beside its joint, displaced obliquely by 0.1 m. Without gravity.
CubeChain slanted_cube(real step, double beta) {
  CubeChain out("slanted", 1, 100, vec3(2, 0, 0), real(beta));
  out.scene.world.gravity = vec3(0);
  out.scene.h = step;
  Body& cube = out.scene.world.bodies[out.ids.back()];
  cube.inverse_inertia_local = vec3(real(0.06));  // of an edge of 1 m
  cube.x += real(0.1 / std::sqrt(2.0)) * vec3(1, 0, -1);
  return out;
}

// A free bar of 1 m that rotates about its end at 3 rad/s, after a second.
struct Spun {
  double gap = 0, kept = 0;
};
Spun spun(real step, double beta, int projections) {
  const vec3 end(real(-0.5), 0, 0);
  ChainLoop own;
  Body bar = box(1, vec3(1, real(0.1), real(0.1)), vec3(real(0.5), 0, 0));
  bar.w = vec3(0, 0, 3);
  bar.v = cross(bar.w, -end);
  own.chain = {{static_body(vec3(0)), bar}, {Point{vec3(0), end}}};
  own.settings = {.beta = real(beta), .projections = projections};
  own.gravity = vec3(0);
  const double before = kinetic_energy(bar);
  for (int n = 0; n < steps_in(1, step); ++n) own.step(step);
  return {double(own.gap(0)), kinetic_energy(own.chain.bodies[1]) / before};
}

void half_the_step(const Choice& choice) {
  CsvFile table(choice.out + "/half_step.csv", {"method", "steps_per_s", "beta", "energy_j",
                                                "spin_rad_s", "bar_gap_m", "bar_energy_kept"});
  const double same_time = 1 - std::sqrt(0.8);
  for (const auto& [rate, beta] : {std::pair(60, 0.2), {120, 0.2}, {120, same_time}}) {
    const real step = 1 / real(rate);
    CubeChain pulled = slanted_cube(step, beta);
    const Body& cube = pulled.scene.world.bodies[pulled.ids.back()];
    pulled.step();
    const double energy = kinetic_energy(cube);
    for (int n = 1; n < 15 * rate; ++n) pulled.step();
    const Spun bar = spun(step, beta, 0);
    table.row({"feedback"}, {double(rate), beta, energy, double(cube.w.y), bar.gap, bar.kept});
  }
  for (const int rate : {60, 120}) {
    const Spun bar = spun(1 / real(rate), 0, 1);
    table.row({"projection"}, {double(rate), 0, 0, 0, bar.gap, bar.kept});
  }
}

// ---- question 2: projection, and beta beside it ------------------------------------------------

// The bar of the pendulums with projection, with and without feedback: the distance between them.
void one_pendulum(const Choice& choice) {
  CsvFile table(choice.out + "/with_feedback.csv", {"gap_max_m", "apart_max_m"});
  ChainLoop both[2];
  for (ChainLoop& own : both) {
    own.chain = {{static_body(vec3(0)),
                  box(1, vec3(1, real(0.1), real(0.1)), vec3(real(0.5), 0, 0))},
                 {Point{vec3(0), vec3(real(-0.5), 0, 0)}}};
    own.settings = {.beta = &own == both ? real(0) : real(0.2), .projections = 1};
  }
  double gap = 0, apart = 0;
  for (int n = 0; n < steps_in(choice.seconds, h); ++n) {
    for (ChainLoop& own : both) {
      own.step(h);
      gap = std::max(gap, double(own.gap(0)));
    }
    apart = std::max(apart, double(length(both[0].chain.bodies[1].x - both[1].chain.bodies[1].x)));
  }
  table.row({gap, apart});
}

void long_chain(const Choice& choice) {
  CsvFile table(choice.out + "/projections.csv", {"projections", "beta", "gap_max_m"});
  for (const int projections : {0, 1, 10, 100})
    for (const double beta : {0.0, 0.2}) {
      CubeChain chain("long", 20, 100, vec3(1, 0, 0), real(beta));
      chain.scene.stepping.projections = projections;
      table.row({double(projections), beta, play(chain.scene, "", choice.seconds / 2).gap_max});
    }
}

// ---- question 3: the remaining velocities after few iterations ---------------------------------

// Ten cubes that hang plumb: the speed of the last one, and its fall when it is cut off.
void false_speed(const Choice& choice) {
  CsvFile table(choice.out + "/false_speed.csv", {"start", "iterations", "gap_max_m", "sunk_m",
                                                  "speed_m_s", "fall_m"});
  const std::pair<bool, int> starts[] = {{false, 3}, {false, 10}, {false, 30}, {true, 3}};
  for (const auto& [warm, iterations] : starts) {
    CubeChain chain("false speed", 10, 100, vec3(0, -1, 0), 0);
    chain.scene.solver.iterations = iterations;
    chain.scene.stepping.warm_start = warm;
    chain.scene.stepping.projections = 300;
    double gap = 0;
    for (int n = 0; n < steps_in(0.3 * choice.seconds, h); ++n) {
      chain.step();
      for (std::size_t k = 0; k < chain.joints.size(); ++k) gap = std::max(gap, chain.gap(k));
    }
    const Body& last = chain.scene.world.bodies[chain.ids.back()];
    const double place = double(last.x.y), speed = -double(last.v.y);
    chain.scene.world.remove(*chain.joints.back());
    chain.joints.pop_back();
    for (int n = 0; n < 6; ++n) chain.step();
    table.row({warm ? "warm" : "cold"}, {double(iterations), gap, -10 - place, speed,
                                         place - double(last.x.y)});
  }
}

// The same released level: the time at which the last one is lowest, and the energy at the end,
// both from positions alone: a velocity is the difference of two poses divided by the step.
void honey(const Choice& choice) {
  CsvFile table(choice.out + "/honey.csv", {"iterations", "gap_max_m", "lowest_s", "energy_lost"});
  for (const int iterations : {3, 10, 30, 300}) {
    CubeChain chain("honey", 10, 100, vec3(1, 0, 0), 0);
    chain.scene.solver.iterations = iterations;
    chain.scene.stepping.projections = 100;
    const Bodies& bodies = chain.scene.world.bodies;
    double gap = 0, lowest = 0, time = 0, energy = 0;
    for (int n = 1; n <= steps_in(choice.seconds / 2, h); ++n) {
      const Bodies before = bodies;
      chain.step();
      for (std::size_t k = 0; k < chain.joints.size(); ++k) gap = std::max(gap, chain.gap(k));
      energy = 0;
      for (const BodyId id : chain.ids) {
        if (bodies[id].is_static()) continue;
        Body moved = bodies[id];
        moved.v = (moved.x - before[id].x) / h;
        const quat turn = moved.q * conjugate(before[id].q);
        moved.w = real(turn.w < 0 ? -2 : 2) / h * vec3(turn.x, turn.y, turn.z);
        energy += kinetic_energy(moved) + 100 * 9.81 * double(moved.x.y);
      }
      const double y = double(bodies[chain.ids.back()].x.y);
      if (y < lowest && n < steps_in(choice.seconds / 4, h)) {
        lowest = y;
        time = n * double(h);
      }
    }
    table.row({double(iterations), gap, time, -energy / chain.scene.energy_scale});
  }
}

}  // namespace

void questions(const Choice& choice) {
  newton(choice);
  half_the_step(choice);
  one_pendulum(choice);
  long_chain(choice);
  false_speed(choice);
  honey(choice);
}

}  // namespace joints::chapter6
