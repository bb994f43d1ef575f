// One bound after the other.
  const real before = sum;
  sum += (motor.speed - rate) / K;
  if (sum > h * motor.strength) sum = h * motor.strength;
  if (sum < -h * motor.strength) sum = -h * motor.strength;
  return sum - before;
