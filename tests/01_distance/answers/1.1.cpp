// Known answers of exercise 1.1, each put in the place of the solution's.

// ---- wrong: not a unit vector
// expects: Likely mistake: not a unit vector: take direction(...) of the difference
// expects: Likely mistake: not a unit vector: take direction(...) of the difference (upright,
// expects: turned, moved, broken)
  const vec3 u = body2.x - body1.x;  // the thesis' J, meant for C = (|u|^2 - d^2)/2 (E20)
  return {-u, vec3(0), u, vec3(0)};

// ---- wrong: over the length of the rod
// expects: Likely mistake: divided by the length of the rod
// expects: Fails at broken; holds at upright, turned and moved.
// expects: Likely mistake: divided by the length of the rod: that is the distance only while C = 0
// expects: (broken)
  const vec3 n = (body2.x - body1.x) / length;
  return {-n, vec3(0), n, vec3(0)};

// ---- wrong: sign of the row
// expects: Likely mistake: the sign of the whole row, or bodies 1 and 2 swapped
// expects: Likely mistake: the sign of the whole row, or bodies 1 and 2 swapped (upright, turned,
// expects: moved, broken)
// change: body2.x - body1 ==> body1.x - body2

// ---- wrong: sign of v1
// expects: Likely mistake: the sign of the block v1
// expects: Likely mistake: the sign of the block v1 (upright, turned, moved, broken)
// change: -n ==> n

// ---- wrong: sign of v2
// expects: Likely mistake: the sign of the block v2
// change: , n ==> , - n

// ---- wrong: order of the blocks
// expects: Likely mistake: the order of the blocks: a row is {v1, w1, v2, w2}
  const vec3 n = direction(body2.x - body1.x);
  return {-n, n, vec3(0), vec3(0)};

// ---- wrong: body 1 left out
// expects: Likely mistake: the block v1 is missing
// change: -n ==> vec3(0)

// ---- wrong: positions added
// expects: Likely mistake: the positions are added: the direction is their difference
// change: - body1 ==> + body1

// ---- wrong: position of body 1 left out
// expects: Likely mistake: the position of body 1 is missing in the direction
// change: - body1.x ==>

// ---- wrong: no direction asked for
// expects: Likely mistake: a division by zero
// change: direction ==> normalize

// ---- wrong: times the length
// expects: Likely mistake: the row is multiplied by the length of the rod
// change: direction ==> length * direction

// ---- wrong: times the error
// expects: Likely mistake: the row is multiplied by the error
// change: direction ==> error(body1, body2) * direction

// ---- wrong: half of it
// expects: Likely mistake: a factor of 0.5
// change: direction ==> real(0.5) * direction

// ---- wrong: divided twice
// expects: Likely mistake: divided by the distance twice
  const vec3 n = (body2.x - body1.x) / dot(body2.x - body1.x, body2.x - body1.x);
  return {-n, vec3(0), n, vec3(0)};

// ---- wrong: close centres taken for one
// expects: Likely mistake: the row is 0 where the centres are close
// change: return ==> if (glm::length(body2.x - body1.x) < real(1e-3)) return Row{}; return

// ---- wrong: only where there is an error
// expects: Likely mistake: the row is 0 where the error is 0
// change: return ==> if (std::abs(error(body1, body2)) < real(1e-6)) return Row{}; return

// ---- wrong: only where it is too long
// expects: Likely mistake: the row is 0 while the rod is too short
// change: return ==> if (error(body1, body2) < 0) return Row{}; return

// ---- wrong: sign of the error
// expects: Likely mistake: the sign of the error is in the row
// change: direction ==> (error(body1, body2) < 0 ? real(-1) : real(1)) * direction

// ---- wrong: nothing for a wall
// expects: Likely mistake: a static body has its block in J, too
// change: -n ==> body1.is_static() ? vec3(0) : -n

// ---- wrong: in the plane
// expects: Likely mistake: the z of the direction is left out
  const vec3 n = direction(body2.x - body1.x);
  const vec3 n2(n.x, n.y, 0);
  return {-n2, vec3(0), n2, vec3(0)};

// ---- wrong: direction turned
// expects: Likely mistake: n is turned with a body
// change: direction ==> body1.q * direction

// ---- wrong: inverse masses in the row
// expects: Likely mistake: J times M^-1: masses and inertias come in with K
  const vec3 n = direction(body2.x - body1.x);
  return {-n * body1.inverse_mass, vec3(0), n * body2.inverse_mass, vec3(0)};

// ---- wrong: sizes of the direction
// expects: Likely mistake: the sign of each number of the direction is lost
  const vec3 n = abs(direction(body2.x - body1.x));
  return {-n, vec3(0), n, vec3(0)};

// ---- wrong: arms where nothing turns
// expects: Likely mistake: the blocks w1 and w2 should be zero
// change: vec3(0), n, vec3(0) ==> -n, n, n

// ---- wrong: whole numbers divided
// expects: Likely mistake: every entry is zero
// change: direction ==> real(1 / 2) * direction

// ---- right: normalize with a guard
// normalize of the zero vector is NaN: the guard keeps the row zero there.
  const vec3 u = body2.x - body1.x;
  const vec3 n = dot(u, u) > 0 ? normalize(u) : vec3(0);
  return {-n, vec3(0), n, vec3(0)};

// ---- right: block by block
// change: return {-n, vec3(0), n, vec3(0)}; ==> Row J; J.v1 = -n; J.v2 = n; return J;

// ---- wrong units: not a unit vector
// expects: Units: J.v1 is in m and should be a pure number: a length too many: a lever, or a
// expects: direction that is not a unit vector
  const vec3 u = body2.x - body1.x;
  return {-u, vec3(0), u, vec3(0)};
