// (I^-1 skew(r))^T = -skew(r) I^-1: the transpose of the product in the other order.
  const vec3 r1 = to_world(body1, point.anchor1_local), r2 = to_world(body2, point.anchor2_local);
  return transpose(inverse_inertia(body1) * skew(r1) + inverse_inertia(body2) * skew(r2));
