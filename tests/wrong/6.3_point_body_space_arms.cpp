// expects: Likely mistake: body-space arm
  const vec3 lambda = -inverse(point.K(body1, body2)) * point.error(body1, body2);
  body1.x -= body1.inverse_mass * lambda;
  body2.x += body2.inverse_mass * lambda;
  const vec3 turn1 = inverse_inertia(body1) * cross(lambda, point.anchor1_local);
  const vec3 turn2 = inverse_inertia(body2) * cross(point.anchor2_local, lambda);
  body1.q = turned(body1.q, turn1, 1);
  body2.q = turned(body2.q, turn2, 1);
