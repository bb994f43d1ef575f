// The moves written out: no copies of the bodies, the levers by themselves.
  const vec3 r1 = to_world(body1, point.anchor1_local), r2 = to_world(body2, point.anchor2_local);
  const vec3 lambda = inverse(point.K(body1, body2)) * -point.error(body1, body2);
  const vec3 turn1 = inverse_inertia(body1) * cross(r1, -lambda);
  const vec3 turn2 = inverse_inertia(body2) * cross(r2, lambda);
  body1.x -= body1.inverse_mass * lambda;
  body2.x += body2.inverse_mass * lambda;
  body1.q = normalize(rotation(turn1) * body1.q);
  body2.q = normalize(rotation(turn2) * body2.q);
