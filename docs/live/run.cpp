// Steps with the settings of the page, and looks into a step.
#include "docs/live/run.h"

#include <numbers>

#include "contacts/ground_contact.h"
#include "engine/kept/input.h"
#include "engine/instruments/rate.h"
#include "engine/kept/state.h"
#include "engine/kernels.h"
#include "joints/ball_joint.h"

namespace joints::live {

namespace {

// Of all bodies that move [kg].
double moving_mass(const Bodies& bodies) {
  double sum = 0;
  for (const Body& body : all_of(bodies))
    if (body.inverse_mass > 0) sum += 1 / double(body.inverse_mass);
  return sum;
}

}  // namespace

LiveRun::LiveRun(const Entry& entry, std::optional<double> ratio)
    : live_(entry.make()), ratio_(ratio.value_or(double(live_.ratio))), speed_(live_.speed),
      strength_(live_.strength), beta_(live_.beta) {
  require(std::isfinite(ratio_) && ratio_ > 0, "ratio", real(ratio_),
          "must be positive and finite [1]");
  direct_.added_inertia = live_.added_inertia;
  const double usual_mass = moving_mass(world().bodies);
  Body& heavy = world().bodies.at(live_.heavy);
  heavy.inverse_mass /= real(ratio_);
  heavy.inverse_inertia_local /= real(ratio_);
  energy_0_ = joints::energy(all_of(world().bodies), world().gravity);
  energy_scale_ = live_.scene->energy_scale * moving_mass(world().bodies) / usual_mass;
}

PageSettings LiveRun::settings() const {
  const Scene& scene = *live_.scene;
  const StepOptions& how = scene.stepping;
  return {beta_, double(scene.solver.iterations), double(scene.h), double(how.substeps),
          double(how.warm_start), double(how.projections), double(scene.solver.relaxation),
          double(how.frequency), double(how.damping), double(is_direct_), double(direct_.newton),
          double(direct_.added_inertia), double(how.leapfrog), ratio_, tilt_, speed_,
          strength_, double(is_own_)};
}

void LiveRun::set(const PageSettings& to) {
  Scene& scene = *live_.scene;
  world().set_beta(real(to.beta));
  beta_ = to.beta;
  scene.solver.iterations = int(to.iterations);
  scene.solver.relaxation = real(to.relaxation);
  scene.h = real(to.h);
  scene.stepping = {.warm_start = to.warm != 0,
                    .substeps = int(to.substeps),
                    .projections = int(to.projections),
                    .leapfrog = to.leapfrog != 0,
                    .frequency = real(to.frequency),
                    .damping = real(to.damping)};
  direct_.fallback.iterations = scene.solver.iterations;
  direct_.fallback.relaxation = scene.solver.relaxation;
  direct_.fallback.split_iterations = 0;
  direct_.newton = int(to.newton);
  direct_.added_inertia = real(to.added_inertia);
  is_own_ = to.own != 0 && live_.own;
  is_direct_ = to.direct != 0;
  if (to.tilt != tilt_) {
    const real size = length(world().gravity), angle = real(to.tilt * std::numbers::pi / 180);
    const double before = joints::energy(all_of(world().bodies), world().gravity);
    world().gravity = size * vec3(std::sin(angle), -std::cos(angle), 0);
    energy_0_ += joints::energy(all_of(world().bodies), world().gravity) - before;
    tilt_ = to.tilt;
  }
  speed_ = to.speed;
  strength_ = to.strength;
  if (live_.drive) live_.drive(real(speed_), real(strength_));
  require(scene.stepping.substeps > 0, "substeps: there must be at least one");
  check_input(world(), solver(), h_sub(), scene.stepping);
}

Solver& LiveRun::solver() {
  if (is_direct_) return direct_;
  return live_.scene->solver;
}

void LiveRun::step() {
  if (live_.before) live_.before(time_);
  Scene& scene = *live_.scene;
  if (is_own_)
    live_.own(world().bodies, settings(), world().gravity);
  else
    joints::step(world(), solver(), scene.h, scene.stepping);
  time_ += double(scene.h);
}

double LiveRun::gap() const {
  GapMeter meter;
  if (scene().gaps)
    scene().gaps(meter);
  else
    meter.look(scene().marks, poses(world().bodies));
  return meter.maximum();
}

double LiveRun::energy() const {
  return joints::energy(all_of(world().bodies), world().gravity) - energy_0_;
}

// ---- the hand -----------------------------------------------------------------------------------

void LiveRun::grab(int slot, const vec3& point) {
  let_go();
  Bodies& bodies = world().bodies;
  require(slot >= 0 && slot < int(scene().shapes.size()) && bodies.used(slot),
          "body: there is none of this number");
  BodyId held;
  for (const auto& joint : world().joints())  // a joint knows the ids of its bodies
    for (const BodyId id : {joint->body1, joint->body2})
      if (int(id.slot) == slot) held = id;
  hand_ = world().add(static_body(point));
  auto& joint = world().add<BallJoint>(*hand_, held,
                                       point_at(bodies[*hand_], bodies[held], point));
  joint.frequency = real(2.5);
  joint.projected = false;
  joint.beta = real(beta_);
}

void LiveRun::move_hand(const vec3& point) {
  if (hand_) world().bodies[*hand_].x = point;
}

void LiveRun::let_go() {
  if (hand_) world().remove(*hand_);
  hand_.reset();
}

// ---- within a step ------------------------------------------------------------------------------

// Begins the next step, iterates, looks, and sets everything back. The direct solver has no
// iterations: any number of them solves.
void LiveRun::within(int iterations, int blocks, const std::function<void()>& look) {
  Scene& scene = *live_.scene;
  const State as_it_was = save(world());
  if (live_.before) live_.before(time_);
  begin_step(world(), solver(), h_sub(), scene.stepping);
  if (is_direct_) {
    if (iterations > 0) direct_.solve(world().bodies);
  } else {
    for (int k = 0; k < iterations; ++k) scene.solver.iterate(world().bodies);
    scene.solver.iterate(world().bodies, 0, std::min(blocks, scene.solver.prepared_count()));
  }
  look();
  restore(world(), as_it_was);
}

std::vector<RowLook> LiveRun::rows_now() {
  std::vector<RowLook> found;
  Blocks blocks;
  for (std::size_t number = 0; number < world().joints().size(); ++number) {
    Joint& joint = *world().joints()[number];
    joint.begin_step(world().bodies, h_sub());
    blocks.clear();
    joint.append(world().bodies, blocks);
    double row = 0;
    for (const Block& block : blocks.list) {
      const RowSettings& target = block.settings;
      if (!target.holds_position || target.follows != 0) continue;
      for (int i = 0; i < block.rows; ++i) {
        const Row& J = blocks.J[std::size_t(block.first + i)];
        const real C = blocks.C[std::size_t(block.first + i)];
        const bool pushes = i == block.rows - 1 && target.one_sided();
        const bool moves = dot(J.v2, J.v2) > 0;
        found.push_back({double(number), pushes ? 0 : ++row, double(block.body1),
                         double(block.body2), pushes && C > 0 ? 0 : double(C), double(moves),
                         glm::dvec3(moves ? J.v2 : J.w2)});
      }
    }
  }
  return found;
}

std::vector<RowLook> LiveRun::rows_at(const std::vector<double>& poses) {
  const State as_it_was = save(world());
  for (std::size_t k = 0; k < scene().shapes.size() && 7 * k + 6 < poses.size(); ++k) {
    const auto at = [p = &poses[7 * k]](int i) { return real(p[i]); };
    Body& body = world().bodies.at(int(k));
    body.x = vec3(at(0), at(1), at(2));
    body.q = quat(at(3), at(4), at(5), at(6));
  }
  const std::vector<RowLook> found = rows_now();
  restore(world(), as_it_was);
  return found;
}

int LiveRun::blocks() {
  int count = 0;
  within(0, 0, [&] { count = int(world().blocks.list.size()); });
  return count;
}

namespace {

// What is left of the velocity error of each row of a block [m/s, rad/s].
void residuals(const Bodies& bodies, const Blocks& blocks, const Block& block, real h,
               double* out) {
  const Row* J = &blocks.J[std::size_t(block.first)];
  const Body &a = bodies.at(block.body1), &b = bodies.at(block.body2);
  const SoftCoefficients now = soft_coefficients(block.settings, h, blocks.duration_or(h));
  Row response[6];
  real K[36];
  if (now.softness != 0) {
    form_responses(J, block.rows, a, b, response);
    form_K(J, response, block.rows, K);
  }
  for (int i = 0; i < block.rows; ++i) {
    const real C = blocks.C[std::size_t(block.first + i)];
    real e = row_velocity(J[i], a, b) + bias(block, i, C, now.bias_rate, h);
    for (int j = 0; now.softness != 0 && j < block.rows; ++j)
      e += now.softness * K[i * block.rows + j] * block.impulse[j];
    if (i == block.rows - 1) {  // at a bound it may have any rate that leads away from it
      const RowSettings& target = block.settings;
      const bool follows = target.follows != 0;
      const real duration = blocks.duration_or(h);
      const real upper = target.upper * (follows ? block.impulse[target.follows] : duration);
      const real lower = follows ? -upper : duration * target.lower;
      if (block.impulse[i] <= lower && e > 0) e = 0;
      if (block.impulse[i] >= upper && e < 0) e = 0;
    }
    out[i] = double(e);
  }
}

// The points and the forces of a joint: the blocks [from, to) of a world belong to it.
JointLook look_of(const World& world, const Scene& scene, std::size_t number, std::size_t from,
                  std::size_t to, real h) {
  const Joint& joint = *world.joints()[number];
  const Body &a = world.bodies[joint.body1], &b = world.bodies[joint.body2];
  JointLook out{double(joint.body1.slot), double(joint.body2.slot), {}, 0, {}, 0};
  vec3 place = (a.x + b.x) / real(2), weighed(0);
  real weight = 0;
  if (number < scene.marks.size()) place = world_point(a, vec3(scene.marks[number].anchor1_local));
  const auto* contact = dynamic_cast<const GroundContact*>(&joint);
  double sum = 0, left[6];
  for (std::size_t k = from; k < to; ++k) {
    const Block& block = world.blocks.list[k];
    residuals(world.bodies, world.blocks, block, h, left);
    for (int i = 0; i < block.rows; ++i) {
      const Row& J = world.blocks.J[std::size_t(block.first + i)];
      sum += left[i] * left[i];
      out.impulse += glm::dvec3(block.impulse[i] * J.v2);
      if (!contact || block.settings.follows != 0) continue;
      // v2 is n and w2 is r2 x n: the corner is beside the centre by n x w2, on the top of body 1.
      const vec3 n = J.v2;
      const real height = contact->top.height + dot(n, a.x - b.x);
      const real push = std::max(block.impulse[i], real(1e-12));
      weighed += push * (b.x + cross(n, J.w2) + height * n);
      weight += push;
    }
  }
  out.place = glm::dvec3(weight > 0 ? weighed / weight : place);
  out.error = std::sqrt(sum);
  return out;
}

}  // namespace

std::vector<JointLook> LiveRun::joints_now(int blocks) const {
  std::vector<JointLook> found;
  const World& now = world();
  Blocks scratch;
  std::size_t from = 0;
  for (std::size_t k = 0; k < now.joints().size(); ++k) {
    scratch.clear();
    now.joints()[k]->append(now.bodies, scratch);
    const std::size_t to = from + scratch.list.size();
    if (to > from && (!hand_ || !(now.joints()[k]->body1 == *hand_))) {
      found.push_back(look_of(now, scene(), k, from, to, h_sub()));
      found.back().next = std::size_t(blocks) >= from && std::size_t(blocks) < to;
    }
    from = to;
  }
  return found;
}

std::vector<JointLook> LiveRun::look(int iterations, int blocks) {
  std::vector<JointLook> found;
  within(iterations, blocks, [&] { found = joints_now(blocks); });
  return found;
}

std::vector<double> LiveRun::errors(int most) {
  std::vector<double> sizes;
  const int last = is_direct_ ? 1 : most;
  within(0, 0, [&] {
    Bodies& bodies = world().bodies;
    for (int k = 0; k <= last; ++k) {
      if (k > 0) is_direct_ ? direct_.solve(bodies) : live_.scene->solver.iterate(bodies);
      double largest = 0;
      for (const JointLook& joint : joints_now(0)) largest = std::max(largest, joint.error);
      sizes.push_back(largest);
    }
  });
  return sizes;
}

double LiveRun::rate(int most) {
  return contraction_rate(world(), most, h_sub(), live_.scene->solver, live_.scene->stepping);
}

}  // namespace joints::live
