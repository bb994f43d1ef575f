// expects: the new sum is added to the old one
  const real bound = h * motor.strength;
  const real now = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  sum += now;
  return now;
