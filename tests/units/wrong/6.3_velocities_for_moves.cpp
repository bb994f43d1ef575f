// expects: Units: in the projection of a point, adding
// expects: a velocity has got among the moves
  const vec3 lambda = -inverse(point.K(body1, body2)) * point.error(body1, body2);
  Body move1 = body1, move2 = body2;
  apply_impulse(point.jacobian(body1, body2), lambda, move1, move2);
  body1.x += move1.v;
  body2.x += move2.v;
  body1.q = turned(body1.q, move1.w, 1);
  body2.q = turned(body2.q, move2.w, 1);
