// Known answers of exercise 2.2, each put in the place of the solution's.

// ---- wrong: body space inertia
// expects: Likely mistake: body-space inertia of both bodies: it must be turned into the world, R
// expects: I^-1 R^T (upright, turned, moved, broken)
  const auto local = [](const Body& body) {
    const vec3 i = body.inverse_inertia_local;
    return mat3(i.x, 0, 0, 0, i.y, 0, 0, 0, i.z);
  };
  const mat3 s1 = skew(to_world(body1, anchor1_local)), s2 = skew(to_world(body2, anchor2_local));
  return mat3(body1.inverse_mass + body2.inverse_mass) + s1 * local(body1) * transpose(s1) +
         s2 * local(body2) * transpose(s2);

// ---- wrong: number plus matrix
// expects: Likely mistake: a matrix plus a number adds it to all nine entries: write mat3(a)
// expects: (upright, turned, moved, broken)
// change: return mat3 ==> return

// ---- wrong: without rotation
// expects: Likely mistake: the share of the rotation is missing
// expects: Likely mistake: the share of the rotation is missing (upright, turned, moved, broken)
  return mat3(body1.inverse_mass + body2.inverse_mass);

// ---- wrong: without transpose
// expects: Likely mistake: the sign of the rotation's share: it is added (skew(r) I^-1 skew(r)
// expects: lacks a transpose)
// expects: Likely mistake: the sign of the rotation's share: it is added (skew(r) I^-1 skew(r)
// expects: lacks a transpose) (upright, turned, moved, broken)
// change: transpose(s1) ==> s1
// change: transpose(s2) ==> s2

// ---- wrong: world inertia half turned
// expects: Likely mistake: the world inertia lacks R^T on its right
  const auto world = [](const Body& body) {
    const vec3 i = body.inverse_inertia_local;
    const mat3 R = mat3_cast(body.q), local(i.x, 0, 0, 0, i.y, 0, 0, 0, i.z);
    return R * local;
  };
  const mat3 s1 = skew(to_world(body1, anchor1_local)), s2 = skew(to_world(body2, anchor2_local));
  return mat3(body1.inverse_mass + body2.inverse_mass) + s1 * world(body1) * transpose(s1) +
         s2 * world(body2) * transpose(s2);

// ---- wrong: world inertia half turned back
// expects: Likely mistake: the world inertia lacks R on its left
  const auto world = [](const Body& body) {
    const vec3 i = body.inverse_inertia_local;
    const mat3 R = mat3_cast(body.q), local(i.x, 0, 0, 0, i.y, 0, 0, 0, i.z);
    return local * transpose(R);
  };
  const mat3 s1 = skew(to_world(body1, anchor1_local)), s2 = skew(to_world(body2, anchor2_local));
  return mat3(body1.inverse_mass + body2.inverse_mass) + s1 * world(body1) * transpose(s1) +
         s2 * world(body2) * transpose(s2);

// ---- wrong: inertia turned the wrong way round
// expects: Likely mistake: the inertia is turned the wrong way round
  const auto world = [](const Body& body) {
    const vec3 i = body.inverse_inertia_local;
    const mat3 R = mat3_cast(body.q), local(i.x, 0, 0, 0, i.y, 0, 0, 0, i.z);
    return transpose(R) * local * R;
  };
  const mat3 s1 = skew(to_world(body1, anchor1_local)), s2 = skew(to_world(body2, anchor2_local));
  return mat3(body1.inverse_mass + body2.inverse_mass) + s1 * world(body1) * transpose(s1) +
         s2 * world(body2) * transpose(s2);

// ---- wrong: body space levers
// expects: Likely mistake: body-space lever: the levers of both bodies
// change: to_world(body1, anchor1_local) ==> anchor1_local
// change: (to_world(body2, anchor2_local)) ==> (anchor2_local)

// ---- wrong: levers exchanged
// expects: Likely mistake: the lever of one body with the inertia of the other
// change: s1 = ==> s1 = skew(to_world(body2, anchor2_local)), s2 =
// change: , s2 = skew(to_world(body2, anchor2_local)) ==>

// ---- wrong: inverted
// expects: Likely mistake: the inverse of K: that is the effective mass
  const mat3 s1 = skew(to_world(body1, anchor1_local)), s2 = skew(to_world(body2, anchor2_local));
  return inverse(mat3(body1.inverse_mass + body2.inverse_mass) +
         s1 * inverse_inertia(body1) * transpose(s1) +
         s2 * inverse_inertia(body2) * transpose(s2));

// ---- wrong: without masses
// expects: Likely mistake: the inverse masses are missing
// change: body1.inverse_mass + body2.inverse_mass ==> 0

// ---- wrong: mass of body 1 left out
// expects: Likely mistake: the inverse mass of body 1 is missing
// change: body1.inverse_mass + ==>

// ---- wrong: masses multiplied
// expects: Likely mistake: the inverse masses are multiplied: they are added
  const mat3 s1 = skew(to_world(body1, anchor1_local)), s2 = skew(to_world(body2, anchor2_local));
  return mat3(body1.inverse_mass) * mat3(body2.inverse_mass) +
         s1 * inverse_inertia(body1) * transpose(s1) +
         s2 * inverse_inertia(body2) * transpose(s2);

// ---- wrong: order of the product
// expects: Likely mistake: K is symmetric, and yours is not
  const mat3 s1 = skew(to_world(body1, anchor1_local)), s2 = skew(to_world(body2, anchor2_local));
  return mat3(body1.inverse_mass + body2.inverse_mass) +
         s1 * transpose(s1) * inverse_inertia(body1) +
         s2 * transpose(s2) * inverse_inertia(body2);

// ---- wrong: rotation of body 1 left out
// expects: Likely mistake: the rotation of body 1 is missing
// change: s1 * inverse_inertia(body1) * transpose(s1) + ==>

// ---- wrong: rotation of body 1 twice
// expects: Likely mistake: the rotation of body 1 is counted twice
// change: s2 * inverse_inertia(body2) * transpose(s2) ==>
//         s1 * inverse_inertia(body1) * transpose(s1)

// ---- wrong: points for levers
// expects: Likely mistake: a point where a lever belongs
  const mat3 s1 = skew(world_point(body1, anchor1_local));
  const mat3 s2 = skew(world_point(body2, anchor2_local));
  return mat3(body1.inverse_mass + body2.inverse_mass) +
         s1 * inverse_inertia(body1) * transpose(s1) +
         s2 * inverse_inertia(body2) * transpose(s2);

// ---- wrong: only the diagonal
// expects: Likely mistake: the entries beside the diagonal are missing
  const mat3 s1 = skew(to_world(body1, anchor1_local)), s2 = skew(to_world(body2, anchor2_local));
  const mat3 turns = s1 * inverse_inertia(body1) * transpose(s1) +
                     s2 * inverse_inertia(body2) * transpose(s2);
  return mat3(body1.inverse_mass + body2.inverse_mass) +
         mat3(turns[0][0], 0, 0, 0, turns[1][1], 0, 0, 0, turns[2][2]);

// ---- wrong: without inertia
// expects: Likely mistake: the inverse inertia is missing
// change: * inverse_inertia(body1) ==>
// change: inverse_inertia(body2) * ==>

// ---- wrong: mass for inertia
// expects: Likely mistake: inverse mass where inverse inertia belongs
// change: inverse_inertia(body1) ==> mat3(body1.inverse_mass)
// change: inverse_inertia(body2) ==> mat3(body2.inverse_mass)

// ---- wrong: unit matrix between walls
// expects: Likely mistake: between two static bodies K is 0
// change: return mat3 ==> if (body1.is_static() && body2.is_static()) return mat3(1); return mat3

// ---- wrong: mat3 taken for zero
// expects: Likely mistake: the unit matrix too much
  const mat3 s1 = skew(to_world(body1, anchor1_local)), s2 = skew(to_world(body2, anchor2_local));
  mat3 k;
  k += mat3(body1.inverse_mass + body2.inverse_mass) +
         s1 * inverse_inertia(body1) * transpose(s1) +
         s2 * inverse_inertia(body2) * transpose(s2);
  return k;

// ---- right: with minus signs
// skew^T = -skew: two minus signs in the place of two transposes.
  const mat3 s1 = skew(to_world(body1, anchor1_local)), s2 = skew(to_world(body2, anchor2_local));
  return mat3(body1.inverse_mass + body2.inverse_mass) - s1 * inverse_inertia(body1) * s1 -
         s2 * inverse_inertia(body2) * s2;

// ---- right: transposed on the left
  const mat3 s1 = skew(to_world(body1, anchor1_local)), s2 = skew(to_world(body2, anchor2_local));
  return mat3(body1.inverse_mass + body2.inverse_mass) +
         transpose(s1) * inverse_inertia(body1) * s1 +
         transpose(s2) * inverse_inertia(body2) * s2;

// ---- right: from the rows
  const Jacobian<3> J = jacobian(body1, body2);
  mat3 K;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      K[j][i] = body1.inverse_mass * dot(J[i].v1, J[j].v1) +
                body2.inverse_mass * dot(J[i].v2, J[j].v2) +
                dot(J[i].w1, inverse_inertia(body1) * J[j].w1) +
                dot(J[i].w2, inverse_inertia(body2) * J[j].w2);
  return K;

// ---- wrong units: inertia for its inverse
// expects: Units: in K, adding kg m^4 to 1/kg: inertia where its inverse belongs
// change: inverse_inertia(body1) ==> inverse(inverse_inertia(body1))
// change: inverse_inertia(body2) ==> inverse(inverse_inertia(body2))
