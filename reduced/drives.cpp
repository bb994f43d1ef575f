// The staircase of motor, friction and limits, and the spring, within half a step.
#include "reduced/drives.h"

#include <algorithm>

namespace joints {

namespace {

// A share that is z^2 for small z and 1 for great ones: how implicit a stiff spring is.
real share(real z) { return 1 / (1 + 1 / (z * z)); }

}  // namespace

void Drive::begin(const TreeLink& link, real h, bool first) {
  const DriveSettings& s = settings;
  // The rate that reaches a limit within a step; beyond it, the rate that corrects a share.
  const auto stop = [&](real bound, real sign) {
    const real gap = sign * (link.x - bound);
    return -sign * gap / h * (gap > 0 ? real(1) : s.beta);
  };
  const bool equal = s.limits.lower == s.limits.upper;
  const real least = s.limits.lower > -unbounded ? stop(s.limits.lower, 1) : -unbounded;
  const real most = equal ? least : s.limits.upper < unbounded ? stop(s.limits.upper, -1)
                                                               : unbounded;
  count = 0;
  constant = {};
  const auto add = [&](real rate, real below, real above, int item) {
    if (rate < least || rate > most) {  // out of reach: its force is known
      constant[std::size_t(item)] = rate < least ? above : below;
      return;
    }
    int k = count++;
    for (; k > 0 && thresholds[k - 1].rate > rate; --k) thresholds[k] = thresholds[k - 1];
    thresholds[k] = {rate, below, above, item};
  };
  // The limits are the outermost ones, also where others have the same rate.
  if (least > -unbounded) add(least, unbounded, equal ? -unbounded : real(0), 2);
  if (s.motor.strength > 0) {
    real speed = s.motor.speed;
    if (s.target < unbounded)
      speed = std::clamp(s.beta / h * (s.target - link.x), -speed, speed);
    add(speed, s.motor.strength, -s.motor.strength, 0);
  }
  if (s.friction > 0) add(0, s.friction, -s.friction, 1);
  if (most < unbounded && !equal) add(most, 0, -unbounded, 3);

  int at = -1, lower = 0;
  for (int k = 0; k < count; ++k) {
    if (thresholds[k].item == held_item) at = k;
    if (link.rate > thresholds[k].rate) lower = k + 1;
  }
  place = at >= 0 ? 2 * at + 1 : 2 * lower;
  while (place < 2 * count && !(force(place / 2) < unbounded) && place % 2 == 0) ++place;
  while (place > 0 && !(force((place + 1) / 2) > -unbounded) && place % 2 == 0) --place;

  // The spring. Soft ones by the midpoint rule in both halves, stiff ones implicitly.
  added = spring = 0;
  clipped = 0;
  const auto [stiffness, damping, rest, strength] = s.spring;
  if (!s.spring.acts()) return;
  const real half = h / 2, D = std::max(link.D, std::numeric_limits<real>::min());
  const real of_k = share(stiffness * half * half / D), of_c = share(damping * half / D);
  if (first) {
    spring = -stiffness * (link.x - rest);
    added = half * (stiffness * half * (1 + of_k) + damping);
    spring -= added / half * link.rate;
  } else {
    spring = -stiffness * (link.x + (2 * of_k - 1) * half * link.rate - rest) -
             damping * link.rate;
    added = half * (stiffness * half * of_k + damping * of_c);
  }
  const int k = place / 2;  // its strength is reached or not at a rate of this place
  const real high = k < count ? thresholds[k].rate : unbounded;
  const real low = place % 2 == 1 ? high : k > 0 ? thresholds[k - 1].rate : -unbounded;
  const real rate = std::clamp(link.rate + half * link.acceleration, low, high);
  const real linear = spring - added / half * (rate - link.rate);
  clipped = linear > strength ? 1 : linear < -strength ? -1 : 0;
}

real Drive::force(int number) const {
  real sum = constant[0] + constant[1];
  for (int k = 0; k < count; ++k) sum += k < number ? thresholds[k].above : thresholds[k].below;
  return sum;
}

bool Drive::apply(TreeLink& link, real base, real half) const {
  const bool held = place % 2 == 1;
  const real adds = clipped != 0 || held ? real(0) : added;
  const bool changes = held != link.held || adds != link.added;
  link.held = held;
  link.added = adds;
  const real of_spring = clipped != 0 ? clipped * settings.spring.strength : spring;
  if (held) {
    link.acceleration = (thresholds[place / 2].rate - base) / half;
  } else {
    link.tau = force(place / 2) + of_spring;
  }
  return changes;
}

real Drive::spring_force(const TreeLink& link) const {
  return clipped != 0 ? clipped * settings.spring.strength
                      : spring - added * link.acceleration;
}

Drive::Span Drive::span(const TreeLink& link, real base, real half) const {
  const int k = place / 2;
  if (link.held) {
    const real slop = 64 * epsilon * (std::abs(link.tau) + std::abs(spring));
    return {force(k + 1), force(k), link.tau - spring_force(link), slop};
  }
  const real slop = 64 * epsilon * (std::abs(base) + std::abs(half * link.acceleration));
  Span span{k > 0 ? thresholds[k - 1].rate : -unbounded,
            k < count ? thresholds[k].rate : unbounded, base + half * link.acceleration, slop};
  if (const real strength = settings.spring.strength; added > 0 && strength < unbounded) {
    const real slow = base + half * (spring - strength) / added;  // below, all of the strength
    const real fast = base + half * (spring + strength) / added;
    if (clipped < 1) span.least = std::max(span.least, clipped == 0 ? slow : fast);
    if (clipped > -1) span.most = std::min(span.most, clipped == 0 ? fast : slow);
  }
  return span;
}

void Drive::cross(const Span& span) {
  const int k = place / 2, side = span.side();
  if (place % 2 == 1) {  // more force than there is: slower than the threshold
    at = thresholds[k].rate;
    place -= side;
    return;
  }
  at = side > 0 ? span.most : span.least;
  if (side > 0 ? k < count && at == thresholds[k].rate : k > 0 && at == thresholds[k - 1].rate) {
    place += side;
    at = force(k);
  } else {
    clipped -= side;
  }
}

void Drive::add_impulses(const TreeLink& link, real half) {
  const real of_spring = spring_force(link);
  impulse[3] += half * of_spring;
  real rest = link.tau - of_spring;
  if (!link.held && clipped == 0) rest = force(place / 2);
  held_item = place % 2 == 1 ? thresholds[place / 2].item : -1;
  for (int item = 0; item < 2; ++item) {
    impulse[item] += half * constant[item];
    rest -= constant[item];
  }
  const auto to = [&](const Threshold& threshold, real force) {
    impulse[std::min(threshold.item, 2)] += half * force;
  };
  for (int k = 0; k < count; ++k)
    if (2 * k + 1 != place) {
      const real force = k < (place + 1) / 2 ? thresholds[k].above : thresholds[k].below;
      to(thresholds[k], force);
      rest -= force;
    }
  if (place % 2 == 1) to(thresholds[place / 2], rest);
}

}  // namespace joints
