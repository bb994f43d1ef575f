// The impulse of a block at rest with the gap for its bias.
  Body move1 = body1, move2 = body2;
  move1.v = move1.w = move2.v = move2.w = vec3(0);
  const Jacobian<3> J = point.jacobian(body1, body2);
  const vec3 C = point.error(body1, body2);
  apply_impulse(J, block_impulse(J, point.K(body1, body2), C, move1, move2), move1, move2);
  move1.x += move1.v;
  move2.x += move2.v;
  move1.q = turned(body1.q, move1.w, 1);
  move2.q = turned(body2.q, move2.w, 1);
  for (auto [moved, body] : {std::pair{&move1, &body1}, std::pair{&move2, &body2}}) {
    body->x = moved->x;
    body->q = moved->q;
  }
