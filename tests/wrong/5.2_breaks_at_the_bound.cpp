// region: 3
// expects: 10 N of 10, at the bound
// expects: Likely mistake: at its bound a weld still holds: > and not >=
  return length(load.force) >= strength.force || length(load.torque) >= strength.torque;
