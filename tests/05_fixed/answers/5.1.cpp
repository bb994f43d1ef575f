// Known answers of exercise 5.1, each put in the place of the solution's.

// ---- wrong: K of the point
// expects: Likely mistake: this is K of the point: X is what the lock does to it
  return point.K(body1, body2);

// ---- wrong: anchor of the other body
// expects: Likely mistake: r2: the anchor of the other body
// change: point.anchor2_local ==> point.anchor1_local

// ---- wrong: body space inertia
// expects: Likely mistake: body-space inertia: take inverse_inertia(body)
  const auto local = [](const Body& body) {
    const vec3 i = body.inverse_inertia_local;
    return mat3(i.x, 0, 0, 0, i.y, 0, 0, 0, i.z);
  };
  const vec3 r1 = to_world(body1, point.anchor1_local), r2 = to_world(body2, point.anchor2_local);
  return -(skew(r1) * local(body1) + skew(r2) * local(body2));

// ---- wrong: factor of two
// expects: Likely mistake: a factor of 2 in all of it, in every case
// change: -(skew ==> real(-2) * (skew

// ---- wrong: inertia of body 2 for both
// expects: Likely mistake: the inertia of body 2 is taken for body 1, too
// change: inverse_inertia(body1) ==> inverse_inertia(body2)

// ---- wrong: last column never filled
// expects: Likely mistake: in X[x, z], X[y, z] and X[z, z] alone: X is zero
  const vec3 r1 = to_world(body1, point.anchor1_local), r2 = to_world(body2, point.anchor2_local);
  const mat3 all = -(skew(r1) * inverse_inertia(body1) + skew(r2) * inverse_inertia(body2));
  mat3 X(0);
  for (int column = 0; column < 2; ++column) X[column] = all[column];
  return X;

// ---- wrong: lever in body axes
// expects: holds at upright and 1 static
// expects: Likely mistake: r1: body-space lever, it is not turned into the world
// change: to_world(body1, point.anchor1_local) ==> point.anchor1_local

// ---- wrong: lever to the other anchor
// expects: Fails at broken
// expects: Likely mistake: r1: it ends at the anchor on the other body
// change: to_world(body1, point.anchor1_local) ==>
//         world_point(body2, point.anchor2_local) - body1.x

// ---- wrong: levers added up first
// expects: Likely mistake: the levers, or the inertias, are added up first
// change: -(skew(r1) * inverse_inertia(body1) + skew(r2) * inverse_inertia(body2)) ==>
//         -skew(r1 + r2) * (inverse_inertia(body1) + inverse_inertia(body2))

// ---- wrong: levers exchanged
// expects: Likely mistake: the lever of one body with the inertia of the other
// change: skew(r1) ==> skew(r2)
// change: + skew(r2) ==> + skew(r1)

// ---- wrong: masses in the place of inertias
// expects: Likely mistake: the inverse mass in the place of the inverse inertia
// change: inverse_inertia(body1) ==> body1.inverse_mass
// change: inverse_inertia(body2) ==> body2.inverse_mass

// ---- wrong: nothing beside a static body
// expects: Fails at 1 static and 2 static; holds at upright, turned, moved
// expects: Likely mistake: beside a static body it is zero: the share of the other body stays
// change: const vec3 r1 ==>
//         if (body1.is_static() || body2.is_static()) return mat3(0); const vec3 r1

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

// ---- wrong: turned the wrong way
// expects: Likely mistake: r1 and r2: turned the wrong way: to_world, not to_local
// change: to_world(body1 ==> to_local(body1
// change: to_world(body2 ==> to_local(body2

// ---- wrong: two mistakes
// expects: Likely mistake: the sign of body 1's share: both shares have the minus
// expects: and r2: turned with the other body: each anchor rides on its own
// change: to_world(body2, point ==> to_world(body1, point
// change: -(skew(r1) * inverse_inertia(body1) + skew(r2) ==>
//         -(-skew(r1) * inverse_inertia(body1) + skew(r2)

// ---- wrong: value never set
// expects: Likely mistake: a value that was never set
  mat3 X(0);
  for (int i = 0; i < 3; ++i) {
    real sum;
    sum += point.anchor1_local[i];
    X[i][i] = sum;
  }
  return X;

// ---- right: column by column
// What a turn about each axis does to the anchors.
  mat3 X(0);
  for (int column = 0; column < 3; ++column) {
    vec3 turn(0);
    turn[column] = 1;
    X[column] = cross(inverse_inertia(body1) * turn, to_world(body1, point.anchor1_local)) +
                cross(inverse_inertia(body2) * turn, to_world(body2, point.anchor2_local));
  }
  return X;

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
