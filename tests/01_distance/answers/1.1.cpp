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
  const vec3 n = direction(body1.x - body2.x);
  return {-n, vec3(0), n, vec3(0)};

// ---- wrong: sign of v1
// expects: Likely mistake: the sign of the block v1
// expects: Likely mistake: the sign of the block v1 (upright, turned, moved, broken)
  const vec3 n = direction(body2.x - body1.x);
  return {n, vec3(0), n, vec3(0)};

// ---- right: normalize with a guard
// normalize of the zero vector is NaN: the guard keeps the row zero there.
  const vec3 u = body2.x - body1.x;
  const vec3 n = dot(u, u) > 0 ? normalize(u) : vec3(0);
  return {-n, vec3(0), n, vec3(0)};

// ---- wrong units: not a unit vector
// expects: Units: J.v1 is in m and should be a pure number: a length too many: an arm, or a
// expects: direction that is not a unit vector
  const vec3 u = body2.x - body1.x;
  return {-u, vec3(0), u, vec3(0)};
