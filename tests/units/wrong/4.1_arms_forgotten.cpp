// region: 2
// expects: Units: J.w1 is a pure number and should be in m: an arm is missing
  return {{Row{-n[0], -n[0], n[0], n[0]}, Row{-n[1], -n[1], n[1], n[1]}}};
