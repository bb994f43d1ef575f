// Known answers of exercise 5.2, each put in the place of the solution's.

// ---- wrong: about sign
// region: 2
// expects: Likely mistake: the sign of the new share, (from - to) x F: from and to are exchanged
  return {load.force, load.torque + cross(to - from, load.force)};

// ---- wrong: about without the old torque
// region: 2
// expects: Likely mistake: the old torque is lost: the new share is added to it
  return {load.force, cross(from - to, load.force)};

// ---- wrong: breaks at the bound
// region: 3
// expects: 10 N of 10, at the bound
// expects: Likely mistake: at its bound a weld still holds: > and not >=
  return length(load.force) >= strength.force || length(load.torque) >= strength.torque;

// ---- wrong: breaks by the largest entry
// region: 3
// expects: 12 N of 10 downwards
// expects: Likely mistake: the largest entry where the length belongs, and entries may be negative
  const auto largest = [](const vec3& a) { return glm::max(a.x, glm::max(a.y, a.z)); };
  return largest(load.force) > strength.force || largest(load.torque) > strength.torque;

// ---- wrong: breaks when both are too much
// region: 3
// expects: 12 N of 10, 0 N m of 2
// expects: Likely mistake: `and` where `or` belongs: one of the two is enough to break a weld
  return length(load.force) > strength.force && length(load.torque) > strength.torque;

// ---- wrong: impulse for force
// expects: Likely mistake: this is the impulse: a force is the impulse over the step h
  return {vec3(impulse[0], impulse[1], impulse[2]), vec3(impulse[3], impulse[4], impulse[5])};

// ---- wrong: threes exchanged
// expects: Likely mistake: the two threes are exchanged: the point's rows come first
  const vec3 turn(impulse[0], impulse[1], impulse[2]), push(impulse[3], impulse[4], impulse[5]);
  return {push / h, turn / h};

// ---- right: about with the force first
// region: 2
// Both signs turned: the force first, and the lever from the old point to the new one.
  Reaction moved = load;
  moved.torque += cross(load.force, to - from);
  return moved;

// ---- right: breaks by squares
// region: 3
// Squares in the place of lengths: no root is drawn.
  const auto over = [](const vec3& a, real bound) { return dot(a, a) > bound * bound; };
  return over(load.force, strength.force) || over(load.torque, strength.torque);

// ---- wrong units: impulse for force
// expects: Units: the force is in kg m/s and should be in kg m/s^2: a time too many: is a
// expects: division by h missing?
  return {vec3(impulse[0], impulse[1], impulse[2]), vec3(impulse[3], impulse[4], impulse[5])};
