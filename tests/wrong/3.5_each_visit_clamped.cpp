// expects: Likely mistake: each visit is clamped: it is the sum over all visits of a step that
// expects: stays within h strength
  const real bound = h * motor.strength;
  const real change = std::clamp(-(rate - motor.speed) / K, -bound, bound);
  sum += change;
  return change;
