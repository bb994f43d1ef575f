// Known answers of exercise 4.1, each put in the place of the solution's.

// ---- wrong: C from centre to centre
// expects: Likely mistake: centres in place of anchors: u is p2 - p1
  const vec3 d = body2.x - body1.x;
  return {dot(d, to_world(body1, n1_local)), dot(d, to_world(body1, n2_local))};

// ---- wrong: C turned with body 2
// expects: Likely mistake: n is turned with body 2: the line rides on body 1
  return {dot(u, to_world(body2, n1_local)), dot(u, to_world(body2, n2_local))};

// ---- wrong: body space lever
// region: 2
// expects: Likely mistake: body-space arm: the lever of body 1 is not turned into the world
// expects: (turned, moved, broken)
  const vec3 r1 = anchor1_local, r2 = to_world(body2, anchor2_local);
  Jacobian<2> J;
  for (int i = 0; i < 2; ++i) J[i] = {-n[i], -cross(r1 + u, n[i]), n[i], cross(r2, n[i])};
  return J;

// ---- wrong: n in body space
// region: 2
// expects: Likely mistake: n is left in body space: turn it into the world with body 1 (turned,
// expects: moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  Jacobian<2> J;
  for (int i = 0; i < 2; ++i) {
    const vec3 m = i == 0 ? n1_local : n2_local;
    J[i] = {-m, -cross(r1 + u, m), m, cross(r2, m)};
  }
  return J;

// ---- wrong: n turned with body 2
// region: 2
// expects: Likely mistake: n is turned with body 2 here, but n rides on body 1
// expects: Likely mistake: n is turned with body 2 here, but n rides on body 1 (upright, turned,
// expects: moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  Jacobian<2> J;
  for (int i = 0; i < 2; ++i) {
    const vec3 m = to_world(body2, i == 0 ? n1_local : n2_local);
    J[i] = {-m, -cross(r1 + u, m), m, cross(r2, m)};
  }
  return J;

// ---- wrong: u forgotten
// region: 2
// expects: Likely mistake: u is forgotten, the lever of body 1 is r1 + u, because n rides on body 1
// expects: (turned, moved, broken)
// expects: Likely mistake: u belongs to the lever of body 1 and to no other: push and answer act
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  Jacobian<2> J;
  for (int i = 0; i < 2; ++i) J[i] = {-n[i], -cross(r1, n[i]), n[i], cross(r2, n[i])};
  return J;

// ---- right: C in axes of body 1
// The same two numbers, seen from body 1: u is turned and n1 and n2 stay.
  const vec3 seen = to_local(body1, u);
  return {dot(seen, n1_local), dot(seen, n2_local)};

// ---- right: lever to the point of body 2
// region: 2
// r1 + u is the arrow from the centre of body 1 to the point of body 2.
  const vec3 p2 = world_point(body2, anchor2_local);
  return {{Row{-n[0], cross(n[0], p2 - body1.x), n[0], cross(p2 - body2.x, n[0])},
           Row{-n[1], cross(n[1], p2 - body1.x), n[1], cross(p2 - body2.x, n[1])}}};

// ---- wrong units: arms forgotten
// region: 2
// expects: Units: J.w1 is a pure number and should be in m: an arm is missing
  return {{Row{-n[0], -n[0], n[0], n[0]}, Row{-n[1], -n[1], n[1], n[1]}}};
