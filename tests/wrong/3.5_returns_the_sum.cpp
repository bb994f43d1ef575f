// expects: Likely mistake: the new sum is returned instead of its change
  const real bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum;
