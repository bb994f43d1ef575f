// Known answers of exercise 1.6, each put in the place of the solution's.

// ---- wrong: K body space inertia
// region: 2
// expects: Likely mistake: body-space inertia of both bodies: it must be turned into the world, R
// expects: I^-1 R^T (upright, turned, moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const vec3 n = direction(body2.x + r2 - body1.x - r1);
  const vec3 a1 = cross(r1, n), a2 = cross(r2, n);
  return body1.inverse_mass + body2.inverse_mass + dot(a1, body1.inverse_inertia_local * a1) +
         dot(a2, body2.inverse_inertia_local * a2);

// ---- wrong: K without rotation
// region: 2
// expects: Likely mistake: the share of the rotation is missing
// expects: Likely mistake: the share of the rotation is missing (upright, turned, moved, broken)
  return body1.inverse_mass + body2.inverse_mass;

// ---- wrong: bodies swapped
// expects: Likely mistake: bodies 1 and 2 swapped
// expects: Likely mistake: bodies 1 and 2 swapped (upright, turned, moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const vec3 n = direction(body2.x + r2 - body1.x - r1);
  return {n, cross(r2, n), -n, -cross(r1, n)};

// ---- wrong: body space arm of body 1
// expects: Fails at turned, moved and broken; holds at upright.
// expects: Likely mistake: body-space arm: the lever of body 1 is not turned into the world
// expects: (turned, moved, broken)
  const vec3 r1 = anchor1_local, r2 = to_world(body2, anchor2_local);
  const vec3 n = direction(body2.x + r2 - body1.x - r1);
  return {-n, -cross(r1, n), n, cross(r2, n)};

// ---- wrong: body space arm of body 2
// expects: Likely mistake: body-space arm: the lever of body 2 is not turned into the world
// expects: (upright, turned, moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const vec3 n = direction(body2.x + r2 - body1.x - r1);
  return {-n, -cross(r1, n), n, cross(anchor2_local, n)};

// ---- wrong: body space arms
// expects: Likely mistake: body-space arm: the levers of both bodies are not turned into the world
// expects: (upright, turned, moved, broken)
  const vec3 r1 = anchor1_local, r2 = anchor2_local;
  const vec3 n = direction(body2.x + r2 - body1.x - r1);
  return {-n, -cross(r1, n), n, cross(r2, n)};

// ---- wrong: from centre to centre
// expects: Likely mistake: the direction runs from centre to centre, not from anchor to anchor
// expects: (upright, turned, moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const vec3 n = direction(body2.x - body1.x);
  return {-n, -cross(r1, n), n, cross(r2, n)};

// ---- wrong: order of the cross products
// expects: Likely mistake: the sign of the blocks w1 and w2: a x b is -(b x a)
// expects: Likely mistake: the sign of the blocks w1 and w2: a x b is -(b x a) (upright, turned,
// expects: moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const vec3 n = direction(body2.x + r2 - body1.x - r1);
  return {-n, -cross(n, r1), n, cross(n, r2)};

// ---- wrong: sign of w1
// expects: Likely mistake: the sign of the block w1 (upright, turned, moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const vec3 n = direction(body2.x + r2 - body1.x - r1);
  return {-n, cross(r1, n), n, cross(r2, n)};

// ---- wrong: without levers
// expects: Likely mistake: the blocks w1 and w2 are missing: they hold the levers
// expects: Likely mistake: the blocks w1 and w2 are missing: they hold the levers (upright,
// expects: turned, moved, broken)
  const vec3 u = world_point(body2, anchor2_local) - world_point(body1, anchor1_local);
  const vec3 n = direction(u);
  return {-n, vec3(0), n, vec3(0)};

// ---- right: lever to the other end
// r1 + u in the place of r1: the difference u x n is zero, since n lies along u.
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const vec3 u = body2.x + r2 - body1.x - r1, n = direction(u);
  return {-n, -cross(r1 + u, n), n, cross(r2, n)};

// ---- wrong units: K arms forgotten
// region: 2
// expects: Units: in K, adding 1/(kg m^2) to 1/kg: the arms are missing
  const vec3 n = direction(world_point(body2, anchor2_local) - world_point(body1, anchor1_local));
  return body1.inverse_mass + body2.inverse_mass + dot(n, inverse_inertia(body1) * n) +
         dot(n, inverse_inertia(body2) * n);
