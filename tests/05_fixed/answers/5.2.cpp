// Known answers of exercise 5.2, each put in the place of the solution's.

// ---- wrong: about by entries
// region: 2
// expects: Likely mistake: entry times entry: the lever and the force have a cross product
// change: cross(from - to, load.force) ==> (from - to) * load.force

// ---- wrong: about exchanged
// region: 2
// expects: Likely mistake: force and torque are exchanged: {force, torque}
  return {load.torque + cross(from - to, load.force), load.force};

// ---- wrong: about in float
// region: 2
// expects: Likely mistake: right to a few digits only: is there a float among the reals
// change: cross(from - to, load.force) ==> vec3(cross(glm::vec3(from - to), glm::vec3(load.force)))

// ---- wrong: about lever of the torque
// region: 2
// expects: Likely mistake: the force has the lever, not the torque
// change: cross(from - to, load.force) ==> cross(from - to, load.torque)

// ---- wrong: about lever of the torque alone
// region: 2
// expects: Likely mistake: the force has the lever, not the torque: (from - to) x F; and the old
// change: load.torque + cross(from - to, load.force) ==> cross(from - to, load.torque)

// ---- wrong: about short levers left out
// region: 2
// expects: points close together
// expects: Likely mistake: a short lever counts as none
// change: return ==> if (length(from - to) < real(0.1)) return load; return

// ---- wrong: about sign
// region: 2
// expects: Likely mistake: the sign of the new share, (from - to) x F: from and to are exchanged
  return {load.force, load.torque + cross(to - from, load.force)};

// ---- wrong: about unit lever
// region: 2
// expects: Likely mistake: the lever is made a unit vector
// change: from - to ==> normalize(from - to)

// ---- wrong: about without the old torque
// region: 2
// expects: Likely mistake: the old torque is lost: the new share is added to it
  return {load.force, cross(from - to, load.force)};

// ---- wrong: breaks at the bound
// region: 3
// expects: 10 N of 10, at the bound
// expects: Likely mistake: at its bound a weld still holds: > and not >=
  return length(load.force) >= strength.force || length(load.torque) >= strength.torque;

// ---- wrong: breaks by one entry
// region: 3
// expects: Likely mistake: one entry where the length belongs
  return load.force.x > strength.force || load.torque.x > strength.torque;

// ---- wrong: breaks by shares
// region: 3
// expects: Likely mistake: the shares of the two bounds are added up
  return length(load.force) / strength.force + length(load.torque) / strength.torque > 1;

// ---- wrong: breaks by the bound of the force
// region: 3
// expects: Likely mistake: the torque is compared with the bound of the force
// change: > strength.torque ==> > strength.force

// ---- wrong: breaks by the largest entry
// region: 3
// expects: 12 N of 10 downwards
// expects: Likely mistake: the largest entry where the length belongs, and entries may be negative
  const auto largest = [](const vec3& a) { return glm::max(a.x, glm::max(a.y, a.z)); };
  return largest(load.force) > strength.force || largest(load.torque) > strength.torque;

// ---- wrong: breaks by the product
// region: 3
// expects: Likely mistake: force times torque is compared
  return length(load.force) * length(load.torque) > strength.force * strength.torque;

// ---- wrong: breaks in whole numbers
// region: 3
// expects: Likely mistake: the length is cut to a whole number: an int has no fraction
  const int force = length(load.force), torque = length(load.torque);
  return force > strength.force || torque > strength.torque;

// ---- wrong: breaks when both are too much
// region: 3
// expects: 12 N of 10, 0 N m of 2
// expects: Likely mistake: `and` where `or` belongs: one of the two is enough to break a weld
  return length(load.force) > strength.force && length(load.torque) > strength.torque;

// ---- wrong: every second entry exchanged
// expects: force.y is what belongs to force.z; force.z is what belongs to force.y
// change: impulse[1], impulse[2] ==> impulse[2], impulse[1]

// ---- wrong: impulse for force
// expects: Likely mistake: this is the impulse: a force is the impulse over the step h
  return {vec3(impulse[0], impulse[1], impulse[2]), vec3(impulse[3], impulse[4], impulse[5])};

// ---- wrong: index off by one
// expects: Likely mistake: the force begins with impulse[1]: the three of the point are impulse[0]
// change: impulse[0], impulse[1], impulse[2] ==> impulse[1], impulse[2], impulse[3]

// ---- wrong: index outside
// expects: an index outside an array of 6 numbers
// change: impulse[3], impulse[4], impulse[5] ==> impulse[4], impulse[5], impulse[6]

// ---- wrong: threes exchanged
// expects: Likely mistake: the two threes are exchanged: the point's rows come first
  const vec3 couple(impulse[0], impulse[1], impulse[2]), push(impulse[3], impulse[4], impulse[5]);
  return {push / h, couple / h};

// ---- wrong: torque an impulse still
// expects: Likely mistake: this is the impulse: a force is the impulse over the step h (torque)
// change: couple / h ==> couple

// ---- wrong: torque begins too early
// expects: Likely mistake: the torque begins with impulse[2]
// change: impulse[3], impulse[4], impulse[5] ==> impulse[2], impulse[3], impulse[4]

// ---- wrong: two entries of three
// expects: Likely mistake: in force.z and torque.z alone: 0 in every case
// change: impulse[1], impulse[2]) ==> impulse[1], 0)
// change: impulse[4], impulse[5]) ==> impulse[4], 0)

// ---- wrong: values never set
// expects: Likely mistake: a value that was never set
  std::array<real, 6> sums;
  for (int i = 0; i < 6; ++i) sums[i] += impulse[i] / h;
  return {vec3(sums[0], sums[1], sums[2]), vec3(sums[3], sums[4], sums[5])};

// ---- wrong: whole steps a second
// expects: holds at h = 0.25
// expects: Likely mistake: 1/h is cut to a whole number
  const int rate = 1 / h;
  return {real(rate) * vec3(impulse[0], impulse[1], impulse[2]),
          real(rate) * vec3(impulse[3], impulse[4], impulse[5])};

// ---- right: about by a matrix
// region: 2
  return {load.force, load.torque - skew(load.force) * (from - to)};

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

// ---- right: breaks by the greater share
// region: 3
  return std::max(length(load.force) / strength.force, length(load.torque) / strength.torque) > 1;

// ---- wrong units: impulse for force
// expects: Units: the force is in kg m/s and should be in kg m/s^2: a time too many: is a
// expects: division by h missing?
  return {vec3(impulse[0], impulse[1], impulse[2]), vec3(impulse[3], impulse[4], impulse[5])};
