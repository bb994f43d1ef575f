// expects: change of v2 (on paper)
// expects: Are those of the copies written back, too? Only x and q move
  const vec3 lambda = -inverse(point.K(body1, body2)) * point.error(body1, body2);
  Body move1 = body1, move2 = body2;
  move1.v = move1.w = move2.v = move2.w = vec3(0);
  apply_impulse(point.jacobian(body1, body2), lambda, move1, move2);
  for (auto [move, body] : {std::pair{&move1, &body1}, std::pair{&move2, &body2}}) {
    move->x += move->v;
    move->q = turned(move->q, move->w, 1);
    *body = *move;
  }
