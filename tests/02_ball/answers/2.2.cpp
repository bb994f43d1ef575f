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
  const mat3 s1 = skew(to_world(body1, anchor1_local)), s2 = skew(to_world(body2, anchor2_local));
  return (body1.inverse_mass + body2.inverse_mass) +
         s1 * inverse_inertia(body1) * transpose(s1) +
         s2 * inverse_inertia(body2) * transpose(s2);

// ---- wrong: without rotation
// expects: Likely mistake: the share of the rotation is missing
// expects: Likely mistake: the share of the rotation is missing (upright, turned, moved, broken)
  return mat3(body1.inverse_mass + body2.inverse_mass);

// ---- wrong: without transpose
// expects: Likely mistake: the sign of the rotation's share: it is added (skew(r) I^-1 skew(r)
// expects: lacks a transpose)
// expects: Likely mistake: the sign of the rotation's share: it is added (skew(r) I^-1 skew(r)
// expects: lacks a transpose) (upright, turned, moved, broken)
  const mat3 s1 = skew(to_world(body1, anchor1_local)), s2 = skew(to_world(body2, anchor2_local));
  return mat3(body1.inverse_mass + body2.inverse_mass) + s1 * inverse_inertia(body1) * s1 +
         s2 * inverse_inertia(body2) * s2;

// ---- right: with minus signs
// skew^T = -skew: two minus signs in the place of two transposes.
  const mat3 s1 = skew(to_world(body1, anchor1_local)), s2 = skew(to_world(body2, anchor2_local));
  return mat3(body1.inverse_mass + body2.inverse_mass) - s1 * inverse_inertia(body1) * s1 -
         s2 * inverse_inertia(body2) * s2;

// ---- wrong units: inertia for its inverse
// expects: Units: in K, adding kg m^4 to 1/kg: inertia where its inverse belongs
  const mat3 s1 = skew(to_world(body1, anchor1_local)), s2 = skew(to_world(body2, anchor2_local));
  return mat3(body1.inverse_mass + body2.inverse_mass) +
         s1 * inverse(inverse_inertia(body1)) * transpose(s1) +
         s2 * inverse(inverse_inertia(body2)) * transpose(s2);
