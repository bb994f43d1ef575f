// expects: the turn of body 2 is missing
  return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2);
