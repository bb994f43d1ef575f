// Known answers of exercise 5.1, each put in the place of the solution's.

// ---- wrong: body space inertia
// expects: Likely mistake: body-space inertia: take inverse_inertia(body)
  const auto local = [](const Body& body) {
    const vec3 i = body.inverse_inertia_local;
    return mat3(i.x, 0, 0, 0, i.y, 0, 0, 0, i.z);
  };
  const vec3 r1 = to_world(body1, point.anchor1_local), r2 = to_world(body2, point.anchor2_local);
  return -(skew(r1) * local(body1) + skew(r2) * local(body2));

// ---- wrong: sign
// expects: Likely mistake: the sign: body 2 has -skew(r2) in the point and E in the lock: a minus
  const vec3 r1 = to_world(body1, point.anchor1_local), r2 = to_world(body2, point.anchor2_local);
  return skew(r1) * inverse_inertia(body1) + skew(r2) * inverse_inertia(body2);

// ---- wrong: sign of body 1
// expects: Likely mistake: the sign of body 1's share: both shares have the minus
// expects: Likely mistake: the sign of body 1's share: both shares have the minus, skew(r1)
// expects: meets -E of the lock (upright, turned, moved)
  const vec3 r1 = to_world(body1, point.anchor1_local), r2 = to_world(body2, point.anchor2_local);
  return skew(r1) * inverse_inertia(body1) - skew(r2) * inverse_inertia(body2);

// ---- wrong: transposed
// expects: Likely mistake: transposed: the rows of X belong to the point and its columns to
  const vec3 r1 = to_world(body1, point.anchor1_local), r2 = to_world(body2, point.anchor2_local);
  return inverse_inertia(body1) * skew(r1) + inverse_inertia(body2) * skew(r2);

// ---- right: entry by entry
// The rows of the point, each times the inverse inertia: J_t M^-1 J_r^T as it stands.
  const Jacobian<3> J = point.jacobian(body1, body2);
  const mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2);
  mat3 X;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      X[column][row] = dot(J[row].w2, I2[column]) - dot(J[row].w1, I1[column]);
  return X;

// ---- right: transposed twice
// (I^-1 skew(r))^T = -skew(r) I^-1: the transpose of the product in the other order.
  const vec3 r1 = to_world(body1, point.anchor1_local), r2 = to_world(body2, point.anchor2_local);
  return transpose(inverse_inertia(body1) * skew(r1) + inverse_inertia(body2) * skew(r2));

// ---- wrong units: arms on both sides
// expects: Units: X is in 1/kg and should be in 1/(kg m): a length too many
  const mat3 s1 = skew(to_world(body1, point.anchor1_local));
  const mat3 s2 = skew(to_world(body2, point.anchor2_local));
  return s1 * inverse_inertia(body1) * s1 + s2 * inverse_inertia(body2) * s2;
