// expects: Likely mistake: body-space inertia of both bodies: it must be turned into the world, R
// expects: I^-1 R^T (upright, turned, moved, broken)
  const auto local = [](const Body& body) {
    const vec3 i = body.inverse_inertia_local;
    return mat3(i.x, 0, 0, 0, i.y, 0, 0, 0, i.z);
  };
  const mat3 s1 = skew(to_world(body1, anchor1_local)), s2 = skew(to_world(body2, anchor2_local));
  return mat3(body1.inverse_mass + body2.inverse_mass) + s1 * local(body1) * transpose(s1) +
         s2 * local(body2) * transpose(s2);
