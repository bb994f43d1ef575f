// expects: Likely mistake: times h: there is no step in it
  const vec3 lambda = -inverse(point.K(body1, body2)) * point.error(body1, body2);
  Body move1 = body1, move2 = body2;
  move1.v = move1.w = move2.v = move2.w = vec3(0);
  apply_impulse(point.jacobian(body1, body2), lambda, move1, move2);
  const real h = real(1) / 60;
  body1.x += h * move1.v;
  body2.x += h * move2.v;
  body1.q = turned(body1.q, move1.w, h);
  body2.q = turned(body2.q, move2.w, h);
