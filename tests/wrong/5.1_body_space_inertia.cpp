// expects: Likely mistake: body-space inertia: take inverse_inertia(body)
  const auto local = [](const Body& body) {
    const vec3 i = body.inverse_inertia_local;
    return mat3(i.x, 0, 0, 0, i.y, 0, 0, 0, i.z);
  };
  const vec3 r1 = to_world(body1, point.anchor1_local), r2 = to_world(body2, point.anchor2_local);
  return -(skew(r1) * local(body1) + skew(r2) * local(body2));
