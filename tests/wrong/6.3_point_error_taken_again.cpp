// expects: Likely mistake: taken again after body 1 has moved (error
  const vec3 lambda = -inverse(point.K(body1, body2)) * point.error(body1, body2);
  Body move1 = body1, move2 = body2;
  move1.v = move1.w = move2.v = move2.w = vec3(0);
  apply_impulse(point.jacobian(body1, body2), lambda, move1, move2);
  body1.x += move1.v;
  body1.q = turned(body1.q, move1.w, 1);
  move2.v = move2.w = vec3(0);
  const vec3 again = -inverse(point.K(body1, body2)) * point.error(body1, body2);
  apply_impulse(point.jacobian(body1, body2), again, move1, move2);
  body2.x += move2.v;
  body2.q = turned(body2.q, move2.w, 1);
