// expects: Likely mistake: K is missing: divide by it
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed), -bound, bound);
  return sum - before;
