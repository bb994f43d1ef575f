// region: 2
// expects: error left, at most (upright, a 100th of C)
// expects: Likely mistake: nothing moves where the error is small: there is no threshold
  const real C = rope.error(body1, body2);
  if (C > real(-0.01)) return;
  const real lambda = -C / rope.K(body1, body2);
  Body move1 = body1, move2 = body2;
  move1.v = move1.w = move2.v = move2.w = vec3(0);
  apply_impulse(rope.jacobian(body1, body2), lambda, move1, move2);
  body1.x += move1.v;
  body2.x += move2.v;
  body1.q = turned(body1.q, move1.w, 1);
  body2.q = turned(body2.q, move2.w, 1);
