// region: 2
// expects: Likely mistake: body-space inertia of both bodies: it must be turned into the world, R
// expects: I^-1 R^T (upright, turned, moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const vec3 n = direction(body2.x + r2 - body1.x - r1);
  const vec3 a1 = cross(r1, n), a2 = cross(r2, n);
  return body1.inverse_mass + body2.inverse_mass + dot(a1, body1.inverse_inertia_local * a1) +
         dot(a2, body2.inverse_inertia_local * a2);
