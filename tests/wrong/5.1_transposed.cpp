// expects: Likely mistake: transposed: the rows of X belong to the point and its columns to
  const vec3 r1 = to_world(body1, point.anchor1_local), r2 = to_world(body2, point.anchor2_local);
  return inverse_inertia(body1) * skew(r1) + inverse_inertia(body2) * skew(r2);
