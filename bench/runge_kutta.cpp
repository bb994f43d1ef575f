// A half-explicit Runge-Kutta method: five slopes, their mean, and a projection.
#include "bench/runge_kutta.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "engine/kept/input.h"

namespace joints {

namespace {

constexpr double exact = 1e-12;  // errors below this are rounding [m or rad; or relative]
// If errors are above this after a step, it has found no pose that satisfies the joints.
constexpr double open = sizeof(real) == 4 ? 1e-3 : 1e-8;
constexpr int corrections = 8;  // largest number of corrections of the poses
constexpr double small = 1e-6;  // what a correction leaves of them for the next one
// Largest change between the second and the third stage, relative to the squares of all velocities:
// an oscillation with h nu = 2.5 has 0.8, and one with h nu = 1 has 0.02.
constexpr double most_change = 0.8;
constexpr real at_rest = real(1e-6);  // slower bodies count as at rest [m/s]

// Normalises a quaternion of any size: the square of its length might overflow.
quat unit(const quat& q) {
  return normalize(q / std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)}));
}

void copy(Bodies& bodies, std::vector<Body>& to) {
  to.assign(bodies.begin(), bodies.end());
}

// Calls f(accumulated impulse) for every row.
template <class F>
void for_impulses(const Blocks& rigid, const Blocks& springs, const F& f) {
  for (const Blocks* blocks : {&rigid, &springs})
    for (const Block& block : blocks->list)
      for (int i = 0; i < block.rows; ++i) f(block.impulse[i]);
}

// Exchanges the rows of two lists of blocks, and nothing else of them.
void exchange_rows(Blocks& a, Blocks& b) {
  a.list.swap(b.list);
  a.C.swap(b.C);
  a.J.swap(b.J);
}

// The weights of the slopes in each stage, the last line for the step's end, and the times of the
// stages: HEM4 of Brasey and Hairer, with the abscissas of Radau IIA.
const real root = std::sqrt(real(6));
const real weights[6][5] = {
    {},
    {real(0.3)},
    {(1 + root) / 30, (11 - 4 * root) / 30},
    {(-79 - 31 * root) / 150, (-1 - 4 * root) / 30, (24 + 11 * root) / 25},
    {(14 + 5 * root) / 6, (-8 + 7 * root) / 6, (-9 - 7 * root) / 4, (9 - root) / 4},
    {0, 0, (16 - root) / 36, (16 + root) / 36, real(1) / 9}};
const real times[] = {0, real(0.3), (4 - root) / 10, (4 + root) / 10, 1};

}  // namespace

void RungeKutta::step(World& world, real h) {
  std::optional<HeldMatrices> matrices(std::in_place, world.bodies);  // of the present poses
  begin(world, h);
  for (const auto& joint : world.joints()) joint->begin_step(world.bodies, h);
  copy(world.bodies, given_);
  double enough = 0;  // largest error of J V that may be left
  for (const Body& body : given_)
    enough = std::max(enough, exact * double(std::max(length(body.v), length(body.w))));
  wanted_.assign(world.blocks.C.size(), 0);
  solver_.reach(world.bodies, world.blocks, wanted_, enough);  // joints may have come
  copy(world.bodies, start_);
  std::vector<double> impulses(world.blocks.C.size() + springs_.C.size(), 0.0);  // of the step
  real before = 1;  // the time for which the forces of the stage before have acted [s]
  for (int stage = 0; stage < stages; ++stage) {
    if (stage > 0) {
      exchange_rows(world.blocks, next_);
      exchange_rows(springs_, next_springs_);
      factor(world);
    }
    std::vector<Slope>& slope = slopes_[stage];
    find_free_slope(world, times[stage] * h, slope);
    matrices.reset();
    write(world.bodies, stage + 1);
    matrices.emplace(world.bodies);
    copy(world.bodies, free_);
    collect(world, next_, &next_springs_);
    const real acted = h * weights[stage + 1][stage];
    solver_.warm_start(world.bodies, stage == 0 ? 0 : acted / before);  // about the same forces
    before = acted;
    solver_.reach(world.bodies, next_, wanted_, enough);
    for (std::size_t slot = 0; slot < slope.size(); ++slot) {
      const Body& body = world.bodies.at(int(slot));
      slope[slot].v += (body.v - free_[slot].v) / acted;
      slope[slot].w += (body.w - free_[slot].w) / acted;
    }
    if (stage == 2) check_slopes(world);
    auto sum = impulses.begin();
    const double mean = double(h * weights[stages][stage]), rigid = mean / double(acted);
    const auto end_of_rigid = sum + long(world.blocks.C.size());
    for_impulses(world.blocks, springs_, [&](real given) {  // impulses of rows, forces of springs
      const double factor = sum < end_of_rigid ? rigid : mean;
      *sum++ += factor * double(given);
    });
  }
  matrices.reset();
  project(world);
  auto sum = impulses.begin();
  for_impulses(world.blocks, springs_, [&](real& impulse) { impulse = real(*sum++); });
  exchange_rows(world.blocks, next_);
  world.last_h = world.blocks.impulse_duration = h;
  check_motion(world.bodies);
}

// Rejects worlds that it cannot move, and factors the blocks at the present poses.
void RungeKutta::begin(World& world, real h) {
  check_input(world, h);
  require(most_work >= 0, "most_work", real(most_work), "must not be negative");
  const char* const bounded =
      "world: no joint may have limits, a motor, friction or a spring of a coordinate, and no row "
      "may have bounds";
  for (const auto& joint : world.joints()) {
    const Joint::Stats extras = joint->stats();
    require(extras.limits == 0 && extras.motors == 0 && !extras.bounded, bounded);
  }
  collect(world, world.blocks, &springs_);
  for (const Blocks* blocks : {&std::as_const(world.blocks), &std::as_const(springs_)})
    for (const Block& block : blocks->list) {
      const RowSettings& target = block.settings;
      require(target.lower == -unbounded && target.upper == unbounded && target.follows == 0,
              bounded);
      require((target.frequency > 0) == (blocks == &springs_) && target.rate == 0,
              "world: a row has a frequency or a rate that its joint has not");
    }
  h_ = h;
  solver_.most_work = most_work;
  factor(world);
}

// Sets the bodies to their state in a stage, or at the step's end, from the slopes before it.
void RungeKutta::write(Bodies& bodies, int stage) const {
  for (int slot = 0; slot < bodies.slots(); ++slot) {
    Body& body = bodies.at(slot);
    if (body.kinematic) {
      body.x = start_[slot].x, body.q = start_[slot].q;
      integrate_pose(body, stage < stages ? h_ * times[stage] : h_);
      continue;
    }
    Body to = start_[slot];
    for (int k = 0; k < stage; ++k) {
      const Slope& slope = slopes_[k][slot];
      const real time = h_ * weights[stage][k];
      to.x += time * slope.x;
      to.q = to.q + time * slope.q;
      to.v += time * slope.v;
      to.w += time * slope.w;
    }
    body.x = to.x, body.q = unit(to.q), body.v = to.v, body.w = to.w;
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
// with the mass K^-1 is -K^-1 (omega^2 C + 2 damping omega J V); SoftCoefficients is its implicit
// step.
void RungeKutta::stretch_springs(const Bodies& bodies) const {
  for (const Block& block : springs_.list) {
    std::fill_n(block.impulse, block.rows, real(0));
    const Row* const J = &springs_.J[std::size_t(block.first)];
    const Body &body1 = bodies.at(block.body1), &body2 = bodies.at(block.body2);
    const real omega = 2 * std::numbers::pi_v<real> * block.settings.frequency;
    Row response[6];
    real inverse[36];
    form_responses(J, block.rows, body1, body2, response);
    form_K(J, response, block.rows, inverse);
    invert_symmetric(inverse, block.rows);
    for (int i = 0; i < block.rows; ++i)
      for (int j = 0; j < block.rows; ++j)
        block.impulse[i] -= inverse[i * block.rows + j] * omega *
                            (omega * springs_.C[std::size_t(block.first + j)] +
                             2 * block.settings.damping * row_velocity(J[j], body1, body2));
  }
}

// Restores the bodies and throws.
void RungeKutta::give_up(Bodies& bodies, const std::string& why) const {
  std::copy(given_.begin(), given_.end(), bodies.data());
  throw std::runtime_error("world: " + why +
                           "; take a shorter step, or remove joints that hold what others hold "
                           "already, as some in a net of balls do");
}

// If the accelerations of the second and the third stage differ by much more than the velocities,
// the forces change too fast for a step of this length.
void RungeKutta::check_slopes(World& world) {
  double differ = 0, size = 0;  // sums of mass times velocity squared
  for (int slot = 0; slot < world.bodies.slots(); ++slot) {
    const Body& body = world.bodies.at(slot);
    if (body.is_static()) continue;
    const auto square = [&](const vec3& v, const vec3& w) {
      const vec3 local = to_local(body, w);
      return double(dot(v, v) / body.inverse_mass + dot(local, local / body.inverse_inertia_local));
    };
    const Slope &second = slopes_[1][slot], &third = slopes_[2][slot];
    differ += square(h_ * (third.v - second.v), h_ * (third.w - second.w));
    size += square(vec3(at_rest), vec3(0)) + square(start_[slot].v, start_[slot].w) +
            square(h_ * (world.gravity + body.inverse_mass * body.force), vec3(0));
  }
  if (differ > most_change * size)  // overflow is reported at the end of the step
    give_up(world.bodies, "the forces change too much within the step");
}

// The velocities, and the accelerations without the forces of rigid joints.
void RungeKutta::find_free_slope(World& world, real time, std::vector<Slope>& slope) {
  Bodies& bodies = world.bodies;
  const std::size_t joints = world.joints().size();
  if (forces) forces(bodies, time);
  require(bodies.slots() == int(start_.size()) && world.joints().size() == joints,
          "forces: must not add or remove bodies or joints");
  stretch_springs(bodies);
  slope.clear();
  for (int slot = 0; slot < bodies.slots(); ++slot) {
    const Body& body = bodies.at(slot);
    if (body.is_static()) {  // a belt and a kinematic body keep their velocities
      slope.push_back({vec3(0), quat(0, 0, 0, 0), vec3(0), vec3(0)});
      continue;
    }
    const vec3 w = to_local(body, body.w), momentum = w / body.inverse_inertia_local;
    slope.push_back({body.v, real(0.5) * (quat(0, body.w.x, body.w.y, body.w.z) * body.q),
                     world.gravity + body.inverse_mass * body.force,
                     inverse_inertia(body) * (body.torque - to_world(body, cross(w, momentum)))});
  }
  for (const Block& block : springs_.list)
    for (int i = 0; i < block.rows; ++i) {
      const Row& J = springs_.J[std::size_t(block.first + i)];
      const auto accelerate = [&](int slot, const vec3& v, const vec3& w) {
        const Body& body = bodies.at(slot);
        slope[slot].v += block.impulse[i] * body.inverse_mass * v;
        slope[slot].w += block.impulse[i] * (inverse_inertia(body) * w);
      };
      accelerate(block.body1, J.v1, J.w1);
      accelerate(block.body2, J.v2, J.w2);
    }
}

// Projects the poses by Newton's method with the factor of the last stage, until they are exact or
// do not improve. The velocities stay.
void RungeKutta::project(World& world) {
  Bodies& bodies = world.bodies;
  copy(bodies, free_);  // for the velocities
  double before = std::numeric_limits<double>::infinity();
  poses_.errors_only = true;
  for (int n = 0;; ++n) {
    wanted_.clear();
    double largest = 0;
    for (const real C : (n == 0 ? next_ : poses_).C) {
      wanted_.push_back(-C);
      largest = std::max(largest, std::abs(double(C)));
    }
    if (n == corrections || largest < exact || !(largest < before)) {
      if (!(largest < open))
        give_up(bodies, "the step found no poses that satisfy the joints");
      break;
    }
    before = largest;
    for (int slot = 0; slot < bodies.slots(); ++slot)
      bodies.at(slot).v = bodies.at(slot).w = vec3(0);
    solver_.reach(bodies, world.blocks, wanted_, small * largest);
    for (int slot = 0; slot < bodies.slots(); ++slot) {
      Body& body = bodies.at(slot);
      body.x += body.v;
      body.q = normalize(rotation(body.w) * body.q);
    }
    collect(world, poses_, nullptr);
  }
  for (int slot = 0; slot < bodies.slots(); ++slot)
    bodies.at(slot).v = free_[slot].v, bodies.at(slot).w = free_[slot].w;
}

}  // namespace joints
