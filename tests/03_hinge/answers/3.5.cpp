// Known answers of exercise 3.5, each put in the place of the solution's.

// ---- wrong: K forgotten
// expects: Likely mistake: K is missing: divide by it
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed), -bound, bound);
  return sum - before;

// ---- wrong: K squared
// expects: Likely mistake: K is in it twice: (rate - speed) / K
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / (K * K), -bound, bound);
  return sum - before;

// ---- wrong: a step of 1/60
// expects: Likely mistake: the bound is h strength: h is what is given, not 1/60
  const real bound = motor.strength / 60, before = sum;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum - before;

// ---- wrong: abs rate
// expects: Likely mistake: no absolute value of the rate: it has a direction
  const real bound = h * motor.strength, before = sum;
  sum = std::clamp(sum - (std::abs(rate) - motor.speed) / K, -bound, bound);
  return sum - before;

// ---- wrong: all over h
// expects: Likely mistake: an impulse has no h in it: (rate - speed) / K, and the bound is h
// expects: strength
  const real bound = motor.strength, before = sum;
  sum = std::clamp(sum - (rate - motor.speed) / (h * K), -bound, bound);
  return sum - before;

// ---- wrong: at speed already by size
// expects: Likely mistake: a motor that runs too fast brakes: its impulse may have either sign
  if (std::abs(rate) >= std::abs(motor.speed)) return 0;
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum - before;

// ---- wrong: before after
// expects: Likely mistake: 0 is returned: keep the old sum before the new one is stored
  const real bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  const real before = sum;
  return sum - before;

// ---- wrong: bound by speed
// expects: Likely mistake: the bound is h strength: it does not ask for the speed
  const real before = sum, bound = h * motor.speed;
  sum = std::clamp(sum - (rate - motor.speed) / K, -std::abs(bound), std::abs(bound));
  return sum - before;

// ---- wrong: bound on one side
// expects: Likely mistake: the sum is kept between 0 and the bound on the side of the speed: a
// expects: motor brakes, too
  const real bound = h * motor.strength * (motor.speed < 0 ? -1 : 1), before = sum;
  const real least = std::min(bound, real(0)), most = std::max(bound, real(0));
  sum = std::clamp(sum - (rate - motor.speed) / K, least, most);
  return sum - before;

// ---- wrong: bound with K
// expects: Likely mistake: the bound is h strength: K has no part in it
  const real bound = h * motor.strength / K, before = sum;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum - before;

// ---- wrong: clamp ends exchanged
// expects: std::clamp(a, low, high) was given a high that is below low: are the ends exchanged, has
// expects: a
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / K, bound, -bound);
  return sum - before;

// ---- wrong: clamp not assigned
// expects: Likely mistake: nothing is clamped, or the old sum is: the new one stays within h
// expects: strength
  const real before = sum, bound = h * motor.strength;
  sum -= (rate - motor.speed) / K;
  std::clamp(sum, -bound, bound);
  return sum - before;

// ---- wrong: clamp the rate
// expects: Likely mistake: the rate is clamped: it is the sum that stays within h strength
  const real bound = h * motor.strength, before = sum;
  sum = sum - std::clamp(rate - motor.speed, -bound, bound) / K;
  return sum - before;

// ---- wrong: does not push when bound reached
// expects: Likely mistake: a sum at its bound may come back: there, too, the motor is asked
  const real before = sum, bound = h * motor.strength;
  if (std::abs(sum) >= bound) return 0;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum - before;

// ---- wrong: drops when exceeding
// expects: Likely mistake: where more is wanted than the bound allows the motor gives up: it gives
// expects: as much as it may
  const real before = sum, bound = h * motor.strength;
  const real wanted = sum - (rate - motor.speed) / K;
  if (std::abs(wanted) > bound) return 0;
  sum = wanted;
  return sum - before;

// ---- wrong: each change clamped
// expects: Likely mistake: each change is clamped: it is the accumulated impulse of a step that
// expects: stays within h strength
  const real bound = h * motor.strength;
  const real change = std::clamp(-(rate - motor.speed) / K, -bound, bound);
  sum += change;
  return change;

// ---- wrong: early out 1e-3
// expects: Likely mistake: a motor pushes until its speed is reached: no threshold on what is
// expects: lacking
  if (std::abs(rate - motor.speed) < 1e-3) return 0;
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum - before;

// ---- wrong: early out 1e-6
// expects: Likely mistake: a motor pushes until its speed is reached: no threshold on what is
// expects: lacking
  if (std::abs(rate - motor.speed) < 1e-6) return 0;
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum - before;

// ---- wrong: early out on small strength
// expects: Likely mistake: a weak motor is one, too: no threshold on its strength
  if (motor.strength < 1e-3) return 0;
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum - before;

// ---- wrong: early out on speed 0
// expects: Likely mistake: a motor whose speed is 0 is a brake: it pushes until nothing moves
  if (motor.speed == 0) return 0;
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum - before;

// ---- wrong: float literal
// expects: Likely mistake: right to a few digits only: is there a float among the reals
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(float(sum - (rate - motor.speed) / K), float(-bound), float(bound));
  return sum - before;

// ---- wrong: if else keeps old
// expects: Likely mistake: below the lower bound the sum is that bound: it is not left as it was
  const real before = sum, bound = h * motor.strength, wanted = sum - (rate - motor.speed) / K;
  if (wanted < bound && wanted > -bound) sum = wanted;
  else if (wanted >= bound) sum = bound;
  return sum - before;

// ---- wrong: if lower sign lost
// expects: Likely mistake: below the lower bound the sum is the lower bound, not the upper one
  const real before = sum, bound = h * motor.strength;
  sum = sum - (rate - motor.speed) / K;
  if (std::abs(sum) > bound) sum = bound;
  return sum - before;

// ---- wrong: int speed
// expects: Likely mistake: the speed is cut off to a whole number: an int has no fraction
  const real bound = h * motor.strength, before = sum;
  const int speed = motor.speed;
  sum = std::clamp(sum - (rate - speed) / K, -bound, bound);
  return sum - before;

// ---- wrong: int strength
// expects: Likely mistake: the bound is cut off to a whole number: an int has no fraction
  const int bound = h * motor.strength;
  const real before = sum;
  sum = std::clamp(sum - (rate - motor.speed) / K, real(-bound), real(bound));
  return sum - before;

// ---- wrong: lack for the sum
// expects: Likely mistake: the missing speed is not all: it is divided by K, and comes on top of
// expects: the sum
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(motor.speed - rate, -bound, bound);
  return sum - before;

// ---- wrong: lower bound 0
// expects: Likely mistake: the sum is kept from 0 to h strength: the torque is bounded either way
  const real bound = h * motor.strength, before = sum;
  sum = std::clamp(sum - (rate - motor.speed) / K, real(0), bound);
  return sum - before;

// ---- wrong: min max exchanged
// expects: Likely mistake: the sum is always at its lower bound: are min and max exchanged, or is
// expects: something in it never set?
  const real before = sum, bound = h * motor.strength;
  sum = std::min(std::max(sum - (rate - motor.speed) / K, bound), -bound);
  return sum - before;

// ---- wrong: minus sum
// expects: Likely mistake: the sign of the sum so far: what is wanted comes on top of it
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(-sum - (rate - motor.speed) / K, -bound, bound);
  return sum - before;

// ---- wrong: new sum added
// expects: the new sum is added to the old one
  const real bound = h * motor.strength;
  const real now = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  sum += now;
  return now;

// ---- wrong: precedence
// expects: Likely mistake: the bracket in (rate - speed) / K: all of the difference is divided
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - rate - motor.speed / K, -bound, bound);
  return sum - before;

// ---- wrong: returns bound
// expects: Likely mistake: the bound is returned: return by how much the sum changed
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return bound;

// ---- wrong: returns the sum
// expects: Likely mistake: the new sum is returned instead of its change
  const real bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum;

// ---- wrong: returns what was cut off
// expects: Likely mistake: what was cut off is returned: return by how much the sum changed
  const real bound = h * motor.strength, wanted = sum - (rate - motor.speed) / K;
  sum = std::clamp(wanted, -bound, bound);
  return wanted - sum;

// ---- wrong: sign of the speed
// expects: Likely mistake: the sign of the speed: the motor wants J V - speed = 0, not J V + speed
// expects: = 0
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate + motor.speed) / K, -bound, bound);
  return sum - before;

// ---- wrong: strength 0 unlimited
// expects: Likely mistake: strength 0 is a motor that is off, not one without a bound
  const real before = sum, bound = h * motor.strength;
  sum -= (rate - motor.speed) / K;
  if (motor.strength > 0) sum = std::clamp(sum, -bound, bound);
  return sum - before;

// ---- wrong: sum not stored
// expects: Likely mistake: the sum is not stored
  const real bound = h * motor.strength;
  return std::clamp(sum - (rate - motor.speed) / K, -bound, bound) - sum;

// ---- wrong: sum thrown away
// expects: Likely mistake: the sum so far is thrown away: it grows over all iterations of a step
  const real bound = h * motor.strength;
  sum = 0;
  const real before = sum;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum - before;

// ---- wrong: torque for an impulse
// expects: Likely mistake: the bound is h strength: an impulse is a torque times a time, and h is
// expects: missing
  const real before = sum;
  sum = std::clamp(sum - (rate - motor.speed) / K, -motor.strength, motor.strength);
  return sum - before;

// ---- wrong: unset sum
// expects: Likely mistake: a value that was never set
  real wanted;
  const real before = sum;
  wanted += sum - (rate - motor.speed) / K;
  sum = wanted;
  return sum - before;

// ---- wrong: unset wanted
// expects: never set
  real wanted;
  const real bound = h * motor.strength, before = sum;
  wanted -= (rate - motor.speed) / K;
  sum = std::clamp(wanted, -bound, bound);
  return sum - before;

// ---- right: copysign
  const real before = sum, bound = h * motor.strength;
  sum -= (rate - motor.speed) / K;
  if (std::abs(sum) > bound) sum = std::copysign(bound, sum);
  return sum - before;

// ---- right: nothing to do where nothing lacks
  const real lack = motor.speed - rate, bound = h * motor.strength;
  if (lack == 0) return 0;
  const real before = sum;
  sum = std::clamp(sum + lack / K, -bound, bound);
  return sum - before;

// ---- right: off at zero strength
  if (motor.strength == 0) { const real before = sum; sum = 0; return -before; }
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum - before;

// ---- right: what is left of the bound
// The change is clamped to what the sum has left, up and down.
  const real bound = h * motor.strength, lack = (motor.speed - rate) / K;
  const real change = std::min(std::max(lack, -bound - sum), bound - sum);
  sum += change;
  return change;

// ---- right: with fmin and fmax
  const real bound = h * motor.strength;
  const real now = std::fmax(-bound, std::fmin(bound, sum + (motor.speed - rate) / K));
  const real change = now - sum;
  sum += change;
  return change;

// ---- right: with ifs
// One bound after the other.
  const real before = sum;
  sum += (motor.speed - rate) / K;
  if (sum > h * motor.strength) sum = h * motor.strength;
  if (sum < -h * motor.strength) sum = -h * motor.strength;
  return sum - before;

// ---- wrong units: force for impulse
// expects: Units: in the change of the sum, comparing kg m/s^2 with kg m/s: h is missing (an
// expects: impulse is h times a force, a bias is C/h)
// change: const real bound = h * motor.strength; ==>
// change: bound, bound ==> motor.strength, motor.strength
