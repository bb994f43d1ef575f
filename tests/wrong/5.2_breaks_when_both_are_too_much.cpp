// region: 3
// expects: 12 N of 10, 0 N m of 2
// expects: Likely mistake: `and` where `or` belongs: one of the two is enough to break a weld
  return length(load.force) > strength.force && length(load.torque) > strength.torque;
