// expects: Likely mistake: q + (0, w) q/2 is only the first term of the turn
  const vec3 lambda = -inverse(point.K(body1, body2)) * point.error(body1, body2);
  Body move1 = body1, move2 = body2;
  move1.v = move1.w = move2.v = move2.w = vec3(0);
  apply_impulse(point.jacobian(body1, body2), lambda, move1, move2);
  body1.x += move1.v;
  body2.x += move2.v;
  for (auto [body, w] : {std::pair{&body1, move1.w}, std::pair{&body2, move2.w}})
    body->q = normalize(body->q + real(0.5) * (quat(0, w.x, w.y, w.z) * body->q));
