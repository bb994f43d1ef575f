// expects: Likely mistake: body 1 is missing
  return body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2);
