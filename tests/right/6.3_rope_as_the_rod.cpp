// region: 2
// The rod of the rope, which has both signs turned.
  const real C = rope.rod.error(body1, body2);
  if (C > 0) {
    const Row J = rope.rod.jacobian(body1, body2);
    Body move1 = body1, move2 = body2;
    move1.v = move1.w = move2.v = move2.w = vec3(0);
    apply_impulse(J, row_impulse(J, rope.rod.K(body1, body2), C, move1, move2), move1, move2);
    body1.x += move1.v;
    body2.x += move2.v;
    body1.q = turned(body1.q, move1.w, 1);
    body2.q = turned(body2.q, move2.w, 1);
  }
