// region: 2
// expects: Units: J along n.w1 is a pure number and should be in m: an arm is missing
  return {-direction, -direction, direction, direction};
