// expects: Likely mistake: the sum is not stored
  const real bound = h * motor.strength;
  return std::clamp(sum - (rate - motor.speed) / K, -bound, bound) - sum;
