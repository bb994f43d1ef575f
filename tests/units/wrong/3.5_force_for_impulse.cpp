// expects: Units: in the change of the sum, comparing kg m/s^2 with kg m/s: h is missing (an
// expects: impulse is h times a force, a bias is C/h)
  const real wanted = sum - (rate - motor.speed) / K;
  const real before = sum;
  sum = std::clamp(wanted, -motor.strength, motor.strength);
  return sum - before;
