// The classical Runge-Kutta method: four slopes, their mean, and a projection.
#include "chapters/09_direct/runge_kutta.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "engine/input.h"

namespace joints {

namespace {

constexpr double exact = 1e-12;  // errors below this are rounding [m or rad]
// If errors are above this after a step, it has found no pose that satisfies the joints.
constexpr double open = sizeof(real) == 4 ? 1e-3 : 1e-8;
constexpr int corrections = 8;  // largest number of corrections of the poses
// Largest change between the second and the third stage, relative to the squares of all velocities:
// an oscillation with h nu = 2.5 has 16, and one with h nu = 1 has 1/16.
constexpr double most_change = 16;
constexpr real at_rest = real(1e-6);  // slower bodies count as at rest [m/s]

// Normalises a quaternion of any size: the square of its length might overflow.
quat unit(const quat& q) {
  return normalize(q / std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)}));
}

// Moves a body by its velocities for a time, which may be negative.
void displace(Body& body, real time) {
  if (body.is_static()) return;
  body.x += time * body.v;
  body.q = normalize(rotation(time * body.w) * body.q);
}

// Calls f(accumulated impulse) for every row.
template <class F>
void for_impulses(const Blocks& rigid, const Blocks& springs, const F& f) {
  for (const Blocks* blocks : {&rigid, &springs})
    for (const Block& block : blocks->list)
      for (int i = 0; i < block.rows; ++i) f(block.impulse[i]);
}

}  // namespace

void RungeKutta::step(World& world, real h) {
  begin(world, h);
  for (const auto& joint : world.joints()) joint->begin_step(world.bodies, h);
  read(world.bodies, start_);
  sum_.assign(start_.size(), State{vec3(0), quat(0, 0, 0, 0), vec3(0), vec3(0)});
  std::vector<double> impulses(world.blocks.C.size() + springs_.C.size(), 0.0);  // of the step
  const real at[] = {0, h / 2, h / 2, h}, share[] = {h / 6, h / 3, h / 3, h / 6};
  for (int stage = 0; stage < 4; ++stage) {
    if (stage > 0) {
      write(world.bodies, at[stage], slope_);
      collect(world, world.blocks, &springs_);
      factor(world);
    }
    for_impulses(world.blocks, springs_, [](real& impulse) { impulse = 0; });
    find_slope(world, at[stage], slope_);
    if (stage == 1) second_ = slope_;
    if (stage == 2) check_slopes(world);
    auto sum = impulses.begin();
    for_impulses(world.blocks, springs_,  // forces in a stage
                 [&](real force) { *sum++ += double(share[stage]) * double(force); });
    for (std::size_t k = 0; k < sum_.size(); ++k) {
      sum_[k].x += share[stage] * slope_[k].x;
      sum_[k].q = sum_[k].q + share[stage] * slope_[k].q;
      sum_[k].v += share[stage] * slope_[k].v;
      sum_[k].w += share[stage] * slope_[k].w;
    }
  }
  write(world.bodies, 1, sum_);
  project(world);
  auto sum = impulses.begin();
  for_impulses(world.blocks, springs_, [&](real& impulse) { impulse = real(*sum++); });
  world.last_h = world.blocks.acting = h;
  check_motion(world.bodies);
}

// Rejects worlds that it cannot move, and factors the blocks at the present poses.
void RungeKutta::begin(World& world, real h) {
  check_input(world, h);
  const char* const bounded = "world: no joint may have limits or a motor, and no row bounds";
  for (const auto& joint : world.joints()) {
    const Joint::Extras extras = joint->extras();
    require(extras.limits == 0 && extras.motors == 0 && !extras.bounded, bounded);
  }
  collect(world, world.blocks, &springs_);
  for (const Blocks* blocks : {&std::as_const(world.blocks), &std::as_const(springs_)})
    for (const Block& block : blocks->list) {
      const RowTarget& target = block.target;
      require(target.lower == -unbounded && target.upper == unbounded && target.follows == 0,
              bounded);
      require((target.frequency > 0) == (blocks == &springs_) && target.rate == 0,
              "world: a row has a frequency or a rate that its joint has not");
    }
  h_ = h;
  solver_.most_work = most_work;
  factor(world);
}

void RungeKutta::read(const Bodies& bodies, std::vector<State>& states) {
  states.clear();
  for (int slot = 0; slot < bodies.slots(); ++slot) {
    const Body& body = bodies.at(slot);
    states.push_back({body.x, body.q, body.v, body.w});
  }
}

// Sets the bodies to their state at the start plus c times a slope.
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

// Collects the blocks at the present poses: of rigid joints, and of springs unless null.
void RungeKutta::collect(const World& world, Blocks& rigid, Blocks* springs) const {
  rigid.clear();
  if (springs) springs->clear();
  for (const auto& joint : world.joints())
    if (joint->frequency == 0) joint->append(world.bodies, rigid);
    else if (springs) joint->append(world.bodies, *springs);
}

void RungeKutta::factor(World& world) {
  solver_.prepare(world.bodies, world.blocks, 0, h_);
  if (solver_.report().iterated)
    refuse("world: a factorisation takes more multiplications a row than RungeKutta::most_work, " +
           std::to_string(most_work));
  solver_.factor_now();
}

// Stores the forces of the springs in place of their impulses. The force of a spring and damper
// with the mass K^-1 is -K^-1 (omega^2 C + 2 damping omega J V); Feedback is its implicit step.
void RungeKutta::stretch_springs(const Bodies& bodies) const {
  for (const Block& block : springs_.list) {
    const Row* const J = &springs_.J[std::size_t(block.first)];
    const Body &body1 = bodies.at(block.body1), &body2 = bodies.at(block.body2);
    const real omega = 2 * std::numbers::pi_v<real> * block.target.frequency;
    Row response[6];
    real inverse[36];
    form_responses(J, block.rows, body1, body2, response);
    form_K(J, response, block.rows, inverse);
    invert_symmetric(inverse, block.rows);
    for (int i = 0; i < block.rows; ++i)
      for (int j = 0; j < block.rows; ++j)
        block.impulse[i] -= inverse[i * block.rows + j] * omega *
                            (omega * springs_.C[std::size_t(block.first + j)] +
                             2 * block.target.damping * row_velocity(J[j], body1, body2));
  }
}

// Restores the bodies and throws.
void RungeKutta::give_up(Bodies& bodies, const std::string& why) const {
  for (int slot = 0; slot < bodies.slots(); ++slot) {
    Body& body = bodies.at(slot);
    const State& from = start_[slot];
    body.x = from.x, body.q = from.q, body.v = from.v, body.w = from.w;
  }
  throw std::runtime_error("world: " + why +
                           "; take a shorter step, or remove joints that hold what others hold "
                           "already, as some in a net of balls do");
}

// The slopes of the second and third stage belong to the same time. If they differ by much more
// than the velocities, the forces change too fast for a step of this length.
void RungeKutta::check_slopes(World& world) {
  double differ = 0, size = 0;  // sums of mass times velocity squared
  for (int slot = 0; slot < world.bodies.slots(); ++slot) {
    const Body& body = world.bodies.at(slot);
    if (body.is_static()) continue;
    const auto square = [&](const vec3& v, const vec3& w) {
      const vec3 local = to_local(body, w);
      return double(dot(v, v) / body.inverse_mass + dot(local, local / body.inverse_inertia_local));
    };
    differ += square(h_ * (slope_[slot].v - second_[slot].v),
                     h_ * (slope_[slot].w - second_[slot].w));
    size += square(vec3(at_rest), vec3(0)) + square(start_[slot].v, start_[slot].w) +
            square(h_ * (world.gravity + body.inverse_mass * body.force), vec3(0));
  }
  if (differ > most_change * size)  // overflow is reported at the end of the step
    give_up(world.bodies, "the forces change too much within the step");
}

// Computes the required -J'V of every row: minus the rate at which J V changes while V is constant.
// It is a central difference over a time for which curvature and rounding cause similar errors.
void RungeKutta::find_row_rates(World& world) {
  Bodies& bodies = world.bodies;
  real fastest = 1;
  for (int slot = 0; slot < bodies.slots(); ++slot)
    fastest = std::max(fastest, length(bodies.at(slot).w));
  const real time = std::cbrt(std::numeric_limits<real>::epsilon()) / fastest;
  wanted_.assign(world.blocks.C.size(), 0);
  real now = 0;
  for (const int side : {-1, 1}) {
    const real then = real(side) * time;
    for (int slot = 0; slot < bodies.slots(); ++slot) displace(bodies.at(slot), then - now);
    now = then;
    collect(world, displaced_, nullptr);
    const double share = side / (2 * double(time));
    for (const Block& block : displaced_.list)
      for (int i = 0; i < block.rows; ++i)
        wanted_[block.first + i] -= share * double(row_velocity(displaced_.J[block.first + i],
                                                                bodies.at(block.body1),
                                                                bodies.at(block.body2)));
  }
  for (int slot = 0; slot < bodies.slots(); ++slot) displace(bodies.at(slot), -now);
}

void RungeKutta::find_slope(World& world, real time, std::vector<State>& slope) {
  Bodies& bodies = world.bodies;
  if (forces) forces(bodies, time);
  stretch_springs(bodies);
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
  for (const Block& block : springs_.list) {
    Body* const held[] = {&bodies.at(block.body1), &bodies.at(block.body2)};
    for (int i = 0; i < block.rows; ++i) {
      const Row& J = springs_.J[std::size_t(block.first + i)];
      held[0]->v += block.impulse[i] * held[0]->inverse_mass * J.v1;
      held[0]->w += block.impulse[i] * (inverse_inertia(*held[0]) * J.w1);
      held[1]->v += block.impulse[i] * held[1]->inverse_mass * J.v2;
      held[1]->w += block.impulse[i] * (inverse_inertia(*held[1]) * J.w2);
    }
  }
  reach(world);
  for (int slot = 0; slot < bodies.slots(); ++slot)
    slope[slot].v = bodies.at(slot).v, slope[slot].w = bodies.at(slot).w;
}

// Projects the poses by Newton's method, until they are exact or do not improve, then the
// velocities.
void RungeKutta::project(World& world) {
  Bodies& bodies = world.bodies;
  read(bodies, slope_);  // for the velocities
  double before = std::numeric_limits<double>::infinity();
  for (int slot = 0; slot < bodies.slots(); ++slot) bodies.at(slot).v = bodies.at(slot).w = vec3(0);
  for (int n = 0;; ++n) {
    collect(world, world.blocks, &springs_);
    factor(world);
    wanted_.clear();
    double largest = 0;
    for (const real C : world.blocks.C) {
      wanted_.push_back(-double(C));
      largest = std::max(largest, std::abs(double(C)));
    }
    if (n == corrections || largest < exact || !(largest < before)) {
      if (!(largest < open))
        give_up(bodies, "the step found no poses that satisfy the joints");
      break;
    }
    before = largest;
    reach(world);
    for (int slot = 0; slot < bodies.slots(); ++slot) {
      displace(bodies.at(slot), 1);
      bodies.at(slot).v = bodies.at(slot).w = vec3(0);
    }
  }
  for (int slot = 0; slot < bodies.slots(); ++slot)
    bodies.at(slot).v = slope_[slot].v, bodies.at(slot).w = slope_[slot].w;
  wanted_.assign(world.blocks.C.size(), 0.0);
  reach(world);
}

// Changes the velocities so that J V has the required values; twice, because A is softened.
void RungeKutta::reach(World& world) {
  Bodies& bodies = world.bodies;
  for (int n = 0; n < 2; ++n) {
    rates_ = wanted_;
    for (const Block& block : world.blocks.list)
      for (int i = 0; i < block.rows; ++i)
        rates_[block.first + i] -= double(row_velocity(world.blocks.J[block.first + i],
                                                       bodies.at(block.body1),
                                                       bodies.at(block.body2)));
    solver_.change_rates(bodies, rates_);
  }
}

}  // namespace joints
