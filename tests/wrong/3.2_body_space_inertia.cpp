// expects: Likely mistake: body-space inertia: take inverse_inertia(body)
  return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, body1.inverse_inertia_local * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, body2.inverse_inertia_local * b.w2);
