// expects: Likely mistake: the bound is h strength: an impulse is a torque times a time, and h is
// expects: missing
  const real before = sum;
  sum = std::clamp(sum - (rate - motor.speed) / K, -motor.strength, motor.strength);
  return sum - before;
