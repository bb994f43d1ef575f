// The classical Runge-Kutta method: four slopes, their mean, and a projection.
#include "chapters/09_direct/runge_kutta.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/input.h"

namespace joints {

namespace {

constexpr double exact = 1e-12;  // errors below this are rounding [m or rad]

// Of length 1, however large it is: the square of its length might overflow.
quat unit(const quat& q) {
  return normalize(q / std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)}));
}

// Moves a body along its velocities for a while, which may be negative.
void displace(Body& body, real time) {
  if (body.is_static()) return;
  body.x += time * body.v;
  body.q = normalize(rotation(time * body.w) * body.q);
}

}  // namespace

void RungeKutta::step(World& world, real h) {
  check_input(world, h);
  const char* const bounded = "world: no joint may have limits or a motor, and no row bounds";
  for (const auto& joint : world.joints()) {
    const Joint::Extras extras = joint->extras();
    require(extras.limits == 0 && extras.motors == 0 && !extras.bounded, bounded);
  }
  for (const auto& joint : world.joints()) joint->begin_step(world.bodies, h);
  collect(world, world.blocks);
  for (const Block& block : world.blocks.list)
    require(block.target.lower == -unbounded && block.target.upper == unbounded &&
                block.target.follows == 0, bounded);
  h_ = h;
  read(world.bodies);
  sum_.assign(start_.size(), State{vec3(0), quat(0, 0, 0, 0), vec3(0), vec3(0)});
  const real at[] = {0, h / 2, h / 2, h}, share[] = {h / 6, h / 3, h / 3, h / 6};
  for (int stage = 0; stage < 4; ++stage) {
    if (stage > 0) {
      write(world.bodies, at[stage], slope_);
      collect(world, world.blocks);
    }
    find_slope(world, slope_);
    for (std::size_t k = 0; k < sum_.size(); ++k) {
      sum_[k].x += share[stage] * slope_[k].x;
      sum_[k].q = sum_[k].q + share[stage] * slope_[k].q;
      sum_[k].v += share[stage] * slope_[k].v;
      sum_[k].w += share[stage] * slope_[k].w;
    }
  }
  write(world.bodies, 1, sum_);
  project(world);
  check_motion(world.bodies);
}

void RungeKutta::read(const Bodies& bodies) {
  start_.clear();
  for (int slot = 0; slot < bodies.slots(); ++slot) {
    const Body& body = bodies.at(slot);
    start_.push_back({body.x, body.q, body.v, body.w});
  }
}

// The start and c times a slope.
void RungeKutta::write(Bodies& bodies, real c, const std::vector<State>& slope) const {
  for (int slot = 0; slot < bodies.slots(); ++slot) {
    Body& body = bodies.at(slot);
    const State &from = start_[slot], &by = slope[slot];
    body.x = from.x + c * by.x;
    body.q = unit(from.q + c * by.q);
    body.v = from.v + c * by.v;
    body.w = from.w + c * by.w;
  }
}

// The blocks at the present poses.
void RungeKutta::collect(World& world, Blocks& blocks) {
  blocks.clear();
  for (const auto& joint : world.joints()) joint->append(world.bodies, blocks);
}

// J'V of every row, the rate at which J V changes while V stays: a central difference over a time
// for which curvature and rounding leave about the same error.
void RungeKutta::find_row_rates(World& world) {
  Bodies& bodies = world.bodies;
  real fastest = 1;
  for (int slot = 0; slot < bodies.slots(); ++slot)
    fastest = std::max(fastest, length(bodies.at(slot).w));
  const real time = std::cbrt(std::numeric_limits<real>::epsilon()) / fastest;
  rates_.assign(world.blocks.C.size(), 0);
  real now = 0;
  for (const int side : {-1, 1}) {
    const real then = real(side) * time;
    for (int slot = 0; slot < bodies.slots(); ++slot) displace(bodies.at(slot), then - now);
    now = then;
    collect(world, displaced_);
    const double share = side / (2 * double(time));
    for (const Block& block : displaced_.list)
      for (int i = 0; i < block.rows; ++i)
        rates_[block.first + i] += share * double(row_velocity(displaced_.J[block.first + i],
                                                               bodies.at(block.body1),
                                                               bodies.at(block.body2)));
  }
  for (int slot = 0; slot < bodies.slots(); ++slot) displace(bodies.at(slot), -now);
}

void RungeKutta::find_slope(World& world, std::vector<State>& slope) {
  Bodies& bodies = world.bodies;
  solver_.prepare(bodies, world.blocks, 0, h_);
  solver_.factor_now();
  find_row_rates(world);
  slope.clear();
  for (int slot = 0; slot < bodies.slots(); ++slot) {
    Body& body = bodies.at(slot);
    if (body.is_static()) {  // stays where it is; a belt keeps its velocity
      slope.push_back({vec3(0), quat(0, 0, 0, 0), vec3(0), vec3(0)});
      body.v = body.w = vec3(0);
      continue;
    }
    slope.push_back({body.v, real(0.5) * (quat(0, body.w.x, body.w.y, body.w.z) * body.q),
                     vec3(0), vec3(0)});
    const vec3 w = to_local(body, body.w), momentum = w / body.inverse_inertia_local;
    body.v = world.gravity + body.inverse_mass * body.force;  // from here on, accelerations
    body.w = inverse_inertia(body) * (body.torque - to_world(body, cross(w, momentum)));
  }
  for (const Block& block : world.blocks.list)
    for (int i = 0; i < block.rows; ++i) {
      double& rate = rates_[block.first + i];
      rate = -rate - double(row_velocity(world.blocks.J[block.first + i], bodies.at(block.body1),
                                         bodies.at(block.body2)));
    }
  solver_.change_rates(bodies, rates_);
  for (int slot = 0; slot < bodies.slots(); ++slot)
    slope[slot].v = bodies.at(slot).v, slope[slot].w = bodies.at(slot).w;
}

// Poses by Newton's method, until they are exact or twice, then velocities.
void RungeKutta::project(World& world) {
  Bodies& bodies = world.bodies;
  read(bodies);  // start_ holds the velocities meanwhile
  for (int slot = 0; slot < bodies.slots(); ++slot) bodies.at(slot).v = bodies.at(slot).w = vec3(0);
  for (int n = 0;; ++n) {
    collect(world, world.blocks);
    solver_.prepare(bodies, world.blocks, 0, h_);
    solver_.factor_now();
    rates_.clear();
    double largest = 0;
    for (const real C : world.blocks.C) {
      rates_.push_back(-double(C));
      largest = std::max(largest, std::abs(double(C)));
    }
    if (n == 2 || largest < exact) break;
    solver_.change_rates(bodies, rates_);
    for (int slot = 0; slot < bodies.slots(); ++slot) {
      displace(bodies.at(slot), 1);
      bodies.at(slot).v = bodies.at(slot).w = vec3(0);
    }
  }
  for (int slot = 0; slot < bodies.slots(); ++slot)
    bodies.at(slot).v = start_[slot].v, bodies.at(slot).w = start_[slot].w;
  for (const Block& block : world.blocks.list)
    for (int i = 0; i < block.rows; ++i)
      rates_[block.first + i] = -double(row_velocity(world.blocks.J[block.first + i],
                                                     bodies.at(block.body1),
                                                     bodies.at(block.body2)));
  solver_.change_rates(bodies, rates_);
}

}  // namespace joints
