// expects: Likely mistake: the sign of the speed: the motor wants J V - speed = 0, not J V + speed
// expects: = 0
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate + motor.speed) / K, -bound, bound);
  return sum - before;
