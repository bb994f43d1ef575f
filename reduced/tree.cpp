// The steps of a tree: leapfrog in the coordinates, and a Runge-Kutta method.
#include "reduced/tree.h"

#include <algorithm>

#include "reduced/recursion.inl"

namespace joints {

namespace {

constexpr real most_growth = 4;

void move_freely(TreeLink& root, real h) {
  root.centre += h * root.v;
  if (root.w != vec3(0)) root.q = normalize(rotation(h * root.w) * root.q);
}

}  // namespace

// ---- the recursion ------------------------------------------------------------------------------

void Tree::place_all() { place_links(links.data(), links.data() + links.size()); }

void Tree::locate_all() {
  for (std::size_t k = 1; k < links.size(); ++k) {
    TreeLink& link = links[k];
    move(link, links[link.parent]);
    locate(link, links[link.parent]);
  }
}

void Tree::recursion(bool inertia, bool moving) {
  accelerate_links(links.data(), links.data() + links.size(), inertia, moving);
}

void Tree::find_accelerations() {
  for (Drive& drive : drives_) links[drive.link].held = false;
  set_explicit_springs();
  recursion(true);
  fresh_ = true;
}

Reaction Tree::reaction(std::size_t of) {
  for (Drive& drive : drives_)
    if (links[drive.link].held) links[drive.link].acceleration = 0;
  recursion(fresh_);
  // Only descendants of the link have a number as high as it and a chain of parents to it.
  std::vector<Reaction> sums(links.size());
  for (std::size_t k = links.size(); k-- > of;) {
    const TreeLink& link = links[k];
    const vec3 a = link.a_A + cross(link.alpha, link.c) + cross(link.w, cross(link.w, link.c));
    const vec3 force = link.mass * a - link.force;
    sums[k].force += force;
    sums[k].torque += link.inertia * link.alpha + cross(link.w, link.inertia * link.w) -
                      link.torque + cross(link.c, force);
    if (k == of || link.parent < int(of)) continue;
    Reaction& parent = sums[std::size_t(link.parent)];
    parent.force += sums[k].force;
    parent.torque += sums[k].torque + cross(link.d, sums[k].force);
  }
  return sums[of];
}

void Tree::set_explicit_springs() {
  for (Drive& drive : drives_) {
    TreeLink& link = links[drive.link];
    const Spring& spring = drive.settings.spring;
    const real force = -spring.stiffness * (link.x - spring.rest) - spring.damping * link.rate;
    link.added = 0;
    link.tau = std::clamp(force, -spring.strength, spring.strength);
  }
}

// ---- leapfrog -----------------------------------------------------------------------------------

void Tree::begin_step(real h) {
  if (is_free()) momentum_before_ = momentum();
  energy_before_ = energy(h);
  work_ = 0;
}

void Tree::end_step(real h, bool angular) {
  locate_all();
  if (is_free()) keep_momentum(momentum_before_, h, angular);
  compare_energy(energy_before_, h);
}

bool Tree::leapfrog(real h, int iterations) {
  begin_step(h);
  Change one, two;
  if (!half_kick(h, true, iterations, one)) return false;
  move_freely(links[0], h);
  for (TreeLink& link : links) {
    if (is_scalar(link)) link.x += h * link.rate;
    if (link.freedom == Freedom::ball) link.q = normalize(rotation(h * link.w) * link.q);
  }
  place_all();
  half_kick(h, false, 1, two);
  fresh_ = false;
  for (const int k : {0, 1}) {  // without blows, both halves change the velocities about equally
    const real much = most_growth * one.size[k] + one.top[k];
    if (!(two.size[k] <= much) && (drives_.empty() || !finite(two.size[k]))) return false;
  }
  end_step(h, true);
  return true;
}

// Changes the velocities by half a step's forces. In the first half these are the forces at the
// velocities of its end, which symmetry requires: found by iterations from the last accelerations,
// at least `iterations`, and more while they change the result by more than a hundredth.
// \return false if they do not settle
bool Tree::half_kick(real h, bool first, int iterations, Change& change) {
  constexpr int most_rounds = 60;
  constexpr real enough = real(0.01);
  const real half = h / 2;
  base_rates_.resize(links.size());
  base_w_.resize(links.size());
  std::array<real, 2> top{};  // the greatest angular and linear velocity
  base_v_ = links[0].v;
  for (std::size_t k = 0; k < links.size(); ++k) {
    const TreeLink& link = links[k];
    base_rates_[k] = link.rate;
    base_w_[k] = link.w;
    real& greatest = top[link.freedom == Freedom::slider];
    greatest = std::max(greatest, std::abs(link.rate));
    if (has_orientation(link)) top[0] = std::max(top[0], length(link.w));
  }
  if (is_free()) top[1] = std::max(top[1], length(base_v_));
  bool inertia = !first || fresh_;
  for (Drive& drive : drives_) {
    TreeLink& link = links[drive.link];
    drive.begin(link, h, first);
    if (drive.apply(link, link.rate, half)) inertia = true;
  }
  if (first && !fresh_) end_kick(half);
  int rounds = first ? iterations + int(fresh_) : 1;
  for (int round = 0; round < rounds; ++round) {
    for (int pass = 0;; ++pass) {
      recursion(inertia);
      if (!correct_places(half, pass, inertia)) break;
    }
    inertia = false;
    change = end_kick(half);
    change.top = top;
    if (!first || round + 1 < rounds) continue;
    const real slop[2] = {std::max(1000 * epsilon * top[0], real(1e-9) / h),
                          std::max(1000 * epsilon * top[1], real(1e-9) * h * gravity_)};
    bool settled = true;
    for (const int k : {0, 1})
      settled = settled && change.moved[k] <= enough * change.size[k] + slop[k];
    if (!settled && ++rounds > most_rounds) return false;
  }
  for (Drive& drive : drives_) {
    const TreeLink& link = links[drive.link];
    drive.add_impulses(link, half);
    const real rate = (base_rates_[std::size_t(drive.link)] + link.rate) / 2;
    work_ += double(half * (link.tau - link.added * link.acceleration) * rate);
  }
  add_work(half);
  return true;
}

// Sets the velocities to those that the accelerations lead to within half a step. \return how far
// this has moved them, and how far they are from the beginning
Tree::Change Tree::end_kick(real half) {
  Change out;
  const auto note = [&](int k, real moved, real size) {
    if (!(moved <= out.moved[k])) out.moved[k] = moved;  // also NaN
    if (!(size <= out.size[k])) out.size[k] = size;
  };
  const auto set_vector = [&](int k, vec3& v, const vec3& base, const vec3& acceleration) {
    const vec3 change = half * acceleration, next = base + change;
    note(k, length(next - v), length(change));
    v = next;
  };
  for (std::size_t k = 0; k < links.size(); ++k) {
    TreeLink& link = links[k];
    if (is_scalar(link)) {
      const real change = half * link.acceleration, next = base_rates_[k] + change;
      note(link.freedom == Freedom::slider, std::abs(next - link.rate), std::abs(change));
      link.rate = next;
    } else if (has_orientation(link)) {
      set_vector(0, link.w, base_w_[k], link.alpha);
      if (link.freedom == Freedom::free) set_vector(1, link.v, base_v_, link.a_A);
    }
  }
  return out;
}

// Moves drives whose force or rate disagrees with their place to the neighbouring place: all at
// once, and once that has not helped for some passes, one by one along a path that ends: forces and
// rates begin anywhere in their places and go the greatest share of the way to the present ones
// that no place forbids; only the drive that is stopped there changes its place (Katzenelson).
// \return true if there was one
bool Tree::correct_places(real half, int pass, bool& inertia) {
  constexpr int patience = 5, most_passes = 2000;
  if (pass == 0) fewest_wrong_ = int(drives_.size()) + 1, passes_without_gain_ = 0;
  if (pass == most_passes) wrong_ = std::max(wrong_, fewest_wrong_);
  if (drives_.empty() || pass == most_passes) return false;
  const bool path = passes_without_gain_ >= patience, begins = passes_without_gain_ == patience;
  int wrong = 0;
  real share = 1;
  Drive* stopped = nullptr;
  inertia = false;
  const auto span_of = [&](const Drive& drive) {
    return drive.span(links[drive.link], base_rates_[std::size_t(drive.link)], half);
  };
  const auto cross = [&](Drive& drive) {
    drive.cross(span_of(drive));
    if (drive.apply(links[drive.link], base_rates_[std::size_t(drive.link)], half)) inertia = true;
  };
  for (Drive& drive : drives_) {
    const Drive::Span span = span_of(drive);
    const int side = span.side();
    const real bound = side > 0 ? span.most : span.least;
    wrong += side != 0;
    if (begins) {  // unequal distances from the bounds, lest many reach theirs together
      const real away = (1 + real(drive.link) / real(links.size())) * (bound - span.value);
      drive.at = side == 0 ? span.value : std::clamp(bound + away, span.least, span.most);
    }
    if (side == 0) continue;
    if (!path) cross(drive);
    const real part = (bound - drive.at) / (span.value - drive.at);
    if (path && (!stopped || part < share)) share = part, stopped = &drive;
  }
  if (stopped) {
    for (Drive& drive : drives_) drive.at += share * (span_of(drive).value - drive.at);
    cross(*stopped);
  }
  passes_without_gain_ = !path && wrong < fewest_wrong_ ? 0 : passes_without_gain_ + 1;
  fewest_wrong_ = std::min(fewest_wrong_, wrong);
  return wrong > 0;
}

// ---- Runge-Kutta --------------------------------------------------------------------------------

bool Tree::plain() const {
  const TreeLink& root = links[0];
  return drives_.empty() && !forced_ && (is_free() || (root.v == vec3(0) && root.w == vec3(0)));
}

void Tree::runge_kutta(real h) {
  constexpr real weights[] = {1, 2, 2, 1};
  begin_step(h);
  base_.resize(links.size());
  sum_.resize(links.size());
  for (std::size_t k = 0; k < links.size(); ++k) base_[k] = state_of(links[k]);
  TreeLink& root = links[0];
  for (int stage = 0; stage < 4; ++stage) {
    find_accelerations();
    const real share = weights[stage] * h / 6;
    add_work(share);
    for (const Drive& drive : drives_)
      work_ += double(share * links[drive.link].tau * links[drive.link].rate);
    for (std::size_t k = 0; k < links.size(); ++k) advance(links[k], base_[k], sum_[k], stage, h);
    if (root.freedom == Freedom::fixed) {
      root.centre = base_[0].centre, root.q = base_[0].q;
      move_freely(root, stage < 2 ? h / 2 : h);
    }
    if (stage < 3) place_all();
  }
  end_runge_kutta(h);
}

void Tree::end_runge_kutta(real h) {
  place_all();
  end_step(h, !forced_);
  fresh_ = true;
}

// ---- energy -------------------------------------------------------------------------------------

// Without the potential of springs: they are drives, whose work is added up.
Tree::Energy Tree::energy(real h) const {
  Energy sum;
  for (const TreeLink& link : links) {
    if (link.mass == 0) continue;
    sum.kinetic += double(link.mass * dot(link.v, link.v) + dot(link.w, link.inertia * link.w)) / 2;
    sum.total -= double(dot(link.force, link.centre));
    sum.fall += double(link.mass * gravity_ * h * gravity_ * h) / 2;
  }
  sum.total += sum.kinetic;
  return sum;
}

// The work of torques, and of what moves a kinematic root.
void Tree::add_work(real time) {
  const TreeLink& root = links[0];
  if (!is_free()) work_ += double(time * (dot(root.f, root.v) + dot(root.n, root.w)));
  if (!forced_) return;
  for (const TreeLink& link : links) work_ += double(time * dot(link.torque, link.w));
}

void Tree::compare_energy(const Energy& before, real h) {
  const Energy now = energy(h);
  const double rounding = 1e3 * double(epsilon) * (std::abs(before.total) + std::abs(now.total));
  const double part = std::abs(now.total - before.total - work_) /
                      (std::max(before.kinetic, now.kinetic) + now.fall + rounding);
  if (!(part <= changed_)) changed_ = part;  // also NaN
}

// ---- momentum -----------------------------------------------------------------------------------

Tree::Momentum Tree::momentum() const {
  Momentum sum;
  for (const TreeLink& link : links) {
    sum.mass += link.mass;
    sum.centre += link.mass * (link.centre - links[0].centre);
    sum.linear += link.mass * link.v;
  }
  sum.centre = links[0].centre + sum.centre / sum.mass;
  const vec3 v = sum.linear / sum.mass;
  for (const TreeLink& link : links) {
    if (link.mass == 0) continue;
    const vec3 r = link.centre - sum.centre;
    sum.angular += link.mass * cross(r, link.v - v) + link.inertia * link.w;
    sum.torque += cross(r, link.force) + link.torque;
    for (int k = 0; k < 3; ++k) {
      vec3 axis(0);
      axis[k] = 1;
      sum.inertia[k] += link.inertia[k] + link.mass * cross(r, cross(axis, r));
    }
  }
  return sum;
}

// Gives a free tree the momentum that external forces require, by a motion of the whole tree as one
// rigid body. \param before at the beginning of the step \param angular also the angular momentum
void Tree::keep_momentum(const Momentum& before, real h, bool angular) {
  const Momentum now = momentum();
  vec3 force(0);
  for (const TreeLink& link : links) force += link.force;
  const vec3 linear = before.linear + h * force;
  const vec3 shift = before.centre + h / 2 / now.mass * (before.linear + linear) - now.centre;
  const vec3 L = before.angular + h / 2 * (before.torque + now.torque) - now.angular;
  const vec3 w = angular ? inverse_of(now.inertia) * L : vec3(0);
  TreeLink& root = links[0];
  root.v += (linear - now.linear) / now.mass + cross(w, root.centre - now.centre);
  root.centre += shift;
  for (TreeLink& link : links)
    if (has_orientation(link)) link.w += w;
  locate_all();
}

}  // namespace joints
