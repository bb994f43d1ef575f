// Known answers of exercise 4.3, each put in the place of the solution's.

// ---- wrong: as printed
// region: 2
// expects: Likely mistake: levers are missing: such a row drives the centres, not the points, and
// expects: its sign is wrong as well (upright, turned, moved, broken)
  const vec3 a = to_world(body1, a1_local);
  return {a, vec3(0), -a, vec3(0)};

// ---- wrong: axis in body space
// region: 2
// expects: Likely mistake: a is left in body space: turn it into the world with body 1 (turned,
// expects: moved, broken)
  const vec3 a = a1_local;
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  return {-a, -cross(r1 + u, a), a, cross(r2, a)};

// ---- wrong: u forgotten
// region: 2
// expects: Likely mistake: u is forgotten, the lever of body 1 is r1 + u, because a rides on body 1
// expects: (turned, moved, broken)
  const vec3 a = to_world(body1, a1_local);
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  return {-a, -cross(r1, a), a, cross(r2, a)};

// ---- wrong: way from centre to centre
// expects: Likely mistake: centres in place of anchors: u is p2 - p1
  return dot(body2.x - body1.x, to_world(body1, a1_local));

// ---- wrong: without levers
// region: 2
// expects: Likely mistake: levers are missing: such a row drives the centres, not the points
// expects: (upright, turned, moved, broken)
// expects: Likely mistake: levers are missing, or are points: push and answer act along two lines
  const vec3 a = to_world(body1, a1_local);
  return {-a, vec3(0), a, vec3(0)};

// ---- right: lever to the point of body 2
// region: 2
// Push and answer both act at the point of body 2.
  const vec3 a = to_world(body1, a1_local), p2 = world_point(body2, anchor2_local);
  return {-a, -cross(p2 - body1.x, a), a, cross(p2 - body2.x, a)};

// ---- right: way in axes of body 1
// The way is the same number, seen from body 1.
  return dot(to_local(body1, u), a1_local);
