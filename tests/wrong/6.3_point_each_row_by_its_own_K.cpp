// expects: Likely mistake: each row divided by its own K
  const vec3 C = point.error(body1, body2);
  const mat3 K = point.K(body1, body2);
  const vec3 lambda(-C.x / K[0][0], -C.y / K[1][1], -C.z / K[2][2]);
  Body move1 = body1, move2 = body2;
  move1.v = move1.w = move2.v = move2.w = vec3(0);
  apply_impulse(point.jacobian(body1, body2), lambda, move1, move2);
  body1.x += move1.v;
  body2.x += move2.v;
  body1.q = turned(body1.q, move1.w, 1);
  body2.q = turned(body2.q, move2.w, 1);
