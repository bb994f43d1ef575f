// expects: Likely mistake: the inertia of the other body
  return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body2) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body1) * b.w2);
