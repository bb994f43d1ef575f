// Known answers of exercise 3.5, each put in the place of the solution's.

// ---- wrong: K forgotten
// expects: Likely mistake: K is missing: divide by it
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed), -bound, bound);
  return sum - before;

// ---- wrong: each visit clamped
// expects: Likely mistake: each visit is clamped: it is the sum over all visits of a step that
// expects: stays within h strength
  const real bound = h * motor.strength;
  const real change = std::clamp(-(rate - motor.speed) / K, -bound, bound);
  sum += change;
  return change;

// ---- wrong: new sum added
// expects: the new sum is added to the old one
  const real bound = h * motor.strength;
  const real now = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  sum += now;
  return now;

// ---- wrong: returns the sum
// expects: Likely mistake: the new sum is returned instead of its change
  const real bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum;

// ---- wrong: sign of the speed
// expects: Likely mistake: the sign of the speed: the motor wants J V - speed = 0, not J V + speed
// expects: = 0
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate + motor.speed) / K, -bound, bound);
  return sum - before;

// ---- wrong: sum not stored
// expects: Likely mistake: the sum is not stored
  const real bound = h * motor.strength;
  return std::clamp(sum - (rate - motor.speed) / K, -bound, bound) - sum;

// ---- wrong: torque for an impulse
// expects: Likely mistake: the bound is h strength: an impulse is a torque times a time, and h is
// expects: missing
  const real before = sum;
  sum = std::clamp(sum - (rate - motor.speed) / K, -motor.strength, motor.strength);
  return sum - before;

// ---- right: what is left of the bound
// The change is clamped to what the sum has left, up and down.
  const real bound = h * motor.strength, lack = (motor.speed - rate) / K;
  const real change = std::min(std::max(lack, -bound - sum), bound - sum);
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
  const real wanted = sum - (rate - motor.speed) / K;
  const real before = sum;
  sum = std::clamp(wanted, -motor.strength, motor.strength);
  return sum - before;
