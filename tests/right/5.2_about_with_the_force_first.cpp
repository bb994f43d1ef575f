// region: 2
// Both signs turned: the force first, and the lever from the old point to the new one.
  Reaction moved = load;
  moved.torque += cross(load.force, to - from);
  return moved;
