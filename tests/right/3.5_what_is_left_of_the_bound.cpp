// The change is clamped to what the sum has left, up and down.
  const real bound = h * motor.strength, lack = (motor.speed - rate) / K;
  const real change = std::min(std::max(lack, -bound - sum), bound - sum);
  sum += change;
  return change;
