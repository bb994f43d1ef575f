// expects: Likely mistake: the sign of body 1's share: skew(r1) meets -E of the lock
// expects: Likely mistake: the sign of body 1's share: skew(r1) meets -E of the lock (upright,
// expects: turned, moved)
  const vec3 r1 = to_world(body1, point.anchor1_local), r2 = to_world(body2, point.anchor2_local);
  return skew(r1) * inverse_inertia(body1) - skew(r2) * inverse_inertia(body2);
